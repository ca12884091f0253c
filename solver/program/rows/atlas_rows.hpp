// A sheet of an atlas as rows of a table.
#pragma once

#include "solver/atlas/atlas.hpp"
#include "solver/program/rows/curve_table.hpp"

namespace stationary {

/// Its rows into the table; its events get theirs. What is told of it beside them.
SheetRecord write_rows(AtlasSheet& sheet, CurveTable& table);

/// The part of the checkpoints at which no sheet is missing.
double complete_fraction(const Atlas& found);

}  // namespace stationary
