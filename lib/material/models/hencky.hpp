// hencky:  W = mu tr (ln S)^2 + (lambda/2) ln^2 d in the plane
//            = ((mu + lambda)/2) ln^2 d + (mu/2) ln^2 (lambda_1/lambda_2),
// lambda_1 >= lambda_2 the principal stretches. With x = e/t^2 = 1 - 4 d/t^2 in [0, 1):
//   ln^2 (lambda_1/lambda_2) = 4 atanh^2 sqrt x = 4 x B(x)^2,   B(x) = atanh(sqrt x)/sqrt x,
// and B is analytic at x = 0 (the circle): no square root of a difference enters. Since
// dx/dt = 2 (1 - x)/t and dx/dl = -(1 - x), only B and B' occur in the derivatives to second order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/interval.hpp"
#include "lib/number/odd_reciprocal.hpp"

namespace stationary {

/// B(x) = atanh(sqrt x)/sqrt x and B'(x), both to full precision on [0, 1).
template <class S>
struct AtanhRatio {
  S b;
  S b_x = poison<S>();
};

/// Below x = 1/4 the series sum x^k/(2k+1), its length chosen from x; above it, where nothing
/// cancels by more than a factor of ten, B from a logarithm and x B' = (1/(1 - x) - B)/2. A value
/// alone loses nothing in the logarithm down to far smaller x, and a wide number starts its series
/// there. Needs 1 - x = 4 d/t^2 separately, since x may round to 1.
template <int order, class S>
AtanhRatio<S> atanh_ratio(const PlanarInvariants<S>& q, const S& x, const S& one_minus_x) {
  using std::sqrt;
  constexpr int bits = significand_bits<S>();
  double size = leading(x);
  if constexpr (over_intervals<S>) size = values_of(x).magnitude();
  const double series_below = (order >= 2 || bits <= 64) ? 0.25 : 0x1p-16;
  AtanhRatio<S> out;
  if (size < series_below) {
    const int bits_per_term = size > 0.0 ? -std::ilogb(size) - 1 : bits;
    int last = bits / (bits_per_term < 1 ? 1 : bits_per_term) + 1;
    if constexpr (over_intervals<S>) last = std::max(last, 8);
    S b = odd_reciprocal<S>(last);
    S b_x = S(0.0);
    if constexpr (over_intervals<S>) {
      // The terms from x^(last + 1) on, over x^last: x times a number below 1, and a slope below 1.
      // For |x| < 1/4 and last >= 8 so wide a number leaves room for their derivatives too, up to
      // the third.
      const S rest(Interval(-1.0, 1.0));
      b = b + x * rest;
      b_x = rest;
    }
    for (int k = last - 1; k >= 0; --k) {
      if constexpr (order >= 2) b_x = b_x * x + b;
      b = b * x + odd_reciprocal<S>(k);
    }
    out.b = b;
    if constexpr (order >= 2) out.b_x = b_x;
  } else {
    const S root = sqrt(q.e);
    const S sum = q.t + root;
    out.b = log(sum * sum / (4.0 * q.d)) * q.t / (2.0 * root);
    if constexpr (order >= 2) out.b_x = (S(1.0) / one_minus_x - out.b) / (2.0 * x);
  }
  return out;
}

/// B and B' at x in [0, 1), with y = 1 - x: by the series below 1/4, its rest summed as geometric.
template <int order>
AtanhRatio<Interval> atanh_ratio_at(const Interval& x, const Interval& y) {
  AtanhRatio<Interval> out;
  if (x.hi < 0.25) {
    // The terms from x^(last + 1) on, over x^last: at most a geometric series, and its slope.
    constexpr int last = 30;
    const Interval rest = Interval(0.0, 1.0) * odd_reciprocal<Interval>(last + 1) / y;
    Interval b = odd_reciprocal<Interval>(last) + x * rest;
    Interval b_x = rest / y;
    for (int k = last - 1; k >= 0; --k) {
      if constexpr (order >= 2) b_x = b_x * x + b;
      b = b * x + odd_reciprocal<Interval>(k);
    }
    out.b = b;
    if constexpr (order >= 2) out.b_x = b_x;
  } else {
    const Interval root = sqrt(x);
    out.b = log(square(Interval(1.0) + root) / y) / (2.0 * root);
    if constexpr (order >= 2) out.b_x = (Interval(1.0) / y - out.b) / (2.0 * x);
  }
  return out;
}

/// Over an interval: all terms of the series are positive, so B and B' increase with x and its ends
/// decide, each with the formula that is right there.
template <int order>
AtanhRatio<Interval> atanh_ratio(const PlanarInvariants<Interval>&, const Interval& x,
                                 const Interval& one_minus_x) {
  AtanhRatio<Interval> out{Interval::entire(), Interval::entire()};
  if (!one_minus_x.positive() || !x.bounded()) return out;
  const Interval smallest(std::max(x.lo, 0.0));
  const Interval rest(one_minus_x.lo);
  const Interval largest = Interval(1.0) - rest;
  const auto least = atanh_ratio_at<order>(smallest, Interval(1.0) - smallest);
  const Interval end(x.hi);
  const auto most = largest.lo > x.hi ? atanh_ratio_at<order>(end, Interval(1.0) - end)
                                      : atanh_ratio_at<order>(largest, rest);
  out.b = {least.b.lo, most.b.hi};
  if constexpr (order >= 2) out.b_x = {least.b_x.lo, most.b_x.hi};
  return out;
}

template <class C = double>
struct Hencky {
  C mu;
  C lambda;

  /// W_t > 0 everywhere.
  static constexpr bool rises_with_trace = true;
  static constexpr std::string_view name = "hencky";
  static constexpr std::string_view formula = "mu tr (ln S)^2 + (lambda/2) ln^2 d";
  static constexpr std::array<std::string_view, 2> parameters{"mu", "lambda"};
  static constexpr std::array<std::string_view, 2> domain{"mu > 0", "mu + lambda > 0"};

  std::array<C, 2> coefficients() const { return {mu, lambda}; }
  std::array<bool, 2> in_domain() const { return {mu > 0.0, mu + lambda > 0.0}; }
  double rest_stretch() const { return 1.0; }

  /// In u = ln xi, v = ln zeta W is quadratic: mu (u^2 + v^2) + (lambda/2) (u + v)^2.
  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    const S u = log(xi);
    const S v = log(zeta);
    // In the wider type: S may be more precise than the coefficients.
    const Product<C, S> own = Product<C, S>(2.0 * mu) + lambda;
    const S pull_xi = c_xi * square(xi);
    const S pull_zeta = c_zeta * square(zeta);
    return {.g_xi = own * u + lambda * v - pull_xi,
            .g_zeta = own * v + lambda * u - pull_zeta,
            .uu = own - 2.0 * pull_xi,
            .uv = Product<C, S>(lambda),
            .vv = own - 2.0 * pull_zeta};
  }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& q) const {
    PlanarDerivatives<Product<C, S>> out;
    const S l = log(q.d);
    const S t2 = q.t * q.t;
    const S x = q.e / t2;
    const S one_minus_x = 4.0 * q.d / t2;
    const AtanhRatio<S> ratio = atanh_ratio<order>(q, x, one_minus_x);
    const auto bulk = Product<C, S>(mu) + lambda;
    out.w = 0.5 * bulk * (l * l) + 2.0 * mu * (x * ratio.b * ratio.b);
    if constexpr (order >= 1) {
      const auto shear = 2.0 * mu * ratio.b;
      out.w_t = 2.0 * shear / q.t;
      out.w_l = bulk * l - shear;
      if constexpr (order >= 2) {
        const auto slope = 2.0 * mu * (one_minus_x * ratio.b_x);
        out.w_tt = (4.0 * slope - 2.0 * shear) / t2;
        out.w_tl = -2.0 * slope / q.t;
        out.w_ll = bulk + slope;
      }
    }
    return out;
  }
};

}  // namespace stationary
