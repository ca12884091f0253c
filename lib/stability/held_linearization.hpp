// The linearized reduced dynamics at alpha = 0 of a body whose volume is held, in blocks as of any
// other (linearization.hpp), rho being C/d: its velocity is -rho (xi'/xi + zeta'/zeta), so in
// (xi, zeta)
//
//   M = [ J1 + J3 rho^2/xi^2    J3 rho^2/(xi zeta)    ]   and the spin about axis 1 or 2 pulls by
//       [ J3 rho^2/(xi zeta)    J2 + J3 rho^2/zeta^2  ]   rho^2 = C^2/(xi zeta - alpha^2)^2 too.
//
// (i) even (xi, zeta): det(Lambda M + K) = 0; odd as ever, V_aa with the pull of rho. (iii) even:
// alpha, whose gyroscopic couplings are the same, and (xi, zeta); odd as ever. A mode less each.
#pragma once

#include "lib/stability/linearization.hpp"

namespace stationary {

/// A symmetric pencil Lambda M + K of xi and zeta; entries 11, 12, 22.
template <class S>
struct PlanarPencil {
  S mass[3];
  S K[3];
  S least[2];  ///< J1, J2: M - diag(J1, J2) is positive semidefinite

  Polynomial<S, 1> entry(int k) const { return {{K[k], mass[k]}}; }
  Polynomial<S, 2> characteristic() const { return entry(0) * entry(2) - entry(1) * entry(1); }
};

template <class S>
PlanarPencil<S> held_mass(const StraightState<S>& s) {
  const S thick = s.J.J3 * (s.rho * s.rho);
  PlanarPencil<S> out{};
  out.mass[0] = s.J.J1 + thick / (s.xi * s.xi);
  out.mass[1] = thick / (s.xi * s.zeta);
  out.mass[2] = s.J.J2 + thick / (s.zeta * s.zeta);
  out.least[0] = s.J.J1;
  out.least[1] = s.J.J2;
  return out;
}

/// With the pull of a spin on rho among V's second derivatives. state: those along the held volume
/// (BodyModel::derivatives()); c_rho: its centrifugal rate.
template <class S>
StraightState<S> with_thickness_pull(StraightState<S> s, const S& c_rho) {
  const S pull = c_rho * (s.rho * s.rho);
  const S mixed = 2.0 * pull / (s.xi * s.zeta);
  s.V_aa = s.V_aa - mixed;
  s.V_xx = s.V_xx - 3.0 * pull / (s.xi * s.xi);
  s.V_xz = s.V_xz - mixed;
  s.V_zz = s.V_zz - 3.0 * pull / (s.zeta * s.zeta);
  return s;
}

/// (i), even; the state with_thickness_pull() of J3 omega^2. For (ii) give the exchanged state.
template <class S>
PlanarPencil<S> held_even_i(const StraightState<S>& s) {
  const S omega2 = s.omega * s.omega;
  const S gain = 4.0 * omega2 / s.I1();
  // Half the slopes of I1 = J2 zeta^2 + J3 rho^2.
  const S thick = s.J.J3 * (s.rho * s.rho);
  const S u_xi = -(thick / s.xi);
  const S u_zeta = s.J.J2 * s.zeta - thick / s.zeta;
  PlanarPencil<S> out = held_mass(s);
  out.K[0] = s.V_xx + gain * (u_xi * u_xi);
  out.K[1] = s.V_xz + gain * (u_xi * u_zeta);
  out.K[2] = s.V_zz - omega2 * s.J.J2 + gain * (u_zeta * u_zeta);
  return out;
}

/// (iii), even.
template <class S>
struct HeldGyroscopicBlock {
  S mass_alpha;
  S K_alpha;
  S G_xi;
  S G_zeta;
  PlanarPencil<S> plane;

  Polynomial<S, 3> characteristic() const {
    return alpha_entry() * plane.characteristic() +
           raised(S(G_xi * G_xi) * plane.entry(2) + S(G_zeta * G_zeta) * plane.entry(0) -
                  S(2.0 * (G_xi * G_zeta)) * plane.entry(1));
  }
  /// As GyroscopicBlock::trace_adjugate().
  Polynomial<S, 2> trace_adjugate() const {
    return alpha_entry() * (plane.entry(0) + plane.entry(2)) + plane.characteristic() +
           raised(constant(S(G_xi * G_xi + G_zeta * G_zeta)));
  }
  Polynomial<S, 1> alpha_entry() const { return {{K_alpha, mass_alpha}}; }
};

template <class S>
HeldGyroscopicBlock<S> held_even_iii(const StraightState<S>& s) {
  const GyroscopicBlock<S> of_plane = even_block_iii(s);
  PlanarPencil<S> plane = held_mass(s);
  plane.K[0] = of_plane.rest.K[0][0];
  plane.K[1] = of_plane.rest.K[0][1];
  plane.K[2] = of_plane.rest.K[1][1];
  return {of_plane.mass_alpha, of_plane.K_alpha, of_plane.G_xi, of_plane.G_zeta, plane};
}

/// Two-polar family, lambda != mu: two_polar_pencil() along the held volume.
template <class S>
PlanarPencil<S> held_two_polar(const StraightState<S>& s, const S& theta_dot) {
  const SymmetricPencil<S> free = two_polar_pencil(s, theta_dot);
  PlanarPencil<S> out = held_mass(s);
  out.K[0] = free.K[0][0];
  out.K[1] = free.K[0][1];
  out.K[2] = free.K[1][1];
  return out;
}

}  // namespace stationary
