#include "python/binding/case.hpp"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/toml_from_python.hpp"
#include "solver/program/computation/check_case.hpp"

namespace stationary::python {
namespace {

using Overrides = std::map<std::string, std::string, std::less<>>;
using Shared = std::shared_ptr<Case>;
using Tree = std::shared_ptr<CaseTree>;

Shared make(CaseTree tree) {
  const WithoutLock released;
  return std::make_shared<Case>(make_case(std::move(tree)));
}

Shared read(const std::string& path, const std::vector<std::string>& overrides) {
  const WithoutLock released;
  return std::make_shared<Case>(read_case(path, overrides));
}

Shared with(const Case& input, const py::dict& values) {
  std::vector<Override> overrides;
  for (const auto& [name, value] : values) {
    const auto key = py::cast<std::string>(name);
    overrides.push_back({key + "=" + assigned_text(value, key)});
  }
  const WithoutLock released;
  return std::make_shared<Case>(make_case(input.source, overrides));
}

py::tuple state(const CaseTree& tree) {
  return py::make_tuple(
      to_python(tree.root()), tree.name(),
      std::map<std::string, std::string>(tree.overrides().begin(), tree.overrides().end()));
}

CaseTree restored_tree(const py::dict& keys, const std::string& name,
                       const std::map<std::string, std::string>& overrides) {
  return CaseTree::of(table_from_python(keys, name), name,
                      Overrides(overrides.begin(), overrides.end()));
}

Shared restored_case(const py::dict& keys, const std::string& name,
                     const std::map<std::string, std::string>& overrides) {
  return make(restored_tree(keys, name, overrides));
}

/// The keys of a case, which need not be all that one has.
void declare_keys(py::module_& module) {
  py::class_<CaseTree, Tree>(module, "Keys")
      .def_static(
          "read",
          [](const std::string& path) { return std::make_shared<CaseTree>(CaseTree::read(path)); },
          py::arg("path"))
      .def_static(
          "of",
          [](const py::dict& keys) {
            return std::make_shared<CaseTree>(
                CaseTree::of(table_from_python(keys, case_name), case_name));
          },
          py::arg("keys"))
      .def_static(
          "of_case", [](const Case& input) { return std::make_shared<CaseTree>(input.source); },
          py::arg("case"))
      // For every protocol of pickle: with py::pickle the protocols 0 and 1 end the interpreter.
      .def(py::init([](const py::dict& keys, const std::string& name,
                       const std::map<std::string, std::string>& overrides) {
             return std::make_shared<CaseTree>(restored_tree(keys, name, overrides));
           }),
           py::arg("keys"), py::arg("name"), py::arg("overrides"))
      .def("__reduce__",
           [](const py::object& self) {
             return py::make_tuple(self.attr("__class__"), state(self.cast<const CaseTree&>()));
           })
      .def("case", [](const CaseTree& self) { return make(self); });
  module.def("assigned_text", &assigned_text, py::arg("value"), py::arg("key"));
}

}  // namespace

std::string file_of(const CaseTree& keys) {
  return keys.name() == case_name ? std::string() : keys.name();
}

void declare_case(py::module_& module) {
  declare_keys(module);
  py::class_<Case, Shared>(module, "Case")
      .def_static("read", &read, py::arg("path"), py::arg("overrides"))
      .def_static(
          "of", [](const py::dict& keys) { return restored_case(keys, case_name, {}); },
          py::arg("keys"))
      .def_static("restored", &restored_case, py::arg("keys"), py::arg("name"),
                  py::arg("overrides"))
      .def("with_values", &with, py::arg("values"))
      .def("keys", [](const Case& input) { return to_python(input.source.root()); })
      .def("state", [](const Case& input) { return state(input.source); })
      .def(
          "check", [](const Case& input) { return cli::check_case(input); },
          py::call_guard<WithoutLock>())
      .def_property_readonly("name", [](const Case& input) { return input.source.name(); })
      .def_property_readonly("title", [](const Case& input) { return input.title; });
}

}  // namespace stationary::python
