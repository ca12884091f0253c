#include "solver/program/case/case_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solver/kind/kind.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary {

namespace {

/// The number of the motion with this key, or nullptr.
double* motion_number(Motion& motion, std::string_view key) {
  for (const MotionNumber& each : motion_numbers(motion))
    if (each.parameter == key) return each.value;
  return nullptr;
}

/// Which coefficient of the model a key names.
std::optional<int> coefficient_index(const ModelChoice& model, std::string_view key) {
  const auto& names = model.description.parameters;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (key == coefficient_key(model, names[k])) return static_cast<int>(k);
  return std::nullopt;
}

/// The number a key names, or nullptr.
double* find_number(FamilyParameters& family, std::string_view key) {
  if (double* number = motion_number(family.motion, key)) return number;
  Body& J = family.body;
  if (key == "body.J.2") return &J.J3;
  if (!keeps_round(family.motion)) {
    if (key == "body.J.0") return &J.J1;
    if (key == "body.J.1") return &J.J2;
  }
  for (ModelChoice& model : family.models)
    if (const auto at = coefficient_index(model, key))
      return &model.coefficients[static_cast<std::size_t>(*at)];
  return nullptr;
}

std::vector<std::string> motion_and_body_keys(Motion motion) {
  std::vector<std::string> out;
  for (const MotionNumber& each : motion_numbers(motion)) out.emplace_back(each.parameter);
  if (!keeps_round(motion)) out.insert(out.end(), {"body.J.0", "body.J.1"});
  out.emplace_back("body.J.2");
  return out;
}

constexpr double most = 1e90;       // of J, a coefficient, and V/J
constexpr double fastest = 1e45;    // its square is one of V/J
constexpr double slowest = 1e-100;  // modes of the size of its square keep their digits

bool within(double x, double limit) {
  return x == 0.0 || (std::abs(x) <= limit && std::abs(x) >= 1.0 / limit);
}

}  // namespace

FamilyParameters own_numbers(const Case& input) { return {input.body, input.models, input.motion}; }

std::unique_ptr<Kind> kind_of(const FamilyParameters& at) {
  return kind_of(at.body, make_potential(at.models, at.body), at.motion);
}

std::optional<OutOfScale> out_of_scale(const FamilyParameters& family) {
  const auto range = [](double limit) {
    return fmt::format("numbers from {:g} to {:g}", 1.0 / limit, limit);
  };
  const Body& J = family.body;
  const std::array inertias{J.J1, J.J2, J.J3};
  for (std::size_t k = 0; k < inertias.size(); ++k)
    if (!within(inertias[k], most))
      return OutOfScale{fmt::format("body.J.{}", k), fmt::format("found {}", inertias[k]),
                        range(most)};
  Motion motion = family.motion;
  for (const auto& [parameter, value, momentum] : motion_numbers(motion)) {
    const double limit = momentum ? most : fastest;
    const double size = std::abs(*value);
    if (!(size == 0.0 || (size >= slowest && size <= limit)))
      return OutOfScale{parameter == "nu" ? "motion.nu" : std::string(parameter),
                        fmt::format("found {}", *value),
                        fmt::format("0 or numbers from {:g} to {:g}", slowest, limit)};
  }
  double largest = 0.0;
  for (const ModelChoice& model : family.models) {
    if (model.tape) continue;  // its numbers may be anything
    for (std::size_t k = 0; k < model.coefficients.size(); ++k) {
      const std::string& name = model.description.parameters[k];
      if (name == "degrees") {
        constexpr double most_degrees = 1e6;
        if (std::abs(model.coefficients[k]) > most_degrees)
          return OutOfScale{coefficient_key(model, name),
                            fmt::format("found {}", model.coefficients[k]),
                            fmt::format("numbers from {:g} to {:g}", -most_degrees, most_degrees),
                            "beyond, a number hardly tells one direction from another"};
        continue;
      }
      if (!within(model.coefficients[k], most))
        return OutOfScale{coefficient_key(model, name),
                          fmt::format("found {}", model.coefficients[k]), range(most)};
      if (name != "rest" && model.description.kind != ModelDescription::Kind::whole)
        largest = std::max(largest, std::abs(model.coefficients[k]));
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

std::vector<std::string> case_parameters(const Motion& motion,
                                         const std::vector<ModelChoice>& models) {
  std::vector<std::string> out = motion_and_body_keys(motion);
  for (const ModelChoice& model : models)
    for (const std::string& parameter : model.description.parameters)
      out.push_back(coefficient_key(model, parameter));
  return out;
}

std::vector<std::string> followed_parameters(const Motion& motion,
                                             const std::vector<ModelChoice>& models) {
  const bool sheared = name(motion) == oblique_name && !anisotropic(models);
  if (sheared || is_followed_in_nu_alone(motion)) return {"nu"};
  return case_parameters(motion, models);
}

ParameterParts parts_of(std::string_view parameter) {
  const std::size_t slash = parameter.find('/');
  if (slash == std::string_view::npos) return {parameter, {}};
  return {parameter.substr(0, slash), parameter.substr(slash + 1)};
}

std::string read_parameter_name(const CaseTree& tree, const std::string& key, std::string found,
                                const std::vector<std::string>& valid, bool or_ratio) {
  const std::vector<std::string_view> names(valid.begin(), valid.end());
  const auto named = [&](std::string_view part) {
    // The dotted key of the same number.
    const std::string_view name = part == "motion.nu" ? "nu" : part;
    const bool absent = (part == "gravity.g" || part == "body.volume") && !find(tree, part);
    if (std::ranges::find(names, name) == names.end())
      throw fault_at(tree, key, "found the string " + in_quotes(found),
                     or_ratio && names.size() > 1
                         ? "one of " + listed(names) + ", or a ratio \"a/b\" of two of them"
                         : "one of " + listed(names),
                     absent ? "the case has no " + std::string(part) + " to begin with"
                            : did_you_mean(nearest_name(part, names)));
    return std::string(name);
  };
  const bool ratio = found.find('/') != std::string::npos;
  const ParameterParts parts = parts_of(found);
  if (!ratio) return named(parts.first);
  const std::string first = named(parts.first);
  const std::string second = named(parts.second);
  if (first == second)
    throw fault_at(tree, key, "found the string " + in_quotes(found),
                   "a ratio of two different numbers");
  return first + '/' + second;
}

double parameter_unit(const FamilyParameters& family, std::string_view parameter) {
  const std::string_view second = parts_of(parameter).second;
  return second.empty() ? 1.0 : parameter_value(family, second);
}

namespace {

/// Its domain is left to be looked at.
void set_parameter(FamilyParameters& family, std::string_view key, double value) {
  if (const auto [first, second] = parts_of(key); !second.empty()) {
    const double unit = parameter_value(family, second);
    if (!(unit > 0.0)) throw std::invalid_argument(std::string(second) + " > 0, to be divided by");
    set_parameter(family, first, value * unit);
    return;
  }
  double* number = find_number(family, key);
  if (number == nullptr) throw std::invalid_argument("a parameter of the case");
  if (!std::isfinite(value)) throw std::invalid_argument(std::string(key) + " finite");
  if (nu_is_length(family.motion) && key == "nu" && value < 0.0)
    throw std::invalid_argument("nu >= 0 (it is the length |nu| there)");
  *number = value;
}

}  // namespace

FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value) {
  return with_parameters(std::move(family), std::array{ParameterValue{key, value}});
}

FamilyParameters with_parameters(FamilyParameters family, std::span<const ParameterValue> values) {
  const auto waits = [&](const ParameterValue& each) {
    return std::ranges::any_of(values, [&](const ParameterValue& other) {
      return parts_of(each.parameter).second == parts_of(other.parameter).first;
    });
  };
  for (const bool waiting : {false, true})
    for (const ParameterValue& each : values)
      if (waits(each) == waiting) set_parameter(family, each.parameter, each.value);
  family.body = Body(family.body.J1, family.body.J2, family.body.J3);  // its domain
  make_potential(family.models, family.body);
  if (const auto fault = out_of_scale(family))
    throw std::invalid_argument(fault->allowed + " (" + fault->hint + ")");
  return family;
}

std::size_t refused_of(const FamilyParameters& family, std::span<const ParameterValue> values) {
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    try {
      (void)with_parameters(family, values.subspan(k, 1));
    } catch (const std::invalid_argument&) {
      return k;
    }
  }
  return values.size() - 1;
}

double parameter_value(FamilyParameters family, std::string_view key) {
  if (const auto [first, second] = parts_of(key); !second.empty())
    return parameter_value(family, first) / parameter_value(family, second);
  const double* number = find_number(family, key);
  if (number == nullptr) throw std::invalid_argument("a parameter of the case");
  return *number;
}

FamilyParameter family_parameter(std::string_view parameter,
                                 const std::vector<ModelChoice>& models) {
  const std::string_view key = parts_of(parameter).first;
  using Kind = FamilyParameter::Kind;
  constexpr std::string_view inertia = "body.J.";
  if (key.starts_with(inertia)) return {Kind::inertia, key[inertia.size()] - '0'};
  for (const ModelChoice& model : models) {
    const auto at = coefficient_index(model, key);
    if (!at) continue;
    if (model.description.kind == ModelDescription::Kind::fibre) {
      // k and degrees of each.
      const bool second = &model != models.data() &&
                          (&model - 1)->description.kind == ModelDescription::Kind::fibre;
      return {Kind::fibre, *at + (second ? 2 : 0)};
    }
    if (model.description.kind == ModelDescription::Kind::whole ||
        (is_whole_body(models) && !anisotropic(models)))
      return {Kind::plane, place_in_body(model, *at)};
    if (model.parts && !anisotropic(models)) return {Kind::shared, *at};
    return {model.slot == "thickness" ? Kind::thickness : Kind::plane, *at};
  }
  const bool second = key == "motion.theta_dot" || key == "motion.p_theta";
  return {Kind::nu, second ? 1 : 0};
}

}  // namespace stationary
