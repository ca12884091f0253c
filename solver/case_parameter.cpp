#include "solver/case_parameter.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace stationary {

std::vector<std::string> case_parameters(const std::vector<ModelChoice>& models) {
  std::vector<std::string> out{"nu", "body.J.0", "body.J.1", "body.J.2"};
  for (const ModelChoice& model : models)
    for (const std::string_view parameter : model.description->parameters)
      out.push_back("potential." + model.slot + '.' + std::string(parameter));
  return out;
}

FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value) {
  if (key == "nu") {
    if (!std::isfinite(value)) throw std::invalid_argument("nu finite");
    family.nu = value;
    return family;
  }
  Body& J = family.body;
  if (key == "body.J.0") {
    J = Body(value, J.J2, J.J3);
    return family;
  }
  if (key == "body.J.1") {
    J = Body(J.J1, value, J.J3);
    return family;
  }
  if (key == "body.J.2") {
    J = Body(J.J1, J.J2, value);
    return family;
  }
  for (ModelChoice& model : family.models) {
    for (std::size_t k = 0; k < model.coefficients.size(); ++k) {
      if (key != "potential." + model.slot + '.' + std::string(model.description->parameters[k]))
        continue;
      model.coefficients[k] = value;
      make_potential(family.models);  // its domain
      return family;
    }
  }
  throw std::invalid_argument("a parameter of the case");
}

}  // namespace stationary
