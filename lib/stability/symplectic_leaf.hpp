// The linearized dynamics on the leaf |pi| = const, for any stationary motion (alpha != 0, tilted
// and oblique axes included), in canonical coordinates x = (b1, alpha, xi, zeta, rho; b2, p_alpha,
// ...):
//
//   x' = J E'' x,   J = [[0, 1], [-1, 0]],   E = H - kappa |pi|^2/2,  kappa = nu . pi/|pi|^2
//
// delta pi = sqrt|pi| (b1 e1 + b2 e2) with (e1, e2, pi/|pi|) right-handed: pi' = nu x pi then reads
// b1' = dE/db2, b2' = -dE/db1. With m = (pi, p), N = d(m)/dq at fixed velocity (inertia.hpp):
//
//   E''(m, q) = (dm - N dq)^T M^-1 (dm - N dq) + dq^T (V_qq - C(nu)) dq - kappa |d pi|^2.
//
// At pi = 0 there is no b: 8 dimensions. q must be a stationary motion (not checked).
#pragma once

#include <Eigen/Dense>

#include "lib/body/body.hpp"
#include "lib/body/inertia.hpp"

namespace stationary {

template <class S>
struct Leaf {
  int pairs;  ///< 5, or 4 at pi = 0: E'' is 2 pairs x 2 pairs
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> second_variation;
  /// Magnitudes of the terms of each entry, for error bounds: |change| <= u magnitude for inputs of
  /// relative uncertainty u.
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> magnitude;
};

/// V_qq and, for its entries, the conditioning (see first_order_bound.hpp), both 4x4.
template <class S>
Leaf<S> leaf(const Body& body, const BasicStretch<S>& q, const Vector3<S>& nu,
             const Matrix4<S>& V_qq, const Matrix4<S>& V_qq_condition) {
  using Dense = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  using std::abs;
  using std::sqrt;
  const Matrix7<S> M = mass_matrix(body, q);
  const Matrix7<S> M_inverse = M.ldlt().solve(Matrix7<S>::Identity());
  const Matrix7<S> M_magnitude =
      S(2.0) * M_inverse.cwiseAbs() * M.cwiseAbs() * M_inverse.cwiseAbs();
  const Eigen::Matrix<S, 7, 4> N = steady_momenta_jacobian(body, q, nu);
  const Matrix4<S> C = centrifugal_matrix(body, nu);
  const Vector3<S> pi = locked_inertia(body, q) * nu;
  const S size = sqrt(pi.squaredNorm());
  const int b = size > S(0.0) ? 1 : 0;

  // Columns: (m, q) of each canonical coordinate.
  Dense T = Dense::Zero(11, 8 + 2 * b);
  if (b == 1) {
    int smallest = 0;
    for (int k = 1; k < 3; ++k)
      if (abs(pi[k]) < abs(pi[smallest])) smallest = k;
    Vector3<S> aside = Vector3<S>::Zero();
    aside[smallest] = S(1.0);
    const Vector3<S> axis = pi / size;
    const Vector3<S> e1 = aside.cross(axis).normalized();
    const Vector3<S> e2 = axis.cross(e1);
    T.col(0).template head<3>() = sqrt(size) * e1;
    T.col(5).template head<3>() = sqrt(size) * e2;
  }
  for (int k = 0; k < 4; ++k) {
    T(7 + k, b + k) = S(1.0);
    T(3 + k, 4 + 2 * b + k) = S(1.0);
  }

  Dense full(11, 11);
  full << M_inverse, -M_inverse * N, -(M_inverse * N).transpose(),
      V_qq - C + N.transpose() * M_inverse * N;
  Dense magnitude(11, 11);
  const Eigen::Matrix<S, 7, 4> mixed = M_magnitude * N.cwiseAbs();
  magnitude << M_magnitude, S(2.0) * mixed, S(2.0) * mixed.transpose(),
      V_qq_condition + S(3.0) * C.cwiseAbs() + S(4.0) * N.cwiseAbs().transpose() * mixed;
  if (b == 1) {
    const S kappa = nu.dot(pi) / (size * size);
    for (int k = 0; k < 3; ++k) {
      full(k, k) -= kappa;
      magnitude(k, k) += S(4.0) * abs(kappa);
    }
  }
  return {4 + b, T.transpose() * full * T, T.cwiseAbs().transpose() * magnitude * T.cwiseAbs()};
}

}  // namespace stationary
