// `continue --resume`: the interrupted table read back, and the curve followed on from its open
// ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/family/follow_sheet.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/resume_table.hpp"

namespace stationary::cli {

/// The columns with proofs that a table of this case has not, though they are asked for: what is
/// proven of its rows is then not known.
std::vector<std::string_view> unproven_to_resume(const Case& input,
                                                 const std::vector<Column>& columns);

/// The table at `path`, of this case and with these columns. Throws InputError where it is another.
ResumedTable resumed_table(const Case& input, const std::string& path,
                           const std::vector<Column>& columns,
                           const std::optional<std::string>& parameter);

/// New rows before the table's own, those, new rows after them. unit: the family's parameter where the
/// table's is 1.
FollowReport follow_on(const AnyFamily& family, const ResumedTable& old, double unit,
                       FollowOptions options, CurveTable& table);

}  // namespace stationary::cli
