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
};

/// Through (-l, earlier), (0, a), (1, b), by Newton's form.
inline Parabola parabola_through(double l, double earlier, double a, double b) {
  const double d01 = b - a;
  const double d10 = (a - earlier) / l;
  const double curvature = (d01 - d10) / (1.0 + l);
  return {a, d01 - curvature, curvature};
}

/// Slope of the cubic that has the slopes a and b at its ends and gains so much between them.
inline Parabola slope_of_cubic(double a, double b, double gain) {
  return {a, 6.0 * gain - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * gain};
}

/// Whether it comes near zero between its ends; b is what it should be at 1.
inline bool may_touch_zero(const Parabola& f, double b) {
  if (f.curvature * f.a <= 0.0) return false;  // bends away from zero
  const double vertex = -0.5 * f.slope / f.curvature;
  if (!(vertex > -0.1 && vertex < 1.1)) return false;
  const double least = f.a + vertex * (f.slope + vertex * f.curvature);
  return least * f.a <= 0.0 || std::abs(least) <= 0.3 * std::min(std::abs(f.a), std::abs(b));
}

}  // namespace stationary
