// What tells a corrected point from one of another sheet, for every path that is followed: on its own sheet a
// predicted point is near, Newton's corrections contract, and the bordered determinant keeps its sign. (A sheet met
// across the gap of a broken bifurcation goes on straight, with the other sign.)
#pragma once

namespace stationary {

/// How far off the predictor of a step of length h may be: as far as a curve whose tangent turns by max_angle on
/// the way is from the tangent it left on, and the rounding.
constexpr double longest_first_correction(double h, double max_angle) {
  return 0.5 * max_angle * h + 1e-13;
}

/// Corrections below this are rounding.
constexpr double contracted = 1e-12;

/// Whether a correction of this size after one of that size is Newton's near a solution.
constexpr bool contracts(double size, double before) {
  return size <= 0.25 * before || size <= contracted;
}

/// Whether two points with these signs of the bordered determinant can lie on one sheet.
constexpr bool same_sheet(bool positive_here, bool positive_next) {
  return positive_here == positive_next;
}

}  // namespace stationary
