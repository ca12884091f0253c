// A curve G(x; p) = 0 in the coordinates continuation measures in,
//
//   y = (ln x, p/scale) in R^(N+1),
//
// points on it with their unit tangents, and the arc between two of them as the cubic that has both
// points and both tangents (error l^4/384 of its fourth derivative).
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/motion/family.hpp"

namespace stationary {

template <int N>
using ArcVector = Eigen::Matrix<double, N + 1, 1>;

template <int N>
struct ArcPoint {
  ReducedVector<N> x;
  ReducedVector<N> tail = ReducedVector<N>::Constant(std::numeric_limits<double>::quiet_NaN());
  double p = std::numeric_limits<double>::quiet_NaN();
  ArcVector<N> tangent;
  /// Sign of det [dG/dy; tangent^T]: one and the same all along a sheet.
  bool positive = true;
  double error_bound = std::numeric_limits<double>::quiet_NaN();  ///< of x at p
  bool at_turn = false;       ///< x was corrected onto the curve, not to p
  FamilySlopes<N> slopes;     ///< there
  double slopes_error = 0.0;  ///< what they are off by may do to the tangent, beside their rounding
};

template <int N>
struct Arc {
  ArcVector<N> chord;  ///< from its beginning to its end
  ArcVector<N> from;   ///< tangents
  ArcVector<N> to;
  double length = 0.0;
  double turned = 0.0;  ///< angle between the tangents

  Arc() = default;
  /// length: that of the circle with this chord and this angle between the tangents.
  Arc(const ArcVector<N>& between, const ArcVector<N>& t0, const ArcVector<N>& t1)
      : chord(between), from(t0), to(t1) {
    const double sine = std::min(1.0, 0.5 * (t0 - t1).norm());  // of half the angle
    const double stretch = angle_over_sine(sine);
    turned = 2.0 * sine * stretch;
    length = chord.norm() * stretch;
  }

  /// y(u) - y(0), u = 0 ... 1 and, extrapolating, beyond.
  ArcVector<N> at(double u) const {
    return (u * (u - 1.0) * (u - 1.0) * length) * from + (u * u * (3.0 - 2.0 * u)) * chord +
           (u * u * (u - 1.0) * length) * to;
  }
  /// dy/du, normalized.
  ArcVector<N> direction(double u) const {
    return (((3.0 * u - 4.0) * u + 1.0) * length * from + (6.0 * u * (1.0 - u)) * chord +
            (u * (3.0 * u - 2.0) * length) * to)
        .normalized();
  }

  /// u where the cubic's parameter turns first, from its tangents, or the end nearest to it.
  double turn_of_parameter() const {
    const double gain = chord[N];
    const double a = from[N] * length;
    if (a == 0.0) return 0.0;
    const double b = to[N] * length;
    const double A = 3.0 * (a + b - 2.0 * gain);
    const double B = 2.0 * (3.0 * gain - 2.0 * a - b);
    const double root = std::sqrt(std::max(0.0, B * B - 4.0 * A * a));
    return std::clamp(-2.0 * a / (B + (B > 0.0 ? root : -root)), 0.0, 1.0);
  }

  /// An angle of this sine over it: of the angles that steps turn by, its series to 1e-15.
  static double angle_over_sine(double sine) {
    if (sine > 0.11) return asin(sine) / sine;
    const double x = sine * sine;
    constexpr double c[] = {1.0 / 6.0,     3.0 / 40.0,    5.0 / 112.0,
                            35.0 / 1152.0, 63.0 / 2816.0, 231.0 / 13312.0};
    return 1.0 + x * (c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))));
  }
};

}  // namespace stationary
