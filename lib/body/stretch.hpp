// The stretch S = [[xi, alpha, 0], [alpha, zeta, 0], [0, 0, rho]], positive definite; q = (alpha,
// xi, zeta, rho) in this order everywhere.
//
//   t = xi + zeta,  d = xi zeta - alpha^2,  e = t^2 - 4 d = (xi - zeta)^2 + 4 alpha^2
//   principal stretches lambda >= mu: roots of x^2 - t x + d;
//   theta = atan2(2 alpha, xi - zeta)/2
//
// t and d have no singularity at the circle lambda = mu, the principal stretches do. e is carried
// along because near the circle it cannot be had from t and d without cancellation.
// The paper's eqs. (15)-(17); lambda, mu are stretches here, never material coefficients.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "lib/number/number.hpp"

namespace stationary {

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;
template <class S>
using Vector4 = Eigen::Matrix<S, 4, 1>;
template <class S>
using Matrix4 = Eigen::Matrix<S, 4, 4>;

/// (a - b)/(a + b), as two stretches or locked inertias are compared.
constexpr double relative_difference(double a, double b) { return (a - b) / (a + b); }

template <class S>
struct BasicStretch {
  S alpha;
  S xi;
  S zeta;
  S rho;

  Vector4<S> vector() const { return {alpha, xi, zeta, rho}; }
  static BasicStretch from(const Vector4<S>& q) { return {q[0], q[1], q[2], q[3]}; }
};

using Stretch = BasicStretch<double>;

/// (xi, zeta, rho).
template <class S>
Vector3<S> diagonal(const BasicStretch<S>& q) {
  return {q.xi, q.zeta, q.rho};
}

/// The violated inequality of positive definiteness, or nullptr: xi > 0, zeta > 0, rho > 0,
/// xi zeta - alpha^2 > 0, all finite.
const char* violated_inequality(const Stretch& q);

/// Throws std::invalid_argument with the violated inequality.
void require_positive_definite(const Stretch& q);

/// Planar invariants of S.
template <class S>
struct PlanarInvariants {
  S t;  ///< trace, xi + zeta
  S d;  ///< determinant, xi zeta - alpha^2
  S e;  ///< discriminant, t^2 - 4 d >= 0
};

template <class S>
PlanarInvariants<S> planar_invariants(const BasicStretch<S>& q) {
  const S difference = q.xi - q.zeta;
  return {q.xi + q.zeta, q.xi * q.zeta - q.alpha * q.alpha,
          square(difference) + 4.0 * square(q.alpha)};
}

/// At alpha = 0, where xi and zeta are themselves the principal stretches.
template <class S>
PlanarInvariants<S> planar_invariants(const S& xi, const S& zeta) {
  const S difference = xi - zeta;
  return {xi + zeta, xi * zeta, square(difference)};
}

/// Extended precision from doubles: t and d are exact (one rounding error each, kept).
inline PlanarInvariants<DoubleDouble> extended_invariants(double xi, double zeta) {
  const DoubleDouble difference = two_sum(xi, -zeta);
  return {two_sum(xi, zeta), two_product(xi, zeta), difference * difference};
}

/// Two-polar form of the plane: S = U(theta) diag(lambda, mu) U(theta)^T, lambda >= mu > 0. No
/// angle on the circle lambda = mu.
struct PrincipalStretches {
  double lambda;
  double mu;
  std::optional<double> theta;
};

/// Each of lambda, mu to a few units in its last place (mu as d / lambda, not as a difference).
PrincipalStretches principal_stretches(const Stretch& q);

/// The least and the largest of lambda, mu, rho.
struct StretchRange {
  double least;
  double most;
};
StretchRange stretch_range(const Stretch& q);

/// The inverse: eq. (17), for lambda, mu, rho > 0; the angle counts 0 where it has no meaning.
Stretch stretch_from_principal(const PrincipalStretches& planar, double rho);

}  // namespace stationary
