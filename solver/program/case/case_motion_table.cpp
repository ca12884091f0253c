#include "solver/program/case/case_motion_table.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "solver/program/case/case_schema.hpp"

namespace stationary {
namespace {

/// Those of these keys that the motion has: they are not the branch's.
void refuse_keys(const CaseTree& tree, std::initializer_list<std::string_view> keys,
                 std::string_view branch, std::string_view instead, Faults& faults) {
  for (const std::string_view key : keys) {
    const std::string path = dotted("motion", key);
    if (find(tree, path) == nullptr) continue;
    faults.add(InputError(tree.key_origin(path), path,
                          fmt::format("found {}, which branch \"{}\" does not take", key, branch),
                          std::string(instead), fmt::format("remove {}", key)));
  }
}

/// motion.nu, of a branch that takes it and no other number, and none of these keys.
double read_nu(const CaseTree& tree, std::initializer_list<std::string_view> others,
               std::string_view branch, std::string_view meaning) {
  Faults faults;
  refuse_keys(tree, others, branch, meaning, faults);
  refuse_keys(tree, {"omega", "theta_dot", "s3", "p_theta"}, branch, meaning, faults);
  faults.raise();
  if (find(tree, "motion.nu") == nullptr) {
    throw fault_at(tree, "motion.nu", "found no such key",
                   std::string(find_case_key("motion.nu")->allowed), "add nu in [motion]");
  }
  return value_or(tree, "motion.nu", 0.0);
}

/// Branches whose mechanics ask for an isotropic potential, or for another.
void require_symmetry(const CaseTree& tree, std::string_view branch, bool asks_isotropic,
                      const std::vector<ModelChoice>& models) {
  const bool gravitates = find(tree, "gravity") != nullptr;
  if (asks_isotropic != anisotropic(models) || (!asks_isotropic && gravitates)) return;
  throw fault_at(
      tree, "motion.branch",
      fmt::format("found the string {} with an {} potential", in_quotes(branch),
                  asks_isotropic ? "anisotropic" : "isotropic"),
      asks_isotropic ? "one of \"i\", \"ii\", \"iii\", \"oblique\""
                     : "one of \"i\", \"ii\", \"iii\", \"tilted\", or \"two-polar\" where J1 = J2",
      asks_isotropic ? "its equations are an isotropic potential's"
                     : "oblique motions are had of a potential with directions of its own, or with "
                       "gravity");
}

AxisRotation read_axis_rotation(const CaseTree& tree, Branch branch) {
  constexpr std::string_view meaning = "nu (the spin along the branch's axis)";
  return {branch, read_nu(tree, {"plane", "axis"}, name(branch), meaning)};
}

/// motion.nu as the length of a vector.
double read_length(const CaseTree& tree, std::initializer_list<std::string_view> others,
                   std::string_view branch, std::string_view meaning) {
  const double nu = read_nu(tree, others, branch, meaning);
  if (nu > 0.0) return nu;
  throw fault_at(tree, "motion.nu",
                 fmt::format("found nu = {} with branch {}", nu, in_quotes(branch)), "nu > 0",
                 "it is the length |nu| of a vector");
}

/// isotropic: its family is connected with neither axis at rest.
ObliqueRotation read_oblique(const CaseTree& tree, bool isotropic) {
  constexpr std::string_view of_both = "nu (its length |nu|), and axis";
  constexpr std::string_view without_axis =
      "nu (its length |nu|), and of a potential with directions of its own axis";
  ObliqueRotation out{isotropic ? read_length(tree, {"plane", "axis"}, oblique_name, without_axis)
                                : read_length(tree, {"plane"}, oblique_name, of_both)};
  const std::string axis = value_or<std::string>(tree, "motion.axis", "");
  if (!axis.empty()) out.near = axis == "1" ? Branch::i : Branch::ii;
  return out;
}

Motion read_tilted(const CaseTree& tree) {
  constexpr std::string_view meaning = "nu (its length |nu|), and plane";
  TiltedMotion out{{}, read_length(tree, {"axis"}, tilted_name, meaning)};
  const std::string plane = value_or<std::string>(tree, "motion.plane", "");
  if (plane == spatial_plane_name) {
    return SpatialRotation{out.nu};
  }
  for (const TiltPlane each : {TiltPlane::one_three, TiltPlane::two_three})
    if (plane == name(each)) out.plane = each;
  return out;
}

constexpr std::string_view two_polar_numbers = "omega and theta_dot, or s3 and p_theta";

/// The one of its two pairs of numbers that the motion has.
TwoPolarMotion read_pair(const CaseTree& tree) {
  constexpr std::string_view rule = two_polar_numbers;
  struct Pair {
    std::string_view first;
    std::string_view second;
    bool has_first;
    bool has_second;
    bool any() const { return has_first || has_second; }
    std::string_view given() const { return has_first ? first : second; }
    std::string_view missing() const { return has_first ? second : first; }
  };
  const auto pair = [&](std::string_view first, std::string_view second) {
    return Pair{first, second, find(tree, dotted("motion", first)) != nullptr,
                find(tree, dotted("motion", second)) != nullptr};
  };
  const Pair rates = pair("omega", "theta_dot");
  const Pair momenta = pair("s3", "p_theta");
  if (!rates.any() && !momenta.any()) {
    throw fault_at(tree, "motion", "found none of omega, theta_dot, s3, p_theta", std::string(rule),
                   "add one of the two pairs");
  }
  if (rates.any() && momenta.any()) {
    const std::string key = dotted("motion", momenta.given());
    throw InputError(tree.key_origin(key), key,
                     fmt::format("found both {} and {}", rates.given(), momenta.given()),
                     std::string(rule), "keep one of the two pairs");
  }
  const Pair& chosen = rates.any() ? rates : momenta;
  if (!chosen.has_first || !chosen.has_second) {
    throw fault_at(tree, dotted("motion", chosen.missing()),
                   fmt::format("found {} alone", chosen.given()), std::string(rule),
                   fmt::format("add {} in [motion]", chosen.missing()));
  }
  const double first = value_or(tree, dotted("motion", chosen.first), 0.0);
  const double second = value_or(tree, dotted("motion", chosen.second), 0.0);
  if (rates.any()) return TwoPolarRates<double>{first, second};
  return TwoPolarMomenta<double>{first, second};
}

TwoPolarMotion read_two_polar(const CaseTree& tree, const std::optional<Body>& body) {
  Faults faults;
  TwoPolarMotion out;
  refuse_keys(tree, {"nu", "plane", "axis"}, two_polar_name,
              fmt::format("{}, instead", two_polar_numbers), faults);
  faults.collect([&] { out = read_pair(tree); });
  if (body && !body->symmetric())
    faults.add(
        fault_at(tree, "body.J", fmt::format("found J1 = {}, J2 = {}", body->J1, body->J2),
                 "J1 = J2 in branch \"two-polar\"",
                 "these motions exist because material rotations about axis 3 are a symmetry"));
  faults.raise();
  return out;
}

}  // namespace

Motion read_motion(const CaseTree& tree, const std::optional<Body>& body,
                   const std::optional<std::vector<ModelChoice>>& models) {
  const std::string named = value_or<std::string>(tree, "motion.branch", "");
  if (const auto branch = branch_from_name(named)) return read_axis_rotation(tree, *branch);
  if (models) require_symmetry(tree, named, named != oblique_name, *models);
  if (named == oblique_name) return read_oblique(tree, models && !anisotropic(*models));
  if (named == tilted_name) return read_tilted(tree);
  return read_two_polar(tree, body);
}

}  // namespace stationary
