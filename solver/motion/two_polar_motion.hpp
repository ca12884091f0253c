// What a two-polar stationary motion (J1 = J2) asks for, and its rates and momenta; equations in
// lib/balance/two_polar.hpp.
//
// At fixed rates some potentials have lambda != mu only on a line of solutions:
//   reciprocal-determinant, neo-hookean: only where J (omega^2 + theta'^2) = k (mu), t free;
//   neo-hookean-3d likewise with mu;  biot: only where J (omega - theta')^2 = 2 mu, d free.
// Such a line is isolated at fixed momenta.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "lib/balance/two_polar.hpp"
#include "lib/body/body.hpp"
#include "lib/material/potential.hpp"
#include "solver/motion/equilibrium.hpp"

namespace stationary {

/// The line of solutions at fixed rates, or that there is none off the circle: the reason, and
/// whether the rates lie on it.
struct RatesVerdict {
  std::string condition;
  bool on_line = false;
  std::string line_message() const;  ///< of rates on it
};

/// Nothing for a potential whose ellipses are isolated.
std::optional<RatesVerdict> rates_verdict(double J, const Potential& potential,
                                          const TwoPolarRates<double>& rates);

/// The equilibrium's rates, momenta and nu, from q and circle; on the circle of given momenta, where
/// s3 = p_theta and only the sum of the rates is determined, theta' = 0.
void set_motion(const Body& body, const TwoPolarMotion& motion, Equilibrium& at);

/// The balance residual from the numbers q and rates, relative to the largest term; v at q, to
/// second order.
double two_polar_residual_check(const Body& body, const PotentialDerivatives<double>& v,
                                const Stretch& q, const TwoPolarRates<double>& rates);
/// That, with v of the potential, and compatibility, which two vectors along axis 3 keep.
void check_motion(const Body& body, const Potential& potential, Equilibrium& at);

/// Throws std::invalid_argument unless J1 = J2 and the motion is finite.
void require_two_polar(const Body& body, const TwoPolarMotion& motion);

}  // namespace stationary
