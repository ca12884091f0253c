// One lane of a batch (batch.hpp) of a potential that is not isotropic: the family
// through the lane's rest state (anisotropic_family.hpp) is followed once,
//
//   G(x(s); nu(s)) = 0,   s from rest, until |nu| has passed the largest asked for,
//
// and each |nu| is answered where it is met first along the curve: on the arc (hermite_arc.hpp)
// between the two rows around it, then corrected at that nu, many at a time in packs where the potential
// is made of built-in models and fibres (oriented_lanes.hpp). Turns of nu are rows, so that between
// two rows nu passes each value once; what the correction comes to must be as near to the arc as
// the arc is to the curve, and have the rest state's sign of det dG/d ln x, which every first
// meeting has: else the curve is followed once more, from the row before to that nu.
//
// So an answer is that of solve() with no search: it follows the same sheet to the same place.
#pragma once

#include <atomic>
#include <limits>
#include <span>

#include "solver/batch/oriented_lanes.hpp"
#include "solver/motion/problem.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

struct LanePoint {
  SolveStatus status = SolveStatus::not_run;
  /// NaN where not solved.
  Stretch q{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
            std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  double error_bound = std::numeric_limits<double>::quiet_NaN();  ///< as Equilibrium::error_bound
};

/// Into out, one for each nu: nu finite, >= 0, ascending. stop may be null; where it becomes true
/// what is left stays not_run.
/// (i), (ii) and V_alpha not known to vanish at alpha = 0: each nu > 0 by solve(), which searches
/// for the motions that compatibility leaves to chance and proves that there is none.
/// Throws std::bad_variant_access for an isotropic potential.
void solve_anisotropic_lane(const Problem& problem, std::span<const double> nu,
                            const OrientedKernels& kernels, const std::atomic<bool>* stop,
                            std::span<LanePoint> out);

}  // namespace stationary
