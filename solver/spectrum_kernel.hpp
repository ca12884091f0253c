// Spectra of a tile's cells (spectrum_tile.hpp) in packs: the blocks of linearization.hpp evaluated
//
//   class, negative   in working precision with running errors (running_error.hpp): each sign that
//                     decides must be certain `slack` times over
//   modes, growth     in pairs of doubles at q corrected to them, as spectrum.cpp has them
//
// A cell any of whose signs is not certain is left to the scalar path, whose own bounds are tighter
// than slack times these: what a lane claims the scalar path claims too. So are rest, where the
// leaf is another, and an ellipse of J1 = J2 in (iii).
//
// The models give K: with G the balance in (u, v, w) = ln (xi, zeta, rho) and C the centrifugal
// terms,
//   V_xx - C = diag(1/q) G' diag(1/q) at equilibrium,  V_aa = 2 (V_xi - V_zeta)/(xi - zeta)
//                                                           = 2 (C_xi - C_zeta)/(xi - zeta),
// on the circle 2 (V_xi,xi - V_xi,zeta).
#pragma once

#include "lib/linearization.hpp"
#include "lib/running_error.hpp"
#include "lib/spectrum.hpp"
#include "solver/batch_kernel.hpp"
#include "solver/lane_roots.hpp"
#include "solver/spectrum_tile.hpp"

namespace stationary {

constexpr double lane_slack = 0x1p10;
/// Below it xi - zeta is too small for V_aa by the quotient above.
constexpr double least_ellipticity = 0x1p-21;

template <class V>
struct LaneDerivative {
  Pair<V> value;
  V units;

  [[gnu::always_inline]] static LaneDerivative load(const SpectrumTile::Derivative& from,
                                                    std::size_t i) {
    return {{V::load(from.head + i), V::load(from.tail + i)}, V::load(from.units + i)};
  }
  [[gnu::always_inline]] void store(SpectrumTile::Derivative& to, std::size_t i) const {
    value.hi.store(to.head + i);
    value.lo.store(to.tail + i);
    units.store(to.units + i);
  }
};

/// Of the same derivative, with its error and as a pair.
template <class V>
[[gnu::always_inline]] inline LaneDerivative<V> lane_derivative(const RunningError<V>& bounded,
                                                                const Pair<V>& pair, bool modes) {
  return {modes ? pair : Pair<V>(bounded.value), bounded.units};
}

/// The part's derivatives and what rounding left of its x: of xi and zeta, or of rho.
template <class V, class System>
[[gnu::flatten]] void lane_derivatives(const SpectrumTile::Numbers* coefficient,
                                       const SpectrumTile::Numbers* q,
                                       const SpectrumTile::Numbers* pull, bool modes,
                                       SpectrumTile& tile, SpectrumTile::Numbers* tail) {
  using Error = RunningError<V>;
  constexpr int n = System::unknowns;
  for (std::size_t i = 0; i < SpectrumTile::size; i += V::lanes) {
    System system;
    for (int k = 0; k < 2; ++k) system.coefficient[k] = V::load(coefficient[k] + i);
    const V nu = V::load(tile.nu + i);
    V x[2];
    Error x_error[2];
    Error rate_error[2];
    const Error nu_error = Error::input(nu);
    for (int k = 0; k < n; ++k) {
      x[k] = V::load(q[k] + i);
      const V inertia = V::load(pull[k] + i);
      system.rate[k] = Pair<V>(inertia) * two_product(nu, nu);
      x_error[k] = Error::input(x[k]);
      rate_error[k] = Error::input(inertia) * (nu_error * nu_error);
    }
    const auto bounded = system.template balance<Error>(x_error, rate_error);
    LogBalance<Pair<V>> pairs;
    if (modes) {
      LaneLinearized<V> here = system.linearize(x);
      system.extended_residual(x, here.g);
      const V scale = 1.0 / (here.uu * here.vv - here.uv * here.uv);
      const V step[2] = {(here.vv * here.g[0] - here.uv * here.g[1]) * scale,
                         (here.uu * here.g[1] - here.uv * here.g[0]) * scale};
      Pair<V> corrected[2];
      for (int k = 0; k < n; ++k) {
        // As extended_solution(): beyond the last place it says the Jacobian is useless here.
        const V move = select(abs(step[k]) < V(1e-10), -(x[k] * step[k]), V(0.0));
        corrected[k] = two_sum(x[k], move);
        // Heads stay what they are in nearly every cell; where not, the scalar path is right too.
        ((corrected[k].hi - x[k]) + corrected[k].lo).store(tail[k] + i);
      }
      pairs = system.template balance<Pair<V>>(corrected, system.rate);
    }
    if constexpr (n == 2) {
      lane_derivative(bounded.uu, pairs.uu, modes).store(tile.uu, i);
      lane_derivative(bounded.uv, pairs.uv, modes).store(tile.uv, i);
      lane_derivative(bounded.vv, pairs.vv, modes).store(tile.vv, i);
    } else {
      lane_derivative(bounded.ww, pairs.ww, modes).store(tile.ww, i);
    }
  }
}

template <class V, template <class> class Model>
void plane_derivatives(SpectrumTile& tile, bool modes) {
  lane_derivatives<V, PlanarLanes<V, Model>>(tile.plane, tile.q, tile.pull, modes, tile, tile.tail);
}
template <class V, template <class> class Model>
void thickness_derivatives(SpectrumTile& tile, bool modes) {
  lane_derivatives<V, ThicknessLanes<V, Model>>(tile.thickness, tile.q + 2, tile.pull + 2, modes,
                                                tile, tile.tail + 2);
}

/// One pack of a tile's cells in the number type S; (iii) where normal, else (i).
template <bool normal, class S, class Mask>
[[gnu::always_inline]] inline StraightState<S> lane_state(const Inertia3<S>& J, const S (&q)[3],
                                                          const S& omega, const S& uu, const S& uv,
                                                          const S& vv, const S& ww,
                                                          const Mask& circle) {
  const S inverse[3] = {S(1.0) / q[0], S(1.0) / q[1], S(1.0) / q[2]};
  const S square = omega * omega;
  StraightState<S> s{J, q[0], q[1], q[2], omega, {}, {}, {}, {}, S(0.0), S(0.0), {}};
  s.V_xx = uu * (inverse[0] * inverse[0]);
  s.V_xz = uv * (inverse[0] * inverse[1]);
  s.V_zz = vv * (inverse[1] * inverse[1]) + J.J2 * square;
  s.V_rr = ww * (inverse[2] * inverse[2]);
  if constexpr (normal) {
    s.V_xx = s.V_xx + J.J1 * square;
    s.V_aa = select(circle, 2.0 * (s.V_xx - s.V_xz),
                    2.0 * square * (J.J1 * q[0] - J.J2 * q[1]) / (q[0] - q[1]));
  } else {
    s.V_rr = s.V_rr + J.J3 * square;
    s.V_aa = -(2.0 * square * (J.J2 * q[1]) / (q[0] - q[1]));
  }
  return s;
}

template <int bytes>
[[gnu::always_inline]] inline RunningError<Pack<bytes>> select(const PackMask<bytes>& where,
                                                               const RunningError<Pack<bytes>>& x,
                                                               const RunningError<Pack<bytes>>& y) {
  return {select(where, x.value, y.value), select(where, x.units, y.units)};
}

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
  // Where P or Q1 is definite, the sign of that one; else Q1 on the eigenvector of P Q1 to -Lambda,
  // as in spectrum.cpp.
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

/// The branch's part, from the models' derivatives; (iii) where normal, else (i).
template <class V, bool normal>
[[gnu::flatten]] void lane_spectra(SpectrumTile& tile, bool modes) {
  using Mask = typename V::Mask;
  using Error = RunningError<V>;
  for (std::size_t i = 0; i < SpectrumTile::size; i += V::lanes) {
    const V nu = V::load(tile.nu + i);
    const V q[3] = {V::load(tile.q[0] + i), V::load(tile.q[1] + i), V::load(tile.q[2] + i)};
    const V J[3] = {V::load(tile.inertia[0] + i), V::load(tile.inertia[1] + i),
                    V::load(tile.inertia[2] + i)};
    const V uncertainty = V::load(tile.uncertainty + i);
    const auto uu = LaneDerivative<V>::load(tile.uu, i);
    const auto uv = LaneDerivative<V>::load(tile.uv, i);
    const auto vv = LaneDerivative<V>::load(tile.vv, i);
    const auto ww = LaneDerivative<V>::load(tile.ww, i);

    const Mask symmetric = J[0] == J[1];
    const V apart = abs(q[0] - q[1]);
    // A circle known only to its error is the circle (model_stability.hpp).
    const Mask circle =
        symmetric & (apart <= 4.0 * uncertainty * q[0]) & (normal ? nu == nu : ~(nu == nu));
    LaneVerdict<V> verdict;
    verdict.threshold = lane_slack * uncertainty;
    verdict.decided = (~(nu == V(0.0))) & (circle | (least_ellipticity * q[0] < apart));
    if constexpr (normal) verdict.decided = verdict.decided & (circle | ~symmetric);
    {
      const auto error = [](const LaneDerivative<V>& d) {
        return Error(leading(d.value), d.units);
      };
      const Error x[3] = {Error::input(q[0]), Error::input(q[1]), Error::input(q[2])};
      const auto s = lane_state<normal>(
          Inertia3<Error>{Error::input(J[0]), Error::input(J[1]), Error::input(J[2])}, x,
          Error::input(nu), error(uu), error(uv), error(vv), error(ww), circle);
      if constexpr (normal) {
        normal_verdict(s, circle, verdict);
      } else {
        in_plane_verdict(s, symmetric, verdict);
      }
    }
    if (modes && any(verdict.decided)) {
      const Pair<V> x[3] = {{q[0], V::load(tile.tail[0] + i)},
                            {q[1], V::load(tile.tail[1] + i)},
                            {q[2], V::load(tile.tail[2] + i)}};
      const auto s = lane_state<normal>(Inertia3<Pair<V>>{J[0], J[1], J[2]}, x, Pair<V>(nu),
                                        uu.value, uv.value, vv.value, ww.value, circle);
      LaneModes<V> all;
      if constexpr (normal) {
        all = normal_modes(s, circle, verdict.decided);
      } else {
        all = in_plane_modes(s, symmetric, verdict.decided);
      }
      all.sort();
      V growth = all.re[0];
      for (int k = 1; k < 5; ++k) growth = larger(growth, all.re[k]);
      select(verdict.real | verdict.complex, growth, V(0.0)).store(tile.growth + i);
      for (int k = 0; k < 5; ++k) {
        all.re[k].store(tile.re[k] + i);
        all.im[k].store(tile.im[k] + i);
        all.krein[k].store(tile.krein[k] + i);
      }
    }
    verdict.code().store(tile.verdict + i);
    verdict.negative.store(tile.negative + i);
  }
}

}  // namespace stationary
