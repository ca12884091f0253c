// The series of duplication.hpp over intervals, sum_n T_n/(2 n + 1) with what is left out after its
// term N. As T_n is a polynomial in E2 and E3 alone, it is expanded in these two,
//
//   sum c_ab (E2 - E2_0)^a (E3 - E3_0)^b,   a + b <= order,
//
// and E2 and E3 as series put into it: a third of the products. The tail as a function of E2 and E3,
// |E2| <= e^2, |E3| <= e^3, has
//
//   |d^(a+b) tail/dE2^a dE3^b| <= sum_(n > N) (n/2)^a (n/3)^b kappa^n e^(n - 2 a - 3 b)/(2 n + 1),
//
// kappa = 1.3248 > 1/x, x the root of x^2 + x^3 = 1: |T_n| <= (kappa e)^n by its recurrence. In other
// number types it is below their rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/gravity/power_series.hpp"
#include "lib/number/interval.hpp"

namespace stationary::duplication {

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

/// Coefficients of (E2 - E2_0)^a (E3 - E3_0)^b, a + b <= order, at [a][b].
template <int order>
using TwoVariables =
    std::array<std::array<Interval, std::size_t(order) + 1>, std::size_t(order) + 1>;

/// T_1 = 0, T_0 = 1, and the sum with the bounds of its tail.
template <int order>
TwoVariables<order> sum_in_two(const Interval& E2, const Interval& E3, int last) {
  using Two = TwoVariables<order>;
  const auto each = [](const auto& f) {
    for (std::size_t a = 0; a <= std::size_t(order); ++a)
      for (std::size_t b = 0; a + b <= std::size_t(order); ++b) f(a, b);
  };
  const auto fraction = [](int p, int q) {
    return Interval(static_cast<double>(p)) / Interval(static_cast<double>(q));
  };
  Two before[3] = {};  // T_(n-3), T_(n-2), T_(n-1)
  before[0][0][0] = 1.0;
  before[2][0][0] = -0.5 * E2;
  if constexpr (order > 0) before[2][1][0] = -0.5;
  Two sum{};
  each([&](std::size_t a, std::size_t b) {
    sum[a][b] = before[0][a][b] + fraction(1, 5) * before[2][a][b];
  });
  for (int n = 3; n <= last; ++n) {
    const Interval of_third = fraction(2 * n - 3, 2 * n);
    const Interval of_second = fraction(n - 1, n);
    const Interval weight = fraction(1, 2 * n + 1);
    Two next{};
    each([&](std::size_t a, std::size_t b) {
      Interval third = E3 * before[0][a][b];
      if (b > 0) third += before[0][a][b - 1];
      Interval second = E2 * before[1][a][b];
      if (a > 0) second += before[1][a - 1][b];
      next[a][b] = of_third * third - of_second * second;
      sum[a][b] += weight * next[a][b];
    });
    before[0] = before[1];
    before[1] = before[2];
    before[2] = next;
  }
  const double e = above(std::max(above(std::sqrt(E2.magnitude())),
                                  above(above(std::cbrt(E3.magnitude())) * 0x1.000001p0)));
  each([&](std::size_t a, std::size_t b) {
    double factorials = 1.0;
    for (const std::size_t of : {a, b})
      for (std::size_t m = 2; m <= of; ++m) factorials *= static_cast<double>(m);
    const double bound =
        above(remainder_bound(static_cast<int>(a), static_cast<int>(b), e, last) / factorials);
    sum[a][b] += Interval(-bound, bound);
  });
  return sum;
}

template <int order>
PowerSeries<Interval, order> enclosed_sum(const PowerSeries<Interval, order>& E2,
                                          const PowerSeries<Interval, order>& E3, int last) {
  using Series = PowerSeries<Interval, order>;
  const TwoVariables<order> c = sum_in_two<order>(E2.value(), E3.value(), last);
  const Series d2 = E2.nilpotent();
  const Series d3 = E3.nilpotent();
  // Horner's form in d2, and in d3 of each of its coefficients.
  const auto in_third = [&](std::size_t a) {
    Series out(c[a][std::size_t(order) - a]);
    for (std::size_t b = std::size_t(order) - a; b-- > 0;) {
      out = d3 * out;
      out.c[0] = c[a][b];
    }
    return out;
  };
  Series out = in_third(std::size_t(order));
  for (std::size_t a = std::size_t(order); a-- > 0;) out = d2 * out + in_third(a);
  return out;
}

}  // namespace stationary::duplication
