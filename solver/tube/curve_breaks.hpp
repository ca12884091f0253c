// Where the number of points that proven curves (tube_set.hpp) have at one nu may change: where a
// curve turns, dq/ds = 0, where it passes a side of the region or a condition changes its sign, and
// where it passes into its own mirror image, at which it turns too.
// Slices of each tube are halved until their signs are decided, or until what q they may have is as
// narrow as rounding, or as that of one point of the curve: where two folds nearly meet, rounding
// leaves q and dq/ds known to few digits. After thirty thousand slices what is left is undecided.
// Between two neighbouring such intervals every point of a curve is regular and inside, so that
// their number is constant.
#pragma once

#include <atomic>
#include <vector>

#include "solver/tube/tube_set.hpp"

namespace stationary {

struct CurveBreak {
  Interval q;
  bool turns = false;    ///< dq/ds may vanish here
  bool crosses = false;  ///< the region may be left here
  bool ends = false;     ///< or a condition of the motions changes its sign
  /// A curve passes the region's mirror coordinate's 0 once, into its own mirror image.
  bool mirrors = false;
  bool undecided = false;  ///< left so for want of patience
};

/// Ascending, touching ones merged; some are missing where *stop became true.
template <int N>
std::vector<CurveBreak> curve_breaks(const CurveEquations<N>& equations,
                                     const CurveRegion<N>& region, const TubeSet<N>& tubes,
                                     const std::atomic<bool>* stop = nullptr);

}  // namespace stationary
