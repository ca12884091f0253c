// The sheets of an atlas as rows of a table.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "solver/atlas/atlas.hpp"
#include "solver/atlas/least_energy.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/table/cell_table.hpp"

namespace stationary {

/// Its rows into the table; its events get theirs. What is told of it beside them.
SheetRecord write_rows(AtlasSheet& sheet, CurveTable& table);

/// Of whom an atlas is, and whether its rows are to be proven.
struct AtlasBody {
  const Body& body;
  const Potential& potential;
  bool prove = false;
  MaterialCoordinates coordinates{};  ///< those of its rows
  /// Becomes true while they are written: those left are neither written nor proven, and
  /// found.interrupted is set.
  const std::atomic<bool>* stop = nullptr;
};
/// All sheets into the table, which may be null, and what is told of each; how many rows are proven.
CurveProofs write_sheets(const AtlasBody& of, Atlas& found, RowSink* writer,
                         std::vector<SheetRecord>& records);

/// A row for each piece, as lines of CSV.
std::vector<CellColumn> least_energy_columns();
std::string least_energy_rows(const std::vector<LeastEnergyPiece>& pieces,
                              const std::vector<AtlasSheet>& sheets);

/// The part of the checkpoints at which no sheet is missing; of a complete atlas the part of the
/// range, over its kinds of motion, for which the number of sheets is proven.
double complete_fraction(const Atlas& found);
/// Of the ranges of all kinds of motion together, the part for which nothing is proven.
double unproven_fraction(const std::vector<Completeness>& completeness);

}  // namespace stationary
