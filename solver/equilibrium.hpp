// One stationary ellipsoid: S given nu.
//
// Cold start, method automatic:
//   1. a walk along the rest state's sheet (rest_walk) from nu = 0 to nu, so that the answer is the
//      solution connected to rest; Ceres (trust region) solves at nu from where the walk arrived;
//   2. where that sheet does not reach nu, or Ceres stops short, NLopt searches globally for a
//      start, and where it finds none branch and prune (search.hpp) for all solutions; the answer
//      says that its connection to rest is not known (unless search = false).
// From a given start: Ceres, then Newton, then the same global search.
// ceres, newton: that solver alone, from the rest state or the given start, with no walk.
// nlopt: the global search alone.
// All end in the same correction with an extended-precision residual (refine). The residual of
// what is returned is recomputed in lib, and that decides, whatever a solver said.
#pragma once

#include <atomic>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "lib/stretch.hpp"
#include "solver/problem.hpp"

namespace stationary {

enum class Method { automatic, ceres, newton, nlopt };
constexpr std::string_view method_names[] = {"auto", "ceres", "newton", "nlopt"};
constexpr std::string_view name(Method m) { return method_names[static_cast<int>(m)]; }

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

struct Equilibrium {
  SolveStatus status = SolveStatus::not_run;
  std::string message;  ///< for a person: how it was found, or why not
  Stretch q{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
            std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  Vector3<double> nu = Vector3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
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

struct SolveOptions {
  Method method = Method::automatic;
  std::optional<Stretch> start;             ///< default: the rest state
  bool search = true;                       ///< false: rest's sheet alone, no global search
  int threads = 1;                          ///< for Ceres
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: return with status interrupted
};

/// nu: along the branch's axis, any finite value. Throws std::invalid_argument for a nu that is not
/// finite or a start that is not positive definite or, of an isotropic potential, has alpha != 0.
/// Of another potential: anisotropic_equilibrium.hpp.
Equilibrium solve(const Problem& problem, double nu, const SolveOptions& options = {});

}  // namespace stationary
