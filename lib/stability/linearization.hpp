// The linearized reduced dynamics at a stationary ellipsoid with alpha = 0, in blocks (reflections
// split it wherever V_alpha,xi = V_alpha,zeta = V_alpha,rho = 0: every isotropic V). Lambda = s^2.
//
// z = (pi, q, p):  pi' = nu x pi,  q' = dH/dp,  p' = -dH/dq,  nu = dH/dpi     (Lie-Poisson; the
// paper prints pi' = pi x nu, which gives wrong spectra in (i), (ii): docs/theory.md, errata). On
// the leaf |pi| = const, with omega the spin,
// I1 = J2 zeta^2 + J3 rho^2, I2 = J1 xi^2 + J3 rho^2, I3 = J1 xi^2 + J2 zeta^2:
//
// (i) even (xi, zeta, rho):  diag(J1, J2, J3) x'' + K x = 0,
//       K = V_xx - omega^2 diag(0, J2, J3) + (4 omega^2/I1) u u^T,  u = (0, J2 zeta, J3 rho)
// (i) odd (alpha, pi2; p_alpha, pi3): energy Q1(alpha, pi2) + Q2(p_alpha, pi3), halves of
//       Q1 = [ V_aa - J1 omega^2 + omega^2 h^2/I2   omega h/I2  ]   h = J1 xi + J2 zeta
//            [ omega h/I2                           1/I2 - 1/I1 ]
//       Q2 = [ I3/D   g/D                ]   g = J1 xi - J2 zeta,  D = J1 J2 (xi + zeta)^2
//            [ g/D    (J1+J2)/D - 1/I1   ]
//     (alpha, p_alpha) canonical, {pi2, pi3} = pi1 = I1 omega:  Lambda = -eigenvalues of P Q1,
//     P = Gamma Q2 Gamma, Gamma = diag(1, pi1)
// (ii): (i) with 1 and 2, xi and zeta exchanged.
// (iii) odd (pi1, pi2): energy (1/I1 - 1/I3) pi1^2/2 + (1/I2 - 1/I3) pi2^2/2,
//       Lambda = -omega^2 (I3 - I1)(I3 - I2)/(I1 I2)
// (iii) even (alpha, xi, zeta[, rho]), gyroscopic: M x'' + G x' + K x = 0,
//       M = diag(D/I3, J1, J2[, J3]),  G_xi,alpha = 2 omega J1 J2 zeta (xi+zeta)/I3,
//       G_zeta,alpha = -2 omega J1 J2 xi (xi+zeta)/I3,
//       K_aa = V_aa - omega^2 (J1+J2),
//       K = V_xx - omega^2 diag(J1, J2[, 0]) + (4 omega^2/I3) w w^T,  w = (J1 xi, J2 zeta[, 0]).
//       Where V is separable rho stands alone: Lambda = -V_rr/J3.
// omega = 0 in (iii) is the state of rest, on its 8-dimensional leaf.
//
// Everything is a template on the scalar; characteristic polynomials are formed by the caller's
// arithmetic: extended precision for values, Conditioned for their error bounds.
#pragma once

#include "lib/body/inertia.hpp"
#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"
#include "lib/number/polynomial.hpp"

namespace stationary {

/// State and second derivatives of V at alpha = 0, in q coordinates.
template <class S>
struct StraightState {
  Inertia3<S> J;
  S xi, zeta, rho;
  S omega;
  S V_aa, V_xx, V_xz, V_zz, V_xr, V_zr, V_rr;

  S I1() const { return J.J2 * (zeta * zeta) + J.J3 * (rho * rho); }
  S I2() const { return J.J1 * (xi * xi) + J.J3 * (rho * rho); }
  S I3() const { return J.J1 * (xi * xi) + J.J2 * (zeta * zeta); }

  /// Axes 1 and 2 exchanged: turns (ii) into (i).
  StraightState exchanged() const {
    return {{J.J2, J.J1, J.J3}, zeta, xi, rho, omega, V_aa, V_zz, V_xz, V_xx, V_zr, V_xr, V_rr};
  }
};

template <class S, class Model>
StraightState<S> straight_state(const Inertia3<S>& J, const Model& model, const S& xi,
                                const S& zeta, const S& rho, const S& omega) {
  const auto w = model.template evaluate<2>(planar_invariants(xi, zeta), rho);
  const S inverse_xi = S(1.0) / xi;
  const S inverse_zeta = S(1.0) / zeta;
  const S inverse_rho = S(1.0) / rho;
  const S curvature = w.plane.w_ll - w.plane.w_l;
  StraightState<S> out{J, xi, zeta, rho, omega, {}, {}, {}, {}, {}, {}, {}};
  // l = ln xi + ln zeta at alpha = 0; l_aa = -2/d.
  out.V_aa = -2.0 * w.plane.w_l * (inverse_xi * inverse_zeta);
  out.V_xx = w.plane.w_tt + (2.0 * w.plane.w_tl + curvature * inverse_xi) * inverse_xi;
  out.V_zz = w.plane.w_tt + (2.0 * w.plane.w_tl + curvature * inverse_zeta) * inverse_zeta;
  out.V_xz = w.plane.w_tt + w.plane.w_tl * (inverse_xi + inverse_zeta) +
             w.plane.w_ll * (inverse_xi * inverse_zeta);
  out.V_xr = (w.w_tr + w.w_lr * inverse_xi) * inverse_rho;
  out.V_zr = (w.w_tr + w.w_lr * inverse_zeta) * inverse_rho;
  out.V_rr = (w.w_rr - w.w_r) * (inverse_rho * inverse_rho);
  return out;
}

/// Of a body with gravity or a held volume.
template <class S, class C>
StraightState<S> straight_state(const Inertia3<S>& J, const BodyModel<C>& model, const S& xi,
                                const S& zeta, const S& rho, const S& omega) {
  const Matrix4<S> H =
      model.template derivatives<2>(BasicStretch<S>{S(0.0), xi, zeta, rho}).hessian;
  return {J, xi, zeta, rho, omega, H(0, 0), H(1, 1), H(1, 2), H(2, 2), H(1, 3), H(2, 3), H(3, 3)};
}

/// At alpha = 0, from V's second derivatives there.
template <class S>
StraightState<S> straight_state(const Inertia3<S>& J, const AnisotropicModel<S>& model,
                                const BasicStretch<S>& q, const S& omega) {
  const Matrix4<S> H = potential_derivatives<2>(model, q).hessian;
  return {J,       q.xi,    q.zeta,  q.rho,   omega,   H(0, 0),
          H(1, 1), H(1, 2), H(2, 2), H(1, 3), H(2, 3), H(3, 3)};
}

/// A symmetric pencil Lambda diag(mass) + K of three coordinates.
template <class S>
struct SymmetricPencil {
  S mass[3];
  S K[3][3];  ///< upper triangle used

  Polynomial<S, 1> diagonal(int i) const { return {{K[i][i], mass[i]}}; }
  /// det (Lambda diag(mass) + K), a cubic.
  Polynomial<S, 3> characteristic() const {
    const auto a = diagonal(0);
    const auto b = diagonal(1);
    const auto c = diagonal(2);
    return a * (b * c - constant(S(K[1][2] * K[1][2]))) -
           (S(K[0][1] * K[0][1]) * c + S(K[0][2] * K[0][2]) * b) +
           constant(S(2.0 * (K[0][1] * K[0][2] * K[1][2])));
  }
  /// The same where K02 = 0: V separable.
  Polynomial<S, 3> characteristic_separable() const {
    const auto c = diagonal(2);
    return diagonal(0) * (diagonal(1) * c - constant(S(K[1][2] * K[1][2]))) -
           S(K[0][1] * K[0][1]) * c;
  }
};

/// (i), even. For (ii) give the exchanged state.
template <class S>
SymmetricPencil<S> even_pencil_i(const StraightState<S>& s) {
  const S omega2 = s.omega * s.omega;
  const S gain = 4.0 * omega2 / s.I1();
  const S uz = s.J.J2 * s.zeta;
  const S ur = s.J.J3 * s.rho;
  SymmetricPencil<S> out{{s.J.J1, s.J.J2, s.J.J3}, {}};
  out.K[0][0] = s.V_xx;
  out.K[0][1] = s.V_xz;
  out.K[0][2] = s.V_xr;
  out.K[1][1] = s.V_zz - omega2 * s.J.J2 + gain * (uz * uz);
  out.K[1][2] = s.V_zr + gain * (uz * ur);
  out.K[2][2] = s.V_rr - omega2 * s.J.J3 + gain * (ur * ur);
  return out;
}

/// (i), odd: the two quadratic forms of the energy and pi1 between them.
template <class S>
struct OddForms {
  S Q1[3];   ///< 11, 12, 22 of (alpha, pi2)
  S Q2[3];   ///< of (p_alpha, pi3)
  S P[3];    ///< Gamma Q2 Gamma
  S det_Q1;  ///< each determinant from its own closed form, free of cancellation between products
  S det_P;

  /// Lambda^2 + tr(P Q1) Lambda + det P det Q1.
  Polynomial<S, 2> characteristic() const {
    return {{S(det_P * det_Q1), S(P[0] * Q1[0] + 2.0 * (P[1] * Q1[1]) + P[2] * Q1[2]), S(1.0)}};
  }
};

/// For (ii) give the exchanged state. det_Q1 = [kappa (I1 - I2) - h^2 omega^2]/(I1 I2), kappa =
/// V_aa - J1 omega^2; det P = pi1^2 (I1 - I3)/(I1 D): zeros where other axes branch off, in the
/// plane and tilted. For isotropic V kappa (I1 - I2) - h^2 omega^2 = omega^2 J2 (J1 - J2) zeta^2
/// (xi+zeta)/(xi-zeta).
template <class S>
OddForms<S> odd_forms_i(const StraightState<S>& s) {
  const S I1 = s.I1();
  const S I2 = s.I2();
  const S I3 = s.I3();
  const S sum = s.xi + s.zeta;
  const S h = s.J.J1 * s.xi + s.J.J2 * s.zeta;
  const S g = s.J.J1 * s.xi - s.J.J2 * s.zeta;
  const S D = s.J.J1 * s.J.J2 * (sum * sum);
  const S omega2 = s.omega * s.omega;
  const S pi1 = I1 * s.omega;
  const S kappa = s.V_aa - s.J.J1 * omega2;
  // Not as differences of the inertias, whose common part may be nearly all of them.
  const S of_xi = s.J.J1 * (s.xi * s.xi);
  const S I1_I2 = s.J.J2 * (s.zeta * s.zeta) - of_xi;
  const S I1_I3 = s.J.J3 * (s.rho * s.rho) - of_xi;
  OddForms<S> out;
  out.Q1[0] = kappa + omega2 * (h * h) / I2;
  out.Q1[1] = s.omega * h / I2;
  out.Q1[2] = I1_I2 / (I1 * I2);
  out.Q2[0] = I3 / D;
  out.Q2[1] = g / D;
  out.Q2[2] = (s.J.J1 + s.J.J2) / D - S(1.0) / I1;
  out.P[0] = out.Q2[0];
  out.P[1] = pi1 * out.Q2[1];
  out.P[2] = pi1 * pi1 * out.Q2[2];
  out.det_Q1 = (kappa * I1_I2 - h * h * omega2) / (I1 * I2);
  out.det_P = pi1 * pi1 * (I1_I3 / (I1 * D));
  return out;
}

/// (iii), odd.
template <class S>
S odd_lambda_iii(const StraightState<S>& s) {
  const S of_rho = s.J.J3 * (s.rho * s.rho);
  const S I3_I1 = s.J.J1 * (s.xi * s.xi) - of_rho;
  const S I3_I2 = s.J.J2 * (s.zeta * s.zeta) - of_rho;
  return -(s.omega * s.omega) * (I3_I1 * I3_I2) / (s.I1() * s.I2());
}

/// (iii), even: alpha's own entries, its gyroscopic couplings, and the pencil of (xi, zeta, rho).
template <class S>
struct GyroscopicBlock {
  S mass_alpha;
  S K_alpha;
  S G_xi;    ///< G_xi,alpha
  S G_zeta;  ///< G_zeta,alpha
  SymmetricPencil<S> rest;

  /// det of the (xi, zeta) pencil.
  Polynomial<S, 2> planar_determinant() const {
    return rest.diagonal(0) * rest.diagonal(1) - constant(S(rest.K[0][1] * rest.K[0][1]));
  }
  /// Without rho: det = a det B + Lambda g^T adj(B) g, a cubic.
  Polynomial<S, 3> characteristic() const {
    return alpha_entry() * planar_determinant() +
           raised(S(G_xi * G_xi) * rest.diagonal(1) + S(G_zeta * G_zeta) * rest.diagonal(0) -
                  constant(S(2.0 * (G_xi * G_zeta * rest.K[0][1]))));
  }
  /// With rho coupled: a quartic.
  Polynomial<S, 4> characteristic_coupled() const {
    const auto& K = rest.K;
    const auto b = rest.diagonal(0);
    const auto c = rest.diagonal(1);
    const auto r = rest.diagonal(2);
    const auto adj_bb = c * r - constant(S(K[1][2] * K[1][2]));
    const auto adj_cc = b * r - constant(S(K[0][2] * K[0][2]));
    const auto adj_bc = constant(S(K[0][2] * K[1][2])) - S(K[0][1]) * r;
    return alpha_entry() * rest.characteristic() +
           raised(S(G_xi * G_xi) * adj_bb + S(G_zeta * G_zeta) * adj_cc +
                  S(2.0 * (G_xi * G_zeta)) * adj_bc);
  }
  /// tr adj of the Hermitian pencil at s = sqrt Lambda, without and with rho: p'(Lambda) times this
  /// has the sign of the mode's energy (its Krein signature) at a simple imaginary mode.
  Polynomial<S, 2> trace_adjugate() const {
    return alpha_entry() * (rest.diagonal(0) + rest.diagonal(1)) + planar_determinant() +
           raised(constant(S(G_xi * G_xi + G_zeta * G_zeta)));
  }
  Polynomial<S, 3> trace_adjugate_coupled() const {
    const auto& K = rest.K;
    const auto a = alpha_entry();
    const auto b = rest.diagonal(0);
    const auto c = rest.diagonal(1);
    const auto r = rest.diagonal(2);
    return rest.characteristic() + characteristic() + a * (b * r - constant(S(K[0][2] * K[0][2]))) +
           a * (c * r - constant(S(K[1][2] * K[1][2]))) +
           raised(S(G_xi * G_xi + G_zeta * G_zeta) * r);
  }

 private:
  Polynomial<S, 1> alpha_entry() const { return {{K_alpha, mass_alpha}}; }
};

template <class S>
GyroscopicBlock<S> even_block_iii(const StraightState<S>& s) {
  const S I3 = s.I3();
  const S sum = s.xi + s.zeta;
  const S omega2 = s.omega * s.omega;
  const S gain = 4.0 * omega2 / I3;
  const S wx = s.J.J1 * s.xi;
  const S wz = s.J.J2 * s.zeta;
  const S twist = 2.0 * (s.omega * (s.J.J1 * s.J.J2) * sum) / I3;
  GyroscopicBlock<S> out;
  out.mass_alpha = s.J.J1 * s.J.J2 * (sum * sum) / I3;
  out.K_alpha = s.V_aa - omega2 * (s.J.J1 + s.J.J2);
  out.G_xi = twist * s.zeta;
  out.G_zeta = -(twist * s.xi);
  out.rest.mass[0] = s.J.J1;
  out.rest.mass[1] = s.J.J2;
  out.rest.mass[2] = s.J.J3;
  out.rest.K[0][0] = s.V_xx - omega2 * s.J.J1 + gain * (wx * wx);
  out.rest.K[1][1] = s.V_zz - omega2 * s.J.J2 + gain * (wz * wz);
  out.rest.K[0][1] = s.V_xz + gain * (wx * wz);
  out.rest.K[0][2] = s.V_xr;
  out.rest.K[1][2] = s.V_zr;
  out.rest.K[2][2] = s.V_rr;
  return out;
}

/// Two-polar family (J1 = J2 = J), lambda != mu, in (lambda, mu, rho) at fixed s3 and p_theta:
/// masses (J, J, J3), stiffness V_xx + T_xx. The state's xi, zeta, omega are lambda, mu, omega.
template <class S>
SymmetricPencil<S> two_polar_pencil(const StraightState<S>& s, const S& theta_dot) {
  const S own = 3.0 * (s.J.J1 * (s.omega * s.omega + theta_dot * theta_dot));
  const S mixed = 6.0 * (s.J.J1 * (s.omega * theta_dot));
  SymmetricPencil<S> out{{s.J.J1, s.J.J1, s.J.J3}, {}};
  out.K[0][0] = s.V_xx + own;
  out.K[1][1] = s.V_zz + own;
  out.K[0][1] = s.V_xz + mixed;
  out.K[0][2] = s.V_xr;
  out.K[1][2] = s.V_zr;
  out.K[2][2] = s.V_rr;
  return out;
}

/// Its wobble (s1, s2): Lambda = -a b with a = omega - s3/I1, b = omega - s3/I2; the energies of
/// s1, s2 have the signs of -a s3, -b s3.
template <class S>
struct TwoPolarWobble {
  S a;
  S b;
  S s3;
};

template <class S>
TwoPolarWobble<S> two_polar_wobble(const StraightState<S>& s, const S& theta_dot) {
  const S s3 =
      s.J.J1 * ((s.xi * s.xi + s.zeta * s.zeta) * s.omega + 2.0 * (s.xi * s.zeta * theta_dot));
  return {s.omega - s3 / s.I1(), s.omega - s3 / s.I2(), s3};
}

}  // namespace stationary
