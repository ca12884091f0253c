// The reduced equations of motion from the Hamiltonian's values alone:
//
//   z = (pi, q, p) in R^11,  H = (pi, p)^T M(q)^-1 (pi, p)/2 + V(q),
//   pi' = nu x pi,  q' = dH/dp,  p' = -dH/dq,  nu = dH/dpi.
//
// Derivatives of H are differences in 50 digits (linearization) or dual numbers (flow): none of the
// library's own derivatives is used. sign = -1 is the bracket as the paper prints it, pi' = pi x
// nu.
#pragma once

#include <Eigen/Core>

#include "lib/body/inertia.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::testing {

template <class S>
using Vector11 = Eigen::Matrix<S, 11, 1>;

template <class Model, class S>
S hamiltonian(const Body& body, const Model& model, const Vector11<S>& z) {
  const BasicStretch<S> q{z[3], z[4], z[5], z[6]};
  Vector7<S> momenta;
  momenta << z[0], z[1], z[2], z[7], z[8], z[9], z[10];
  const Vector7<S> v = inverse_legendre(body, q, momenta);
  return 0.5 * momenta.dot(v) + potential_derivatives<0>(model, q).value;
}

/// z of a steady rotation.
template <class S>
Vector11<S> steady_point(const Body& body, const BasicStretch<S>& q, const Vector3<S>& nu) {
  const Vector7<S> m = steady_momenta(body, q, nu);
  Vector11<S> z;
  z << m[0], m[1], m[2], q.alpha, q.xi, q.zeta, q.rho, m[3], m[4], m[5], m[6];
  return z;
}

/// z' from z and dH/dz.
template <class S>
Vector11<S> lie_poisson_field(const Vector11<S>& z, const Vector11<S>& dH, double sign = 1.0) {
  Vector11<S> out;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    out[k] = S(sign) * (dH[i] * z[j] - dH[j] * z[i]);
  }
  for (int k = 0; k < 4; ++k) {
    out[3 + k] = dH[7 + k];
    out[7 + k] = -dH[3 + k];
  }
  return out;
}

/// Gradient and Hessian of f at x by central differences: h = 1e-12 leaves errors near 1e-24 of f's
/// scale.
template <int n, class F>
std::pair<Eigen::Matrix<Number50, n, 1>, Eigen::Matrix<Number50, n, n>> differences(
    const F& f, const Eigen::Matrix<Number50, n, 1>& x) {
  const Number50 h("1e-12");
  using Vector = Eigen::Matrix<Number50, n, 1>;
  const auto moved = [&](int i, int a, int j, int b) {
    Vector y = x;
    y[i] += a * h;
    y[j] += b * h;
    return Number50(f(y));
  };
  const Number50 f0 = f(x);
  Vector gradient;
  Eigen::Matrix<Number50, n, n> hessian;
  std::array<Number50, n> ahead;
  std::array<Number50, n> behind;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    ahead[k] = moved(i, 1, i, 0);
    behind[k] = moved(i, -1, i, 0);
    gradient[i] = (ahead[k] - behind[k]) / (2 * h);
    hessian(i, i) = (ahead[k] - 2 * f0 + behind[k]) / (h * h);
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      const Number50 sum = moved(i, 1, j, 1) + moved(i, -1, j, -1);
      hessian(i, j) = hessian(j, i) =
          (sum - ahead[a] - behind[a] - ahead[b] - behind[b] + 2 * f0) / (2 * h * h);
    }
  }
  return {gradient, hessian};
}

/// d(z')/dz at a relative equilibrium, 11x11.
template <class Model>
Eigen::Matrix<Number50, 11, 11> lie_poisson_matrix(const Body& body, const Model& model,
                                                   const Vector11<Number50>& z, double sign = 1.0) {
  const auto [dH, ddH] =
      differences<11>([&](const Vector11<Number50>& y) { return hamiltonian(body, model, y); }, z);
  Eigen::Matrix<Number50, 11, 11> A;
  for (int column = 0; column < 11; ++column) {
    // The field is bilinear in (z, dH).
    Vector11<Number50> e = Vector11<Number50>::Constant(Number50(0));
    e[column] = 1;
    const Vector11<Number50> second = ddH.col(column);
    Vector11<Number50> through = lie_poisson_field<Number50>(z, second, sign);
    const Vector11<Number50> own = lie_poisson_field<Number50>(e, dH, sign);
    for (int k = 0; k < 3; ++k) through[k] += own[k];
    A.col(column) = through;
  }
  return A;
}

}  // namespace stationary::testing
