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

/// The columns that a table of this case is to have beside missing_to_resume(), and has not: alpha, where it
/// may be no zero, and what is proven, where that is asked for.
std::vector<std::string_view> lacking_to_resume(const Case& input,
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
