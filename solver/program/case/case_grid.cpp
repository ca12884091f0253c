#include "solver/program/case/case_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary {
namespace {

MapAxis read_axis(const CaseTree& tree, const std::string& key, const FamilyParameters& family) {
  const auto node = tree.root().at_path(key);
  MapAxis out{.parameter = node["parameter"].value_or(std::string()),
              .from = node["from"].value_or(0.0),
              .to = node["to"].value_or(0.0),
              .count = 0};
  if (out.parameter == "motion.nu") out.parameter = "nu";  // the dotted key of the same number
  const std::vector<std::string> valid = case_parameters(family.motion, family.models);
  if (std::ranges::find(valid, out.parameter) == valid.end()) {
    const std::vector<std::string_view> names(valid.begin(), valid.end());
    throw fault_at(tree, key + ".parameter", "found the string " + in_quotes(out.parameter),
                   "one of " + listed(names), did_you_mean(nearest_name(out.parameter, names)));
  }
  if (!(out.from < out.to)) {
    throw fault_at(tree, key + ".to",
                   fmt::format("found the empty range from {} to {}", out.from, out.to),
                   "from < to");
  }
  const double count = node["count"].value_or(0.0);
  if (!(count >= 2.0 && count <= most_map_cells && count == std::floor(count))) {
    throw fault_at(tree, key + ".count", fmt::format("found {}", count),
                   fmt::format("a whole number from 2 to {}", most_map_cells));
  }
  out.count = static_cast<std::size_t>(count);
  if (node["scale"].value_or(std::string_view()) == name(AxisScale::log)) {
    out.scale = AxisScale::log;
    if (!(out.from > 0.0)) {
      throw fault_at(tree, key + ".from", fmt::format("found {} with scale = \"log\"", out.from),
                     "from > 0");
    }
  }
  return out;
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
    out[k] = scale == AxisScale::log ? from * std::pow(to / from, part) : from + (to - from) * part;
  }
  out.back() = to;
  return out;
}

std::vector<const MapAxis*> CaseMap::axes() const {
  std::vector<const MapAxis*> out{&x};
  if (y) out.push_back(&*y);
  return out;
}

std::optional<CaseMap> read_map(const CaseTree& tree, const FamilyParameters& family) {
  if (!tree.root().contains("map")) return std::nullopt;
  CaseMap out{read_axis(tree, "map.x", family), std::nullopt};
  if (tree.root().at_path("map.y")) out.y = read_axis(tree, "map.y", family);
  if (out.y && out.y->parameter == out.x.parameter) {
    throw fault_at(tree, "map.y.parameter",
                   "found " + in_quotes(out.y->parameter) + ", which is x's too",
                   "another parameter than x's");
  }
  if (out.y && out.y->count > most_map_cells / out.x.count) {
    throw fault_at(tree, "map.y.count",
                   fmt::format("found {} by {} cells", out.x.count, out.y->count),
                   fmt::format("at most {} cells", most_map_cells));
  }
  require_domain(tree, out, family);
  return out;
}

}  // namespace stationary
