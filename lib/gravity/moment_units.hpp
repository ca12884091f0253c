// Units in which moments J s^2 are of the size of one, for F(T, D, z) (ellipsoid_integral.hpp):
//
//   F(u T, u^2 D, u z) = F(T, D, z)/sqrt u,   so g F = g' F' of T' = u T, ..., g' = sqrt(u) g,
//
// u a power of four, so that nothing is rounded. Its second derivatives, of the size of T^(-9/2), leave the
// range of doubles long before J and g do.
#pragma once

#include <cmath>

namespace stationary {

struct MomentUnits {
  double moment = 1.0;    ///< u
  double strength = 1.0;  ///< sqrt u

  /// T: a moment. None other than its own for one that is near 1.
  explicit MomentUnits(double T) {
    constexpr double near = 0x1p60;
    if (!(T > 0.0) || !std::isfinite(T) || (T < near && T > 1.0 / near)) return;
    const int k = std::ilogb(T) / 2;
    moment = std::ldexp(1.0, -2 * k);
    strength = std::ldexp(1.0, -k);
  }
  bool are_own() const { return moment == 1.0; }
};

}  // namespace stationary
