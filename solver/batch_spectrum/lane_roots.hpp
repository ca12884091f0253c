// Roots of quadratics and cubics in the lanes of a pack, in pairs of doubles: what polynomial.hpp
// does one at a time,
//
//   x^3 + ... = (x - r)(x^2 + b x + c),  r by Newton from beyond the inflection's isolated side,
//
// then the quadratic, its smaller root as a quotient.
#pragma once

#include "lib/number/polynomial.hpp"
#include "lib/number/simd_pack.hpp"

namespace stationary {

template <class V>
struct LaneRootPair {
  Pair<V> mean;
  Pair<V> separation;  ///< mean +- sqrt(separation); complex where negative, small and large unused
  Pair<V> small;
  Pair<V> large;
};

template <class V>
[[gnu::always_inline]] inline LaneRootPair<V> lane_quadratic_roots(const Pair<V>& b,
                                                                   const Pair<V>& c) {
  LaneRootPair<V> out;
  out.mean = -0.5 * b;
  out.separation = renormalized(out.mean * out.mean - c);
  const Pair<V> root = sqrt(out.separation);
  const auto left = leading(out.mean) < V(0.0);
  out.large = renormalized(select(left, out.mean - root, out.mean + root));
  out.small = c / out.large;
  return out;
}

template <class V>
struct LaneCubicRoots {
  Pair<V> single;
  LaneRootPair<V> pair;
};

/// At least the cube root of x >= 0, at most four times it.
template <int bytes>
[[gnu::always_inline]] inline Pack<bytes> above_cube_root(const Pack<bytes>& x) {
  using P = Pack<bytes>;
  using Unsigned = typename PackRegister<bytes>::Unsigned;
  using Register = typename PackRegister<bytes>::Double;
  const P third = (split_exponent(x).k + 3.0) * (1.0 / 3.0);  // of an exponent above x's
  // 2^third rounded up: whole numbers in the low bits beyond 2^52, shifted into the exponent.
  const P raised = third + (0x1.8p52 + 1024.0);
  const auto power = [](Register r) {
    return std::bit_cast<Register>(std::bit_cast<Unsigned>(r) << 52);
  };
  return {power(raised.a), power(raised.b)};
}

/// Lanes whose roots are not found, near triple ones, are cleared in `known`; others are not
/// waited for.
template <class V>
[[gnu::always_inline]] inline LaneCubicRoots<V> lane_cubic_roots(const Polynomial<Pair<V>, 3>& p,
                                                                 typename V::Mask& known) {
  using Mask = typename V::Mask;
  const Pair<V> inverse = Pair<V>(1.0) / p.c[3];
  const Pair<V> c0 = p.c[0] * inverse;
  const Pair<V> c1 = p.c[1] * inverse;
  const Pair<V> c2 = p.c[2] * inverse;
  const V a0 = leading(c0);
  const V a1 = leading(c1);
  const V a2 = leading(c2);
  // y^3 + P y + Q in y = x - inflection has its isolated root on the side of -Q: three real ones
  // within 2 sqrt(-P/3), one alone within that and the cube root of Q.
  const V inflection = -(a2 * (1.0 / 3.0));
  const V P = a1 + a2 * inflection;
  const V Q = ((inflection + a2) * inflection + a1) * inflection + a0;
  const V size = abs(inflection);
  known = known & ((0x1p-10 * (size * size) < abs(P)) | (0x1p-15 * (size * size * size) < abs(Q)));
  V bound = sqrt(select(P < V(0.0), P * (-4.0 / 3.0), V(0.0)));
  const Mask alone = V(0.0) < 4.0 * (P * P * P) + 27.0 * (Q * Q);
  bound = bound + select(alone, above_cube_root(abs(Q)), V(0.0));
  V r = inflection + select(Q < V(0.0), bound, -bound);
  Mask moving = known;
  constexpr int most = 30;
  for (int k = 0; k < most; ++k) {
    const V value = ((r + a2) * r + a1) * r + a0;
    const V slope = (3.0 * r + 2.0 * a2) * r + a1;
    const V step = value / slope;
    r = select(moving, r - step, r);
    moving = moving & ~(abs(step) <= 1e-9 * abs(r));
    if (!any(moving)) break;
  }
  known = known & ~moving;
  Pair<V> x(r);
  for (int k = 0; k < 2; ++k) {
    const V slope = (3.0 * x.hi + 2.0 * a2) * x.hi + a1;
    const V step = leading(((x + c2) * x + c1) * x + c0) / slope;
    x = two_sum(x.hi, x.lo - step);
  }
  LaneCubicRoots<V> out;
  out.single = x;
  // From the end where nothing cancels.
  const Mask outer = abs(a0) <= abs(x.hi * x.hi * x.hi);
  const Pair<V> reciprocal = Pair<V>(1.0) / x;
  const Pair<V> c_outer = -(c0 * reciprocal);
  const Pair<V> b_outer = (c_outer - c1) * reciprocal;
  const Pair<V> b_inner = c2 + x;
  const Pair<V> c_inner = c1 + x * b_inner;
  out.pair = lane_quadratic_roots(renormalized(select(outer, b_outer, b_inner)),
                                  renormalized(select(outer, c_outer, c_inner)));
  return out;
}

}  // namespace stationary
