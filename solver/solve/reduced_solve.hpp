// The strategies of solve.hpp on one reduced system: walk from rest, Ceres, Newton, NLopt, and the
// refinement they all end in. Knows nothing of potentials or files.
#pragma once

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include "lib/matrix/elementwise.hpp"
#include "solver/continuation/rest_walk.hpp"
#include "solver/newton/ceres_solve.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/nlopt_seed.hpp"
#include "solver/solve/counted_steps.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

template <int N>
struct ReducedAnswer {
  SolveStatus status = SolveStatus::not_run;
  ReducedVector<N> x = ReducedVector<N>::Constant(std::numeric_limits<double>::quiet_NaN());
  ReducedVector<N> tail = ReducedVector<N>::Constant(std::numeric_limits<double>::quiet_NaN());
  double error_bound = std::numeric_limits<double>::quiet_NaN();
  Connection connection = Connection::unknown;
  std::string message;
};

template <class System>
class ReducedSolve {
 public:
  static constexpr int N = System::dimension;

  /// rest: the rest state's stretches, to double precision. nu only labels messages. circle: that
  /// the figures may be.
  ReducedSolve(const System& system, const ReducedVector<N>& rest, double nu,
               const SolveOptions& options, Counts& counts, Circle circle = Circle::none)
      : system_(system), rest_(rest), nu_(nu), options_(options), counts_(counts) {
    walk_.circle = circle;
    // Of a body whose stretches are far from 1.
    walk_.min_stretch *= std::min(1.0, rest.minCoeff());
    walk_.max_stretch *= std::max(1.0, rest.maxCoeff());
  }

  ReducedAnswer<N> run(const std::optional<ReducedVector<N>>& start) {
    switch (options_.method) {
      case Method::newton:
        return by_newton(start.value_or(rest_), start.has_value());
      case Method::ceres:
        return by_ceres(start.value_or(rest_), start.has_value());
      case Method::nlopt:
        return by_nlopt();
      case Method::automatic:
        break;
    }
    return start ? from_start(*start) : from_rest();
  }

 private:
  /// The correction every answer ends in, and one more from there: so answer and error bound depend on the solution alone,
  /// not on the way to it, and a page, which has no Ceres, tells the same bits.
  bool finish(ReducedVector<N> x, ReducedAnswer<N>& out) {
    for (int time = 0; time < 2; ++time) {
      ReducedVector<N> tail;
      const Refined refined = refine(system_, x, most_corrections, &tail);
      counts_.newton_steps += refined.steps;
      counts_.extended_residuals += refined.steps;
      counts_.jacobians += refined.steps;
      if (!refined.converged) break;
      out.status = SolveStatus::solved;
      out.x = x;
      out.tail = tail;
      out.error_bound = refined.error_bound;
    }
    return out.status == SolveStatus::solved;
  }

  bool polish(ReducedVector<N>& x) {
    const NewtonResult result = newton(system_, x);
    counts_.newton_steps += result.steps;
    counts_.residuals += result.steps;
    counts_.jacobians += result.steps;
    return result.converged;
  }

  static std::string method_name() {
    return version_of_ceres().empty() ? "Levenberg-Marquardt" : "Ceres";
  }

  CeresOutcome run_ceres(ReducedVector<N>& x) {
    CeresOutcome outcome = ceres_solve(system_, x, options_.threads);
    counts_.ceres_iterations += outcome.iterations;
    counts_.residuals += outcome.residuals;
    counts_.jacobians += outcome.jacobians;
    return outcome;
  }

  ReducedAnswer<N> by_newton(ReducedVector<N> x, bool given) {
    ReducedAnswer<N> out;
    const std::string from = given ? "the given start" : "the rest state";
    if (polish(x) && finish(x, out)) {
      out.connection = given ? Connection::given_start : Connection::unknown;
      out.message = "Newton from " + from;
      return out;
    }
    out.status = SolveStatus::failed;
    out.message = "Newton from " + from + " did not converge; solve.method = \"auto\" walks there";
    return out;
  }

  ReducedAnswer<N> by_ceres(ReducedVector<N> x, bool given) {
    ReducedAnswer<N> out;
    const std::string from = given ? "the given start" : "the rest state";
    const CeresOutcome outcome = run_ceres(x);
    if (outcome.usable && finish(x, out)) {
      out.connection = given ? Connection::given_start : Connection::unknown;
      out.message = method_name() + " from " + from;
      return out;
    }
    out.status = SolveStatus::failed;
    out.message =
        method_name() + " from " + from + " stopped after " + std::to_string(outcome.iterations) +
        " iterations where the balance does not hold; solve.method = \"auto\" walks there";
    return out;
  }

  ReducedAnswer<N> from_start(const ReducedVector<N>& start) {
    ReducedAnswer<N> out = by_ceres(start, true);
    if (out.status == SolveStatus::solved) return out;
    // Ceres' trust region may stall where stretches or stiffnesses are many orders apart.
    out = by_newton(start, true);
    if (out.status == SolveStatus::solved) return out;
    return elsewhere("No solution was reached from the given start. ");
  }

  ReducedAnswer<N> from_rest() {
    ReducedAnswer<N> out;
    RestWalk<System> walk(system_, rest_, walk_);
    const WalkResult<N> walked = walk.run(options_.stop);
    counts_.walk_steps += walked.steps;
    counts_.jacobians += walked.linearizations;
    if (walked.end == WalkEnd::interrupted) {
      out.status = SolveStatus::interrupted;
      return out;
    }
    if (walked.end != WalkEnd::reached) return elsewhere(story(walked));
    ReducedVector<N> x = walked.x;
    const CeresOutcome outcome = run_ceres(x);
    // Ceres may not leave the walk's end for another solution.
    const double moved_by = logarithms(x.array() / walked.x.array()).abs().maxCoeff();
    if (outcome.usable && moved_by < 1e-3 && finish(x, out)) {
      out.connection = Connection::rest;
      out.message = way(walked) + ", then " + method_name();
      return out;
    }
    if (finish(walked.x, out)) {
      out.connection = Connection::rest;
      out.message = way(walked) + " (" + method_name() + " stopped short of it)";
      return out;
    }
    std::ostringstream text;
    text << "The rest state's sheet reaches nu = " << nu_
         << ", but the balance is singular there (a fold, or a solution that is not isolated). ";
    return elsewhere(text.str());
  }

  /// Not here: what there is elsewhere is not this solve's to find. `before` says what was tried.
  static ReducedAnswer<N> elsewhere(const std::string& before) {
    ReducedAnswer<N> out;
    out.status = SolveStatus::not_found;
    out.message = before;
    return out;
  }

  static std::string way(const WalkResult<N>& walked) {
    return "walk from the rest state in " + counted_steps(walked.steps);
  }

  std::string story(const WalkResult<N>& walked) const {
    std::ostringstream text;
    text.precision(6);
    if (!(walked.largest_tau > 0.0)) {
      text << "The walk from the rest state makes no step towards |nu| = " << std::abs(nu_) << ". ";
      return text.str();
    }
    const double nu_reached = std::abs(nu_) * std::sqrt(walked.largest_tau);
    text << "The sheet of the rest state does not reach |nu| = " << std::abs(nu_)
         << ": it goes up to " << nu_reached;
    switch (walked.end) {
      case WalkEnd::escaped:
        text << " and on to unbounded or vanishing stretches (xi = " << walked.x[0]
             << ", zeta = " << walked.x[1] << "). ";
        break;
      case WalkEnd::turned_back:
        text << " and back to nu = 0. ";
        break;
      case WalkEnd::at_border:
        text << ", to the border of the potential's domain (" << walked.border->text << "). ";
        break;
      default:
        text << ", where the walk was given up. ";
        break;
    }
    return text.str();
  }

  /// Newton from the best points of a global search by NLopt.
  ReducedAnswer<N> by_nlopt() {
    ReducedAnswer<N> out;
    SeedOptions options;
    options.stop = options_.stop;
    if constexpr (N == 3) options.evaluations *= 4;
    const Seeds<N> seeds = nlopt_seeds<N>(
        [&](const ReducedVector<N>& x) {
          const Linearized<N> at = system_.linearize(x);
          return (at.g / at.magnitude).squaredNorm();
        },
        options);
    counts_.nlopt_evaluations += seeds.evaluations;
    counts_.residuals += seeds.evaluations;
    if (seeds.interrupted) {
      out.status = SolveStatus::interrupted;
      return out;
    }
    // Of what the seeds lead to, the solution nearest the rest state: a definite choice.
    double nearest = std::numeric_limits<double>::infinity();
    for (ReducedVector<N> x : seeds.points) {
      ReducedAnswer<N> candidate;
      if (!polish(x) || !finish(x, candidate)) continue;
      if (x.minCoeff() < 0.1 * options.min_stretch || x.maxCoeff() > 10.0 * options.max_stretch)
        continue;
      const double distance = logarithms(x.array() / rest_.array()).abs().maxCoeff();
      if (distance < nearest) {
        nearest = distance;
        out = candidate;
      }
    }
    if (out.status == SolveStatus::solved) {
      out.message =
          std::string("Global search (") + (version_of_nlopt().empty() ? "a grid" : "NLopt") +
          ") and Newton found this solution; whether it is connected to the rest state is not "
          "known.";
      return out;
    }
    out.status = SolveStatus::not_found;
    std::ostringstream text;
    text << "Global search in stretches [" << options.min_stretch << ", " << options.max_stretch
         << "] (" << seeds.evaluations
         << " evaluations) found none: not found, which is no proof that none exists.";
    out.message = text.str();
    return out;
  }

  const System& system_;
  ReducedVector<N> rest_;
  double nu_;
  const SolveOptions& options_;
  Counts& counts_;
  WalkOptions walk_;
};

}  // namespace stationary
