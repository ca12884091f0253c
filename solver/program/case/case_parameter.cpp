#include "solver/program/case/case_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stationary {

namespace {

/// The number of the motion with this key, or nullptr.
double* motion_number(Case::Motion& motion, std::string_view key) {
  if (auto* rotation = std::get_if<AxisRotation>(&motion))
    return key == "nu" ? &rotation->nu : nullptr;
  if (auto* tilted = std::get_if<TiltedMotion>(&motion)) return key == "nu" ? &tilted->nu : nullptr;
  if (auto* oblique = std::get_if<ObliqueRotation>(&motion))
    return key == "nu" ? &oblique->nu : nullptr;
  TwoPolarMotion& two_polar = std::get<TwoPolarMotion>(motion);
  if (auto* rates = std::get_if<TwoPolarRates<double>>(&two_polar)) {
    if (key == "motion.omega") return &rates->omega;
    return key == "motion.theta_dot" ? &rates->theta_dot : nullptr;
  }
  auto& momenta = std::get<TwoPolarMomenta<double>>(two_polar);
  if (key == "motion.s3") return &momenta.s3;
  return key == "motion.p_theta" ? &momenta.p_theta : nullptr;
}

/// Which coefficient of the model a key names.
std::optional<int> coefficient_index(const ModelChoice& model, std::string_view key) {
  const auto& names = model.description.parameters;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (key == "potential." + model.slot + '.' + names[k]) return static_cast<int>(k);
  return std::nullopt;
}

/// The number a key names, or nullptr.
double* find_number(FamilyParameters& family, std::string_view key) {
  if (double* number = motion_number(family.motion, key)) return number;
  Body& J = family.body;
  if (key == "body.J.2") return &J.J3;
  if (!std::holds_alternative<TwoPolarMotion>(family.motion)) {
    if (key == "body.J.0") return &J.J1;
    if (key == "body.J.1") return &J.J2;
  }
  for (ModelChoice& model : family.models)
    if (const auto at = coefficient_index(model, key))
      return &model.coefficients[static_cast<std::size_t>(*at)];
  return nullptr;
}

std::vector<std::string> motion_and_body_keys(const Case::Motion& motion) {
  if (!std::holds_alternative<TwoPolarMotion>(motion))
    return {"nu", "body.J.0", "body.J.1", "body.J.2"};
  if (std::holds_alternative<TwoPolarRates<double>>(std::get<TwoPolarMotion>(motion)))
    return {"motion.omega", "motion.theta_dot", "body.J.2"};
  return {"motion.s3", "motion.p_theta", "body.J.2"};
}

constexpr double most = 1e90;     // of J, a coefficient, and V/J
constexpr double fastest = 1e45;  // its square is one of V/J

bool within(double x, double limit) {
  return x == 0.0 || (std::abs(x) <= limit && std::abs(x) >= 1.0 / limit);
}

/// The motion's numbers, by their keys.
std::vector<std::pair<std::string, double>> motion_numbers(const Case::Motion& motion) {
  const auto one = [](double nu) {
    return std::vector<std::pair<std::string, double>>{{"motion.nu", nu}};
  };
  if (const auto* axis = std::get_if<AxisRotation>(&motion)) return one(axis->nu);
  if (const auto* tilted = std::get_if<TiltedMotion>(&motion)) return one(tilted->nu);
  if (const auto* oblique = std::get_if<ObliqueRotation>(&motion)) return one(oblique->nu);
  const auto& two_polar = std::get<TwoPolarMotion>(motion);
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&two_polar))
    return {{"motion.omega", rates->omega}, {"motion.theta_dot", rates->theta_dot}};
  const auto& momenta = std::get<TwoPolarMomenta<double>>(two_polar);
  return {{"motion.s3", momenta.s3}, {"motion.p_theta", momenta.p_theta}};
}

}  // namespace

std::optional<OutOfScale> out_of_scale(const FamilyParameters& family) {
  const auto range = [](double limit) {
    return fmt::format("numbers from {:g} to {:g}", 1.0 / limit, limit);
  };
  const Body& J = family.body;
  for (const double each : {J.J1, J.J2, J.J3})
    if (!within(each, most))
      return OutOfScale{"body.J", fmt::format("found {}", each), range(most)};
  for (const auto& [key, value] : motion_numbers(family.motion)) {
    const double limit = key == "motion.s3" || key == "motion.p_theta" ? most : fastest;
    if (!(std::abs(value) <= limit))
      return OutOfScale{key, fmt::format("found {}", value),
                        fmt::format("numbers of at most {:g}", limit)};
  }
  double largest = 0.0;
  for (const ModelChoice& model : family.models) {
    if (model.tape) continue;  // its numbers may be anything
    for (std::size_t k = 0; k < model.coefficients.size(); ++k) {
      const std::string& name = model.description.parameters[k];
      if (name == "degrees") continue;
      if (!within(model.coefficients[k], most))
        return OutOfScale{"potential." + model.slot + '.' + name,
                          fmt::format("found {}", model.coefficients[k]), range(most)};
      if (name != "rest") largest = std::max(largest, std::abs(model.coefficients[k]));
    }
  }
  if (largest > 0.0 && (largest / most > std::min({J.J1, J.J2, J.J3}) ||
                        std::max({J.J1, J.J2, J.J3}) / most > largest))
    return OutOfScale{"body.J",
                      fmt::format("found [{}, {}, {}] beside coefficients of the potential of {}",
                                  J.J1, J.J2, J.J3, largest),
                      fmt::format("ratios from {:g} to {:g}", 1.0 / most, most)};
  return std::nullopt;
}

std::vector<std::string> case_parameters(const Case::Motion& motion,
                                         const std::vector<ModelChoice>& models) {
  if (std::holds_alternative<TiltedMotion>(motion)) return {"nu"};
  std::vector<std::string> out = motion_and_body_keys(motion);
  for (const ModelChoice& model : models)
    for (const std::string& parameter : model.description.parameters)
      out.push_back("potential." + model.slot + '.' + parameter);
  return out;
}

FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value) {
  double* number = find_number(family, key);
  if (number == nullptr) throw std::invalid_argument("a parameter of the case");
  if (!std::isfinite(value)) throw std::invalid_argument(std::string(key) + " finite");
  *number = value;
  family.body = Body(family.body.J1, family.body.J2, family.body.J3);  // its domain
  make_potential(family.models);
  if (const auto fault = out_of_scale(family))
    throw std::invalid_argument(fault->allowed + " (" + OutOfScale::hint + ")");
  return family;
}

double parameter_value(FamilyParameters family, std::string_view key) {
  const double* number = find_number(family, key);
  if (number == nullptr) throw std::invalid_argument("a parameter of the case");
  return *number;
}

FamilyParameter family_parameter(std::string_view key, const std::vector<ModelChoice>& models) {
  using Kind = FamilyParameter::Kind;
  constexpr std::string_view inertia = "body.J.";
  if (key.starts_with(inertia)) return {Kind::inertia, key[inertia.size()] - '0'};
  for (const ModelChoice& model : models) {
    const auto at = coefficient_index(model, key);
    if (!at) continue;
    if (model.description.kind == ModelDescription::Kind::fibre) {
      // Fibres come last: k and degrees of each.
      const bool second = &model != models.data() &&
                          (&model - 1)->description.kind == ModelDescription::Kind::fibre;
      return {Kind::fibre, *at + (second ? 2 : 0)};
    }
    if (model.parts && !anisotropic(models)) return {Kind::shared, *at};
    return {model.slot == "thickness" ? Kind::thickness : Kind::plane, *at};
  }
  const bool second = key == "motion.theta_dot" || key == "motion.p_theta";
  return {Kind::nu, second ? 1 : 0};
}

}  // namespace stationary
