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

/// The rates of momenta, as sum and difference:
///   omega + theta' = (s3 + p_theta)/(J t^2),   omega - theta' = (s3 - p_theta)/(J (lambda - mu)^2).
/// Equal momenta, taken to be so, have omega = theta'.
template <class S>
struct SumAndSlip {
  S sum;
  S slip;

  TwoPolarRates<S> rates() const { return {0.5 * (sum + slip), 0.5 * (sum - slip)}; }
};
template <class S>
SumAndSlip<S> sum_and_slip(const TwoPolarMomenta<S>& momenta, bool equal, const S& J,
                           const S& lambda, const S& mu) {
  const S t = lambda + mu;
  const S apart = lambda - mu;
  return {(momenta.s3 + momenta.p_theta) / (J * (t * t)),
          equal ? S(0.0) : (momenta.s3 - momenta.p_theta) / (J * (apart * apart))};
}

/// What the momenta's rates are known to: near the circle the difference moves far by the rounding of lambda - mu, but the
/// balance holds it, J (omega - theta')^2 = -W_d.
template <class Model>
TwoPolarRates<Conditioned> conditioned_rates(const Model& model, const TwoPolarMomenta<double>& m,
                                             const Conditioned& J, const Conditioned& lambda,
                                             const Conditioned& mu, const Conditioned& rho) {
  auto known = sum_and_slip<Conditioned>({Conditioned::input(m.s3), Conditioned::input(m.p_theta)},
                                         m.s3 == m.p_theta, J, lambda, mu);
  if constexpr (!is_body_model<Model>) {
    const auto at = planar_invariants(lambda, mu);
    const Conditioned w_l = [&] {
      const auto own = conditioned_model(model);
      if constexpr (requires { model.plane; }) {
        return forces<1>(own.plane, at).w_l;
      } else {
        return forces<1>(own, at, rho).plane.w_l;
      }
    }();
    const Conditioned square = -w_l / (J * at.d);
    if (square.value > 0.0) {
      const Conditioned root = sqrt(square);
      if (root.condition < known.slip.condition) known.slip = known.slip.value < 0.0 ? -root : root;
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
    rates = sum_and_slip<DoubleDouble>({DoubleDouble(m.s3), DoubleDouble(m.p_theta)},
                                       m.s3 == m.p_theta, J.J1, x[0], x[1])
                .rates();
    rates_c = conditioned_rates(model, m, J_c.J1, input(x[0]), input(x[1]), input(x[2]));
  }
  return two_polar_spectrum(straight_state(J, model, x[0], x[1], x[2], rates.omega),
                            rates.theta_dot,
                            straight_state(J_c, conditioned_model(model), input(x[0]), input(x[1]),
                                           input(x[2]), rates_c.omega),
                            rates_c.theta_dot, m.s3, bound, holds_volume(model));
}

}  // namespace stationary
