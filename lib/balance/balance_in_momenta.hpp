// The same balance in the momenta, as the paper prints it: eqs. (91)-(94) with the compatibility
// condition for (i), (ii), and (95)-(98) for (iii). Both are the right sides of the equations of
// motion (77)-(80) at p' = 0 (the paper prints d(alpha)/dt, ... on their left; it is dp_alpha/dt):
//
//   p' = N(q, pi, p) - grad V(q),   N = -dT/dq at fixed momenta,
//   N = N_plane(pi1, pi2) + N_axial(pi3, p);
//   (91)-(94): grad V = N_plane,   (95)-(98): grad V = N_axial.
//
// With pi = I(q) nu and p the momenta of the steady rotation, N = C(nu) q: nu-form and momentum
// form agree to rounding. Sources: eqs. (73), (77)-(80), (91)-(98) and the definitions of Xi,
// Omega, Upsilon before (74).
#pragma once

#include "lib/balance/balance.hpp"
#include "lib/body/inertia.hpp"

namespace stationary {

/// Xi = det of the in-plane block of I(q).
template <class S>
S inertia_determinant(const Body& body, const BasicStretch<S>& q) {
  const S d = q.alpha * q.alpha - q.xi * q.zeta;
  const S thickness = body.J3 * (q.rho * q.rho);
  return S(body.J1) * body.J2 * (d * d) + locked_inertia(body, q)(2, 2) * thickness +
         thickness * thickness;
}

/// Omega(pi1, pi2).
template <class S>
S in_plane_form(const Body& body, const BasicStretch<S>& q, const S& pi1, const S& pi2) {
  const Matrix3<S> I = locked_inertia(body, q);
  return I(1, 1) * (pi1 * pi1) - 2.0 * I(0, 1) * (pi1 * pi2) + I(0, 0) * (pi2 * pi2);
}

/// Upsilon(x, y) of x = pi3 + alpha (p_zeta - p_xi), y = p_alpha.
template <class S>
S axial_form(const Body& body, const BasicStretch<S>& q, const S& x, const S& y) {
  return (S(body.J1) + body.J2) * (x * x) +
         (body.J1 * (q.xi * q.xi) + body.J2 * (q.zeta * q.zeta)) * (y * y) +
         2.0 * (body.J1 * q.xi - body.J2 * q.zeta) * (x * y);
}

/// Kinetic energy in the momenta (pi, p), eq. (73).
template <class S>
S kinetic_energy(const Body& body, const BasicStretch<S>& q, const Vector7<S>& m) {
  const S sum = q.xi + q.zeta;
  const S x = m[2] + q.alpha * (m[5] - m[4]);
  return in_plane_form(body, q, m[0], m[1]) / (2.0 * inertia_determinant(body, q)) +
         axial_form(body, q, x, m[3]) / (2.0 * S(body.J1) * body.J2 * (sum * sum)) +
         m[4] * m[4] / (2.0 * body.J1) + m[5] * m[5] / (2.0 * body.J2) +
         m[6] * m[6] / (2.0 * body.J3);
}

/// N_plane: right sides of (91)-(94).
template <class S>
Vector4<S> in_plane_force(const Body& body, const BasicStretch<S>& q, const S& pi1, const S& pi2) {
  const S J1 = S(body.J1);
  const S J2 = S(body.J2);
  const S J3 = S(body.J3);
  const S Xi = inertia_determinant(body, q);
  const S d = q.xi * q.zeta - q.alpha * q.alpha;
  const S rho2 = q.rho * q.rho;
  const S weight = in_plane_form(body, q, pi1, pi2) / (Xi * Xi);
  const S p11 = pi1 * pi1;
  const S p22 = pi2 * pi2;
  const S p12 = pi1 * pi2;
  const S h = J1 * q.xi + J2 * q.zeta;
  Vector4<S> N;
  N[0] = -((J2 * p11 + J1 * p22) * q.alpha + h * p12) / Xi +
         ((J1 + J2) * J3 * q.alpha * rho2 - 2.0 * J1 * J2 * q.alpha * d) * weight;
  N[1] = -(J1 * q.xi * p11 + J1 * q.alpha * p12) / Xi +
         (J1 * J2 * q.zeta * d + J1 * J3 * q.xi * rho2) * weight;
  N[2] = -(J2 * q.zeta * p22 + J2 * q.alpha * p12) / Xi +
         (J1 * J2 * q.xi * d + J2 * J3 * q.zeta * rho2) * weight;
  N[3] = -(J3 * q.rho * (p11 + p22)) / Xi +
         J3 * q.rho * (locked_inertia(body, q)(2, 2) + 2.0 * J3 * rho2) * weight;
  return N;
}

/// N_axial: right sides of (95)-(98).
template <class S>
Vector4<S> axial_force(const Body& body, const BasicStretch<S>& q, const S& pi3,
                       const Vector3<S>& p_planar) {
  const S J1 = S(body.J1);
  const S J2 = S(body.J2);
  const S p_alpha = p_planar[0];
  const S p_difference = p_planar[2] - p_planar[1];  // p_zeta - p_xi
  const S sum = q.xi + q.zeta;
  const S denominator = J1 * J2 * (sum * sum);
  const S x = pi3 + q.alpha * p_difference;
  const S nu3 = ((J1 + J2) * x + (J1 * q.xi - J2 * q.zeta) * p_alpha) / denominator;
  const S shared = axial_form(body, q, x, p_alpha) / (denominator * sum);
  Vector4<S> N;
  N[0] = -(nu3 * p_difference);
  N[1] = -((J1 * q.xi * p_alpha + J1 * x) * p_alpha) / denominator + shared;
  N[2] = -((J2 * q.zeta * p_alpha - J2 * x) * p_alpha) / denominator + shared;
  N[3] = S(0.0);
  return N;
}

/// grad V - N(q, pi, p): zero at a relative equilibrium. momenta as in legendre().
template <class Model, class S>
Vector4<S> momentum_balance_residual(const Body& body, const Model& model, const BasicStretch<S>& q,
                                     const Vector7<S>& momenta) {
  const Vector3<S> p{momenta[3], momenta[4], momenta[5]};
  return potential_derivatives<1>(model, q).gradient -
         in_plane_force(body, q, momenta[0], momenta[1]) - axial_force(body, q, momenta[2], p);
}

/// Left side of the paper's compatibility condition after (94). With pi = I(q) nu it is
/// +(J1 xi + J2 zeta) alpha Xi nu1^2 in (i), minus that with nu2^2 in (ii): zero only at alpha = 0.
template <class S>
S momentum_compatibility(const Body& body, const BasicStretch<S>& q, const S& pi1, const S& pi2) {
  const S alpha2 = q.alpha * q.alpha;
  return (body.J1 * q.xi + body.J2 * q.zeta) * q.alpha * (pi1 * pi1 - pi2 * pi2) +
         (body.J1 * (alpha2 - q.xi * q.xi) + body.J2 * (q.zeta * q.zeta - alpha2)) * (pi1 * pi2);
}

}  // namespace stationary
