// The spectrum of a two-polar motion whose model is known by its type, from stretches in extended
// precision.
#pragma once

#include <array>

#include "lib/balance/two_polar.hpp"
#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/motion/equilibrium.hpp"
#include "solver/newton/reduced_system.hpp"

namespace stationary {

/// The rates at lambda, mu of what was prescribed, in numbers S of any type; input(x): one of its numbers as S. Rates are
/// themselves; momenta give
///   omega +- theta' = (s3 +- p_theta)/(J (lambda +- mu)^2),
/// which near the circle move far by the rounding of lambda - mu. Equal momenta, taken to be so, have omega = theta'.
template <class S, class Input>
TwoPolarRates<S> rates_at(const TwoPolarState& motion, const S& J, const S& lambda, const S& mu,
                          const Input& input) {
  if (!motion.by_momenta) return {input(motion.rates.omega), input(motion.rates.theta_dot)};
  const S s3 = input(motion.momenta.s3);
  const S p_theta = input(motion.momenta.p_theta);
  const S t = lambda + mu;
  const S sum = (s3 + p_theta) / (J * (t * t));
  if (motion.momenta.s3 == motion.momenta.p_theta) return {0.5 * sum, 0.5 * sum};
  const S apart = lambda - mu;
  const S difference = (s3 - p_theta) / (J * (apart * apart));
  return {0.5 * (sum + difference), 0.5 * (sum - difference)};
}

/// x: (lambda, mu, rho), lambda != mu. bound: relative uncertainty of every input.
template <class Model>
Spectrum two_polar_stability(const Body& body, const Model& model,
                             const std::array<DoubleDouble, 3>& x, const TwoPolarState& motion,
                             double bound) {
  const auto input = [](const auto& value) { return Conditioned::input(leading(value)); };
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  const Inertia3<Conditioned> J_c{input(body.J1), input(body.J2), input(body.J3)};
  const TwoPolarRates<DoubleDouble> rates =
      rates_at(motion, J.J1, x[0], x[1], [](double number) { return DoubleDouble(number); });
  const TwoPolarRates<Conditioned> rates_c =
      rates_at(motion, J_c.J1, input(x[0]), input(x[1]), input);
  return two_polar_spectrum(straight_state(J, model, x[0], x[1], x[2], rates.omega),
                            rates.theta_dot,
                            straight_state(J_c, conditioned_model(model), input(x[0]), input(x[1]),
                                           input(x[2]), rates_c.omega),
                            rates_c.theta_dot, motion.momenta.s3, bound, holds_volume(model));
}

}  // namespace stationary
