// A two-polar stationary motion (J1 = J2) as a problem and as an answer: lambda, mu, rho with the
// rates (omega, theta') and the momenta (s3, p_theta); equations in lib/balance/two_polar.hpp.
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

using TwoPolarMotion = std::variant<TwoPolarRates<double>, TwoPolarMomenta<double>>;

struct TwoPolarEquilibrium {
  SolveStatus status = SolveStatus::not_run;
  std::string message;
  /// (lambda, mu, rho), NaN unless solved.
  Vector3<double> x = Vector3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  TwoPolarRates<double> rates{std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::quiet_NaN()};
  TwoPolarMomenta<double> momenta{std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN()};
  double residual = std::numeric_limits<double>::quiet_NaN();     ///< as Equilibrium::residual
  double error_bound = std::numeric_limits<double>::quiet_NaN();  ///< as Equilibrium::error_bound
  bool circle = false;
  Counts counts;
};

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

/// The equilibrium's rates and momenta, from x and circle; on the circle of given momenta, where
/// s3 = p_theta and only the sum of the rates is determined, theta' = 0.
void set_motion(const Body& body, const TwoPolarMotion& motion, TwoPolarEquilibrium& at);

/// The balance residual from the numbers x and rates, relative to the largest term; v at x, to
/// second order.
double two_polar_residual_check(const Body& body, const PotentialDerivatives<double>& v,
                                const TwoPolarEquilibrium& at);

/// Throws std::invalid_argument unless J1 = J2 and the motion is finite.
void require_two_polar(const Body& body, const TwoPolarMotion& motion);

}  // namespace stationary
