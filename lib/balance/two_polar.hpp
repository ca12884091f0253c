// The two-polar family, J1 = J2 = J: Phi = R diag(lambda, mu, rho) U^-1 with R and U turning
// steadily about axis 3 at omega and theta' (units: reciprocal time). For x = (lambda, mu, rho)
//
//   V_lambda = J [lambda (omega^2 + theta'^2) + 2 mu omega theta'],
//   V_mu     = J [mu (omega^2 + theta'^2) + 2 lambda omega theta'],     V_rho = 0,
// for lambda != mu the same as W_t = J t (omega^2 + theta'^2), W_d = -J (omega - theta')^2.
// In the momenta s3 = J [(lambda^2 + mu^2) omega + 2 lambda mu theta'] and p_theta (omega and
// theta' exchanged), with the paper's section 2:
//   T = (s3 + p_theta)^2/(4 J (lambda + mu)^2) + (s3 - p_theta)^2/(4 J (lambda - mu)^2) + ...
//
// The paper's section 2 (after eq. (12)) and its reference KovRoz_09. V is isotropic, so its
// derivatives in (lambda, mu, rho) are those in (xi, zeta, rho) at alpha = 0.
#pragma once

#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

/// Momenta of the rates at x = (lambda, mu, rho).
template <class S>
TwoPolarMomenta<S> two_polar_momenta(double J, const Vector3<S>& x, const S& omega,
                                     const S& theta_dot) {
  const S squares = x[0] * x[0] + x[1] * x[1];
  const S product = 2.0 * x[0] * x[1];
  return {J * (squares * omega + product * theta_dot), J * (squares * theta_dot + product * omega)};
}

/// What the rates pull with: own lambda + product mu at lambda.
template <class S>
struct TwoPolarPullRates {
  S own;
  S product;
};

template <class Mass, class S>
TwoPolarPullRates<S> two_polar_pull_rates(const Mass& J, const TwoPolarRates<S>& rates) {
  return {J * (rates.omega * rates.omega + rates.theta_dot * rates.theta_dot),
          2.0 * J * (rates.omega * rates.theta_dot)};
}

/// grad V minus the force of the rates (3 equations). x > 0, any omega, theta'.
template <class Model, class S>
Vector3<S> two_polar_residual(double J, const Model& model, const Vector3<S>& x, const S& omega,
                              const S& theta_dot) {
  const auto v = potential_derivatives<1>(model, BasicStretch<S>{S(0.0), x[0], x[1], x[2]});
  const auto pull = two_polar_pull_rates(J, TwoPolarRates<S>{omega, theta_dot});
  return {v.gradient[1] - pull.own * x[0] - pull.product * x[1],
          v.gradient[2] - pull.own * x[1] - pull.product * x[0], v.gradient[3]};
}

/// Jacobian of two_polar_residual in x at fixed rates, symmetric 3x3.
template <class Model, class S>
Matrix3<S> two_polar_jacobian(double J, const Model& model, const Vector3<S>& x, const S& omega,
                              const S& theta_dot) {
  const auto v = potential_derivatives<2>(model, BasicStretch<S>{S(0.0), x[0], x[1], x[2]});
  Matrix3<S> out = v.hessian.template bottomRightCorner<3, 3>();
  const auto pull = two_polar_pull_rates(J, TwoPolarRates<S>{omega, theta_dot});
  out(0, 0) -= pull.own;
  out(1, 1) -= pull.own;
  out(0, 1) -= pull.product;
  out(1, 0) -= pull.product;
  return out;
}

/// The same balance at fixed momenta: grad V + dT/dx (3 equations). lambda != mu.
template <class Model, class S>
Vector3<S> two_polar_momentum_residual(double J, const Model& model, const Vector3<S>& x,
                                       const TwoPolarMomenta<S>& momenta) {
  const auto v = potential_derivatives<1>(model, BasicStretch<S>{S(0.0), x[0], x[1], x[2]});
  const S sum = x[0] + x[1];
  const S difference = x[0] - x[1];
  const S plus = momenta.s3 + momenta.p_theta;
  const S minus = momenta.s3 - momenta.p_theta;
  const S pull_sum = plus * plus / (2.0 * J * (sum * sum * sum));
  const S pull_difference = minus * minus / (2.0 * J * (difference * difference * difference));
  return {v.gradient[1] - pull_sum - pull_difference, v.gradient[2] - pull_sum + pull_difference,
          v.gradient[3]};
}

/// Rates by halves of their sum and difference.
template <class S>
struct TwoPolarHalves {
  S sum;
  S difference;

  TwoPolarRates<S> rates() const { return {sum + difference, sum - difference}; }
};

/// Of given momenta at lambda != mu.
template <class Mass, class S>
TwoPolarHalves<S> two_polar_halves(const Mass& J, const Vector3<S>& x,
                                   const TwoPolarMomenta<S>& m) {
  const S sum = x[0] + x[1];
  const S difference = x[0] - x[1];
  return {(m.s3 + m.p_theta) / (2.0 * J * (sum * sum)),
          (m.s3 - m.p_theta) / (2.0 * J * (difference * difference))};
}

/// Rates of given momenta at lambda != mu: omega = dT/ds3, theta' = dT/dp_theta.
template <class Mass, class S>
TwoPolarRates<S> two_polar_rates(const Mass& J, const Vector3<S>& x, const TwoPolarMomenta<S>& m) {
  return two_polar_halves(J, x, m).rates();
}

/// The kinetic energy T above, in the rates, which the circle lambda = mu has too:
///   T = J [(lambda + mu)^2 (omega + theta')^2 + (lambda - mu)^2 (omega - theta')^2]/4.
template <class S>
S two_polar_kinetic_energy(double J, const Vector3<S>& x, const TwoPolarRates<S>& rates) {
  const S sum = (x[0] + x[1]) * (rates.omega + rates.theta_dot);
  const S difference = (x[0] - x[1]) * (rates.omega - rates.theta_dot);
  return 0.25 * J * (sum * sum + difference * difference);
}

/// The force of the motion in logarithmic coordinates, lambda f_lambda and mu f_mu, and its
/// derivatives in (ln lambda, ln mu): what two_polar balance subtracts from the elastic part.
template <class S>
struct TwoPolarPull {
  S lambda;
  S mu;
  S ll;
  S lm;
  S mm;
};

/// At fixed rates.
template <class Mass, class S>
TwoPolarPull<S> two_polar_pull(const Mass& J, const S& lambda, const S& mu,
                               const TwoPolarRates<S>& rates) {
  const TwoPolarPullRates<S> pull = two_polar_pull_rates(J, rates);
  const S mixed = pull.product * (lambda * mu);
  const S own_lambda = pull.own * (lambda * lambda);
  const S own_mu = pull.own * (mu * mu);
  return {own_lambda + mixed, own_mu + mixed, 2.0 * own_lambda + mixed, mixed,
          2.0 * own_mu + mixed};
}

/// s3 = p_theta exactly, as on the circle lambda = mu: the momenta's pull is then smooth there.
template <class S>
struct TwoPolarEqualMomenta {
  S s3;
};

/// The part of a pull at fixed momenta from plus = s3 + p_theta:
/// -d/dx of plus^2/(4 J (lambda + mu)^2), in the shares of lambda and mu in their sum.
template <class Mass, class S>
TwoPolarPull<S> two_polar_sum_pull(const Mass& J, const S& lambda, const S& mu, const S& plus) {
  const S sum = lambda + mu;
  const S pull = plus * plus / (2.0 * J * (sum * sum));
  const S l = lambda / sum;
  const S m = mu / sum;
  return {pull * l, pull * m, pull * l * (1.0 - 3.0 * l), -3.0 * (pull * l * m),
          pull * m * (1.0 - 3.0 * m)};
}

/// At equal momenta, any lambda and mu.
template <class Mass, class S>
TwoPolarPull<S> two_polar_pull(const Mass& J, const S& lambda, const S& mu,
                               const TwoPolarEqualMomenta<S>& momenta) {
  return two_polar_sum_pull(J, lambda, mu, S(2.0 * momenta.s3));
}

/// At fixed momenta, lambda != mu.
template <class Mass, class S>
TwoPolarPull<S> two_polar_pull(const Mass& J, const S& lambda, const S& mu,
                               const TwoPolarMomenta<S>& momenta) {
  TwoPolarPull<S> out = two_polar_sum_pull(J, lambda, mu, S(momenta.s3 + momenta.p_theta));
  const S minus = momenta.s3 - momenta.p_theta;
  const S difference = lambda - mu;
  const S pull = minus * minus / (2.0 * J * (difference * difference));
  const S l = lambda / difference;
  const S m = mu / difference;
  out.lambda += pull * l;
  out.mu -= pull * m;
  out.ll += pull * l * (1.0 - 3.0 * l);
  out.lm += 3.0 * (pull * l * m);
  out.mm -= pull * m * (1.0 + 3.0 * m);
  return out;
}

}  // namespace stationary
