// Roots of a cubic in pairs of doubles where all are real and none lies close to another: found in
// double, y = sqrt(-p) z in z^3 - z = t for the isolated one and a quadratic for the others, and
// corrected once each with the residual in pairs,
//
//   r <- r - p(r)/[(r - r_1)(r - r_2)],   which leaves the correction times another's over their distance.
//
// Else nothing: that is for polynomial.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "lib/number/polynomial.hpp"

namespace stationary {

struct SeparatedRoots {
  bool found = false;
  std::array<double, 3> root;   ///< rounded once
  std::array<double, 3> slope;  ///< p' there, from the roots before their correction
  std::array<double, 3> gap;    ///< distance from the nearest other, likewise
};

/// Of a monic cubic; P: DoubleDouble, or what rounds as it does (fused.hpp).
template <class P>
SeparatedRoots separated_roots(const Polynomial<P, 3>& monic) {
  SeparatedRoots out;
  const double c0 = leading(monic.c[0]);
  const double c1 = leading(monic.c[1]);
  const double c2 = leading(monic.c[2]);
  const double inflection = c2 * (-1.0 / 3.0);
  const double p = c1 + c2 * inflection;
  if (!(p < 0.0)) return out;
  const double Q = ((inflection + c2) * inflection + c1) * inflection + c0;
  const double scale = std::sqrt(-p);
  const double t = std::abs(Q) / (scale * -p);
  // At 2/(3 sqrt 3) = 0.384900... the other two meet.
  if (!(t < 0.38489)) return out;
  // To 4e-5, and by a step of Halley's to 1e-13, whose square is nothing to a double.
  double z = (1.0000375 + 0.4964256 * t) + t * t * (-0.3201088 + 0.1937796 * t);
  const double square = z * z;
  const double value = (square - 1.0) * z - t;
  const double slope = 3.0 * square - 1.0;
  z -= value * slope / (slope * slope - 3.0 * z * value);
  const double single = Q < 0.0 ? inflection + scale * z : inflection - scale * z;
  // p = (x - r)(x^2 + b x + c), from the end where nothing cancels.
  double b;
  double c;
  if (std::abs(single * single * single) >= std::abs(c0)) {
    c = -c0 / single;
    b = (c - c1) / single;
  } else {
    b = c2 + single;
    c = c1 + single * b;
  }
  const double mean = -0.5 * b;
  const double separation = mean * mean - c;
  if (!(separation > 0.0)) return out;
  const double half = std::sqrt(separation);
  const double large = mean < 0.0 ? mean - half : mean + half;
  const double small = c / large;

  const std::array<double, 3> rough{single, small, large};
  const double between[3] = {rough[1] - rough[2], rough[2] - rough[0], rough[0] - rough[1]};
  double step[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const double one = between[(k + 1) % 3];
    const double other = between[(k + 2) % 3];
    const double r = rough[k];
    const P value = ((monic.c[2] + r) * r + monic.c[1]) * r + monic.c[0];
    out.slope[k] = -(one * other);
    step[k] = leading(value) / out.slope[k];
    out.root[k] = r - step[k];
    out.gap[k] = std::fmin(std::abs(one), std::abs(other));
  }
  // Weierstrass' step leaves of its root's error the share that the others' errors are of their
  // distances, and what the slope is rounded by.
  bool exact = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const double others = std::fmax(std::abs(step[(k + 1) % 3]), std::abs(step[(k + 2) % 3]));
    const double left = std::abs(step[k]) * (2.0 * others + 0x1p-50 * out.gap[k]);
    exact = exact && left <= 0x1p-57 * std::abs(out.root[k]) * out.gap[k];
  }
  out.found = exact;
  return out;
}

}  // namespace stationary
