#include "solver/program/rows/atlas_rows.hpp"

#include <algorithm>

namespace stationary {

SheetRecord write_rows(AtlasSheet& sheet, CurveTable& table) {
  for (const AtlasRow& row : sheet.rows) {
    if (row.before) table.between(*row.before);
    table.row(row.member, row.event);
  }
  table.complete(sheet.report.events);
  return table.record(sheet.report);
}

double complete_fraction(const Atlas& found) {
  const auto complete = std::ranges::count_if(found.checkpoints, &Checkpoint::complete);
  return static_cast<double>(complete) / static_cast<double>(found.checkpoints.size());
}

}  // namespace stationary
