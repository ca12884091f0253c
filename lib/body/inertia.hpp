// Kinetic energy T = v^T M(q) v / 2 of v = (nu1, nu2, nu3, alpha', xi', zeta', rho') and its parts.
//
//   T_rot = nu^T I(q) nu / 2 = q^T C(nu) q / 2   (C does not depend on q: the centrifugal force C q
//                                                 is linear in q)
//   M = [ I(q)  B(q) ]   B couples nu3 to (alpha', xi', zeta'):
//       [ B^T   D    ]   (-(J1 xi - J2 zeta), J1 alpha, -J2 alpha);  D = diag(J1+J2, J1, J2, J3)
//
// Shapes: I 3x3, C 4x4, M 7x7, in the orders above. I, D in units of J (times stretch^2 for I).
// Legendre transform (pi, p) = M v. The paper's eqs. (20)-(22) and the unnumbered ones up to (73).
// Sums and products of J's are formed in S, not in double: they round once, in the number type
// asked for.
// nu is the paper's: L^-1 L' = [[0, nu3, -nu2], [-nu3, 0, nu1], [nu2, -nu1, 0]], see
// conventions.md.
#pragma once

#include <Eigen/Core>

#include "lib/body/body.hpp"
#include "lib/body/stretch.hpp"

namespace stationary {

template <class S>
using Vector7 = Eigen::Matrix<S, 7, 1>;
template <class S>
using Matrix7 = Eigen::Matrix<S, 7, 7>;

/// J as numbers of type S (as inputs of a Conditioned computation, say).
template <class S>
struct Inertia3 {
  S J1;
  S J2;
  S J3;
};

/// That of an axis, from 0, of a Body, an Inertia3 or what else has all three.
template <class Inertias>
constexpr auto& inertia_of(Inertias& J, int axis) {
  return axis == 0 ? J.J1 : axis == 1 ? J.J2 : J.J3;
}

/// Locked inertia I(q), eq. (20). body, here and below: J1, J2, J3 as doubles or in S.
template <class S, class Inertias>
Matrix3<S> locked_inertia(const Inertias& body, const BasicStretch<S>& q) {
  const S alpha2 = q.alpha * q.alpha;
  const S xi2 = q.xi * q.xi;
  const S zeta2 = q.zeta * q.zeta;
  const S rho2 = q.rho * q.rho;
  const S zero = S(0.0);
  const S I12 = -((body.J1 * q.xi + body.J2 * q.zeta) * q.alpha);
  Matrix3<S> I;
  I(0, 0) = body.J1 * alpha2 + body.J2 * zeta2 + body.J3 * rho2;
  I(1, 1) = body.J1 * xi2 + body.J2 * alpha2 + body.J3 * rho2;
  I(2, 2) = body.J1 * xi2 + body.J2 * zeta2 + (S(body.J1) + body.J2) * alpha2;
  I(0, 1) = I(1, 0) = I12;
  I(0, 2) = I(2, 0) = I(1, 2) = I(2, 1) = zero;
  return I;
}

/// (J1 xi^2, J2 zeta^2, J3 rho^2). At alpha = 0 each locked inertia is the sum of the other two, so
/// I_a - I_b = m_b - m_a, without their common part.
inline Vector3<double> second_moments(const Body& body, const Stretch& q) {
  return {body.J1 * (q.xi * q.xi), body.J2 * (q.zeta * q.zeta), body.J3 * (q.rho * q.rho)};
}

/// Diagonal of C(nu) in (xi, zeta, rho), from the squares of nu's components; at alpha = 0 and a
/// spin about one material axis this is all of the centrifugal force.
template <class S>
struct CentrifugalRates {
  S xi;
  S zeta;
  S rho;
};

template <class S, class Inertias>
CentrifugalRates<S> centrifugal_rates(const Inertias& body, const S& nu1_squared,
                                      const S& nu2_squared, const S& nu3_squared) {
  return {body.J1 * (nu2_squared + nu3_squared), body.J2 * (nu1_squared + nu3_squared),
          body.J3 * (nu1_squared + nu2_squared)};
}

/// The products of nu's components in C(nu); nu3 and an in-plane component are never both there
/// but in the squares.
template <class S>
struct SpinProducts {
  S square_1;
  S square_2;
  S square_3;
  S product_12;
};

/// Centrifugal matrix C(nu): T_rot = q^T C q / 2.
template <class S, class Inertias>
Matrix4<S> centrifugal_matrix(const Inertias& body, const SpinProducts<S>& n) {
  Matrix4<S> C = Matrix4<S>::Constant(S(0.0));
  C(0, 0) = body.J1 * n.square_1 + body.J2 * n.square_2 + (S(body.J1) + body.J2) * n.square_3;
  const CentrifugalRates<S> rates = centrifugal_rates(body, n.square_1, n.square_2, n.square_3);
  C(1, 1) = rates.xi;
  C(2, 2) = rates.zeta;
  C(3, 3) = rates.rho;
  C(0, 1) = C(1, 0) = -(body.J1 * n.product_12);
  C(0, 2) = C(2, 0) = -(body.J2 * n.product_12);
  return C;
}

template <class S>
Matrix4<S> centrifugal_matrix(const Body& body, const Vector3<S>& nu) {
  return centrifugal_matrix(
      body, SpinProducts<S>{nu[0] * nu[0], nu[1] * nu[1], nu[2] * nu[2], nu[0] * nu[1]});
}

/// The row of M that couples nu3 to (alpha', xi', zeta'), eq. (21).
template <class S, class Inertias>
Vector3<S> gyroscopic_coupling(const Inertias& body, const BasicStretch<S>& q) {
  return {-(body.J1 * q.xi - body.J2 * q.zeta), body.J1 * q.alpha, -(body.J2 * q.alpha)};
}

/// Mass matrix M(q), 7x7, symmetric positive definite wherever S is.
template <class S, class Inertias>
Matrix7<S> mass_matrix(const Inertias& body, const BasicStretch<S>& q) {
  Matrix7<S> M = Matrix7<S>::Constant(S(0.0));
  M.template topLeftCorner<3, 3>() = locked_inertia(body, q);
  const Vector3<S> coupling = gyroscopic_coupling(body, q);
  for (int k = 0; k < 3; ++k) M(2, 3 + k) = M(3 + k, 2) = coupling[k];
  M(3, 3) = S(body.J1) + body.J2;
  M(4, 4) = S(body.J1);
  M(5, 5) = S(body.J2);
  M(6, 6) = S(body.J3);
  return M;
}

/// Momenta (pi1, pi2, pi3, p_alpha, p_xi, p_zeta, p_rho) of the velocities v (same order).
template <class S>
Vector7<S> legendre(const Body& body, const BasicStretch<S>& q, const Vector7<S>& velocity) {
  return mass_matrix(body, q) * velocity;
}

/// Velocities of given momenta, in closed form: the inverse of legendre(), the paper's equations
/// for nu1, nu2, nu3, d(alpha)/dt, d(xi)/dt, d(zeta)/dt, d(rho)/dt before (73).
template <class S, class Inertias>
Vector7<S> inverse_legendre(const Inertias& body, const BasicStretch<S>& q,
                            const Vector7<S>& momenta) {
  const Matrix3<S> I = locked_inertia(body, q);
  const S det = I(0, 0) * I(1, 1) - I(0, 1) * I(0, 1);
  const S sum = q.xi + q.zeta;
  const S denominator = S(body.J1) * body.J2 * (sum * sum);
  const S shifted = momenta[2] + q.alpha * (momenta[5] - momenta[4]);
  const S g = body.J1 * q.xi - body.J2 * q.zeta;
  const S nu3 = ((S(body.J1) + body.J2) * shifted + g * momenta[3]) / denominator;
  Vector7<S> v;
  v[0] = (I(1, 1) * momenta[0] - I(0, 1) * momenta[1]) / det;
  v[1] = (I(0, 0) * momenta[1] - I(0, 1) * momenta[0]) / det;
  v[2] = nu3;
  v[3] = (g * shifted + (body.J1 * (q.xi * q.xi) + body.J2 * (q.zeta * q.zeta)) * momenta[3]) /
         denominator;
  v[4] = momenta[4] / body.J1 - q.alpha * nu3;
  v[5] = momenta[5] / body.J2 + q.alpha * nu3;
  v[6] = momenta[6] / body.J3;
  return v;
}

/// Momenta of a steady rotation: v = (nu, 0).
template <class S>
Vector7<S> steady_momenta(const Body& body, const BasicStretch<S>& q, const Vector3<S>& nu) {
  Vector7<S> v = Vector7<S>::Constant(S(0.0));
  for (int k = 0; k < 3; ++k) v[k] = nu[k];
  return legendre(body, q, v);
}

/// d(steady_momenta)/dq at fixed nu, 7x4: linear in q.
template <class S, class Inertias>
Eigen::Matrix<S, 7, 4> steady_momenta_jacobian(const Inertias& body, const BasicStretch<S>& q,
                                               const Vector3<S>& nu) {
  const auto J1 = body.J1;
  const auto J2 = body.J2;
  const S h = J1 * q.xi + J2 * q.zeta;
  Eigen::Matrix<S, 7, 4> N = Eigen::Matrix<S, 7, 4>::Constant(S(0.0));
  N(0, 0) = 2.0 * J1 * q.alpha * nu[0] - h * nu[1];
  N(0, 1) = -(J1 * q.alpha * nu[1]);
  N(0, 2) = 2.0 * J2 * q.zeta * nu[0] - J2 * q.alpha * nu[1];
  N(0, 3) = 2.0 * body.J3 * q.rho * nu[0];
  N(1, 0) = 2.0 * J2 * q.alpha * nu[1] - h * nu[0];
  N(1, 1) = 2.0 * J1 * q.xi * nu[1] - J1 * q.alpha * nu[0];
  N(1, 2) = -(J2 * q.alpha * nu[0]);
  N(1, 3) = 2.0 * body.J3 * q.rho * nu[1];
  N(2, 0) = 2.0 * (S(J1) + J2) * q.alpha * nu[2];
  N(2, 1) = 2.0 * J1 * q.xi * nu[2];
  N(2, 2) = 2.0 * J2 * q.zeta * nu[2];
  N(3, 1) = -(J1 * nu[2]);
  N(3, 2) = J2 * nu[2];
  N(4, 0) = J1 * nu[2];
  N(5, 0) = -(J2 * nu[2]);
  return N;
}

}  // namespace stationary
