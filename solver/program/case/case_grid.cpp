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

/// Whether y's number has to be there before x's can be had from it.
bool is_divided_by(const MapAxis& x, const MapAxis& y) {
  return parts_of(x.parameter).second == parts_of(y.parameter).first;
}

/// Body and models with both parameters at a corner of the grid, whichever order their domain
/// takes.
void require_corner(const CaseTree& tree, const CaseMap& map, const FamilyParameters& family,
                    double x, double y) {
  const auto with = [&](const FamilyParameters& of, const MapAxis& axis, std::string_view key,
                        double value) {
    try {
      return with_parameter(of, axis.parameter, value);
    } catch (const std::invalid_argument& error) {
      throw fault_at(tree, fmt::format("{}.{}", key, value == axis.to ? "to" : "from"),
                     fmt::format("found {} = {}", axis.parameter, value), error.what());
    }
  };
  if (map.y) {
    try {
      (void)with(with(family, *map.y, "map.y", y), map.x, "map.x", x);
      return;
    } catch (const InputError&) {
      // Perhaps y's value needs x's first.
      if (is_divided_by(map.x, *map.y)) throw;
    }
  }
  const FamilyParameters first = with(family, map.x, "map.x", x);
  if (map.y) (void)with(first, *map.y, "map.y", y);
}

/// The domains are convex, so the corners answer for all of the grid.
void require_domain(const CaseTree& tree, const CaseMap& map, const FamilyParameters& family) {
  for (const double x : {map.x.from, map.x.to})
    for (const double y : {map.y ? map.y->from : 0.0, map.y ? map.y->to : 0.0})
      require_corner(tree, map, family, x, y);
}

}  // namespace

std::vector<double> MapAxis::values() const {
  std::vector<double> out(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(count - 1);
    out[k] = scale == AxisScale::log ? from * pow(to / from, part) : from + (to - from) * part;
  }
  out.back() = to;
  return out;
}

std::vector<const MapAxis*> CaseMap::axes() const {
  std::vector<const MapAxis*> out{&x};
  if (y) out.push_back(&*y);
  return out;
}

FamilyParameters CaseMap::cell(const FamilyParameters& family, double at_x, double at_y) const {
  if (!y) return with_parameter(family, x.parameter, at_x);
  if (is_divided_by(x, *y))
    return with_parameter(with_parameter(family, y->parameter, at_y), x.parameter, at_x);
  return with_parameter(with_parameter(family, x.parameter, at_x), y->parameter, at_y);
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
