#include "python/binding/potential.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/toml_from_python.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/commands/model_list.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary::python {
namespace {

/// Read as of a case, with its messages. Of the body and the motion nothing is used.
Material read(const py::dict& models) {
  toml::table root;
  root.insert("body", toml::table{{"J", toml::array{1.0, 1.0, 1.0}}});
  root.insert("motion", toml::table{{"branch", "i"}, {"nu", 0.0}});
  toml::table written = table_from_python(models, "Potential");
  root.insert("potential", std::move(written));
  const WithoutLock released;
  Case made = make_case(CaseTree::of(std::move(root), "Potential"));
  return {std::move(made.models), std::move(made.potential)};
}

/// By model and coefficient: {"plane": {"c": 1.0, "k": 2.0}, ...}.
py::dict coefficients(const Material& self) {
  py::dict out;
  for (const ModelChoice& model : self.models) {
    py::dict each;
    for (std::size_t k = 0; k < model.coefficients.size(); ++k)
      each[py::str(model.description.parameters[k])] = model.coefficients[k];
    out[py::str(model.slot)] = each;
  }
  return out;
}

py::dict formulas(const Material& self) {
  py::dict out;
  for (const ModelChoice& model : self.models)
    out[py::str(model.slot)] = model.tape ? model.formula.expression : model.description.formula;
  return out;
}

std::vector<std::string> facts(const Material& self) {
  std::vector<std::string> out;
  for (const ModelChoice& model : self.models)
    out.insert(out.end(), model.facts.begin(), model.facts.end());
  return out;
}

/// (name, where it stands in [potential], formula, parameters, domain, what is assumed) of each.
py::list models() {
  constexpr std::string_view slots[] = {"plane", "thickness", "coupled", "fibre"};
  py::list out;
  for (const ModelDescription& each : cli::all_models())
    out.append(py::make_tuple(each.name, std::string(slots[static_cast<std::size_t>(each.kind)]),
                              each.formula, each.parameters, each.domain,
                              std::string(cli::assumption(each))));
  return out;
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// V at many S, alpha ... rho of one shape.
py::array_t<double> values(const Material& self, const Numbers& alpha, const Numbers& xi,
                           const Numbers& zeta, const Numbers& rho) {
  py::array_t<double> out(std::vector<py::ssize_t>(alpha.shape(), alpha.shape() + alpha.ndim()));
  const auto size = static_cast<std::size_t>(out.size());
  double* const V = out.mutable_data();
  interruptible([&, a = alpha.data(), x = xi.data(), z = zeta.data(),
                 r = rho.data()](const std::atomic<bool>& stop) {
    for (std::size_t k = 0; k < size && !stop; ++k) {
      const Stretch q{a[k], x[k], z[k], r[k]};
      if (const char* inequality = violated_inequality(q))
        throw InputError({}, "S",
                         fmt::format("found alpha = {}, xi = {}, zeta = {}, rho = {}", q.alpha,
                                     q.xi, q.zeta, q.rho),
                         inequality);
      V[k] = self.potential.value(q);
    }
  });
  return out;
}

}  // namespace

Branch branch_named(const std::string& name) {
  if (const auto branch = branch_from_name(name)) return *branch;
  constexpr std::string_view names[] = {"i", "ii", "iii"};
  throw InputError({}, "branch", "found the string " + in_quotes(name), "one of " + listed(names),
                   did_you_mean(nearest_name(name, names)));
}

void declare_potential(py::module_& module) {
  py::class_<Material, std::shared_ptr<Material>>(module, "Potential")
      .def(py::init([](const py::dict& models) { return read(models); }), py::arg("models"))
      .def_property_readonly("isotropic",
                             [](const Material& self) { return self.potential.is_isotropic(); })
      .def_property_readonly("separable",
                             [](const Material& self) { return self.potential.is_separable(); })
      .def_property_readonly("coefficients", &coefficients)
      .def_property_readonly("formulas", &formulas)
      .def_property_readonly("facts", &facts)
      .def("value", &values, py::arg("alpha"), py::arg("xi"), py::arg("zeta"), py::arg("rho"));
  module.def("models", &models);
  module.def("model_list", &cli::model_list, py::arg("name"));
  module.def(
      "body_of_case", [](const Case& input) { return input.own_body; }, py::arg("case"));
}

}  // namespace stationary::python
