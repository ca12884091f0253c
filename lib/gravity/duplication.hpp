// Carlson's integral of an ellipsoid with two of its arguments as a pair,
//
//   F(T, D, z) = R_F(y1, y2, z) = 1/2 int_0^oo [(u^2 + T u + D)(u + z)]^(-1/2) du,
//   T = y1 + y2,  D = y1 y2,
//
// as a power series about (T, D, z). Duplication leaves F as it is and draws the arguments together,
//
//   p = sqrt D,  s = sqrt(T + 2 p),  l = p + s sqrt z,
//   (T, D, z) <- ((T + 2 l)/4, (D + l T + l^2)/16, (z + l)/4);
//
// then, with A = (T + z)/3, Z = 1 - z/A, P = 1 - T/A + D/A^2, E2 = P - Z^2, E3 = P Z,
//
//   F = A^(-1/2) sum_n T_n/(2 n + 1),   n T_n = -(n - 1) E2 T_(n-2) + (n - 3/2) E3 T_(n-3).
//
// Only sums, products and roots of positive numbers: nothing happens where y1 = y2. T^2 >= 4 D is
// not asked for; F is analytic where T > -2 sqrt D.
// Sources: B. C. Carlson, Numer. Algorithms 10 (1995) 13; DLMF 19.36.
#pragma once

#include <type_traits>

#include "lib/gravity/carlson_sum.hpp"
#include "lib/gravity/enclosed_sum.hpp"
#include "lib/gravity/power_series.hpp"
#include "lib/number/double_double.hpp"
#include "lib/number/interval.hpp"

namespace stationary {

namespace duplication {

/// Of many numbers side by side, and whose comparison is of all of them.
template <class S>
concept SideBySide = requires(const S& x) {
  any(x < x);
};

/// Terms of the series that leave less than half a unit in the last place of S of the value and of
/// derivatives up to an order, which each may cost e^-2.
template <class S, int order>
constexpr int last_term() {
  constexpr double bits_each = 6.1;  // -log2(kappa e)
  const auto of_number = [] {
    if constexpr (SideBySide<S>) {
      return significand_bits<double>();
    } else {
      return significand_bits<S>();
    }
  };
  constexpr int bits = of_number() + 20 + 16 * (order > 2 ? order - 2 : 0);
  return static_cast<int>(static_cast<double>(bits) / bits_each) + 1;
}

/// Whether the arguments are near enough to each other; of a number that is none: yes.
template <class S>
bool near_enough(const S& spread) {
  return !(leading(spread) > near * near * near * near);
}
/// Of many numbers: where all are.
template <SideBySide S>
bool near_enough(const S& spread) {
  return !any(S(near * near * near * near) < spread);
}

/// Z^4 + P^2 of numbers: of a pair that is complex, T^2 < 4 D, P is |X|^2, and E2 alone may be
/// small though the pair is far from z.
template <class S>
S spread(const S& T, const S& D, const S& z) {
  const S inverse = S(3.0) / (T + z);
  const S Z = S(1.0) - z * inverse;
  const S P = S(1.0) - T * inverse + D * (inverse * inverse);
  return square(S(Z * Z)) + square(P);
}

}  // namespace duplication

/// F and its derivatives in (T, D, z) up to an order; T, D, z > 0.
template <int order, class S>
PowerSeries<S, order> integral_by_duplication(const S& T0, const S& D0, const S& z0) {
  using Series = PowerSeries<S, order>;
  constexpr int most_steps = 60;  // an argument is at least a quarter as far from the others
  Series T = Series::variable(T0, 0);
  Series D = Series::variable(D0, 1);
  Series z = Series::variable(z0, 2);
  for (int step = 0; step < most_steps; ++step) {
    if (duplication::near_enough(duplication::spread(T.value(), D.value(), z.value()))) break;
    const Series p = sqrt(D);
    const Series l = p + sqrt(T + 2.0 * p) * sqrt(z);
    D = 0.0625 * (D + l * (T + l));
    T = 0.25 * (T + 2.0 * l);
    z = 0.25 * (z + l);
  }
  const Series thrice = T + z;
  const Series inverse = 3.0 * reciprocal(thrice);  // 1/A
  const Series one(S(1.0));
  const Series Z = one - z * inverse;
  const Series P = one - T * inverse + D * (inverse * inverse);
  const Series E2 = P - Z * Z;
  const Series E3 = P * Z;
  constexpr int last = duplication::last_term<S, order>();
  if constexpr (std::is_same_v<S, Interval>) {
    return duplication::enclosed_sum<order, last>(E2, E3) * sqrt(inverse);
  } else {
    const Series sum = duplication::carlson_sum<S>(
        one, Series(-0.5 * E2), last, [&](const Series& T_n) { return E2 * T_n; },
        [&](const Series& T_n) { return E3 * T_n; });
    return sum * sqrt(inverse);
  }
}

// Compiled once, in duplication.cpp, for these orders and numbers: it is long, and every solver comes by it.
#define STATIONARY_DUPLICATIONS(each)                                                         \
  each(1, double) each(2, double) each(3, double) each(0, DoubleDouble) each(1, DoubleDouble) \
      each(2, DoubleDouble) each(1, Interval) each(2, Interval) each(3, Interval)
#define STATIONARY_DECLARED(order, S)                                                      \
  extern template PowerSeries<S, order> integral_by_duplication<order>(const S&, const S&, \
                                                                       const S&);
STATIONARY_DUPLICATIONS(STATIONARY_DECLARED)
#undef STATIONARY_DECLARED

}  // namespace stationary
