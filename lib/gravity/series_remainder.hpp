// What the series of duplication.hpp leaves out after its term N, as an interval: of the tail as a
// function of E2 and E3, |E2| <= e^2, |E3| <= e^3,
//
//   |d^(a+b) tail/dE2^a dE3^b| <= sum_(n > N) (n/2)^a (n/3)^b kappa^n e^(n - 2 a - 3 b)/(2 n + 1),
//
// kappa = 1.3248 > 1/x, x the root of x^2 + x^3 = 1: |T_n| <= (kappa e)^n by its recurrence. Only an
// interval asks for it; in other number types it is below their rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/gravity/power_series.hpp"
#include "lib/number/interval.hpp"

namespace stationary {

template <class S, int order>
void add_remainder(const PowerSeries<S, order>&, const PowerSeries<S, order>&, int,
                   PowerSeries<S, order>&) {}

/// The bound of one derivative; infinite where the terms do not fall fast enough.
inline double remainder_bound(int a, int b, double e, int last) {
  const Interval ratio = Interval(1.3248) * e;
  const Interval n(static_cast<double>(last + 1));
  Interval term(1.0);
  for (int k = 0; k < last + 1 - 2 * a - 3 * b; ++k) term = term * ratio;
  for (int k = 0; k < 2 * a + 3 * b; ++k) term = term * Interval(1.3248);
  for (int k = 0; k < a; ++k) term = term * (0.5 * n);
  for (int k = 0; k < b; ++k) term = term * (n / Interval(3.0));
  term = term / (2.0 * n + Interval(1.0));
  // A term is at most ratio (1 + 1/n)^(a + b) times the one before.
  Interval growth = ratio;
  for (int k = 0; k < a + b; ++k) growth = growth * (Interval(1.0) + Interval(1.0) / n);
  if (!(growth.hi < 0.5)) return std::numeric_limits<double>::infinity();
  return (term / (Interval(1.0) - growth)).hi;
}

template <int order>
void add_remainder(const PowerSeries<Interval, order>& E2, const PowerSeries<Interval, order>& E3,
                   int last, PowerSeries<Interval, order>& sum) {
  const double e = above(std::max(above(std::sqrt(E2.value().magnitude())),
                                  above(above(std::cbrt(E3.value().magnitude())) * 0x1.000001p0)));
  using Series = PowerSeries<Interval, order>;
  const Series d2 = E2.nilpotent();
  const Series d3 = E3.nilpotent();
  Series power2(Interval(1.0));
  double factorial_a = 1.0;
  for (int a = 0; a <= order; ++a) {
    Series power = power2;
    double factorials = factorial_a;
    for (int b = 0; a + b <= order; ++b) {
      const double bound = above(remainder_bound(a, b, e, last) / factorials);
      const Interval coefficient(-bound, bound);
      for (std::size_t n = 0; n < sum.c.size(); ++n) sum.c[n] = sum.c[n] + coefficient * power.c[n];
      power = power * d3;
      factorials *= b + 1.0;
    }
    power2 = power2 * d2;
    factorial_a *= a + 1.0;
  }
}

}  // namespace stationary
