// What became of the cases of one category.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/stress/judge/judge.hpp"

namespace stationary::stress {

struct Tally {
  long tried = 0;
  long solved = 0;
  long none_exists = 0;
  long not_found = 0;
  long not_isolated = 0;
  long failed = 0;

  // Of those solved:
  long marginal = 0;         ///< no class claimed
  long certified = 0;        ///< existence and error bound proven
  long within_one_unit = 0;  ///< in the last place, each of xi, zeta, rho
  double worst_units = 0.0;
  double worst_error_over_bound = 0.0;
  double worst_mode_over_bound = 0.0;

  // Claims that are not true:
  long above_bound = 0;  ///< of S or of an eigenvalue
  long wrong_class = 0;
  long wrong_sheet = 0;
  long wrong_proof = 0;
  long wrong_absence = 0;
  long not_finite = 0;

  long overlooked = 0;  ///< not found though it is there: honest, but a weakness
  long most_work = 0;   ///< evaluations of the longest case: there is a limit
  std::vector<std::string> faults;

  void add(const Outcome& outcome);
  /// The cases whose status was counted, which are all that were tried.
  long reported() const { return solved + none_exists + not_found + not_isolated + failed; }
};

/// Header and line of results/stress.csv.
std::string tally_header();
std::string tally_line(std::string_view category, const Tally& tally);

}  // namespace stationary::stress
