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

/// What the momenta's rates are known to: near the circle their difference moves far by the rounding of lambda - mu, but the
/// balance holds it, J (omega - theta')^2 = -W_d. Equal momenta, taken to be so, have omega = theta'.
template <class Model>
TwoPolarRates<Conditioned> conditioned_rates(const Model& model, const TwoPolarMomenta<double>& m,
                                             const Conditioned& J, const Vector3<Conditioned>& x) {
  auto known = two_polar_halves(
      J, x, TwoPolarMomenta<Conditioned>{Conditioned::input(m.s3), Conditioned::input(m.p_theta)});
  if (m.s3 == m.p_theta) known.difference = 0.0;
  if constexpr (!is_body_model<Model>) {
    const auto at = planar_invariants(x[0], x[1]);
    const Conditioned w_l = [&] {
      const auto own = conditioned_model(model);
      if constexpr (requires { model.plane; }) {
        return forces<1>(own.plane, at).w_l;
      } else {
        return forces<1>(own, at, x[2]).plane.w_l;
      }
    }();
    const Conditioned square = -w_l / (4.0 * J * at.d);
    if (square.value > 0.0) {
      const Conditioned root = sqrt(square);
      if (root.condition < known.difference.condition)
        known.difference = known.difference.value < 0.0 ? -root : root;
    }
  }
  return known.rates();
}

/// x: (lambda, mu, rho), lambda != mu. bound: relative uncertainty of every input.
template <class Model>
Spectrum two_polar_stability(const Body& body, const Model& model,
                             const std::array<DoubleDouble, 3>& x, const TwoPolarState& motion,
                             double bound) {
  const auto input = [](const auto& value) { return Conditioned::input(leading(value)); };
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  const Inertia3<Conditioned> J_c{input(body.J1), input(body.J2), input(body.J3)};
  const auto& [given, m, by_momenta] = motion;
  TwoPolarRates<DoubleDouble> rates{DoubleDouble(given.omega), DoubleDouble(given.theta_dot)};
  TwoPolarRates<Conditioned> rates_c{input(given.omega), input(given.theta_dot)};
  if (by_momenta) {
    rates = two_polar_rates(J.J1, Vector3<DoubleDouble>{x[0], x[1], x[2]},
                            TwoPolarMomenta<DoubleDouble>{m.s3, m.p_theta});
    rates_c = conditioned_rates(model, m, J_c.J1, {input(x[0]), input(x[1]), input(x[2])});
  }
  return two_polar_spectrum(straight_state(J, model, x[0], x[1], x[2], rates.omega),
                            rates.theta_dot,
                            straight_state(J_c, conditioned_model(model), input(x[0]), input(x[1]),
                                           input(x[2]), rates_c.omega),
                            rates_c.theta_dot, m.s3, bound, holds_volume(model));
}

}  // namespace stationary
