// What a bifurcation diagram shows of a table: the principal stretches lambda, mu and rho, the
// frequencies and the growth rate against the family's parameter, and the located events.
//
// The parameter is the table's trailing column, a dotted key such as body.J.0 or a map's nu, if
// there is one; else the spin: nu1, nu2 or nu3 after the branch, |nu| where the axis is oblique or
// tilted (negative where no component is positive, so that a family and its mirror image lie
// apart), and omega of two-polar motions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {

constexpr std::array<Column, 3> stretch_columns{Column::lambda, Column::mu, Column::rho};

/// A row; NaN where nothing was computed.
struct DiagramPoint {
  double parameter;
  std::array<double, stretch_columns.size()> stretch;
  std::array<double, mode_count> frequency;  ///< im1 ... im5
  double growth;
  std::optional<StabilityClass> verdict;
  bool event = false;

  bool has_spectrum() const;
};

struct DiagramEvent {
  std::string name;
  std::size_t point;  ///< of Diagram::points
};

struct Diagram {
  std::string parameter;             ///< the symbol, or the dotted key
  std::vector<DiagramPoint> points;  ///< in the table's order
  std::vector<std::size_t> pieces;   ///< first point of each connected piece
  std::vector<DiagramEvent> events;
  bool has_classes = false;
  bool has_spectrum = false;
  std::array<bool, stretch_columns.size()> has_stretch{};
};

/// Throws InputError where the table lacks what is needed: the parameter, a stretch, a row.
Diagram read_diagram(TableReader& table);

}  // namespace stationary
