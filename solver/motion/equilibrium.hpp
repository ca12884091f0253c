// One stationary ellipsoid, as an answer: whether there is one, S and nu, how far they can be
// trusted, how they were found and what that took.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "lib/body/motion.hpp"
#include "lib/body/stretch.hpp"

namespace stationary {

enum class SolveStatus {
  not_run,
  solved,
  none_exists,   ///< shown not to exist; message says why
  not_found,     ///< searched for without success: no statement about existence
  not_isolated,  ///< a continuum of solutions here: none is returned
  failed,        ///< a numerical failure; message says where
  interrupted
};

enum class Connection {
  rest,         ///< on the curve of equilibria through the rest state
  given_start,  ///< found from solve.start, not examined further
  unknown
};
constexpr std::string_view name(Connection c) {
  return c == Connection::rest ? "rest" : c == Connection::given_start ? "given start" : "unknown";
}

/// How often each thing was evaluated.
struct Counts {
  long residuals = 0;           ///< double residuals (Ceres and NLopt included)
  long jacobians = 0;           ///< with the Jacobian
  long extended_residuals = 0;  ///< in extended precision
  long newton_steps = 0;
  long ceres_iterations = 0;
  long nlopt_evaluations = 0;
  long walk_steps = 0;

  Counts& operator+=(const Counts& other) {
    residuals += other.residuals;
    jacobians += other.jacobians;
    extended_residuals += other.extended_residuals;
    newton_steps += other.newton_steps;
    ceres_iterations += other.ceres_iterations;
    nlopt_evaluations += other.nlopt_evaluations;
    walk_steps += other.walk_steps;
    return *this;
  }
};

/// The motion of a two-polar ellipsoid.
struct TwoPolarState {
  TwoPolarRates<double> rates;
  TwoPolarMomenta<double> momenta;
  bool by_momenta =
      false;  ///< those are what was prescribed, or what a family holds or varies; else the rates
};

/// What a spectrum takes the logarithms of the stretches to be known to: their error bound, where one was
/// computed (else NaN), and never better than they are rounded.
inline double stretch_uncertainty(double error_bound) {
  return std::isnan(error_bound) ? 1e-15 : std::max(error_bound, 0x1p-53);
}

struct Equilibrium {
  SolveStatus status = SolveStatus::not_run;
  std::string message;  ///< for a person: how it was found, or why not
  Stretch q{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
            std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  /// q as it was before it was rounded, to 2^-86 of each stretch, where the solve knows that: whose
  /// heads are no longer q's is of no use.
  std::optional<BasicStretch<DoubleDouble>> unrounded;
  Vector3<double> nu = Vector3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Two-polar: S is diag(lambda, mu, rho) then, and nu what it is at theta = 0.
  std::optional<TwoPolarState> two_polar;
  bool circle = false;                                              ///< two-polar: lambda = mu
  double residual = std::numeric_limits<double>::quiet_NaN();       ///< BalanceCheck::residual
  double compatibility = std::numeric_limits<double>::quiet_NaN();  ///< BalanceCheck::compatibility
  /// Estimated bound of the relative error of each of xi, zeta, rho (of alpha relative to sqrt(xi
  /// zeta), of an oblique axis' angle), in the max norm, against the exact solution for the decimal
  /// numbers of the case (each taken to be within half a unit of its double).
  double error_bound = std::numeric_limits<double>::quiet_NaN();
  Connection connection = Connection::unknown;
  Counts counts;
};

/// Residuals above this (relative to the largest term) are no equilibrium, whatever converged.
constexpr double acceptable_residual = 1e-12;

}  // namespace stationary
