// Relative equilibria in nu-form: elastic force balances centrifugal force, and nu is an
// eigenvector of the locked inertia,
//
//   (a)  F(q, nu) = grad V(q) - C(nu) q = 0        (4 equations)
//   (b)  K(q, nu) = I(q) nu x nu = 0               (3 equations, compatibility)
//
// for any nu; the branches are nu = (nu1, 0, 0), (0, nu2, 0), (0, 0, nu3). Both must hold: (a) has
// more solutions than there are stationary motions. The paper's (91)-(98) are the same set in the
// momenta (balance_in_momenta.hpp).
//
// At alpha = 0 and a spin about one axis (a) is, in u = ln xi, v = ln zeta, w = ln rho and each row
// times its stretch, the gradient of V - q^T C q / 2 in logarithmic coordinates,
//   G_xi   = xi W_t + W_l - c_xi xi^2,
//   G_zeta = zeta W_t + W_l - c_zeta zeta^2,
//   G_rho  = W_r - c_rho rho^2,
// with a symmetric Jacobian; the domain is kept by construction. That is what the solvers solve.
#pragma once

#include <Eigen/Core>

#include "lib/body/body.hpp"
#include "lib/body/inertia.hpp"
#include "lib/body/motion.hpp"
#include "lib/body/stretch.hpp"
#include "lib/material/models/log_balance.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

/// (a), in units of V.
template <class Model, class S>
Vector4<S> balance_residual(const Body& body, const Model& model, const BasicStretch<S>& q,
                            const Vector3<S>& nu) {
  return potential_derivatives<1>(model, q).gradient - centrifugal_matrix(body, nu) * q.vector();
}

/// dF/dq = V_qq - C(nu), symmetric 4x4.
template <class Model, class S>
Matrix4<S> balance_jacobian(const Body& body, const Model& model, const BasicStretch<S>& q,
                            const Vector3<S>& nu) {
  return potential_derivatives<2>(model, q).hessian - centrifugal_matrix(body, nu);
}

/// dF/dnu = -d(C(nu) q)/dnu, 4x3.
template <class S>
Eigen::Matrix<S, 4, 3> balance_jacobian_nu(const Body& body, const BasicStretch<S>& q,
                                           const Vector3<S>& nu) {
  // C is quadratic in nu, so dC/dnu_k q = (C(nu + e_k) - C(nu - e_k)) q / 2 exactly.
  Eigen::Matrix<S, 4, 3> out;
  for (int k = 0; k < 3; ++k) {
    Vector3<S> ahead = nu;
    Vector3<S> behind = nu;
    ahead[k] += S(1.0);
    behind[k] -= S(1.0);
    out.col(k) =
        (centrifugal_matrix(body, behind) - centrifugal_matrix(body, ahead)) * q.vector() * S(0.5);
  }
  return out;
}

/// (b): I(q) nu x nu.
template <class S>
Vector3<S> compatibility_residual(const Body& body, const BasicStretch<S>& q,
                                  const Vector3<S>& nu) {
  const Vector3<S> pi = locked_inertia(body, q) * nu;
  return {pi[1] * nu[2] - pi[2] * nu[1], pi[2] * nu[0] - pi[0] * nu[2],
          pi[0] * nu[1] - pi[1] * nu[0]};
}

/// Rates of C(nu) for a spin about a branch's axis with a given nu^2.
template <class S, class Inertias>
CentrifugalRates<S> axis_rates(const Inertias& body, Branch branch, const S& nu_squared) {
  S squares[3] = {S(0.0), S(0.0), S(0.0)};
  squares[axis(branch)] = nu_squared;
  return centrifugal_rates(body, squares[0], squares[1], squares[2]);
}

/// The balance in logarithmic coordinates, the planar part, from derivatives of W; centrifugal
/// rates in S. (A model's own log_balance() is the same in the stretches themselves.)
template <int order, class S, class Q>
LogBalance<S> planar_log_balance(const PlanarDerivatives<S>& w, const Q& xi, const Q& zeta,
                                 const CentrifugalRates<Q>& c) {
  LogBalance<S> out;
  const Q pull_xi = c.xi * (xi * xi);
  const Q pull_zeta = c.zeta * (zeta * zeta);
  out.g_xi = xi * w.w_t + w.w_l - pull_xi;
  out.g_zeta = zeta * w.w_t + w.w_l - pull_zeta;
  if constexpr (order >= 2) {
    out.uu = xi * (w.w_t + xi * w.w_tt + 2.0 * w.w_tl) + w.w_ll - 2.0 * pull_xi;
    out.vv = zeta * (w.w_t + zeta * w.w_tt + 2.0 * w.w_tl) + w.w_ll - 2.0 * pull_zeta;
    out.uv = xi * zeta * w.w_tt + (xi + zeta) * w.w_tl + w.w_ll;
  }
  return out;
}

/// All three equations, of a coupled potential.
template <int order, class S, class Q>
LogBalance<S> coupled_log_balance(const CoupledDerivatives<S>& w, const Q& xi, const Q& zeta,
                                  const Q& rho, const CentrifugalRates<Q>& c) {
  LogBalance<S> out = planar_log_balance<order>(w.plane, xi, zeta, c);
  const Q pull_rho = c.rho * (rho * rho);
  out.g_rho = w.w_r - pull_rho;
  if constexpr (order >= 2) {
    out.uw = xi * w.w_tr + w.w_lr;
    out.vw = zeta * w.w_tr + w.w_lr;
    out.ww = w.w_rr - 2.0 * pull_rho;
  }
  return out;
}

/// The verdict on a candidate (q, nu), evaluated from the returned numbers alone: what a solver's
/// own word is replaced by.
struct BalanceCheck {
  /// max |F_i| relative to the largest term |V_i|, |V_ij q_j| or |(C q)_i| in F, or |P d_k rho|, what pushes
  /// rho along a held volume. A q correct to the last place leaves a few 1e-16.
  double residual = poison<double>();
  /// max |K_i| relative to the largest product in it; 0 where every product vanishes.
  double compatibility = poison<double>();
};

BalanceCheck check_balance(const Body& body, const Potential& potential, const Stretch& q,
                           const Vector3<double>& nu);

/// The same from the potential's derivatives (order 2) at q. volume_held: they are those along a
/// held volume (Potential::derivatives()), which leaves of the centrifugal force what is along it;
/// cancels: the size of other terms that are in v, and cancel.
BalanceCheck check_balance(const Body& body, const PotentialDerivatives<double>& v,
                           const Stretch& q, const Vector3<double>& nu, bool volume_held = false,
                           double cancels = 0.0);

/// Of an isotropic V at alpha = 0 and a spin about one axis, where F_alpha and K are zero. v: without
/// the derivatives in alpha; c: the rates of C(nu).
BalanceCheck check_straight_balance(const CentrifugalRates<double>& c,
                                    const PotentialDerivatives<double>& v, const Stretch& q);

/// The multiplier P of a held volume, grad V - P grad(d rho) = C(nu) q, at alpha = 0 and the spin
/// nu: positive where it pushes outward. Not a pressure of the material: V + f(d rho) shifts it by
/// f'. NaN where no volume is held.
double pressure(const Body& body, const Potential& potential, const Stretch& q,
                const Vector3<double>& nu);

/// Total energy T + V of the steady rotation.
double energy(const Body& body, const Potential& potential, const Stretch& q,
              const Vector3<double>& nu);

/// The same with V at q known.
double energy(const Body& body, double V, const Stretch& q, const Vector3<double>& nu);

}  // namespace stationary
