// A number computed in working precision with a bound of its own error: every input x is uncertain
// by u |x|, u >= 2^-53, and every operation rounds,
//
//   |value - exact| <= u . units + O(u^2),
//   units(x y) = |x| units(y) + |y| units(x) + |x y|,
//   units(x + y) = units(x) + units(y) + |x + y|
//
// and so on. Unlike Conditioned (first_order_bound.hpp), whose values come from extended precision,
// the value here is the one the bound speaks of: what decides in SIMD lanes whether a sign is
// certain. A double written into a formula (2, 1/2, ...) counts as exact.
#pragma once

#include <cmath>

#include "lib/number/number.hpp"

namespace stationary {

template <class Real>
struct RunningError {
  Real value{0.0};
  Real units{0.0};

  RunningError() = default;
  RunningError(double exact) : value(exact) {}  // NOLINT(google-explicit-constructor)
  STATIONARY_INLINED RunningError(const Real& x, const Real& error) : value(x), units(error) {}

  /// A number uncertain by u |x|.
  STATIONARY_INLINED static RunningError input(const Real& x) {
    using std::abs;
    return {x, abs(x)};
  }

  STATIONARY_INLINED friend RunningError operator-(const RunningError& x) {
    return {-x.value, x.units};
  }
  STATIONARY_INLINED friend RunningError operator+(const RunningError& x, const RunningError& y) {
    return rounded(x.value + y.value, x.units + y.units);
  }
  STATIONARY_INLINED friend RunningError operator-(const RunningError& x, const RunningError& y) {
    return rounded(x.value - y.value, x.units + y.units);
  }
  STATIONARY_INLINED friend RunningError operator*(const RunningError& x, const RunningError& y) {
    using std::abs;
    return rounded(x.value * y.value, abs(x.value) * y.units + abs(y.value) * x.units);
  }
  STATIONARY_INLINED friend RunningError operator/(const RunningError& x, const RunningError& y) {
    using std::abs;
    const Real inverse = 1.0 / y.value;
    const Real quotient = x.value * inverse;  // rounded twice
    return rounded(quotient, (x.units + abs(quotient) * y.units) * abs(inverse) + abs(quotient));
  }
  STATIONARY_INLINED friend RunningError operator*(double c, const RunningError& x) {
    return rounded(c * x.value, (c < 0.0 ? -c : c) * x.units);
  }
  STATIONARY_INLINED friend RunningError operator*(const RunningError& x, double c) {
    return c * x;
  }
  /// The logarithm of a pack is good to some units in its last place (simd_pack.hpp).
  STATIONARY_INLINED friend RunningError log(const RunningError& x) {
    using std::abs;
    const Real value = log(x.value);
    return rounded(value, x.units / abs(x.value) + 4.0 * (1.0 + abs(value)));
  }

 private:
  STATIONARY_INLINED static RunningError rounded(const Real& x, const Real& error) {
    using std::abs;
    return {x, error + abs(x)};
  }
};

}  // namespace stationary
