// The two flows in time, integrated with Boost.Odeint (Fehlberg 7(8), tolerance 1e-13): the reduced
// one of lie_poisson.hpp, and the body in space of placement.hpp, (Phi1, Phi2, rho) and velocities,
//
//   Dy^T J (Dy X'' + D^2 y[X', X']) = -grad V,   y(X) the columns of Phi,
//
// where no angular momentum occurs. First derivatives by dual numbers.
#pragma once

#include <ceres/jet.h>

#include <Eigen/Cholesky>
#include <boost/numeric/odeint.hpp>
#include <functional>
#include <vector>

#include "tests/support/lie_poisson.hpp"
#include "tests/support/placement.hpp"

namespace stationary::testing {

/// x(time) from x(0); system(x, dx).
template <int n, class System>
Eigen::Matrix<double, n, 1> integrated(const System& system, const Eigen::Matrix<double, n, 1>& x0,
                                       double time) {
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>;
  State x(x0.data(), x0.data() + n);
  const auto field = [&](const State& at, State& rate, double) {
    const Eigen::Matrix<double, n, 1> y = Eigen::Map<const Eigen::Matrix<double, n, 1>>(at.data());
    const Eigen::Matrix<double, n, 1> out = system(y);
    std::copy(out.data(), out.data() + n, rate.begin());
  };
  odeint::integrate_adaptive(
      odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<State>()), field, x, 0.0,
      time, 0.02);
  return Eigen::Map<const Eigen::Matrix<double, n, 1>>(x.data());
}

/// Value's gradient at x.
template <int n, class F>
Eigen::Matrix<double, n, 1> gradient(const F& f, const Eigen::Matrix<double, n, 1>& x) {
  using Jet = ceres::Jet<double, n>;
  Eigen::Matrix<Jet, n, 1> y;
  for (int k = 0; k < n; ++k) y[k] = Jet(x[k], k);
  return f(y).v;
}

template <class Model>
struct ReducedFlow {
  Body body;
  Model model;

  double energy(const Vector11<double>& z) const { return hamiltonian(body, model, z); }
  Vector11<double> operator()(const Vector11<double>& z) const {
    const Vector11<double> dH =
        gradient<11>([&]<class S>(const Vector11<S>& y) { return hamiltonian(body, model, y); }, z);
    return lie_poisson_field<double>(z, dH);
  }
};

/// P = pi3 + p_alpha (xi - zeta) - 2 alpha (p_xi - p_zeta): the momentum of material rotations.
inline double material_momentum(const Vector11<double>& z) {
  return z[2] + z[7] * (z[4] - z[5]) - 2.0 * z[3] * (z[8] - z[9]);
}

using Vector14d = Eigen::Matrix<double, 14, 1>;

template <class Model>
struct PlacementFlow {
  Body body;
  Model model;

  Vector14d operator()(const Vector14d& xv) const {
    const Vector7<double> X = xv.head<7>();
    const Vector7<double> V = xv.tail<7>();
    using Jet = ceres::Jet<double, 7>;
    Vector7<Jet> XJ;
    for (int k = 0; k < 7; ++k) XJ[k] = Jet(X[k], k);
    const Vector9<Jet> y = columns<Jet>(XJ);
    Eigen::Matrix<double, 9, 7> Dy;
    for (int k = 0; k < 9; ++k) Dy.row(k) = y[k].v.transpose();
    const Vector7<double> dV = elastic_energy(model, XJ).v;

    // (rho n)'' along the straight line X + t V: only the third column curves.
    const Vector3<double> a = X.head<3>();
    const Vector3<double> b = X.segment<3>(3);
    const Vector3<double> a1 = V.head<3>();
    const Vector3<double> b1 = V.segment<3>(3);
    const Vector3<double> N = a.cross(b);
    const Vector3<double> N1 = a1.cross(b) + a.cross(b1);
    const Vector3<double> N2 = 2.0 * a1.cross(b1);
    const double r = N.norm();
    const double r1 = N.dot(N1) / r;
    const double r2 = (N1.dot(N1) + N.dot(N2) - r1 * r1) / r;
    const double f = X[6] / r;
    const double f1 = V[6] / r - X[6] * r1 / (r * r);
    const double f2 =
        -2.0 * V[6] * r1 / (r * r) - X[6] * r2 / (r * r) + 2.0 * X[6] * r1 * r1 / (r * r * r);
    Vector9<double> curve = Vector9<double>::Zero();
    curve.tail<3>() = f2 * N + 2.0 * f1 * N1 + f * N2;

    Vector9<double> J;
    J << body.J1, body.J1, body.J1, body.J2, body.J2, body.J2, body.J3, body.J3, body.J3;
    const Matrix7<double> M = Dy.transpose() * J.asDiagonal() * Dy;
    const Vector7<double> force = -dV - Dy.transpose() * J.asDiagonal() * curve;
    Vector14d out;
    out << V, M.ldlt().solve(force);
    return out;
  }
};

/// Both flows of a problem, the potential looked up once.
struct Flows {
  std::function<Vector11<double>(const Vector11<double>&)> reduced;
  std::function<Vector14d(const Vector14d&)> in_space;
  std::function<double(const Vector11<double>&)> energy;
};
inline Flows flows(const Body& body, const Potential& potential) {
  return potential.visit_parts([&]<class Model>(const Model& model) {
    const ReducedFlow<Model> reduced{body, model};
    return Flows{reduced, PlacementFlow<Model>{body, model},
                 [reduced](const Vector11<double>& z) { return reduced.energy(z); }};
  });
}

/// Placement and velocity at L = 1 of a reduced state.
inline Vector14d placed_state(const Body& body, const Vector11<double>& z) {
  const Stretch q{z[3], z[4], z[5], z[6]};
  Vector7<double> momenta;
  momenta << z[0], z[1], z[2], z[7], z[8], z[9], z[10];
  const Vector7<double> v = inverse_legendre(body, q, momenta);
  Matrix3<double> S;
  S << q.xi, q.alpha, 0.0, q.alpha, q.zeta, 0.0, 0.0, 0.0, q.rho;
  Matrix3<double> spin;  // L^-1 L'
  spin << 0.0, v[2], -v[1], -v[2], 0.0, v[0], v[1], -v[0], 0.0;
  Matrix3<double> S_dot;
  S_dot << v[4], v[3], 0.0, v[3], v[5], 0.0, 0.0, 0.0, v[6];
  const Matrix3<double> rate = spin * S + S_dot;
  Vector14d out;
  out << placed(q), rate.col(0), rate.col(1), v[6];
  return out;
}

/// S and L of a placement: G = S^2, S = (G + d)/t.
struct Polar {
  Stretch q;
  Matrix3<double> L;
};
inline Polar polar(const Vector14d& xv) {
  const Vector3<double> a = xv.head<3>();
  const Vector3<double> b = xv.segment<3>(3);
  const Vector3<double> normal = a.cross(b);
  const double d = normal.norm();
  const double t = std::sqrt(a.dot(a) + b.dot(b) + 2.0 * d);
  Polar out{{a.dot(b) / t, (a.dot(a) + d) / t, (b.dot(b) + d) / t, xv[6]}, {}};
  const Stretch& q = out.q;
  out.L.col(0) = (q.zeta * a - q.alpha * b) / d;
  out.L.col(1) = (q.xi * b - q.alpha * a) / d;
  out.L.col(2) = normal / d;
  return out;
}

/// The tangent of the flow over `time`: central differences at two steps, extrapolated.
template <int n, class System>
Eigen::MatrixXd tangent(const System& system, const Eigen::Matrix<double, n, 1>& x, double time) {
  const auto difference = [&](int k, double h) -> Eigen::VectorXd {
    Eigen::Matrix<double, n, 1> ahead = x;
    Eigen::Matrix<double, n, 1> behind = x;
    ahead[k] += h;
    behind[k] -= h;
    return (integrated<n>(system, ahead, time) - integrated<n>(system, behind, time)) / (2.0 * h);
  };
  Eigen::MatrixXd out(n, n);
  for (int k = 0; k < n; ++k) out.col(k) = (4.0 * difference(k, 5e-4) - difference(k, 1e-3)) / 3.0;
  return out;
}

}  // namespace stationary::testing
