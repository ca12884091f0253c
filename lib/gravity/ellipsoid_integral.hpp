// F(T, D, z) of duplication.hpp in every number type: value and derivatives up to an order, as a
// power series.
//
//   doubles, pairs, packs, multiprecision, jets: duplication in the type itself
//   intervals: every mixed derivative is completely monotone, (-1)^(i+j+k) F_ijk > 0 and falling in
//     each argument, so two points give the exact hull over a box
//   dual numbers, Taylor numbers, numbers with their conditioning: the series of as many orders more
//     at the value, and the chain rule; no slope goes through the duplication
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/gravity/duplication.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/first_order_bound.hpp"
#include "lib/number/interval.hpp"
#include "lib/number/taylor.hpp"

namespace stationary {

template <int order, class S>
PowerSeries<S, order> ellipsoid_integral(const S& T, const S& D, const S& z) {
  return integral_by_duplication<order>(T, D, z);
}

/// Of a box of positive numbers; entire otherwise.
template <int order>
PowerSeries<Interval, order> ellipsoid_integral(const Interval& T, const Interval& D,
                                                const Interval& z) {
  PowerSeries<Interval, order> out;
  if (!T.positive() || !D.positive() || !z.positive()) {
    out.c.fill(Interval::entire());
    return out;
  }
  const auto least = integral_by_duplication<order>(Interval(T.lo), Interval(D.lo), Interval(z.lo));
  const auto most =
      T.lo == T.hi && D.lo == D.hi && z.lo == z.hi
          ? least
          : integral_by_duplication<order>(Interval(T.hi), Interval(D.hi), Interval(z.hi));
  for (std::size_t n = 0; n < out.c.size(); ++n) {
    Interval both = hull(least.c[n], most.c[n]);
    // The sign that it has.
    if (Monomials<order>::powers[n].total() % 2 == 0) {
      both.lo = std::max(both.lo, 0.0);
    } else {
      both.hi = std::min(both.hi, 0.0);
    }
    out.c[n] = both.bounded() ? both : Interval::entire();
  }
  return out;
}

namespace detail {

/// The derivatives of coefficient n of a series in the three arguments.
template <class S, int order>
std::array<S, 3> coefficient_slopes(const PowerSeries<S, order>& series, const Powers& p) {
  const auto at = [&](const Powers& next, int factor) {
    return S(static_cast<double>(factor) * series.c[Monomials<order>::place(next)]);
  };
  return {at({p.i + 1, p.j, p.k}, p.i + 1), at({p.i, p.j + 1, p.k}, p.j + 1),
          at({p.i, p.j, p.k + 1}, p.k + 1)};
}

}  // namespace detail

template <int order, class U, std::size_t N>
PowerSeries<Dual<U, N>, order> ellipsoid_integral(const Dual<U, N>& T, const Dual<U, N>& D,
                                                  const Dual<U, N>& z) {
  const auto series = ellipsoid_integral<order + 1>(T.value, D.value, z.value);
  PowerSeries<Dual<U, N>, order> out;
  for (std::size_t n = 0; n < out.c.size(); ++n) {
    const auto slopes = detail::coefficient_slopes(series, Monomials<order>::powers[n]);
    out.c[n].value = series.c[n];
    for (std::size_t k = 0; k < N; ++k)
      out.c[n].slope[k] = slopes[0] * T.slope[k] + slopes[1] * D.slope[k] + slopes[2] * z.slope[k];
  }
  return out;
}

/// A Taylor number of order M: the series of M orders more, expanded about the value.
template <int order, class U, int M>
PowerSeries<Taylor<U, M>, order> ellipsoid_integral(const Taylor<U, M>& T, const Taylor<U, M>& D,
                                                    const Taylor<U, M>& z) {
  using Number = Taylor<U, M>;
  const auto series = ellipsoid_integral<order + M>(T.value, D.value, z.value);
  // Powers of what is added to the values.
  const auto powers_of = [](Number x) {
    x[0] = U(0.0);
    std::array<Number, std::size_t(M) + 1> out;
    out[0] = Number(1.0);
    for (std::size_t k = 1; k < out.size(); ++k) out[k] = out[k - 1] * x;
    return out;
  };
  const auto T_powers = powers_of(T);
  const auto D_powers = powers_of(D);
  const auto z_powers = powers_of(z);
  const auto choose = [](int n, int k) {
    double out = 1.0;
    for (int j = 1; j <= k; ++j) out = out * (n - k + j) / j;
    return out;
  };
  PowerSeries<Number, order> out;
  for (std::size_t n = 0; n < out.c.size(); ++n) {
    const Powers& at = Monomials<order>::powers[n];
    for (const Powers& more : Monomials<M>::powers) {
      const Powers both{at.i + more.i, at.j + more.j, at.k + more.k};
      const double ways = choose(both.i, more.i) * choose(both.j, more.j) * choose(both.k, more.k);
      out.c[n] += Number(U(ways * series.c[Monomials<order + M>::place(both)])) *
                  (T_powers[std::size_t(more.i)] * D_powers[std::size_t(more.j)] *
                   z_powers[std::size_t(more.k)]);
    }
  }
  return out;
}

template <int order>
PowerSeries<Conditioned, order> ellipsoid_integral(const Conditioned& T, const Conditioned& D,
                                                   const Conditioned& z) {
  const auto series = ellipsoid_integral<order + 1>(T.value, D.value, z.value);
  PowerSeries<Conditioned, order> out;
  for (std::size_t n = 0; n < out.c.size(); ++n) {
    const auto slopes = detail::coefficient_slopes(series, Monomials<order>::powers[n]);
    out.c[n] = {series.c[n], std::abs(slopes[0]) * T.condition + std::abs(slopes[1]) * D.condition +
                                 std::abs(slopes[2]) * z.condition};
  }
  return out;
}

}  // namespace stationary
