// What a solve's status means to the user: words and an exit code, shared by the computing
// commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/family/follow_sheet.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/session/exit_code.hpp"
#include "solver/program/table/table.hpp"
#include "solver/solve/solve.hpp"

namespace stationary::cli {

ExitCode exit_code(SolveStatus status);
std::string_view outcome(SolveStatus status);
/// outcome, and the message that explains it.
std::string failure_text(std::string_view outcome, const std::string& message);

/// outcome(); only_in_box: none exists, of those searched for.
std::string_view outcome(SolveStatus status, bool only_in_box);

/// Why following was given up, of each end that it was at (EventType::stalled).
std::vector<std::string> given_up(const FollowReport& report);

/// The columns of the table to be, refused before the computation if none is left (trailing: one
/// is always there).
std::vector<Column> chosen_columns(const Case& input, const std::vector<Column>& computed,
                                   std::string_view command, bool trailing);

}  // namespace stationary::cli
