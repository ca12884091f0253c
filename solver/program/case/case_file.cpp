#include "solver/program/case/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <utility>

#include "solver/continuation/step_control.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_motion_table.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/case/case_solve.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/text/named.hpp"
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
  constexpr StepOptions steps;
  require("step", out.step >= steps.min && out.step <= steps.max, fmt::format("found {}", out.step),
          std::string(find_case_key("continuation.step")->allowed));
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

using Ends = std::array<ParameterValue, 2>;

/// The numbers that vary, each at both ends of its range: together, one set for each corner.
std::vector<std::vector<ParameterValue>> ends_of(
    const std::optional<Case::Continuation>& continuation, const std::optional<CaseMap>& map,
    const std::optional<CaseCurve>& curve) {
  std::vector<std::vector<ParameterValue>> out;
  const auto add = [&](const std::vector<Ends>& axes) {
    std::vector<std::vector<ParameterValue>> corners(1);
    for (const Ends& ends : axes) {
      std::vector<std::vector<ParameterValue>> more;
      for (const auto& corner : corners)
        for (const ParameterValue& end : ends) {
          more.push_back(corner);
          more.back().push_back(end);
        }
      corners = std::move(more);
    }
    out.insert(out.end(), corners.begin(), corners.end());
  };
  const auto ends = [](const std::string& key, double from, double to) {
    return Ends{ParameterValue{key, from}, ParameterValue{key, to}};
  };
  if (continuation) add({ends(continuation->parameter, continuation->from, continuation->to)});
  std::vector<Ends> axes;
  if (map)
    for (const MapAxis* axis : map->axes())
      axes.push_back(ends(axis->parameter, axis->from, axis->to));
  add(axes);
  axes.clear();
  for (std::size_t k = 0; curve && k < curve->parameters.size(); ++k)
    axes.push_back(ends(curve->parameters[k], curve->from[k], curve->to[k]));
  add(axes);
  return out;
}

/// Whether a body that is a fluid as it is written is one wherever its numbers vary.
bool stays_fluid(const FamilyParameters& family,
                 const std::vector<std::vector<ParameterValue>>& ends) {
  const auto is_elastic = [](const ParameterValue& each) {
    return parts_of(each.parameter).first.starts_with("potential.");
  };
  return std::ranges::all_of(ends, [&](const std::vector<ParameterValue>& corner) {
    if (std::ranges::none_of(corner, is_elastic)) return true;
    try {
      const FamilyParameters there = with_parameters(family, corner);
      return is_fluid(make_potential(there.models, there.body));
    } catch (const std::invalid_argument&) {
      return true;  // no body at all
    }
  });
}

/// Whether S is told in other coordinates than the body's that is computed.
bool is_told_in_others(const CaseTree& tree, const FamilyParameters& family,
                       const Potential& potential,
                       const std::vector<std::vector<ParameterValue>>& ends) {
  const Body& body = family.body;
  if ((body.J1 == body.J2 && body.J2 == body.J3) || !is_fluid(potential)) return false;
  const bool inertia_varies = std::ranges::any_of(ends, [](const auto& corner) {
    return std::ranges::any_of(corner, [](const ParameterValue& each) {
      return each.parameter.find("body.J.") != std::string_view::npos;
    });
  });
  if (inertia_varies && !body.symmetric())
    throw fault_at(tree, "body.J", fmt::format("found J1 = {}, J2 = {}", body.J1, body.J2),
                   "J1 = J2 of a fluid whose J is followed",
                   "its J is a choice of material coordinates: S sqrt(J) is the same motion");
  return !inertia_varies && stays_fluid(family, ends);
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
        read_parameter_name(tree, "output.uncertainty", std::string(key.str()), valid, false);
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
  for (const std::string& each : events) out.add(named<EventType>(event_names, each).value());
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
      faults.add(fault_at(tree, fault->key, fault->found, fault->allowed, fault->hint));
      family.reset();
    }
  }
  const Case::Solve own_solve = read_solve(tree, motion, models, faults);
  Case::Solve solve = own_solve;
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
      if (!is_told_in_others(tree, *family, *potential, ends_of(continuation, map, curve))) return;
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
          .own_solve = own_solve,
          .solve = std::move(solve),
          .continuation = continuation,
          .map = map,
          .curve = curve,
          .atlas = atlas,
          .output = std::move(output),
          .source = std::move(tree)};
}

}  // namespace stationary
