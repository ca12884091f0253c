// The blocks of linearization.hpp of a separable isotropic V at omega != 0, balanced: each mode is
// scaled by its own stretch and by the square root of its own mass. Their entries are then squares
// of rates however far apart the stretches are, and need few operations.
//
// With G the balance in (u, v, w) = ln (xi, zeta, rho) (log_balance.hpp), m = (J1 xi^2, J2 zeta^2,
// J3 rho^2), gain = 4 omega^2:
//
//   q_i (V_xx - omega^2 diag)_ik q_k = dG_i/dx_k                                 at equilibrium
//   V_aa (xi - zeta)/2 = V_x - V_z = omega^2 (J1 xi - J2 zeta), in (i) without xi   likewise:
//   then what V is does not enter
//
// (i) even: [a d 0; d b e; 0 e c], a = G_uu/m1, d^2 = G_uv^2/(m1 m2), f2 = m2/(m2+m3) = 1 - f3,
//       b = G_vv/m2 + gain f2,  c = G_ww/m3 + gain f3,  e^2 = gain^2 f2 f3,
//       b c - e^2 = b0 c + c0 gain f2,  b0 = G_vv/m2, c0 = G_ww/m3
// (i) odd: Lambda^2 + B Lambda + C with D = J1 J2 (xi + zeta)^2, E = J1 (xi^2 - zeta^2),
//       B = (V_aa - J2 omega^2) I3/D + 2 omega^2 m1/I2      = omega^2 (2 m1/I2 - I3/E)
//       C = omega^2 (m3 - m1)/I2 [V_aa (m2 - m1) - omega^2 J2 zeta ((J1 + J2) zeta + 2 J1 xi)]/D
//                                                 = omega^4 (m3 - m1)/I2 (J1 - J2) zeta^2/E
// (iii) even: k = (V_aa - omega^2 (J1 + J2)) I3/D = omega^2 (J1 - J2) I3/(J2 E),
//       a0 = G_uu/m1, b0 = G_vv/m2, det0 = a0 b0 - G_uv^2/(m1 m2),
//       trace = a0 + b0 + gain, det = det0 + gain/I3 (a0 m2 + b0 m1 - 2 G_uv) of (xi, zeta),
//       Lambda^3 + (k + trace + gain) Lambda^2 + [(k + gain) trace + det0] Lambda + k det
//
// S: pairs of doubles for values, Conditioned for their bounds; C: that of J and omega.
#pragma once

#include <cmath>

#include "lib/balanced/part_curvatures.hpp"
#include "lib/balanced/spin_units.hpp"
#include "lib/body/motion.hpp"
#include "lib/number/first_order_bound.hpp"
#include "lib/number/polynomial.hpp"

namespace stationary {

/// (xi, zeta) along a spin about axis 1 or 3; about axis 2 with 1 and 2 exchanged. In the units of
/// SpinUnits.
template <class S, class C>
struct BalancedState {
  C J1;
  C J2;
  S xi, zeta;
  S zeta2;  ///< its square
  S m1, m2, m3;
  S omega2;
  S uu, uv, vv, ww;
  S sum;       ///< xi + zeta
  bool apart;  ///< xi and zeta are: V_aa is had from the balance
  S E;         ///< where apart
  S V_aa;      ///< where not
};

/// What BalancedState is made of besides the potential's curvatures. least_apart: least
/// |xi - zeta|/(xi + zeta) that K_alpha is divided by.
template <class S, class C>
struct SpinningBody {
  C J1, J2, J3;
  S xi, zeta, rho;
  C omega;
  bool normal;  ///< (iii), else (i)
  double least_apart;

  S square() const { return S(omega) * omega; }
  /// c of c_i x_i^2 in the balance.
  S pull_xi() const { return normal ? S(J1 * square()) : S(0.0); }
  S pull_zeta() const { return J2 * square(); }
  S pull_rho() const { return normal ? S(0.0) : S(J3 * square()); }
  S difference() const { return renormalized(S(xi - zeta)); }
  bool apart() const {
    return std::abs(leading(difference())) >= least_apart * leading(S(xi + zeta));
  }
};

/// Those of a body of separable potential.
template <class S, class C, class Plane>
[[gnu::always_inline]] inline void add_plane(const Plane& model, const SpinningBody<S, C>& of,
                                             Curvatures<S>& out) {
  out.plane = plane_curvatures(model, of.xi, of.zeta, of.pull_xi(), of.pull_zeta());
  if (!of.apart()) out.w_l = pressure(model, of.xi, of.zeta);
}
template <class S, class C, class Thickness>
[[gnu::always_inline]] inline void add_thickness(const Thickness& model,
                                                 const SpinningBody<S, C>& of, Curvatures<S>& out) {
  out.ww = thickness_curvature(model, of.rho, of.pull_rho());
}

template <class S, class C>
[[gnu::always_inline]] inline BalancedState<S, C> balanced_state(const SpinningBody<S, C>& of,
                                                                 const Curvatures<S>& curvatures,
                                                                 const SpinUnits& units) {
  BalancedState<S, C> out;
  out.uu = by_power(curvatures.plane.uu, units.energy);
  out.uv = by_power(curvatures.plane.uv, units.energy);
  out.vv = by_power(curvatures.plane.vv, units.energy);
  out.ww = by_power(curvatures.ww, units.energy);

  out.J1 = by_power(of.J1, units.inertia);
  out.J2 = by_power(of.J2, units.inertia);
  out.xi = of.xi;
  out.zeta = of.zeta;
  out.zeta2 = of.zeta * of.zeta;
  out.m1 = out.J1 * (of.xi * of.xi);
  out.m2 = out.J2 * out.zeta2;
  out.m3 = by_power(of.J3, units.inertia) * (of.rho * of.rho);
  out.omega2 = by_power(of.square(), units.rate * units.rate);

  out.sum = of.xi + of.zeta;
  out.apart = of.apart();
  if (out.apart) {
    out.E = out.J1 * (out.sum * of.difference());
  } else {
    out.V_aa = by_power(curvatures.w_l, -2.0 * units.energy) / (of.xi * of.zeta);
  }
  return out;
}

/// (i), even, as entries.
template <class S>
struct ChainEntries {
  S a, b, c;
  S d2, e2;

  /// det(chain + shift + y), in y.
  Polynomial<S, 3> characteristic_about(double shift) const {
    const S x = renormalized(S(a + shift));
    const S y = renormalized(S(b + shift));
    const S z = renormalized(S(c + shift));
    return {
        {S(x * (y * z - e2) - d2 * z), S(x * y + (y + x) * z - (d2 + e2)), S(x + y + z), S(1.0)}};
  }
};
/// (i), even, its parts.
template <class S>
struct ChainParts {
  S a, b0, c0, d2;
  S gain, gain2, gain3;  ///< the latter times f2, f3

  ChainEntries<S> entries() const { return {a, b0 + gain2, c0 + gain3, d2, gain2 * gain3}; }
  Polynomial<S, 3> characteristic() const {
    const S c = c0 + gain3;
    const S pair = b0 * c + c0 * gain2;
    const S rest = b0 + c0 + gain;
    return {{S(a * pair - d2 * c), S(a * rest + (pair - d2)), S(a + rest), S(1.0)}};
  }
};
template <class S, class C>
ChainParts<S> even_chain_i(const BalancedState<S, C>& s) {
  const S gain = by_power(s.omega2, 4.0);
  const S share = gain / (s.m2 + s.m3);
  return {s.uu / s.m1, s.vv / s.m2,  s.ww / s.m3, s.uv * s.uv / (s.m1 * s.m2),
          gain,        s.m2 * share, s.m3 * share};
}

/// (i), odd; the determinants and Q1_22 of linearization.hpp but for positive factors.
template <class S>
struct OddQuadratic {
  S b, c;
  S det_P;
  S det_Q;
  S Q_22;
};
template <class S, class C>
OddQuadratic<S> odd_quadratic_i(const BalancedState<S, C>& s) {
  const S inverse = S(1.0) / (s.m1 + s.m3);
  const S I3 = s.m1 + s.m2;
  OddQuadratic<S> out;
  out.det_P = renormalized(S(s.m3 - s.m1));
  out.Q_22 = renormalized(S(s.m2 - s.m1));
  const S own = by_power(s.m1 * inverse, 2.0);
  const S tilt = s.omega2 * (out.det_P * inverse);
  if (s.apart) {
    const S inverse_E = S(1.0) / s.E;
    out.det_Q = (S(s.J1) - S(s.J2)) * (s.zeta2 * inverse_E);
    out.b = renormalized(S(s.omega2 * (own - I3 * inverse_E)));
    out.c = tilt * (s.omega2 * out.det_Q);
  } else {
    const S inverse_D = S(1.0) / ((S(s.J1) * s.J2) * (s.sum * s.sum));
    const S pull = (s.J2 * s.zeta) * ((S(s.J1) + S(s.J2)) * s.zeta + by_power(S(s.J1 * s.xi), 2.0));
    out.det_Q = renormalized(S(s.V_aa * out.Q_22 - s.omega2 * pull)) * inverse_D;
    out.b = renormalized(S((s.V_aa - s.J2 * s.omega2) * (I3 * inverse_D) + s.omega2 * own));
    out.c = tilt * out.det_Q;
  }
  return out;
}

/// (iii), even.
template <class S>
struct NormalBlock {
  S k;           ///< of alpha
  S trace, det;  ///< of (xi, zeta)
  S det0, gain;

  Polynomial<S, 3> characteristic() const {
    return {{S(k * det), S((k + gain) * trace + det0), S(k + trace + gain), S(1.0)}};
  }
  /// As of GyroscopicBlock.
  Polynomial<S, 2> trace_adjugate() const {
    return {{S(k * trace + det), S(by_power(k + trace, 2.0) + gain), S(3.0)}};
  }
};
template <class S, class C>
NormalBlock<S> normal_block(const BalancedState<S, C>& s) {
  NormalBlock<S> out;
  const S I3 = s.m1 + s.m2;
  const S a0 = s.uu / s.m1;
  const S b0 = s.vv / s.m2;
  out.gain = by_power(s.omega2, 4.0);
  out.k = s.apart ? ((S(s.J1) - S(s.J2)) * s.omega2) * I3 / (s.J2 * s.E)
                  : renormalized(S(s.V_aa - (S(s.J1) + S(s.J2)) * s.omega2)) * I3 /
                        ((S(s.J1) * s.J2) * (s.sum * s.sum));
  out.det0 = a0 * b0 - s.uv * s.uv / (s.m1 * s.m2);
  out.trace = a0 + b0 + out.gain;
  out.det = out.det0 + out.gain / I3 * (a0 * s.m2 + b0 * s.m1 - by_power(s.uv, 2.0));
  return out;
}

/// (iii), odd.
template <class S, class C>
S odd_lambda_iii(const BalancedState<S, C>& s) {
  return -(s.omega2 * ((s.m1 - s.m3) * (s.m2 - s.m3))) / ((s.m1 + s.m3) * (s.m2 + s.m3));
}

}  // namespace stationary
