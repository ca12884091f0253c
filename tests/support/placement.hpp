// The body as it moves in space, without angular momentum, stretch or bracket: X = (Phi1, Phi2,
// rho) in R^7, the third column of Phi being rho n, n the unit normal of (Phi1, Phi2)
// (Kirchhoff-Love),
//
//   L = (J1 |Phi1'|^2 + J2 |Phi2'|^2 + J3 |(rho n)'|^2)/2 - V(S),   S^2 = (Phi1, Phi2)^T (Phi1,
//   Phi2).
//
// V through the invariants: d^2 = det S^2, t^2 = tr S^2 + 2 d.
#pragma once

#include <Eigen/Cholesky>

#include "lib/body/body.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/lie_poisson.hpp"

namespace stationary::testing {

template <class S>
using Vector9 = Eigen::Matrix<S, 9, 1>;

template <class S>
Vector3<S> crossed(const Vector3<S>& a, const Vector3<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The columns of Phi, one under the other.
template <class S>
Vector9<S> columns(const Vector7<S>& X) {
  using std::sqrt;
  const Vector3<S> a{X[0], X[1], X[2]};
  const Vector3<S> b{X[3], X[4], X[5]};
  const Vector3<S> normal = crossed<S>(a, b);
  const S length = sqrt(S(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]));
  Vector9<S> out;
  for (int k = 0; k < 3; ++k) {
    out[k] = a[k];
    out[3 + k] = b[k];
    out[6 + k] = X[6] * normal[k] / length;
  }
  return out;
}

template <class Model, class S>
S elastic_energy(const Model& model, const Vector7<S>& X) {
  using std::sqrt;
  const Vector3<S> a{X[0], X[1], X[2]};
  const Vector3<S> b{X[3], X[4], X[5]};
  const auto dot = [](const Vector3<S>& x, const Vector3<S>& y) {
    return S(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
  };
  const Vector3<S> normal = crossed<S>(a, b);
  const S aa = dot(a, a);
  const S bb = dot(b, b);
  const S ab = dot(a, b);
  const S d = sqrt(dot(normal, normal));
  const S t2 = aa + bb + 2.0 * d;
  const S t = sqrt(t2);
  // (lambda - mu)^2 = (lambda^2 - mu^2)^2/t^2.
  const S e = ((aa - bb) * (aa - bb) + 4.0 * (ab * ab)) / t2;
  return model.template evaluate<0>(PlanarInvariants<S>{t, d, e}, X[6]).plane.w;
}

/// J-weighted squares of the columns.
template <class S>
S weighted_square(const Body& body, const Vector9<S>& y) {
  const double J[3] = {body.J1, body.J2, body.J3};
  S out = S(0.0);
  for (int k = 0; k < 9; ++k) out += J[k / 3] * (y[k] * y[k]);
  return out;
}

/// Phi = S: the placement with L = 1.
template <class S>
Vector7<S> placed(const BasicStretch<S>& q) {
  Vector7<S> X = Vector7<S>::Constant(S(0.0));
  X[0] = q.xi;
  X[1] = X[3] = q.alpha;
  X[4] = q.zeta;
  X[6] = q.rho;
  return X;
}

/// The linearization about a steady rotation in the frame that turns with it, R^14: eigenvalues of
/// x'' from M x'' + G x' + K x = 0, with L(x, v) in that frame, M = L_vv, G = L_vx - L_xv, K =
/// -L_xx. In space the frame turns at -nu (the sign of nu: lib/conventions.md); nu is an
/// eigenvector of the locked inertia, so at L = 1 that is a steady turn. 14 = 10 of the leaf, a
/// zero pair (turning about nu, its momentum) and +- i |nu| (the other turns). flow: theta' of a
/// two-polar motion (J1 = J2), at omega = nu3: the frame of the material turns with it.
template <class Model>
Eigen::Matrix<Number50, Eigen::Dynamic, Eigen::Dynamic> placement_matrix(
    const Body& body, const Model& model, const BasicStretch<Number50>& q,
    const Vector3<Number50>& nu, const Number50& flow = Number50(0)) {
  using Vector14 = Eigen::Matrix<Number50, 14, 1>;
  const Vector3<Number50> turn = -nu;
  const auto lagrangian = [&](const Vector14& xv) {
    const Vector7<Number50> X = xv.head<7>();
    const Vector7<Number50> V = xv.tail<7>();
    // d(columns) along V, exactly: the normal's derivative by hand.
    const Vector3<Number50> a = X.head<3>();
    const Vector3<Number50> b = X.segment<3>(3);
    const Vector3<Number50> n = crossed<Number50>(a, b);
    const Vector3<Number50> n_dot = crossed<Number50>(Vector3<Number50>(V.head<3>()), b) +
                                    crossed<Number50>(a, Vector3<Number50>(V.segment<3>(3)));
    const Number50 length = sqrt(Number50(n.dot(n)));
    const Number50 length_dot = n.dot(n_dot) / length;
    const Vector9<Number50> y = columns<Number50>(X);
    Vector9<Number50> rate;
    for (int k = 0; k < 3; ++k) {
      rate[k] = V[k];
      rate[3 + k] = V[3 + k];
      rate[6 + k] = (V[6] * n[k] + X[6] * n_dot[k] - X[6] * n[k] * length_dot / length) / length;
    }
    for (int c = 0; c < 3; ++c) {
      const Vector3<Number50> column = y.segment<3>(3 * c);
      const Vector3<Number50> swept = crossed<Number50>(turn, column);
      for (int k = 0; k < 3; ++k) rate[3 * c + k] += swept[k];
    }
    for (int k = 0; k < 3; ++k) {
      rate[k] -= flow * y[3 + k];
      rate[3 + k] += flow * y[k];
    }
    return Number50(weighted_square<Number50>(body, rate) / 2 -
                    elastic_energy<Model, Number50>(model, X));
  };
  Vector14 at = Vector14::Constant(Number50(0));
  at.head<7>() = placed(q);
  const Eigen::Matrix<Number50, 14, 14> second = differences<14>(lagrangian, at).second;
  const Matrix7<Number50> M = second.bottomRightCorner<7, 7>();
  const Matrix7<Number50> L_vx = second.bottomLeftCorner<7, 7>();
  const Matrix7<Number50> G = L_vx - L_vx.transpose();
  const Matrix7<Number50> K = -second.topLeftCorner<7, 7>();
  const Matrix7<Number50> inverse = M.ldlt().solve(Matrix7<Number50>::Identity());
  Eigen::Matrix<Number50, Eigen::Dynamic, Eigen::Dynamic> A(14, 14);
  A << Matrix7<Number50>::Constant(Number50(0)), Matrix7<Number50>::Identity(), -inverse * K,
      -inverse * G;
  return A;
}

}  // namespace stationary::testing
