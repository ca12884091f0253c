// What the program's commands compute of a case, with their tables in memory.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "python/binding/array_table.hpp"
#include "python/binding/case.hpp"
#include "python/binding/cell_array.hpp"
#include "python/binding/diagram.hpp"
#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/computation/atlas_case.hpp"
#include "solver/program/computation/continue_case.hpp"
#include "solver/program/computation/curve_case.hpp"
#include "solver/program/computation/map_case.hpp"
#include "solver/program/computation/row_start.hpp"
#include "solver/program/computation/sensitivity_case.hpp"
#include "solver/program/computation/solve_case.hpp"
#include "solver/program/computation/study_case.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary::python {
namespace {

using Shared = std::shared_ptr<Case>;
using Tree = std::shared_ptr<CaseTree>;

struct Computed {
  std::string input_file;  ///< which is not to be replaced; empty: none
  std::string other_file;  ///< nor is this, a table that it was computed from
  ArrayTable table;
  cli::Outcome outcome;
  std::vector<std::string> lines;  ///< what the program would say on standard error
};

/// compute(target, run) without the lock; file: the case's, call: what stands for the command line.
template <class Compute>
std::shared_ptr<Computed> computed(const std::string& file, std::optional<int> threads,
                                   const std::string& call, const Compute& compute) {
  auto out = std::make_shared<Computed>();
  out->input_file = file;
  cli::Run run;
  run.command_line = {call};
  run.threads = thread_count(threads);
  run.complain = [&lines = out->lines](const std::string& line) { lines.push_back(line); };
  interruptible([&](const std::atomic<bool>& stop) {
    run.stop = &stop;
    out->table.keep_unless(stop);
    out->outcome = compute(&out->table, run);
  });
  return out;
}

template <class Compute>
std::shared_ptr<Computed> computed(const Shared& input, std::optional<int> threads,
                                   const std::string& call, const Compute& compute) {
  return computed(
      file_of(input->source), threads, call,
      [&](TableTarget* target, const cli::Run& run) { return compute(*input, target, run); });
}

std::shared_ptr<Computed> solve(const Shared& input, std::optional<int> threads) {
  return computed(input, threads, "stationary.solve", cli::solve_case);
}

std::shared_ptr<Computed> sensitivity(const Shared& input, bool events,
                                      std::optional<int> threads) {
  return computed(input, threads, "stationary.sensitivity",
                  [events](const Case& given, TableTarget* target, const cli::Run& run) {
                    return cli::sensitivity_case(given, events, target, run);
                  });
}

/// row: that it started from; empty: none.
void keep_table_of(Computed& result, const std::string& row) {
  if (!row.empty()) result.other_file = cli::table_of_row(row);
}

std::shared_ptr<Computed> follow(const Shared& input, const std::string& row,
                                 std::optional<int> threads) {
  const auto out = computed(input, threads, "stationary.follow",
                            [&row](const Case& given, TableTarget* target, const cli::Run& run) {
                              return cli::continue_case(given, {row, {}}, target, run);
                            });
  keep_table_of(*out, cli::start_row_of(*input, row));
  return out;
}

void require_checkpoints(std::optional<int> checkpoints) {
  if (checkpoints && *checkpoints < 1) throw std::invalid_argument("checkpoints from 1 on");
}

std::shared_ptr<Computed> atlas(const Shared& input, std::optional<int> checkpoints, bool complete,
                                std::optional<int> threads) {
  require_checkpoints(checkpoints);
  return computed(
      input, threads, "stationary.atlas",
      [checkpoints, complete](const Case& given, TableTarget* target, const cli::Run& run) {
        return cli::atlas_case(given, {checkpoints, {}, false, complete}, target, run);
      });
}

std::shared_ptr<Computed> map(const Shared& input, std::optional<int> threads) {
  return computed(input, threads, "stationary.map", cli::map_case);
}

std::shared_ptr<Computed> curve(const Shared& input, const std::string& row,
                                std::optional<int> threads) {
  const auto out = computed(input, threads, "stationary.curve",
                            [&row](const Case& given, TableTarget* target, const cli::Run& run) {
                              return cli::curve_case(given, row, target, run);
                            });
  keep_table_of(*out, row);
  return out;
}

/// over: a table's file, or what messages call one whose text is `csv`.
std::shared_ptr<Computed> study(const Tree& base, const std::string& over,
                                const std::optional<std::string>& csv, const std::string& task,
                                std::optional<int> checkpoints, std::optional<int> threads) {
  const auto chosen = cli::study_task(task);
  if (!chosen)
    throw InputError({}, "do", "found the string " + in_quotes(task),
                     "one of " + listed(cli::study_task_names),
                     did_you_mean(nearest_name(task, cli::study_task_names)));
  require_checkpoints(checkpoints);
  const cli::StudySource source =
      csv ? cli::StudySource(TableReader(std::make_unique<std::istringstream>(*csv), over), over)
          : cli::StudySource(over);
  cli::StudyRun asked{base.get(), {}, &source, {}};
  asked.plan.task = *chosen;
  asked.plan.checkpoints = checkpoints;
  const auto out = computed(file_of(*base), threads, "stationary.study",
                            [&asked](TableTarget* target, const cli::Run& run) {
                              return cli::study_case(asked, target, run);
                            });
  if (!csv) out->other_file = over;
  return out;
}

/// The rows themselves, which live as long as the array does.
py::object table_array(const std::shared_ptr<Computed>& self) {
  const ArrayTable& table = self->table;
  if (!table.complete()) return py::none();
  if (table.cells() != nullptr) {
    py::array out = cell_array(*table.cells());
    out.attr("setflags")(py::arg("write") = false);
    return out;
  }
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

/// HDF5 may be built for one thread only, and h5py calls it under the interpreter's lock: so does this.
void write(const Computed& self, const std::string& path) {
  const std::string extension = path.substr(std::min(path.rfind('.'), path.size()));
  std::optional<WithoutLock> released;
  if (!is_column_file_extension(extension)) released.emplace();
  if (!self.other_file.empty())
    cli::refuse_to_replace_table(path, self.other_file, "the table that it was computed from");
  try {
    self.table.write(path, self.input_file);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& fault) {  // a full disk
    released.reset();
    PyErr_SetString(PyExc_OSError, fault.what());
    throw py::error_already_set();
  }
}

py::tuple state(const Computed& self) {
  const ArrayTable::Contents table = self.table.contents();
  return py::make_tuple(self.input_file, self.other_file, static_cast<int>(self.outcome.code),
                        self.outcome.summary, self.lines, table.columns, table.parameters,
                        table.expected, table.cell_columns, py::bytes(table.bytes), table.metadata,
                        table.lasting_metadata, table.complete);
}

std::shared_ptr<Computed> restored_result(const py::tuple& state) {
  auto out = std::make_shared<Computed>();
  ArrayTable::Contents table;
  std::size_t k = 0;
  const auto next = [&](auto& value) {
    value = state[k++].template cast<std::remove_reference_t<decltype(value)>>();
  };
  int code = 0;
  next(out->input_file);
  next(out->other_file);
  next(code);
  next(out->outcome.summary);
  next(out->lines);
  next(table.columns);
  next(table.parameters);
  next(table.expected);
  next(table.cell_columns);
  next(table.bytes);
  next(table.metadata);
  next(table.lasting_metadata);
  next(table.complete);
  out->outcome.code = static_cast<cli::ExitCode>(code);
  out->table.restore(table);
  return out;
}

}  // namespace

void declare_computed(py::module_& module) {
  py::class_<Computed, std::shared_ptr<Computed>>(module, "Computed")
      // For every protocol of pickle: with py::pickle the protocols 0 and 1 end the interpreter.
      .def(py::init(&restored_result), py::arg("state"))
      .def("__reduce__",
           [](const py::object& self) {
             return py::make_tuple(self.attr("__class__"),
                                   py::make_tuple(state(self.cast<const Computed&>())));
           })
      .def_property_readonly("code", [](const Computed& self) { return int(self.outcome.code); })
      .def_property_readonly("summary", [](const Computed& self) { return self.outcome.summary; })
      .def_property_readonly("lines", [](const Computed& self) { return self.lines; })
      .def_property_readonly("complete", [](const Computed& self) { return self.table.complete(); })
      .def_property_readonly("metadata", [](const Computed& self) { return self.table.metadata(); })
      .def_property_readonly("table", &table_array)
      .def("write", &write, py::arg("path"))
      .def(
          "diagram",
          [](const Computed& self, const std::vector<std::string>& columns,
             const std::vector<std::string>& sheets, const std::vector<std::string>& branches,
             bool energy_momentum) {
            return diagram(self.table.csv(), {columns, sheets, branches, energy_momentum});
          },
          py::arg("columns"), py::arg("sheets"), py::arg("branches"), py::arg("energy_momentum"))
      .def("curve_diagram", [](const Computed& self) { return curve_diagram(self.table.csv()); })
      .def(
          "map_diagram",
          [](const Computed& self, const std::optional<std::string>& quantity) {
            return map_diagram(self.table.csv(), quantity);
          },
          py::arg("quantity"));
  module.def("solve", &solve, py::arg("case"), py::arg("threads"));
  module.def("sensitivity", &sensitivity, py::arg("case"), py::arg("events"), py::arg("threads"));
  module.def("follow", &follow, py::arg("case"), py::arg("row"), py::arg("threads"));
  module.def("atlas", &atlas, py::arg("case"), py::arg("checkpoints"), py::arg("complete"),
             py::arg("threads"));
  module.def("map", &map, py::arg("case"), py::arg("threads"));
  module.def("curve", &curve, py::arg("case"), py::arg("row"), py::arg("threads"));
  module.def("study", &study, py::arg("keys"), py::arg("over"), py::arg("csv"), py::arg("task"),
             py::arg("checkpoints"), py::arg("threads"));
}

}  // namespace stationary::python
