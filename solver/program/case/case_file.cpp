#include "solver/program/case/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/case/case_solve.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/text/nearest_name.hpp"
#include "solver/program/text/row_name.hpp"

namespace stationary {
namespace {

/// Nothing where the faults have something against it; so below.
std::optional<Body> read_body(const CaseTree& tree, Faults& faults) {
  const std::vector<double> J = numbers(tree, "body.J");
  if (J.size() != 3 || !faults.sound("body")) return std::nullopt;
  for (std::size_t k = 0; k < J.size(); ++k) {
    if (J[k] > 0.0) continue;
    faults.add(fault_at(tree, fmt::format("body.J.{}", k),
                        fmt::format("found J{} = {}", k + 1, J[k]), fmt::format("J{} > 0", k + 1)));
  }
  if (!faults.sound("body")) return std::nullopt;
  return Body(J[0], J[1], J[2]);
}

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
  throw fault_at(tree, "motion.branch",
                 fmt::format("found the string {} with an {} potential", in_quotes(branch),
                             asks_isotropic ? "anisotropic" : "isotropic"),
                 asks_isotropic ? "one of \"i\", \"ii\", \"iii\", \"oblique\""
                                : "one of \"i\", \"ii\", \"iii\", \"tilted\", \"two-polar\"",
                 asks_isotropic
                     ? "its equations are an isotropic potential's"
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

Motion read_motion(const CaseTree& tree, const std::optional<Body>& body,
                   const std::optional<std::vector<ModelChoice>>& models) {
  const std::string named = value_or<std::string>(tree, "motion.branch", "");
  if (const auto branch = branch_from_name(named)) return read_axis_rotation(tree, *branch);
  if (models) require_symmetry(tree, named, named != oblique_name, *models);
  if (named == oblique_name) return read_oblique(tree, models && !anisotropic(*models));
  if (named == tilted_name) return read_tilted(tree);
  return read_two_polar(tree, body);
}

std::string read_parameter(const CaseTree& tree, const FamilyParameters& family) {
  const std::vector<std::string> valid = followed_parameters(family.motion, family.models);
  // Of a motion without nu it has to be given.
  const bool has_nu = std::ranges::find(valid, "nu") != valid.end();
  if (!has_nu && find(tree, "continuation.parameter") == nullptr) {
    throw fault_at(tree, "continuation.parameter", "found no such key",
                   "one of " + listed(std::vector<std::string_view>(valid.begin(), valid.end())),
                   "add parameter in [continuation]");
  }
  return read_parameter_name(tree, "continuation.parameter",
                             value_or<std::string>(tree, "continuation.parameter", "nu"), valid);
}

/// The names of an array of texts, each one of the allowed.
std::vector<std::string> read_names(const CaseTree& tree, const std::string& key,
                                    std::span<const std::string_view> allowed) {
  std::vector<std::string> out;
  const toml::node* names = find(tree, key);
  if (names == nullptr) return out;
  for (const toml::node& element : *names->as_array()) {
    const std::string& name = element.as_string()->get();
    if (std::ranges::find(allowed, name) == allowed.end()) {
      throw fault_at(tree, fmt::format("{}.{}", key, out.size()),
                     "found the string " + in_quotes(name), "names of " + listed(allowed),
                     did_you_mean(nearest_name(name, allowed)));
    }
    out.push_back(name);
  }
  return out;
}

/// Names of all events but the ends of a sheet.
std::span<const std::string_view> locatable_events() {
  return std::span(event_names).subspan(1, static_cast<std::size_t>(EventType::unexplained));
}

/// What of the range depends on the family.
void require_range(const CaseTree& tree, const Case::Continuation& range,
                   const FamilyParameters& family) {
  if (nu_is_length(family.motion) && range.parameter == "nu" && !(range.from >= 0.0)) {
    throw fault_at(
        tree, "continuation.from",
        fmt::format("found {} with branch {}", range.from, in_quotes(name(family.motion))),
        "from >= 0", "nu is the length |nu| there");
  }
  // Both domains are convex, so the ends of the range answer for all of it.
  for (const bool end : {false, true}) {
    const double value = end ? range.to : range.from;
    try {
      (void)with_parameter(family, range.parameter, value);
    } catch (const std::invalid_argument& error) {
      throw fault_at(tree, end ? "continuation.to" : "continuation.from",
                     fmt::format("found {} = {}", range.parameter, value), error.what());
    }
  }
}

/// family: nothing where something else is wrong with it.
std::optional<Case::Continuation> read_continuation(const CaseTree& tree,
                                                    const std::optional<FamilyParameters>& family,
                                                    Faults& faults) {
  if (find(tree, "continuation") == nullptr) return std::nullopt;
  Case::Continuation out{.parameter = {},
                         .from = value_or(tree, "continuation.from", 0.0),
                         .to = value_or(tree, "continuation.to", 0.0)};
  out.tolerance = value_or(tree, "continuation.tolerance", out.tolerance);
  out.step = value_or(tree, "continuation.step", out.step);
  out.max_points = value_or(tree, "continuation.max_points", out.max_points);
  const auto require = [&](std::string_view name, bool holds, const std::string& found,
                           const std::string& allowed) {
    const std::string key = dotted("continuation", name);
    if (!holds && faults.sound(key)) faults.add(fault_at(tree, key, found, allowed));
  };
  const bool has_range = find(tree, "continuation.from") != nullptr &&
                         find(tree, "continuation.to") != nullptr &&
                         faults.sound("continuation.from");
  if (has_range)
    require("to", out.from < out.to,
            fmt::format("found the empty range from {} to {}", out.from, out.to), "from < to");
  require("tolerance", out.tolerance > 0.0 && out.tolerance <= 1.0,
          fmt::format("found {}", out.tolerance),
          "a number > 0 and <= 1 (1e-13 is the least that double precision keeps)");
  require("step", out.step > 0.0 && out.step <= 0.5, fmt::format("found {}", out.step),
          "a number > 0 and <= 0.5");
  constexpr double most_points = 1e8;  // those of one direction are kept until the other is known
  require("max_points",
          out.max_points >= 2.0 && out.max_points <= most_points &&
              out.max_points == std::floor(out.max_points),
          fmt::format("found {}", out.max_points),
          fmt::format("a whole number from 2 to {}", most_points));
  if (faults.sound("continuation.events"))
    faults.collect(
        [&] { out.events = read_names(tree, "continuation.events", locatable_events()); });
  if (faults.sound("continuation.start_row") && find(tree, "continuation.start_row") != nullptr) {
    const auto row = value_or<std::string>(tree, "continuation.start_row", "");
    const std::filesystem::path folder = std::filesystem::path(tree.name()).parent_path();
    if (!row.empty()) out.start_row = (folder / row).string();  // beside the case file
    try {
      (void)cli::row_name(out.start_row);
    } catch (const InputError& fault) {
      faults.add(
          fault_at(tree, "continuation.start_row", fault.found(), fault.allowed(), fault.remedy()));
    }
  }
  const bool named = family && faults.sound("continuation.parameter") &&
                     faults.collect([&] { out.parameter = read_parameter(tree, *family); });
  if (named && has_range && faults.sound("continuation.to"))
    faults.collect([&] { require_range(tree, out, *family); });
  return out;
}

/// Whether one of J varies.
bool follows_inertia(const std::optional<Case::Continuation>& continuation,
                     const std::optional<CaseMap>& map, const std::optional<CaseCurve>& curve) {
  const auto is_inertia = [](std::string_view key) {
    return key.find("body.J.") != std::string_view::npos;
  };
  if (continuation && is_inertia(continuation->parameter)) return true;
  if (curve && std::ranges::any_of(curve->parameters, is_inertia)) return true;
  return map && std::ranges::any_of(
                    map->axes(), [&](const MapAxis* axis) { return is_inertia(axis->parameter); });
}

/// Whether S is told in other coordinates than the body's that is computed.
bool is_told_in_others(const CaseTree& tree, const Body& body, const Potential& potential,
                       bool inertia_varies) {
  if ((body.J1 == body.J2 && body.J2 == body.J3) || !is_fluid(potential)) return false;
  if (inertia_varies && !body.symmetric())
    throw fault_at(tree, "body.J", fmt::format("found J1 = {}, J2 = {}", body.J1, body.J2),
                   "J1 = J2 of a fluid whose J is followed",
                   "its J is a choice of material coordinates: S sqrt(J) is the same motion");
  return !inertia_varies;
}

/// In the coordinates of the body that is computed.
Case::Solve computed_in(const MaterialCoordinates& coordinates, Case::Solve solve) {
  if (solve.start) solve.start = coordinates.computed(*solve.start);
  if (solve.box)
    for (std::size_t k = 0; k < 3; ++k)
      (*solve.box)[k] = (*solve.box)[k] / Interval(coordinates.unit[k]);
  return solve;
}

/// A formula whose second derivatives, products of three of which are formed, can be computed with.
void require_scale(const CaseTree& tree, const std::vector<ModelChoice>& models,
                   const Potential& potential) {
  constexpr double most = 1e100;
  const auto written =
      std::ranges::find_if(models, [](const ModelChoice& each) { return each.tape != nullptr; });
  if (written == models.end()) return;
  for (const double r : {1.0, 0.75, 1.5}) {
    const Stretch q{0.0, r, r, r};
    if (!std::ranges::all_of(potential.conditions_at(q), &ConditionValue::holds)) continue;
    const double size = potential.derivatives(q).hessian.cwiseAbs().maxCoeff();
    if (std::isnan(size)) continue;
    if (size <= most) return;
    throw fault_at(
        tree, dotted(dotted("potential", written->slot), "expression"),
        fmt::format("found second derivatives of size {:.0e} at S = {} times the unit", size, r),
        fmt::format("at most {:.0e}", most), "V and J in larger units leave S and nu as they are");
  }
}

Case::Atlas read_atlas(const CaseTree& tree, Faults& faults) {
  Case::Atlas out;
  out.complete = value_or(tree, "atlas.complete", false);
  if (find(tree, "atlas.checkpoints") == nullptr || !faults.sound("atlas.checkpoints")) return out;
  const double asked = value_or(tree, "atlas.checkpoints", 1.0);
  if (asked >= 1.0 && asked <= most_checkpoints && asked == std::floor(asked)) {
    out.checkpoints = static_cast<int>(asked);
  } else {
    faults.add(fault_at(tree, "atlas.checkpoints", fmt::format("found {}", asked),
                        fmt::format("a whole number from 1 to {}", most_checkpoints)));
  }
  return out;
}

/// Of numbers that the case has, by their dotted keys.
std::vector<std::pair<std::string, double>> read_uncertainty(const CaseTree& tree,
                                                             const FamilyParameters& family) {
  std::vector<std::pair<std::string, double>> out;
  const toml::node* const node = find(tree, "output.uncertainty");
  if (node == nullptr) return out;
  const std::vector<std::string> valid = case_parameters(family.motion, family.models);
  for (const auto& [key, value] : *node->as_table()) {
    const std::string name =
        read_parameter_name(tree, "output.uncertainty", std::string(key.str()), valid);
    if (!parts_of(name).second.empty())
      throw fault_at(tree, "output.uncertainty", "found the ratio " + in_quotes(name),
                     "numbers of the case, each by itself");
    if (std::ranges::find(out, name, &std::pair<std::string, double>::first) != out.end())
      throw fault_at(tree, "output.uncertainty", "found " + in_quotes(name) + " by two names",
                     "each number once");
    out.emplace_back(name, *value.value<double>());
  }
  return out;
}

Case::Output read_output(const CaseTree& tree, Faults& faults) {
  Case::Output out;
  out.spectrum = value_or(tree, "output.spectrum", true);
  out.certificate = value_or(tree, "output.certificate", false);
  if (faults.sound("output.columns"))
    faults.collect([&] { out.columns = read_names(tree, "output.columns", column_names); });
  return out;
}

/// Applies them; what another model leaves no place for goes.
void apply(CaseTree& tree, std::span<const Override> overrides, Faults& faults) {
  if (overrides.empty()) return;
  const toml::node* potential = find(tree, "potential");
  const toml::table before =
      potential != nullptr && potential->is_table() ? *potential->as_table() : toml::table();
  for (const Override& each : overrides)
    faults.collect([&] { tree.override_key(each.text, each.where); });
  leave_replaced_coefficients(tree, before);
}

}  // namespace

EventSet Case::Continuation::event_set() const {
  if (events.empty()) return {};
  EventSet out = EventSet::none();
  for (const std::string& each : events) {
    const auto* const at = std::ranges::find(event_names, each);
    out.add(static_cast<EventType>(at - std::begin(event_names)));
  }
  return out;
}

Case read_case(const std::string& path, std::span<const std::string> overrides) {
  std::vector<Override> options;
  for (const std::string& each : overrides) options.push_back({each});
  return make_case(CaseTree::read(path), options);
}

Case make_case(CaseTree tree, std::span<const Override> overrides) {
  Faults faults;
  apply(tree, overrides, faults);
  require_known_keys(tree, faults);
  const std::optional<Body> body = read_body(tree, faults);
  // A table with a misspelt name is missing, and nothing is said against it.
  const auto may_read = [&](std::string_view table) {
    return find(tree, table) != nullptr && faults.sound(table);
  };
  const bool has_potential =
      find(tree, "potential") != nullptr || find(tree, "body.volume") != nullptr;
  const auto models = has_potential ? read_models(tree, faults) : std::nullopt;
  std::optional<Motion> motion;
  if (may_read("motion")) faults.collect([&] { motion = read_motion(tree, body, models); });
  std::optional<FamilyParameters> family;
  if (body && models && motion) {
    family = FamilyParameters{*body, *models, *motion};
    if (const auto fault = out_of_scale(*family)) {
      faults.add(fault_at(tree, fault->key, fault->found, fault->allowed, OutOfScale::hint));
      family.reset();
    }
  }
  Case::Solve solve = read_solve(tree, motion, models, faults);
  const auto continuation = read_continuation(tree, family, faults);
  const auto map = read_map(tree, family ? &*family : nullptr, faults);
  const auto curve = read_curve(tree, family ? &*family : nullptr, faults);
  const Case::Atlas atlas = read_atlas(tree, faults);
  Case::Output output = read_output(tree, faults);
  if (family && faults.sound("output.uncertainty"))
    faults.collect([&] { output.uncertainty = read_uncertainty(tree, *family); });
  std::optional<Potential> potential;
  MaterialCoordinates coordinates;
  std::optional<Body> computed = body;
  if (family) {
    faults.collect([&] {
      potential = make_potential(*models, *body);
      require_scale(tree, *models, *potential);
      require_alpha(tree, solve.start, *motion, *potential);
      if (!is_told_in_others(tree, *body, *potential, follows_inertia(continuation, map, curve)))
        return;
      coordinates = coordinates_of(*body);
      computed = round_body(*body);
      potential = make_potential(*models, *computed);
      solve = computed_in(coordinates, std::move(solve));
    });
  }
  faults.raise();
  return {.title = value_or<std::string>(tree, "title", ""),
          .own_body = *body,
          .body = *computed,
          .models = *models,
          .potential = std::move(*potential),
          .motion = *motion,
          .coordinates = coordinates,
          .solve = std::move(solve),
          .continuation = continuation,
          .map = map,
          .curve = curve,
          .atlas = atlas,
          .output = std::move(output),
          .source = std::move(tree)};
}

}  // namespace stationary
