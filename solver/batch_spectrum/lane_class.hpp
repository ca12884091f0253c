// Class and negative directions of a pack's cells: the rules of spectrum.cpp on signs that must be
// certain, each `threshold` times over (spectrum_kernel.hpp).
#pragma once

#include "lib/number/running_error.hpp"
#include "lib/stability/linearization.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

/// What decides a pack's classes.
template <class V>
struct LaneVerdict {
  using Mask = typename V::Mask;
  using Error = RunningError<V>;
  V threshold;  ///< of |value| over units
  Mask decided;
  Mask real;     ///< a positive Lambda
  Mask complex;  ///< a complex one
  V negative{0.0};
  Mask definite_too;  ///< stable whatever `negative` says
  Mask indefinite;    ///< not stable whatever `negative` says

  [[gnu::always_inline]] Mask certain(const Error& x) const {
    return threshold * x.units < abs(x.value);
  }
  /// x < 0, which must be certain.
  [[gnu::always_inline]] Mask negative_sign(const Error& x) {
    decided = decided & certain(x);
    return x.value < V(0.0);
  }
  [[gnu::always_inline]] void count(const Mask& where, double directions = 1.0) {
    negative = negative + select(where, V(directions), V(0.0));
  }
  [[gnu::always_inline]] V code() const {
    const auto number = [](StabilityClass c) { return V(static_cast<double>(c)); };
    const Mask stable = definite_too | ((negative == V(0.0)) & ~indefinite);
    const V imaginary =
        select(stable, number(StabilityClass::stable), number(StabilityClass::elliptic));
    const V all = select(real, number(StabilityClass::unstable),
                         select(complex, number(StabilityClass::oscillatory), imaginary));
    return select(decided, all, V(-1.0));
  }
};

/// Smallest |Lambda| of a symmetric pencil (K02 = 0) against the error of its largest: both through
/// Frobenius norms F of M^-1/2 K M^-1/2, |Lambda|_min >= |det K|/(det M F^2).
template <class V>
[[gnu::always_inline]] inline typename V::Mask away_from_zero(
    const SymmetricPencil<RunningError<V>>& pencil, const V& determinant, const V& threshold) {
  const V m[3] = {pencil.mass[0].value, pencil.mass[1].value, pencil.mass[2].value};
  const V inverse[3] = {1.0 / m[0], 1.0 / m[1], 1.0 / m[2]};
  V size(0.0);
  V error(0.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      if (i == 0 && j == 2) continue;
      const V weight = (i == j ? 1.0 : 2.0) * (inverse[i] * inverse[j]);
      size = size + weight * (pencil.K[i][j].value * pencil.K[i][j].value);
      error = error + weight * (pencil.K[i][j].units * pencil.K[i][j].units);
    }
  }
  const V smallest = determinant * (inverse[0] * (inverse[1] * inverse[2]));
  return threshold * threshold * (size * size) * error < smallest * smallest;
}

/// (i): class and negative directions.
template <class V>
[[gnu::always_inline]] inline void in_plane_verdict(const StraightState<RunningError<V>>& s,
                                                    const typename V::Mask& symmetric,
                                                    LaneVerdict<V>& out) {
  using Mask = typename V::Mask;
  using Error = RunningError<V>;
  const SymmetricPencil<Error> even = even_pencil_i(s);
  const Error minor = even.K[0][0] * even.K[1][1] - even.K[0][1] * even.K[0][1];
  const Error determinant = even.K[2][2] * minor - even.K[1][2] * even.K[1][2] * even.K[0][0];
  const Mask first = out.negative_sign(even.K[0][0]);
  const Mask second = out.negative_sign(minor);
  const Mask third = out.negative_sign(determinant);
  out.count(first);
  out.count((first & ~second) | (~first & second));
  out.count((second & ~third) | (~second & third));
  out.real = V(0.0) < out.negative;
  out.decided = out.decided & away_from_zero(even, determinant.value, out.threshold);

  const OddForms<Error> odd = odd_forms_i(s);
  const Error trace = odd.characteristic().c[1];
  const Mask p_negative = out.negative_sign(odd.det_P);
  out.count(p_negative);
  // J1 = J2: det Q1 = 0, Lambda = 0 and -tr P Q1, of the sign of energy that Q1 has.
  const Error form = odd.Q1[0] + odd.Q1[2];
  const Mask symmetric_decided = out.certain(form) & out.certain(trace);
  const Mask form_negative = form.value < V(0.0);
  const Mask falling = trace.value < V(0.0);
  // Else: det P det Q1 < 0 a real and an imaginary pair; > 0 both of one kind, or a quadruple
  // where neither form is definite.
  const Mask q_negative = odd.det_Q1.value < V(0.0);
  const Mask q_downward = ~q_negative & (odd.Q1[2].value < V(0.0));
  const Mask saddle = (p_negative & ~q_negative) | (~p_negative & q_negative);
  const Mask both = p_negative & q_negative;
  const Error discriminant = trace * trace - 4.0 * (odd.det_P * odd.det_Q1);
  const Mask quadruple = both & (discriminant.value < V(0.0));
  const Mask general_decided =
      out.certain(odd.det_Q1) & (q_negative | out.certain(odd.Q1[2])) &
      (~both | (out.certain(discriminant) & (quadruple | out.certain(trace))));
  out.decided = out.decided & ((symmetric & symmetric_decided) | (~symmetric & general_decided));
  out.count(symmetric & form_negative);
  out.count(~symmetric & q_negative);
  out.count(~symmetric & q_downward, 2.0);
  out.definite_too = symmetric & ~form_negative;
  out.indefinite = symmetric & form_negative;
  out.real = out.real | (symmetric & falling) | (~symmetric & saddle) |
             (~symmetric & q_downward & ~p_negative) | (~symmetric & both & ~quadruple & falling);
  out.complex = ~symmetric & quadruple;
}

/// (iii): likewise. circle: xi = zeta and J1 = J2.
template <class V>
[[gnu::always_inline]] inline void normal_verdict(const StraightState<RunningError<V>>& s,
                                                  const typename V::Mask& circle,
                                                  LaneVerdict<V>& out) {
  using Mask = typename V::Mask;
  using Error = RunningError<V>;
  const Mask first = out.negative_sign(s.I3() - s.I1());
  const Mask second = out.negative_sign(s.I3() - s.I2());
  out.count(first);
  out.count(second);
  const Mask rho = out.negative_sign(s.V_rr);
  out.count(rho);
  out.real = rho | (first & ~second) | (~first & second);

  const GyroscopicBlock<Error> even = even_block_iii(s);
  // Away from the circle.
  const Error minor = even.rest.K[0][0] * even.rest.K[1][1] - even.rest.K[0][1] * even.rest.K[0][1];
  const Mask alpha = even.K_alpha.value < V(0.0);
  const Mask minor_negative = minor.value < V(0.0);
  const Mask downward = ~minor_negative & (even.rest.K[0][0].value < V(0.0));
  const Mask definite = ~(alpha | minor_negative | downward);
  const Mask never = alpha & ~alpha;
  Mask roots_decided = definite;
  Mask even_real = never;
  Mask even_complex = never;
  if (any(~(definite | circle))) {
    const Polynomial<Error, 3> p = even.characteristic();
    const Error inverse = Error(1.0) / p.c[3];
    const Error a = p.c[2] * inverse;
    const Error b = p.c[1] * inverse;
    const Error c = p.c[0] * inverse;
    const Error third = (1.0 / 3.0) * a;
    const Error linear = b - a * third;
    const Error rest = c - third * (b - 2.0 * (third * third));
    const Error discriminant = -4.0 * (linear * linear * linear) - 27.0 * (rest * rest);
    const Mask one_real = discriminant.value < V(0.0);
    const Mask odd_positive = c.value < V(0.0);
    const Mask upward = (a.value < V(0.0)) | (b.value < V(0.0));
    roots_decided = definite | (out.certain(discriminant) &
                                (odd_positive | one_real | (out.certain(a) & out.certain(b))));
    even_real = ~definite & (odd_positive | (~one_real & upward));
    even_complex = ~definite & one_real & ~odd_positive;
  }
  const Mask general_decided = out.certain(even.K_alpha) & out.certain(minor) &
                               (minor_negative | out.certain(even.rest.K[0][0])) & roots_decided;
  out.count(~circle & alpha);
  out.count(~circle & minor_negative);
  out.count(~circle & downward, 2.0);
  out.real = out.real | (~circle & even_real);
  out.complex = ~circle & even_complex;
  out.definite_too = never;
  out.indefinite = never;
  if (!any(circle)) {
    out.decided = out.decided & general_decided;
    return;
  }

  // The circle: breathing, and two shears i (omega +- Omega), Omega^2 = omega^2 + k.
  const Error breathing = even.rest.K[0][0] + even.rest.K[0][1];
  const Error k = even.K_alpha / (2.0 * s.J.J1);
  const Error Omega2 = s.omega * s.omega + k;
  const Mask apart = V(0.0) < Omega2.value;
  const V root = sqrt(select(apart, Omega2.value, V(1.0)));
  const Error Omega(root, 0.5 * (Omega2.units / root) + root);
  const Error omega(abs(s.omega.value), s.omega.units);
  const Error margin = 0.5 * (omega + Omega) + omega * (s.I3() / s.I1() - Error(1.0));
  const Mask narrowing = breathing.value < V(0.0);
  const Mask circle_decided = out.certain(breathing) & out.certain(Omega2) &
                              (~apart | (out.certain(k) & out.certain(margin)));
  out.decided = out.decided & ((circle & circle_decided) | (~circle & general_decided));
  out.count(circle & narrowing);
  out.count(circle & (k.value < V(0.0)), 2.0);
  out.real = out.real | (circle & narrowing);
  out.complex = out.complex | (circle & ~apart);
  out.definite_too = circle & apart & (V(0.0) < margin.value);
}

}  // namespace stationary
