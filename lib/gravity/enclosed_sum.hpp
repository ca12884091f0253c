// The series of duplication.hpp over intervals, sum_n T_n/(2 n + 1) with what is left out after its
// term N. T_n is a polynomial in E2 and E3 alone, of the monomials E2^i E3^j with 2 i + 3 j = n, so
// that the sum is one of some twenty constants. By Horner's form it is expanded in these two,
//
//   sum c_ab (E2 - E2_0)^a (E3 - E3_0)^b,   a + b <= order,
//
// and E2 and E3 as series are put into it: a third of the recurrence's products. The tail as a
// function of E2 and E3, |E2| <= e^2, |E3| <= e^3, has
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

#include "lib/gravity/power_series.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/interval.hpp"

namespace stationary::duplication {

/// Z^4 + P^2 <= near^4 leaves |E2| <= e^2, |E3| <= e^3 with e = 1.19 near.
constexpr double near = 0.0089;

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

/// What is left out after term `last`, where E2 and E3 are as small as duplication makes them.
template <int order, int last>
class TailBounds {
 public:
  TailBounds() {
    for (std::size_t a = 0; a < size; ++a)
      for (std::size_t b = 0; a + b < size; ++b) bound_[a][b] = at(a, b, smallness);
  }
  /// Of the coefficient of the powers a, b, where |E2| <= e^2 and |E3| <= e^3.
  double operator()(std::size_t a, std::size_t b, double e) const {
    return e <= smallness ? bound_[a][b] : at(a, b, e);
  }

 private:
  static constexpr auto size = std::size_t(order) + 1;
  static constexpr double smallness = 1.19 * near;

  static double at(std::size_t a, std::size_t b, double e) {
    double factorials = 1.0;
    for (const std::size_t of : {a, b})
      for (std::size_t m = 2; m <= of; ++m) factorials *= static_cast<double>(m);
    return above(remainder_bound(static_cast<int>(a), static_cast<int>(b), e, last) / factorials);
  }

  std::array<std::array<double, size>, size> bound_{};
};

/// The constants of the sum up to term `last`: [j][i] of E2^i E3^j, 2 i + 3 j <= last.
template <int last>
class SumConstants {
 public:
  static constexpr auto of_second = std::size_t(last) / 3 + 1;
  static constexpr auto of_first = std::size_t(last) / 2 + 1;
  std::array<std::array<Interval, of_first>, of_second> c{};

  SumConstants() {
    // n T_n = -(n - 1) E2 T_(n-2) + (n - 3/2) E3 T_(n-3), term by term.
    auto t = c;
    for (std::size_t j = 0; j < of_second; ++j) {
      for (std::size_t i = 0; i < count(j); ++i) {
        const auto n = static_cast<double>(2 * i + 3 * j);
        if (n == 0.0) t[j][i] = 1.0;
        if (i > 0) t[j][i] -= Interval(n - 1.0) / Interval(n) * t[j][i - 1];
        if (j > 0) t[j][i] += Interval(n - 1.5) / Interval(n) * t[j - 1][i];
        c[j][i] = t[j][i] / Interval(2.0 * n + 1.0);
      }
    }
  }
  /// How many i there are for j.
  static constexpr std::size_t count(std::size_t j) { return (std::size_t(last) - 3 * j) / 2 + 1; }
};

/// c_ab of the sum, with the bounds of its tail.
template <int order, int last>
auto sum_in_two(const Interval& E2, const Interval& E3) {
  constexpr auto size = std::size_t(order) + 1;
  static const SumConstants<last> constants;
  static const TailBounds<order, last> tail;
  std::array<std::array<Interval, size>, size> out{};
  for (std::size_t j = constants.of_second; j-- > 0;) {
    // The constants of E3^j, expanded in E2.
    std::array<Interval, size> inner{};
    for (std::size_t i = constants.count(j); i-- > 0;) {
      for (std::size_t a = size; a-- > 0;) {
        inner[a] = inner[a] * E2;
        if (a > 0) inner[a] += inner[a - 1];
      }
      inner[0] += constants.c[j][i];
    }
    for (std::size_t a = 0; a < size; ++a) {
      for (std::size_t b = size - a; b-- > 0;) {
        out[a][b] = out[a][b] * E3;
        if (b > 0) out[a][b] += out[a][b - 1];
      }
      out[a][0] += inner[a];
    }
  }
  const double e = above(std::max(above(std::sqrt(E2.magnitude())),
                                  above(above(cube_root(E3.magnitude())) * 0x1.000001p0)));
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; a + b < size; ++b) {
      const double bound = tail(a, b, e);
      out[a][b] += Interval(-bound, bound);
    }
  }
  return out;
}

template <int order, int last>
PowerSeries<Interval, order> enclosed_sum(const PowerSeries<Interval, order>& E2,
                                          const PowerSeries<Interval, order>& E3) {
  using Series = PowerSeries<Interval, order>;
  const auto c = sum_in_two<order, last>(E2.value(), E3.value());
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
