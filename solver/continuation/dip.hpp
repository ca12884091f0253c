// Where a function that has one sign at both ends of a step, u = 0 and 1, may have two zeros
// inside: the parabola
//
//   a + u (slope + u curvature)
//
// that stands for it comes near zero.
#pragma once

#include <algorithm>
#include <cmath>

namespace stationary {

struct Parabola {
  double a;
  double slope;
  double curvature;
  double end;  ///< what it should be at 1
};

/// Through (-l, earlier), (0, a), (1, b), by Newton's form, l (1 + l) times as large: nothing is
/// divided by.
inline Parabola parabola_through(double l, double earlier, double a, double b) {
  const double d01 = b - a;
  const double size = l * (1.0 + l);
  const double curvature = l * d01 - (a - earlier);
  return {size * a, size * d01 - curvature, curvature, size * b};
}

/// Slope of the cubic that has the slopes a and b at its ends and gains so much between them.
inline Parabola slope_of_cubic(double a, double b, double gain) {
  return {a, 6.0 * gain - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * gain, b};
}

/// Whether it comes near zero between its ends, or turns no farther beyond them. share: what the least may be of
/// the smaller end.
inline bool may_touch_zero(const Parabola& f, double beyond = 0.1, double share = 0.3) {
  if (f.curvature * f.a <= 0.0) return false;  // bends away from zero
  const double size = std::abs(f.curvature);
  const double turns = f.curvature < 0.0 ? 0.5 * f.slope : -0.5 * f.slope;  // at turns/size
  if (!(turns > -beyond * size && turns < (1.0 + beyond) * size)) return false;
  const double least = f.a + 0.5 * f.slope * (turns / size);
  return least * f.a <= 0.0 || std::abs(least) <= share * std::min(std::abs(f.a), std::abs(f.end));
}

}  // namespace stationary
