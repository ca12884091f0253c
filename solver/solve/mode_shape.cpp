#include "solver/solve/mode_shape.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "lib/balance/two_polar.hpp"
#include "lib/body/inertia.hpp"
#include "lib/leaf/iterated_modes.hpp"
#include "lib/number/elementary.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "lib/stability/held_linearization.hpp"

namespace stationary {
namespace {

using Complex = std::complex<double>;
using ComplexVector = Vector3<Complex>;
using ComplexMatrix = Matrix3<Complex>;

/// a x b = hat(a) b.
ComplexMatrix hat(const ComplexVector& a) {
  const Complex none(0.0);
  ComplexMatrix out;
  out << none, -a[2], a[1], a[2], none, -a[0], -a[1], a[0], none;
  return out;
}

Matrix3<double> matrix_of(const Stretch& q) {
  Matrix3<double> out;
  out << q.xi, q.alpha, 0.0, q.alpha, q.zeta, 0.0, 0.0, 0.0, q.rho;
  return out;
}

/// In the phase in which Re D S^-1 is largest, of length one.
ComplexMatrix normalized(const ComplexMatrix& D, const Stretch& q) {
  const ComplexMatrix strain = D * matrix_of(q).inverse().cast<Complex>();
  const Complex square = strain.cwiseProduct(strain).sum();
  const double length = modulus(square);
  const Complex turn =
      length > 0.0 ? std::conj(square_root(square)) / std::sqrt(length) : Complex(1.0);
  const ComplexMatrix turned = D * turn;
  const double size = std::sqrt(0.5 * (strain.squaredNorm() + length));
  return size > 0.0 ? ComplexMatrix(turned / size) : turned;
}

/// How many before the k-th are equal to it. One that decays, of a quadruple, is not.
std::size_t equal_before(std::span<const Complex> s, std::size_t k) {
  constexpr double near = 1e-12;
  return static_cast<std::size_t>(std::ranges::count_if(s.first(k), [&](const Complex& other) {
    return modulus(other - s[k]) <= near * modulus(s[k]);
  }));
}

/// D of a vector of the leaf, from the slopes of what it is made of.
class RotationShape {
 public:
  RotationShape(const Body& body, const Potential& potential, const Stretch& q,
                const Vector3<double>& nu)
      : q_(q),
        nu_(nu),
        held_(potential.holds_volume()),
        I_(locked_inertia(body, q)),
        B_(gyroscopic_coupling(body, q)),
        N_(steady_momenta_jacobian(body, q, nu).topRows<3>()),
        pi_(I_ * nu) {}

  ComplexMatrix displacement(const std::vector<Complex>& x, const Complex& s) const {
    const std::size_t pairs = x.size() / 2;
    const bool turns = pairs == (held_ ? 4U : 5U);
    const std::size_t alpha = turns ? 1 : 0;
    Eigen::Matrix<Complex, 4, 1> dq(x[alpha], x[alpha + 1], x[alpha + 2], Complex(0.0));
    if (held_) {
      const double per_d = 1.0 / (q_.xi * q_.zeta - q_.alpha * q_.alpha);
      dq[3] = q_.rho * per_d * (2.0 * q_.alpha * dq[0] - q_.zeta * dq[1] - q_.xi * dq[2]);
    } else {
      dq[3] = x[alpha + 3];
    }
    ComplexVector d_pi = ComplexVector::Zero();
    if (turns) {
      const auto frame = leaf_frame(std::array{pi_[0], pi_[1], pi_[2]});
      const double root = std::sqrt(frame.size);
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        d_pi[k] = root * (x[0] * frame.e1[at] + x[pairs] * frame.e2[at]);
      }
    }
    ComplexVector moved = d_pi - N_.cast<Complex>() * dq;
    moved[2] -= s * (B_.cast<Complex>().cwiseProduct(dq.head<3>())).sum();
    const ComplexVector d_nu = I_.inverse().cast<Complex>() * moved;
    ComplexVector chi = d_nu * quotient(-1.0, s);
    if (turns) {
      const Vector3<double> n = nu_.normalized();
      const Complex along = (n.cast<Complex>().cwiseProduct(chi)).sum();
      chi = along * n.cast<Complex>() - hat(pi_.cast<Complex>()) * d_pi / pi_.squaredNorm();
    }
    ComplexMatrix dS;
    dS << dq[1], dq[0], Complex(0.0), dq[0], dq[2], Complex(0.0), Complex(0.0), Complex(0.0), dq[3];
    return hat(chi) * matrix_of(q_).cast<Complex>() + dS;
  }

 private:
  Stretch q_;
  Vector3<double> nu_;
  bool held_;
  Matrix3<double> I_;
  Vector3<double> B_;
  Eigen::Matrix<double, 3, 4> N_;
  Vector3<double> pi_;
};

StraightState<DoubleDouble> state_of(const Body& body, const Potential& potential, const Stretch& q,
                                     double omega) {
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  return potential.visit_parts([&](const auto& model) {
    return straight_state(J, model, DoubleDouble(q.xi), DoubleDouble(q.zeta), DoubleDouble(q.rho),
                          DoubleDouble(omega));
  });
}

/// The pencil of (lambda, mu[, rho]) and, last, the wobble, as a leaf: coordinates (..., s1; their
/// momenta, s2).
Leaf two_polar_leaf(const StraightState<DoubleDouble>& state, const DoubleDouble& theta_dot,
                    bool held) {
  const std::size_t n = held ? 2 : 3;
  Leaf out;
  out.pairs = n + 1;
  for (auto& row : out.second_variation) row.fill(DoubleDouble(0.0));
  auto& E = out.second_variation;
  const std::size_t p = out.pairs;
  if (held) {
    const PlanarPencil<DoubleDouble> pencil = held_two_polar(state, theta_dot);
    const DoubleDouble det = pencil.mass[0] * pencil.mass[2] - pencil.mass[1] * pencil.mass[1];
    E[0][0] = pencil.K[0];
    E[0][1] = E[1][0] = pencil.K[1];
    E[1][1] = pencil.K[2];
    E[p][p] = pencil.mass[2] / det;
    E[p][p + 1] = E[p + 1][p] = -(pencil.mass[1] / det);
    E[p + 1][p + 1] = pencil.mass[0] / det;
  } else {
    const SymmetricPencil<DoubleDouble> pencil = two_polar_pencil(state, theta_dot);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) E[i][j] = E[j][i] = pencil.K[i][j];
      E[p + i][p + i] = DoubleDouble(1.0) / pencil.mass[i];
    }
  }
  const TwoPolarWobble<DoubleDouble> wobble = two_polar_wobble(state, theta_dot);
  E[n][n] = -wobble.a;
  E[p + n][p + n] = -wobble.b;
  for (std::size_t i = 0; i < out.magnitude.size(); ++i)
    for (std::size_t j = 0; j < out.magnitude.size(); ++j)
      out.magnitude[i][j] = std::abs(leading(E[i][j]));
  return out;
}

/// D of a vector of it.
class TwoPolarShape {
 public:
  TwoPolarShape(const Body& body, const Potential& potential, const Stretch& q,
                const TwoPolarRates<double>& rates)
      : q_(q),
        rates_(rates),
        held_(potential.holds_volume()),
        s3_(two_polar_momenta(body.J1, Vector3<double>(q.xi, q.zeta, q.rho), rates.omega,
                              rates.theta_dot)
                .s3) {}

  ComplexMatrix displacement(const std::vector<Complex>& x, const Complex& s) const {
    const auto [alpha, lambda, mu, rho] = q_;
    const std::size_t pairs = x.size() / 2;
    const std::size_t wobble = pairs - 1;
    const Complex d_rho = held_ ? -rho * (x[0] / lambda + x[1] / mu) : x[2];
    // Of s3 and p_theta, their sum and their difference over J: (lambda +- mu)^2 (omega +- theta').
    const Complex fast = -2.0 * (rates_.omega + rates_.theta_dot) * (x[0] + x[1]) / (lambda + mu);
    const Complex slow = -2.0 * (rates_.omega - rates_.theta_dot) * (x[0] - x[1]) / (lambda - mu);
    const Complex d_omega = 0.5 * (fast + slow);
    const Complex d_theta_dot = 0.5 * (fast - slow);
    // -s x delta s/s3^2 of s = (0, 0, s3), which at 0 does not wobble.
    const double per_s3 = s3_ == 0.0 ? 0.0 : 1.0 / s3_;
    const ComplexVector chi(x[pairs + wobble] * per_s3, -x[wobble] * per_s3, quotient(-d_omega, s));
    const ComplexVector around(Complex(0.0), Complex(0.0), quotient(d_theta_dot, s));
    const ComplexMatrix S = matrix_of(q_).cast<Complex>();
    ComplexMatrix out = hat(chi) * S - S * hat(around);
    out(0, 0) += x[0];
    out(1, 1) += x[1];
    out(2, 2) += d_rho;
    return out;
  }

 private:
  Stretch q_;
  TwoPolarRates<double> rates_;
  bool held_;
  double s3_;
};

template <class Shape>
std::vector<ModeShape> shapes(const Leaf& leaf, const Shape& shape, const Stretch& q,
                              std::span<const Complex> s) {
  std::vector<ModeShape> out;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const LeafVector vector = leaf_vector(leaf, s[k], equal_before(s, k));
    out.push_back({s[k], normalized(shape.displacement(vector.x, s[k]), q), vector.residual});
  }
  return out;
}

}  // namespace

std::vector<ModeShape> mode_shapes(const Body& body, const Potential& potential, const Stretch& q,
                                   const Vector3<double>& nu, std::span<const Complex> s) {
  const BasicStretch<DoubleDouble> wide{q.alpha, q.xi, q.zeta, q.rho};
  const Leaf leaf = motion_leaf(body, potential, wide, nu.cast<DoubleDouble>());
  return shapes(leaf, RotationShape(body, potential, q, nu), q, s);
}

std::vector<ModeShape> mode_shapes(const Body& body, const Potential& potential, const Stretch& q,
                                   const TwoPolarRates<double>& rates, std::span<const Complex> s) {
  const Leaf leaf = two_polar_leaf(state_of(body, potential, q, rates.omega),
                                   DoubleDouble(rates.theta_dot), potential.holds_volume());
  return shapes(leaf, TwoPolarShape(body, potential, q, rates), q, s);
}

}  // namespace stationary
