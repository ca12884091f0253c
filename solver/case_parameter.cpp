#include "solver/case_parameter.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace stationary {

namespace {

/// The number of the motion with this key, or nullptr.
double* motion_number(Case::Motion& motion, std::string_view key) {
  if (auto* rotation = std::get_if<AxisRotation>(&motion))
    return key == "nu" ? &rotation->nu : nullptr;
  TwoPolarMotion& two_polar = std::get<TwoPolarMotion>(motion);
  if (auto* rates = std::get_if<TwoPolarRates<double>>(&two_polar)) {
    if (key == "motion.omega") return &rates->omega;
    return key == "motion.theta_dot" ? &rates->theta_dot : nullptr;
  }
  auto& momenta = std::get<TwoPolarMomenta<double>>(two_polar);
  if (key == "motion.s3") return &momenta.s3;
  return key == "motion.p_theta" ? &momenta.p_theta : nullptr;
}

std::vector<std::string> motion_and_body_keys(const Case::Motion& motion) {
  if (std::holds_alternative<AxisRotation>(motion))
    return {"nu", "body.J.0", "body.J.1", "body.J.2"};
  if (std::holds_alternative<TwoPolarRates<double>>(std::get<TwoPolarMotion>(motion)))
    return {"motion.omega", "motion.theta_dot", "body.J.2"};
  return {"motion.s3", "motion.p_theta", "body.J.2"};
}

}  // namespace

std::vector<std::string> case_parameters(const Case::Motion& motion,
                                         const std::vector<ModelChoice>& models) {
  std::vector<std::string> out = motion_and_body_keys(motion);
  for (const ModelChoice& model : models)
    for (const std::string_view parameter : model.description->parameters)
      out.push_back("potential." + model.slot + '.' + std::string(parameter));
  return out;
}

FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value) {
  if (double* number = motion_number(family.motion, key)) {
    if (!std::isfinite(value)) throw std::invalid_argument(std::string(key) + " finite");
    *number = value;
    return family;
  }
  Body& J = family.body;
  if (key == "body.J.2") {
    J = Body(J.J1, J.J2, value);
    return family;
  }
  if (std::holds_alternative<AxisRotation>(family.motion)) {
    if (key == "body.J.0") {
      J = Body(value, J.J2, J.J3);
      return family;
    }
    if (key == "body.J.1") {
      J = Body(J.J1, value, J.J3);
      return family;
    }
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
