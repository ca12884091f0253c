// What the program's commands compute of a case, with their tables in memory.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "python/binding/array_table.hpp"
#include "python/binding/case.hpp"
#include "python/binding/diagram.hpp"
#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "solver/program/computation/atlas_case.hpp"
#include "solver/program/computation/continue_case.hpp"
#include "solver/program/computation/map_case.hpp"
#include "solver/program/computation/solve_case.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary::python {
namespace {

using Shared = std::shared_ptr<Case>;

struct Computed {
  Shared input;
  ArrayTable table;
  cli::Outcome outcome;
  std::vector<std::string> lines;  ///< what the program would say on standard error
};

/// compute(input, target, run) without the lock; call: what stands for the command line.
template <class Compute>
std::shared_ptr<Computed> computed(const Shared& input, std::optional<int> threads,
                                   const std::string& call, const Compute& compute) {
  auto out = std::make_shared<Computed>();
  out->input = input;
  cli::Run run;
  run.command_line = {call};
  run.threads = thread_count(threads);
  run.complain = [&lines = out->lines](const std::string& line) { lines.push_back(line); };
  interruptible([&](const std::atomic<bool>& stop) {
    run.stop = &stop;
    out->table.keep_unless(stop);
    out->outcome = compute(*input, &out->table, run);
  });
  return out;
}

std::shared_ptr<Computed> solve(const Shared& input, std::optional<int> threads) {
  return computed(input, threads, "stationary.solve", cli::solve_case);
}

std::shared_ptr<Computed> follow(const Shared& input, const std::string& row,
                                 std::optional<int> threads) {
  return computed(input, threads, "stationary.follow",
                  [&row](const Case& given, TableTarget* target, const cli::Run& run) {
                    return cli::continue_case(given, {row, {}}, target, run);
                  });
}

std::shared_ptr<Computed> atlas(const Shared& input, std::optional<int> checkpoints,
                                std::optional<int> threads) {
  if (checkpoints && *checkpoints < 1) throw std::invalid_argument("checkpoints from 1 on");
  return computed(input, threads, "stationary.atlas",
                  [checkpoints](const Case& given, TableTarget* target, const cli::Run& run) {
                    return cli::atlas_case(given, {checkpoints, {}, false}, target, run);
                  });
}

std::shared_ptr<Computed> map(const Shared& input, std::optional<int> threads) {
  return computed(input, threads, "stationary.map", cli::map_case);
}

/// The rows themselves, which live as long as the array does.
py::object array(const std::shared_ptr<Computed>& self) {
  const ArrayTable& table = self->table;
  if (!table.complete()) return py::none();
  py::list names;
  py::list formats;
  py::list offsets;
  for (const RecordField& field : table.fields()) {
    names.append(field.name);
    formats.append(field.format);
    offsets.append(field.offset);
  }
  const py::dtype type(names, formats, offsets, static_cast<py::ssize_t>(table.record_size()));
  py::array out(type, {table.rows()}, {table.record_size()}, table.records(), py::cast(self));
  out.attr("setflags")(py::arg("write") = false);
  return out;
}

/// HDF5 of Debian is not for several threads, and h5py calls it under the interpreter's lock: so does
/// this.
void write(const Computed& self, const std::string& path) {
  const std::string extension = path.substr(std::min(path.rfind('.'), path.size()));
  std::optional<py::gil_scoped_release> released;
  if (!is_column_file_extension(extension)) released.emplace();
  self.table.write(path, file_of(*self.input));
}

}  // namespace

void declare_computed(py::module_& module) {
  py::class_<Computed, std::shared_ptr<Computed>>(module, "Computed")
      .def_property_readonly("code", [](const Computed& self) { return int(self.outcome.code); })
      .def_property_readonly("summary", [](const Computed& self) { return self.outcome.summary; })
      .def_property_readonly("lines", [](const Computed& self) { return self.lines; })
      .def_property_readonly("complete", [](const Computed& self) { return self.table.complete(); })
      .def_property_readonly("metadata", [](const Computed& self) { return self.table.metadata(); })
      .def_property_readonly("table", &array)
      .def("write", &write, py::arg("path"))
      .def("diagram", [](const Computed& self) { return diagram(self.table.csv()); })
      .def(
          "map_diagram",
          [](const Computed& self, const std::optional<std::string>& quantity) {
            return map_diagram(self.table.csv(), quantity);
          },
          py::arg("quantity"));
  module.def("solve", &solve, py::arg("case"), py::arg("threads"));
  module.def("follow", &follow, py::arg("case"), py::arg("row"), py::arg("threads"));
  module.def("atlas", &atlas, py::arg("case"), py::arg("checkpoints"), py::arg("threads"));
  module.def("map", &map, py::arg("case"), py::arg("threads"));
}

}  // namespace stationary::python
