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
// kappa = 1.3248 > 1/x, x the root of x^2 + x^3 = 1: |T_n| <= (kappa e)^n by its recurrence
// (carlson_sum.hpp). In other number types the tail is below their rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/gravity/carlson_sum.hpp"
#include "lib/gravity/power_series.hpp"
#include "lib/number/elementary.hpp"
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

/// A polynomial in E2 - E2_0 and E3 - E3_0, cut after a total order: c[a][b] of their powers a, b.
template <int order>
struct TwoVariables {
  static constexpr auto size = std::size_t(order) + 1;
  std::array<std::array<Interval, size>, size> c{};

  /// f(a, b) of every coefficient.
  template <class F>
  static void each(const F& f) {
    for (std::size_t a = 0; a < size; ++a)
      for (std::size_t b = 0; a + b < size; ++b) f(a, b);
  }
  friend TwoVariables operator+(TwoVariables x, const TwoVariables& y) {
    each([&](std::size_t a, std::size_t b) { x.c[a][b] += y.c[a][b]; });
    return x;
  }
  friend TwoVariables operator-(TwoVariables x, const TwoVariables& y) {
    each([&](std::size_t a, std::size_t b) { x.c[a][b] -= y.c[a][b]; });
    return x;
  }
  friend TwoVariables operator*(const Interval& factor, TwoVariables x) {
    each([&](std::size_t a, std::size_t b) { x.c[a][b] = factor * x.c[a][b]; });
    return x;
  }
  /// Times E2 = value + the first variable, and likewise E3.
  TwoVariables times_first(const Interval& value) const {
    TwoVariables out = value * *this;
    each([&](std::size_t a, std::size_t b) {
      if (a > 0) out.c[a][b] += c[a - 1][b];
    });
    return out;
  }
  TwoVariables times_second(const Interval& value) const {
    TwoVariables out = value * *this;
    each([&](std::size_t a, std::size_t b) {
      if (b > 0) out.c[a][b] += c[a][b - 1];
    });
    return out;
  }
};

/// The sum with the bounds of its tail.
template <int order>
TwoVariables<order> sum_in_two(const Interval& E2, const Interval& E3, int last) {
  using Two = TwoVariables<order>;
  Two one;
  one.c[0][0] = 1.0;
  Two sum = carlson_sum<Interval>(
      one, Interval(-0.5) * one.times_first(E2), last,
      [&](const Two& T_n) { return T_n.times_first(E2); },
      [&](const Two& T_n) { return T_n.times_second(E3); });
  const double e = above(std::max(above(std::sqrt(E2.magnitude())),
                                  above(above(cube_root(E3.magnitude())) * 0x1.000001p0)));
  Two::each([&](std::size_t a, std::size_t b) {
    double factorials = 1.0;
    for (const std::size_t of : {a, b})
      for (std::size_t m = 2; m <= of; ++m) factorials *= static_cast<double>(m);
    const double bound =
        above(remainder_bound(static_cast<int>(a), static_cast<int>(b), e, last) / factorials);
    sum.c[a][b] += Interval(-bound, bound);
  });
  return sum;
}

template <int order>
PowerSeries<Interval, order> enclosed_sum(const PowerSeries<Interval, order>& E2,
                                          const PowerSeries<Interval, order>& E3, int last) {
  using Series = PowerSeries<Interval, order>;
  const auto c = sum_in_two<order>(E2.value(), E3.value(), last).c;
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
