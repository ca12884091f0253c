// What followed sheets come to, in one row: of a study, or of a grid of atlases.
//
//   sheets, events       how many
//   first_instability    the least parameter at which a stretch of a sheet that is stable or elliptic
//                        meets one that is unstable or oscillatory
//   first_event          the least parameter of an event
//   complete_fraction    of an atlas: at which part of its checkpoints no sheet is missing;
//                        of atlas.complete for which part of the range that is proven
//   <event>_count, <event>_first    likewise of each type of event but the ends of sheets
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/program/rows/curve_table.hpp"
#include "solver/program/table/cell_table.hpp"

namespace stationary {

/// Their columns.
std::vector<CellColumn> sheet_summary_columns();

/// Their cells, separated by commas.
std::string sheet_summary(std::span<const SheetRecord> sheets,
                          std::optional<double> complete_fraction);

}  // namespace stationary
