#include "lib/balance/balance.hpp"

#include <algorithm>
#include <cmath>

#include "lib/balance/anisotropic_balance.hpp"

namespace stationary {

STATIONARY_ORIENTED_BALANCES(template)

namespace {

/// F relative to the largest term in it, gradient V_i, hessian V_ij, force C q and cancels.
template <int N>
double relative_residual(const Eigen::Vector<double, N>& F,
                         const Eigen::Vector<double, N>& gradient,
                         const Eigen::Matrix<double, N, N>& hessian,
                         const Eigen::Vector<double, N>& force, const Eigen::Vector<double, N>& q,
                         double cancels) {
  const double largest = std::max({gradient.cwiseAbs().maxCoeff(), force.cwiseAbs().maxCoeff(),
                                   (hessian * q.asDiagonal()).cwiseAbs().maxCoeff(), cancels});
  const double worst = F.cwiseAbs().maxCoeff();
  return F.allFinite() ? (worst == 0.0 ? 0.0 : worst / largest) : poison<double>();
}

}  // namespace

BalanceCheck check_balance(const Body& body, const Potential& potential, const Stretch& q,
                           const Vector3<double>& nu) {
  const bool held = potential.holds_volume();
  // What pushes rho cancels in the derivatives along a held volume but for its rounding.
  const double cancels = held ? std::abs(pressure(body, potential, q, nu)) * *potential.volume() /
                                    std::min(q.xi, q.zeta)
                              : 0.0;
  BalanceCheck out = check_balance(body, potential.derivatives(q), q, nu, held, cancels);
  // Derivatives along the held volume do not say whether q has it.
  if (held) {
    const double excess = planar_invariants(q).d * q.rho / *potential.volume() - 1.0;
    if (!(std::abs(excess) <= 1e-12)) out.residual = std::fmax(out.residual, std::abs(excess));
  }
  if (!potential.defined_at(q)) out.residual = poison<double>();
  return out;
}

BalanceCheck check_balance(const Body& body, const PotentialDerivatives<double>& v,
                           const Stretch& q, const Vector3<double>& nu, bool volume_held,
                           double cancels) {
  BalanceCheck out;
  const Matrix4<double> C = centrifugal_matrix(body, nu);
  const Vector4<double> force = C * q.vector();
  Vector4<double> F = v.gradient - force;
  if (volume_held) {
    // rho = C/d: d rho/dq_k = -rho d_k/d.
    const double share = force[3] * q.rho / planar_invariants(q).d;
    F += share * Vector4<double>(-2.0 * q.alpha, q.zeta, q.xi, 0.0);
    F[3] = 0.0;
  }
  out.residual = relative_residual<4>(F, v.gradient, v.hessian, force, q.vector(), cancels);

  const Vector3<double> K = compatibility_residual(body, q, nu);
  const Vector3<double> pi = locked_inertia(body, q) * nu;
  // The products that make up K: pi_a nu_b for a != b.
  double largest_product = 0.0;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (a != b) largest_product = std::max(largest_product, std::abs(pi[a] * nu[b]));
  const double worst_k = K.cwiseAbs().maxCoeff();
  out.compatibility = worst_k == 0.0 ? 0.0 : worst_k / largest_product;
  return out;
}

BalanceCheck check_straight_balance(const CentrifugalRates<double>& c,
                                    const PotentialDerivatives<double>& v, const Stretch& q) {
  const Vector3<double> x(q.xi, q.zeta, q.rho);
  const Vector3<double> gradient = v.gradient.tail<3>();
  const Vector3<double> force(c.xi * q.xi, c.zeta * q.zeta, c.rho * q.rho);
  return {.residual = relative_residual<3>(gradient - force, gradient,
                                           v.hessian.bottomRightCorner<3, 3>(), force, x, 0.0),
          .compatibility = 0.0};
}

double pressure(const Body& body, const Potential& potential, const Stretch& q,
                const Vector3<double>& nu) {
  if (!potential.holds_volume()) return poison<double>();
  const double c_rho = centrifugal_matrix(body, nu)(3, 3);
  if (!potential.is_isotropic()) return potential.anisotropic().pressure(q, c_rho);
  const BodyModel<>& model = *potential.body_model();
  if (q.alpha == 0.0) return model.pressure(q.xi, q.zeta, c_rho);
  const auto x = planar_invariants(q);
  const double rho = *model.volume / x.d;
  double pull = model.elastic.evaluate<1>(x, rho).w_r;
  if (model.gravitates)
    pull += gravity_derivatives<1>(model.g, model.J, planar_moment(model.J, q), x.d, rho).w_r;
  return (pull - c_rho * rho * rho) / *model.volume;
}

double energy(const Body& body, const Potential& potential, const Stretch& q,
              const Vector3<double>& nu) {
  return energy(body, potential.value(q), q, nu);
}

double energy(const Body& body, double V, const Stretch& q, const Vector3<double>& nu) {
  return 0.5 * nu.dot(locked_inertia(body, q) * nu) + V;
}

}  // namespace stationary
