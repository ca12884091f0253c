#include "lib/body/stretch.hpp"

#include <algorithm>
#include <stdexcept>

#include "lib/number/elementary.hpp"

namespace stationary {

const char* violated_inequality(const Stretch& q) {
  if (!q.vector().allFinite()) return "alpha, xi, zeta, rho finite";
  if (!(q.xi > 0.0)) return "xi > 0";
  if (!(q.zeta > 0.0)) return "zeta > 0";
  if (!(q.rho > 0.0)) return "rho > 0";
  const DoubleDouble d = two_product(q.xi, q.zeta) - two_product(q.alpha, q.alpha);
  if (!(double(d) > 0.0)) return "xi zeta - alpha^2 > 0";
  return nullptr;
}

void require_positive_definite(const Stretch& q) {
  if (const char* inequality = violated_inequality(q)) throw std::invalid_argument(inequality);
}

namespace {

/// lambda >= mu.
struct LambdaMu {
  double lambda;
  double mu;
};
LambdaMu lambda_mu(const Stretch& q) {
  if (q.alpha == 0.0) return {std::fmax(q.xi, q.zeta), std::fmin(q.xi, q.zeta)};
  const double t = q.xi + q.zeta;
  const DoubleDouble d = two_product(q.xi, q.zeta) - two_product(q.alpha, q.alpha);
  const double lambda = 0.5 * (t + hypotenuse(q.xi - q.zeta, 2.0 * q.alpha));
  return {lambda, double(d) / lambda};
}

}  // namespace

PrincipalStretches principal_stretches(const Stretch& q) {
  const auto [lambda, mu] = lambda_mu(q);
  if (q.alpha == 0.0 && q.xi == q.zeta) return {lambda, mu, std::nullopt};
  return {lambda, mu, 0.5 * atan2(2.0 * q.alpha, q.xi - q.zeta)};
}

StretchRange stretch_range(const Stretch& q) {
  const auto [lambda, mu] = lambda_mu(q);
  return {std::min(mu, q.rho), std::max(lambda, q.rho)};
}

Stretch stretch_from_principal(const PrincipalStretches& planar, double rho) {
  const double theta = planar.theta.value_or(0.0);
  const double c = cos(theta);
  const double s = sin(theta);
  return {(planar.lambda - planar.mu) * s * c, planar.lambda * c * c + planar.mu * s * s,
          planar.lambda * s * s + planar.mu * c * c, rho};
}

}  // namespace stationary
