// The table [map] of a case: a grid over one or two of its parameters (case_parameter.hpp).
//
//   [map]
//   x = { parameter = "nu", from = 0.0, to = 1.5, count = 400 }
//   y = { parameter = "body.J.1", from = 0.5, to = 2.0, count = 300, scale = "log" }
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/faults.hpp"

namespace stationary {

struct FamilyParameters;
struct ParameterValue;

enum class AxisScale { linear, log };
constexpr std::string_view axis_scale_names[] = {"linear", "log"};
constexpr std::string_view name(AxisScale scale) {
  return axis_scale_names[static_cast<int>(scale)];
}

struct MapAxis {
  std::string parameter;  ///< one of case_parameters(), or a ratio of two
  double from;
  double to;
  std::size_t count;
  AxisScale scale = AxisScale::linear;

  /// `count` of them, evenly spaced in the scale, from and to among them.
  std::vector<double> values() const;
};

/// For a person.
std::string axis_text(const MapAxis& axis);

/// Whether x's number is y's times a value.
bool is_divided_by(const MapAxis& x, const MapAxis& y);

struct CaseMap {
  MapAxis x;
  std::optional<MapAxis> y;

  std::vector<const MapAxis*> axes() const;
  std::size_t cells() const { return x.count * (y ? y->count : 1); }
  /// What is set at a cell, x first; at_y: of a map with y. The map must outlive it.
  std::vector<ParameterValue> values_at(double at_x, double at_y) const;
  /// The case's numbers there.
  FamilyParameters cell(const FamilyParameters& family, double at_x, double at_y) const;
};

constexpr std::size_t most_map_cells = 20'000'000;  ///< 36 bytes each while solved

/// Nothing where the case has no map, or a faulty one: no parameter of the family, an empty range, a
/// count that is not whole or too large, a value outside the domain of body or model. family: nullptr
/// where it is not known, because something else is wrong.
std::optional<CaseMap> read_map(const CaseTree& tree, const FamilyParameters* family,
                                Faults& faults);

}  // namespace stationary
