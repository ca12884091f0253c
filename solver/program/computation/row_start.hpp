// `continue --from ROW` (row_name.hpp): going on from a motion that a table holds.
//
// The case gives body and potential; the row gives S, the motion's numbers and what trailing columns
// have of the body and its potential (numbers, and models and formulas of a study), which override the
// case. The family is the case's motion.branch; where it is another than the row's, the row must be an
// event at which that family begins.
#pragma once

#include <string>

#include "solver/program/session/case_family.hpp"

namespace stationary::cli {

struct RowStart {
  Case input;   ///< with what the row overrides
  Start start;  ///< a motion of its family
};

/// Throws InputError: no such table, row or event, a row without a motion, or of a family that does
/// not lead to the case's.
RowStart start_from_row(const Case& given, const std::string& row);

/// The row that is asked for, else that of the case; empty: none.
inline std::string start_row_of(const Case& given, const std::string& asked) {
  return asked.empty() && given.continuation ? given.continuation->start_row : asked;
}

/// The table that a row is named of. Throws InputError where it names none.
std::string table_of_row(const std::string& row);

/// A row as an event of its own family.
struct EventRow {
  Case input;  ///< with what the row overrides
  Stretch q;
};

/// Throws InputError: no such table or row, or a row of another event or branch.
EventRow event_of_row(const Case& given, const std::string& row, EventType type);

}  // namespace stationary::cli
