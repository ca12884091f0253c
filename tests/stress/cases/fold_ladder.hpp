// How many digits are left beside a fold: at a relative distance epsilon of nu from one, an error
// in the residual is magnified by about epsilon^-1/2 (the inverse of the Jacobian), the two
// solutions being that far apart.
#pragma once

#include <string>
#include <vector>

#include "tests/stress/judge/tally.hpp"

namespace stationary::stress {

/// All folds at one distance.
struct Rung {
  double distance;
  Tally tally;
  double worst_error = 0.0;          ///< relative, of S as it is returned
  double worst_plain_error = 0.0;    ///< of Newton with its residual in double
  double largest_error_bound = 0.0;  ///< what the decimals of the case leave open
};

/// Distances 1e-2, 1e-3, ..., 1e-14 from each of `folds` random folds.
std::vector<Rung> fold_ladder(long folds);

/// results/stress_fold.csv.
std::string ladder_table(const std::vector<Rung>& ladder);

}  // namespace stationary::stress
