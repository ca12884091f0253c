#include "lib/balance/balance.hpp"

#include <algorithm>
#include <cmath>

namespace stationary {

BalanceCheck check_balance(const Body& body, const Potential& potential, const Stretch& q,
                           const Vector3<double>& nu) {
  BalanceCheck out = check_balance(body, potential.derivatives(q), q, nu);
  if (!potential.defined_at(q)) out.residual = poison<double>();
  return out;
}

BalanceCheck check_balance(const Body& body, const PotentialDerivatives<double>& v,
                           const Stretch& q, const Vector3<double>& nu) {
  BalanceCheck out;
  const Matrix4<double> C = centrifugal_matrix(body, nu);
  const Vector4<double> force = C * q.vector();
  const Vector4<double> F = v.gradient - force;
  const double largest = std::max({v.gradient.cwiseAbs().maxCoeff(), force.cwiseAbs().maxCoeff(),
                                   (v.hessian * q.vector().asDiagonal()).cwiseAbs().maxCoeff()});
  const double worst = F.cwiseAbs().maxCoeff();
  out.residual = F.allFinite() ? (worst == 0.0 ? 0.0 : worst / largest) : poison<double>();

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

double energy(const Body& body, const Potential& potential, const Stretch& q,
              const Vector3<double>& nu) {
  return energy(body, potential.value(q), q, nu);
}

double energy(const Body& body, double V, const Stretch& q, const Vector3<double>& nu) {
  return 0.5 * nu.dot(locked_inertia(body, q) * nu) + V;
}

}  // namespace stationary
