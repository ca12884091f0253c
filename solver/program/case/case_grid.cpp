#include "solver/program/case/case_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/number/elementary.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary {
namespace {

/// What of an axis does not depend on the motion.
MapAxis read_axis(const CaseTree& tree, const std::string& key, Faults& faults) {
  const auto node = tree.root().at_path(key);
  MapAxis out{.parameter = node["parameter"].value_or(std::string()),
              .from = node["from"].value_or(0.0),
              .to = node["to"].value_or(0.0),
              .count = 0};
  if (node["from"] && node["to"] && faults.sound(key + ".from") && faults.sound(key + ".to") &&
      !(out.from < out.to)) {
    faults.add(fault_at(tree, key + ".to",
                        fmt::format("found the empty range from {} to {}", out.from, out.to),
                        "from < to"));
  }
  const double count = node["count"].value_or(0.0);
  if (count >= 2.0 && count <= most_map_cells && count == std::floor(count)) {
    out.count = static_cast<std::size_t>(count);
  } else if (node["count"] && faults.sound(key + ".count")) {
    faults.add(fault_at(tree, key + ".count", fmt::format("found {}", count),
                        fmt::format("a whole number from 2 to {}", most_map_cells)));
  }
  if (node["scale"].value_or(std::string_view()) == name(AxisScale::log)) {
    out.scale = AxisScale::log;
    if (node["from"] && faults.sound(key + ".from") && !(out.from > 0.0)) {
      faults.add(fault_at(tree, key + ".from",
                          fmt::format("found {} with scale = \"log\"", out.from), "from > 0"));
    }
  }
  return out;
}

/// The domains are convex, so the corners answer for all of the grid.
void require_domain(const CaseTree& tree, const CaseMap& map, const FamilyParameters& family) {
  const std::vector<const MapAxis*> axes = map.axes();
  for (const double x : {map.x.from, map.x.to}) {
    for (const double y : {map.y ? map.y->from : 0.0, map.y ? map.y->to : 0.0}) {
      const std::vector<ParameterValue> corner = map.values_at(x, y);
      try {
        (void)with_parameters(family, corner);
      } catch (const std::invalid_argument& error) {
        const std::size_t k = refused_of(family, corner);
        const MapAxis& axis = *axes[k];
        throw fault_at(tree,
                       fmt::format("map.{}.{}", k == 0 ? "x" : "y",
                                   corner[k].value == axis.to ? "to" : "from"),
                       fmt::format("found {} = {}", axis.parameter, corner[k].value), error.what());
      }
    }
  }
}

}  // namespace

std::vector<double> MapAxis::values() const {
  std::vector<double> out(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(count - 1);
    if (scale != AxisScale::log) {
      out[k] = from + (to - from) * part;
    } else if (const double whole = to / from; std::isfinite(whole)) {
      out[k] = from * pow(whole, part);
    } else {  // of numbers whose ratio is none
      out[k] = exp(log(from) + part * (log(to) - log(from)));
    }
  }
  out.back() = to;
  return out;
}

std::string axis_text(const MapAxis& axis) {
  return fmt::format("{} from {} to {}, {} values{}", axis.parameter, axis.from, axis.to,
                     axis.count, axis.scale == AxisScale::log ? ", logarithmic" : "");
}

std::vector<const MapAxis*> CaseMap::axes() const {
  std::vector<const MapAxis*> out{&x};
  if (y) out.push_back(&*y);
  return out;
}

bool is_divided_by(const MapAxis& x, const MapAxis& y) {
  return parts_of(x.parameter).second == parts_of(y.parameter).first;
}

std::vector<ParameterValue> CaseMap::values_at(double at_x, double at_y) const {
  std::vector<ParameterValue> out{{x.parameter, at_x}};
  if (y) out.push_back({y->parameter, at_y});
  return out;
}

FamilyParameters CaseMap::cell(const FamilyParameters& family, double at_x, double at_y) const {
  return with_parameters(family, values_at(at_x, at_y));
}

std::optional<CaseMap> read_map(const CaseTree& tree, const FamilyParameters* family,
                                Faults& faults) {
  if (!tree.root().contains("map") || !tree.root()["map"].is_table() ||
      !tree.root().at_path("map.x").is_table())
    return std::nullopt;
  CaseMap out{read_axis(tree, "map.x", faults), std::nullopt};
  if (tree.root().at_path("map.y").is_table()) out.y = read_axis(tree, "map.y", faults);
  if (out.y && out.x.count > 0 && out.y->count > most_map_cells / out.x.count) {
    faults.add(fault_at(tree, "map.y.count",
                        fmt::format("found {} by {} cells", out.x.count, out.y->count),
                        fmt::format("at most {} cells", most_map_cells)));
  }
  if (family == nullptr) return std::nullopt;
  const std::vector<std::string> valid = case_parameters(family->motion, family->models);
  const auto named = [&](MapAxis& axis, const std::string& key) {
    if (find(tree, key) != nullptr && faults.sound(key))
      faults.collect(
          [&] { axis.parameter = read_parameter_name(tree, key, axis.parameter, valid); });
  };
  named(out.x, "map.x.parameter");
  if (out.y) named(*out.y, "map.y.parameter");
  if (!faults.sound("map")) return std::nullopt;
  if (out.y && parts_of(out.y->parameter).first == parts_of(out.x.parameter).first) {
    faults.add(fault_at(tree, "map.y.parameter",
                        "found " + in_quotes(out.y->parameter) + ", which is x's too",
                        "another parameter than x's"));
  } else if (out.y && is_divided_by(out.x, *out.y) && is_divided_by(*out.y, out.x)) {
    faults.add(fault_at(tree, "map.y.parameter",
                        "found " + in_quotes(out.y->parameter) + ", each divided by the other",
                        "a number, or a ratio to another number than x's"));
  } else {
    faults.collect([&] { require_domain(tree, out, *family); });
  }
  return out;
}

}  // namespace stationary
