// Units of a spinning body in which J1 and omega are of the size of one: powers of two, so that
// nothing is rounded and the same body in others gives the same digits. Products of a few of its
// numbers stay in range then.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "lib/number/first_order_bound.hpp"
#include "lib/number/number.hpp"

namespace stationary {

/// 2^-k of 2^k <= |x| < 2^(k+1); x neither subnormal nor beyond 2^1021.
inline double reciprocal_power(double x) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000;
  return std::bit_cast<double>(0x7fe0000000000000 - exponent);
}

/// What a number in the body's units is multiplied by.
struct SpinUnits {
  double inertia;
  double rate;
  double energy;  ///< of inertia rate^2

  SpinUnits(double J1, double omega)
      : inertia(reciprocal_power(J1)),
        rate(reciprocal_power(omega)),
        energy(inertia * (rate * rate)) {}
};

/// power x, power a power of two or its negative: exact.
inline double by_power(double x, double power) { return power * x; }
template <class Real>
[[gnu::always_inline]] inline Pair<Real> by_power(const Pair<Real>& x, double power) {
  return {power * x.hi, power * x.lo};
}
inline Conditioned by_power(const Conditioned& x, double power) {
  return {power * x.value, std::abs(power) * x.condition};
}

}  // namespace stationary
