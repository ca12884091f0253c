// What `solve` finds of a case, in whichever family: one motion, or all of them with proof.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/table/table.hpp"
#include "solver/solve/solve.hpp"

namespace stationary::cli {

/// What an exhaustive search says of a solution.
enum class Listed {
  no,       ///< it was no such search
  proven,   ///< to exist
  unproven  ///< found by Newton's method in what is undecided
};

struct Solution {
  TableRow row;
  Motion motion;  ///< with the plane or axis that the case left open
  std::optional<Spectrum> spectrum;
  std::string proof;  ///< what is proven of it, for a person; empty: nothing was asked
  bool proven = false;
  Listed listed = Listed::no;
};

struct Answer {
  SolveStatus status = SolveStatus::not_run;
  std::string message;
  std::string warning;  ///< what is not proven though it was asked for
  Connection connection = Connection::unknown;
  std::vector<std::pair<std::string_view, long>> counts;
  std::vector<Solution> solutions;  ///< some where solved
  bool only_in_box = false;         ///< none exists, of those searched
  double seconds = 0.0;

  bool solved() const { return status == SolveStatus::solved; }
  std::string_view outcome() const { return cli::outcome(status, only_in_box); }
};

/// Solves, or searches where solve.all says so; proves what output.certificate asks for. wanted: of
/// each solution's row.
Answer answer_of(const Case& input, const Run& run, bool with_spectrum, const ColumnSet& wanted);

}  // namespace stationary::cli
