// The modes of a pack's cells, in pairs of doubles as spectrum.cpp has them.
#pragma once

#include "lib/stability/linearization.hpp"
#include "solver/batch_spectrum/lane_roots.hpp"

namespace stationary {

/// Five modes of a pack, put in the order of Spectrum::mode.
template <class V>
struct LaneModes {
  using Mask = typename V::Mask;
  V re[5];
  V im[5];
  V krein[5];

  /// Of a real Lambda; krein where it is negative.
  [[gnu::always_inline]] void set_real(int k, const Pair<V>& lambda, const V& sign) {
    const V x = leading(lambda);
    const Mask negative = x < V(0.0);
    re[k] = select(negative, V(0.0), sqrt(abs(x)));
    im[k] = select(negative, sqrt(abs(x)), V(0.0));
    krein[k] = select(negative, sign, V(0.0));
  }
  /// Two of a pair of Lambda, real or complex.
  template <class Sign>
  [[gnu::always_inline]] void set_pair(int k, const LaneRootPair<V>& pair, const Sign& sign) {
    set_real(k, pair.small, sign(pair.small));
    set_real(k + 1, pair.large, sign(pair.large));
    const V mean = leading(pair.mean);
    const V separation = leading(pair.separation);
    const Mask complex = separation < V(0.0);
    if (!any(complex)) return;
    const V half = 0.5 * sqrt(abs(separation));
    const V size = sqrt(mean * mean + abs(separation));
    const V one = sqrt(0.5 * (size + abs(mean)));
    const V other = half / one;
    const Mask right = V(0.0) < mean;
    for (int i = k; i < k + 2; ++i) {
      re[i] = select(complex, select(right, one, other), re[i]);
      im[i] = select(complex, select(right, other, one), im[i]);
      krein[i] = select(complex, V(0.0), krein[i]);
    }
  }
  [[gnu::always_inline]] void set_zero(int k, const Mask& where) {
    re[k] = select(where, V(0.0), re[k]);
    im[k] = select(where, V(0.0), im[k]);
    krein[k] = select(where, V(0.0), krein[k]);
  }

  [[gnu::always_inline]] void sort() {
    constexpr int network[9][2] = {{0, 3}, {1, 4}, {0, 2}, {1, 3}, {0, 1},
                                   {2, 4}, {1, 2}, {3, 4}, {2, 3}};
    for (const auto& pair : network) {
      const int i = pair[0];
      const int j = pair[1];
      const Mask swap = (im[j] < im[i]) | ((im[j] == im[i]) & (re[j] < re[i]));
      for (V* column : {re, im, krein}) {
        const V low = select(swap, column[j], column[i]);
        column[j] = select(swap, column[i], column[j]);
        column[i] = low;
      }
    }
  }
};

/// (i).
template <class V>
[[gnu::always_inline]] inline LaneModes<V> in_plane_modes(const StraightState<Pair<V>>& s,
                                                          const typename V::Mask& symmetric,
                                                          typename V::Mask& known) {
  using Mask = typename V::Mask;
  LaneModes<V> out;
  const LaneCubicRoots<V> even =
      lane_cubic_roots(even_pencil_i(s).characteristic_separable(), known);
  out.set_real(0, even.single, V(1.0));
  out.set_real(1, even.pair.small, V(1.0));
  out.set_real(2, even.pair.large, V(1.0));

  const OddForms<Pair<V>> odd = odd_forms_i(s);
  const Polynomial<Pair<V>, 2> p = odd.characteristic();
  const V q1[3] = {leading(odd.Q1[0]), leading(odd.Q1[1]), leading(odd.Q1[2])};
  const V P[3] = {leading(odd.P[0]), leading(odd.P[1]), leading(odd.P[2])};
  // Where P or Q1 is definite, the sign of that one; else Q1 on the eigenvector of P Q1 to -Lambda.
  const Mask q_saddle = leading(odd.det_Q1) < V(0.0);
  const Mask both = q_saddle & (leading(odd.det_P) < V(0.0));
  const V definite =
      select((leading(odd.det_P) < V(0.0)) & (q1[0] + q1[2] < V(0.0)), V(-1.0), V(1.0));
  const bool all_definite = !any(both & known);
  const auto krein = [&](const Pair<V>& lambda) {
    if (all_definite) return definite;
    const V m = -leading(lambda);
    const V n11 = P[0] * q1[0] + P[1] * q1[1];
    const V n12 = P[0] * q1[1] + P[1] * q1[2];
    const V n21 = P[1] * q1[0] + P[2] * q1[1];
    const V n22 = P[1] * q1[1] + P[2] * q1[2];
    const Mask other = abs(n12) + abs(m - n11) < abs(n21) * q1[0] * q1[0] + abs(m - n22);
    const V x = select(other, m - n22, n12);
    const V y = select(other, n21, m - n11);
    const V form = q1[0] * x * x + 2.0 * q1[1] * x * y + q1[2] * y * y;
    return select(both, select(form < V(0.0), V(-1.0), V(1.0)), definite);
  };
  const LaneRootPair<V> pair = lane_quadratic_roots(p.c[1], p.c[0]);
  out.set_pair(3, pair, krein);
  if (!any(symmetric)) return out;
  // J1 = J2: 0 and -tr P Q1, whose energy has the sign that Q1 has.
  LaneModes<V> forced;
  forced.set_real(3, -p.c[1], select(q1[0] + q1[2] < V(0.0), V(-1.0), V(1.0)));
  out.re[3] = select(symmetric, forced.re[3], out.re[3]);
  out.im[3] = select(symmetric, forced.im[3], out.im[3]);
  out.krein[3] = select(symmetric, forced.krein[3], out.krein[3]);
  out.set_zero(4, symmetric);
  return out;
}

/// (iii).
template <class V>
[[gnu::always_inline]] inline LaneModes<V> normal_modes(const StraightState<Pair<V>>& s,
                                                        const typename V::Mask& circle,
                                                        typename V::Mask& known) {
  using Mask = typename V::Mask;
  LaneModes<V> out;
  out.set_real(0, odd_lambda_iii(s), select(leading(s.I3() - s.I1()) < V(0.0), V(-1.0), V(1.0)));
  out.set_real(1, -(s.V_rr / s.J.J3), V(1.0));

  const GyroscopicBlock<Pair<V>> even = even_block_iii(s);
  const Polynomial<Pair<V>, 3> p = even.characteristic();
  const Polynomial<Pair<V>, 2> trace = even.trace_adjugate();
  const V K_alpha = leading(even.K_alpha);
  const V K_xx = leading(even.rest.K[0][0]);
  const V minor = leading(even.planar_determinant().c[0]);
  const Mask definite = (V(0.0) < K_alpha) & (V(0.0) < K_xx) & (V(0.0) < minor);
  const bool all_definite = !any(known & ~definite);
  const auto krein = [&](const Pair<V>& lambda) {
    if (all_definite) return V(1.0);
    const V energy = leading(p.slope(lambda)) * leading(trace(lambda));
    return select(definite, V(1.0), select(energy < V(0.0), V(-1.0), V(1.0)));
  };
  Mask general = ~circle;
  const LaneCubicRoots<V> roots = lane_cubic_roots(p, general);
  known = known & (general | circle);
  out.set_real(2, roots.single, krein(roots.single));
  out.set_pair(3, roots.pair, krein);

  if (!any(circle)) return out;
  // The circle, as in spectrum.cpp.
  LaneModes<V> round;
  round.set_real(2, -((even.rest.K[0][0] + even.rest.K[0][1]) / s.J.J1), V(1.0));
  const Pair<V> shear = even.K_alpha / (2.0 * s.J.J1);
  const Pair<V> Omega2 = renormalized(s.omega * s.omega + shear);
  const V w = abs(leading(s.omega));
  const Mask apart = V(0.0) < leading(Omega2);
  const V fast = w + leading(sqrt(Omega2));
  const V slow = leading(shear) / fast;
  round.set_real(3, -Pair<V>(fast * fast), V(1.0));
  round.set_real(4, -Pair<V>(slow * slow), select(slow < V(0.0), V(-1.0), V(1.0)));
  // s = omega i +- rate.
  const V rate = sqrt(abs(leading(Omega2)));
  for (int k = 3; k < 5; ++k) {
    round.re[k] = select(apart, round.re[k], rate);
    round.im[k] = select(apart, round.im[k], w);
    round.krein[k] = select(apart, round.krein[k], V(0.0));
  }
  for (int k = 2; k < 5; ++k) {
    out.re[k] = select(circle, round.re[k], out.re[k]);
    out.im[k] = select(circle, round.im[k], out.im[k]);
    out.krein[k] = select(circle, round.krein[k], out.krein[k]);
  }
  return out;
}

}  // namespace stationary
