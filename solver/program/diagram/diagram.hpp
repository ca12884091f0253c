// What a diagram shows of tables: against the family's parameter, the principal stretches lambda, mu
// and rho or other columns, the frequencies with their Krein signatures, the growth rate, and the
// located events; or the energy against the size of the angular momentum.
//
// The parameter is the table's column of a number of the case, a dotted key such as body.J.0 or a map's
// nu, wherever it stands, if there is one; else the spin: nu1, nu2 or nu3 after the branch, |nu| where the axis is oblique or
// tilted (negative where no component is positive, so that a family and its mirror image lie
// apart), and omega of two-polar motions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {

/// As many curves are told apart in one panel.
constexpr std::size_t most_ordinates = 3;
using Ordinates = std::array<double, most_ordinates>;

/// A row; NaN where nothing was computed.
struct DiagramPoint {
  double parameter;  ///< of the family
  double abscissa;   ///< what it is drawn against: the parameter, or |pi|
  Ordinates ordinate;
  std::array<double, mode_count> frequency;   ///< im1 ... im5
  std::array<std::int8_t, mode_count> krein;  ///< 0 where there is none
  double growth;
  std::optional<StabilityClass> verdict;
  bool event = false;

  bool has_spectrum() const;
};

struct DiagramEvent {
  std::string name;
  std::size_t point;  ///< of Diagram::points
};

/// Rows that are connected: a sheet.
struct DiagramPiece {
  std::size_t begin;
  std::size_t end;
  std::size_t branch;  ///< of Diagram::branches
  std::string label;   ///< its sheet; of several tables, after the table's letter
};

/// A panel's worth: the pieces of one branch.
struct DiagramBranch {
  std::string name;
  std::string parameter;  ///< its symbol
};

struct Diagram {
  std::vector<std::string> columns;  ///< what is drawn upwards
  std::vector<DiagramPoint> points;  ///< in the tables' order
  std::vector<DiagramPiece> pieces;
  std::vector<DiagramBranch> branches;
  std::vector<DiagramEvent> events;
  std::vector<std::string> tables;  ///< their names
  bool of_energy_and_momentum = false;
  bool has_spectrum = false;
  bool has_krein = false;

  bool of_stretches() const;
};

/// By which the sheets of several tables are told apart: a to z, then aa, ab, ...
std::string table_letters(std::size_t table);

/// What is to be drawn, of all there is.
struct DiagramChoice {
  std::vector<std::string> columns;   ///< empty: the stretches
  std::vector<std::string> sheets;    ///< empty: all
  std::vector<std::string> branches;  ///< empty: all
  bool energy_momentum = false;
};

/// Throws InputError where the tables lack what is needed: the parameter, a column, a row, a sheet
/// or branch that is asked for.
Diagram read_diagram(const std::vector<TableReader*>& tables, const DiagramChoice& choice = {});

}  // namespace stationary
