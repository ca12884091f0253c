// The spectrum of a two-polar motion whose model is known by its type, from stretches in extended
// precision.
#pragma once

#include <array>

#include "lib/balance/two_polar.hpp"
#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/newton/reduced_system.hpp"

namespace stationary {

/// x: (lambda, mu, rho), lambda != mu. bound: relative uncertainty of every input.
template <class Model>
Spectrum two_polar_stability(const Body& body, const Model& model,
                             const std::array<DoubleDouble, 3>& x,
                             const TwoPolarRates<double>& rates, double s3, double bound) {
  const auto input = [](const auto& value) { return Conditioned::input(leading(value)); };
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  const Inertia3<Conditioned> J_c{input(body.J1), input(body.J2), input(body.J3)};
  return two_polar_spectrum(straight_state(J, model, x[0], x[1], x[2], DoubleDouble(rates.omega)),
                            DoubleDouble(rates.theta_dot),
                            straight_state(J_c, conditioned_model(model), input(x[0]), input(x[1]),
                                           input(x[2]), input(rates.omega)),
                            input(rates.theta_dot), s3, bound, holds_volume(model));
}

}  // namespace stationary
