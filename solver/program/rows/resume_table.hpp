// A table of `continue` that is to be gone on with: its rows, and which of its two ends are open
// (the sheet's end would stand in their event cell).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/family/follow_sheet.hpp"
#include "solver/program/rows/curve_table.hpp"

namespace stationary {

struct ResumedTable {
  std::vector<TableRow> rows;
  std::optional<OpenEnd> first;  ///< still to be followed, against the table's order
  std::optional<OpenEnd> last;
  // Of its metadata; read_resumed() leaves them out.
  std::vector<EventRecord> events;
  std::vector<RecordedSegment> segments;  ///< in order
  std::string first_reason;               ///< why the curve ends there, where it does
  std::string last_reason;
  bool at_rest = false;  ///< the motion followed in another number than nu; the case's
};

/// Throws InputError where the file is no such table: other columns than these (with the trailing
/// parameter, if it has one), no rows, or without what a place on the curve takes. goes_on: what the
/// metadata say of the last row, whose cell cannot where it is the first too, and an end as that.
ResumedTable read_resumed(const std::string& path, const std::vector<Column>& columns,
                          const std::optional<std::string>& parameter, std::string_view branch,
                          bool goes_on = false);

}  // namespace stationary
