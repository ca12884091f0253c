// The family a case is about, at any value of its parameter, and where following it starts.
#pragma once

#include "solver/kind/kind.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/resume_table.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

/// The family, and a solved member to start from.
struct Start {
  FamilyParameters at;  ///< with the parameter at p
  double p;
  Equilibrium found;
  bool is_event = false;  ///< of the family, which then is to be met on the way
  /// Where none was found: none exists of those searched for, and nothing is known of others.
  bool only_in_box = false;

  std::string_view outcome() const { return cli::outcome(found.status, only_in_box); }
};

/// Throws InputError where the case has no range to be followed.
void require_range(const Case& input);

/// How far and how finely, in the family's own parameter: of a ratio the number that varies. The case
/// and the run are to outlive it.
FollowOptions follow_options(const Case& input, double unit, const Run& run);

/// By solving at the case's own value of the parameter or at the beginning of its range;
/// start.found says whether that came to something. Throws InputError for a start outside the
/// range.
Start solved_start(const Case& input, const Run& run);

/// Where a table goes on.
Start resumed_start(const Case& input, const ResumedTable& old);

/// Members as far as their outputs are asked for.
AnyFamily family_of(const Case& input, const Start& start, bool with_spectrum, bool to_table);

/// Makes the table ask of its events how motions begin there, and prove its rows where the case
/// wants that.
void ask_kinds(const Case& input, const Start& start, CurveTable& rows);

}  // namespace stationary::cli
