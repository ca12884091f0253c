// The size of the terms of an expression: sums and differences add magnitudes,
//
//   |a + b|, |a - b| <- |a| + |b|,   |a b| <- |a| |b|,   |a / b| <- |a| / |b|,   log a <- |log a|,
//
// so that a balance evaluated in it is what rounding errors, and changes of a coefficient, are to
// be measured against. Divisors and arguments of log must be products of positive numbers.
#pragma once

#include <cmath>

#include "lib/number/number.hpp"

namespace stationary {

template <class Real>
struct TermSize {
  Real value{0.0};

  TermSize() = default;
  TermSize(double x) : value(x < 0.0 ? -x : x) {}  // NOLINT(google-explicit-constructor)
  /// x >= 0.
  explicit TermSize(const Real& x) requires(!std::is_same_v<Real, double>) : value(x) {}

  [[gnu::always_inline]] friend TermSize operator+(const TermSize& x, const TermSize& y) {
    return TermSize(x.value + y.value);
  }
  [[gnu::always_inline]] friend TermSize operator-(const TermSize& x, const TermSize& y) {
    return x + y;
  }
  [[gnu::always_inline]] friend TermSize operator*(const TermSize& x, const TermSize& y) {
    return TermSize(x.value * y.value);
  }
  [[gnu::always_inline]] friend TermSize operator/(const TermSize& x, const TermSize& y) {
    return TermSize(x.value / y.value);
  }
  [[gnu::always_inline]] friend TermSize log(const TermSize& x) {
    using std::abs;
    return TermSize(abs(log(x.value)));
  }
};

}  // namespace stationary
