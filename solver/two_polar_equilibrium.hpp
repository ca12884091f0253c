// Two-polar stationary motions (J1 = J2): lambda, mu, rho given the rates (omega, theta') or the
// momenta (s3, p_theta); equations in lib/two_polar.hpp.
//
// An answer has lambda > mu. At fixed rates some potentials have lambda != mu only on a line of
// solutions, which is said instead of returning one of them:
//   reciprocal-determinant, neo-hookean: only where J (omega^2 + theta'^2) = k (mu), t free;
//   neo-hookean-3d likewise with mu;  biot: only where J (omega - theta')^2 = 2 mu, d free.
// Such a line is isolated at fixed momenta. Where no lambda > mu is found at given rates, the
// circle lambda = mu, which depends on omega + theta' only, is returned and named.
#pragma once

#include <variant>

#include "lib/spectrum.hpp"
#include "lib/two_polar.hpp"
#include "solver/equilibrium.hpp"

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

/// Throws std::invalid_argument unless J1 = J2 and the motion is finite. options.method is not
/// used: the search is global (NLopt), then Newton, then refine; options.start replaces the search.
TwoPolarEquilibrium solve_two_polar(const Body& body, const Potential& potential,
                                    const TwoPolarMotion& motion, const SolveOptions& options = {});

/// Its spectrum on the leaf |s|, p_theta fixed (lambda != mu), or that of (iii) with nu3 = omega +
/// theta' on the circle.
Spectrum stability(const Body& body, const Potential& potential,
                   const TwoPolarEquilibrium& equilibrium);

}  // namespace stationary
