#include "solver/solve/solve.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "lib/number/elementary.hpp"
#include "solver/motion/body_circle.hpp"
#include "solver/motion/vertical_branch.hpp"
#include "solver/newton/thickness_balance.hpp"
#include "solver/search/search.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/nonexistence.hpp"
#include "solver/solve/reduced_solve.hpp"

namespace stationary {
namespace {

void adopt(const auto& answer, Equilibrium& out) {
  out.status = answer.status;
  out.message = answer.message;
  out.connection = answer.connection;
  out.error_bound = answer.error_bound;
}

/// tail: what rounding left of q (refine.hpp).
void keep_unrounded(const ReducedVector<3>& tail, Equilibrium& out) {
  if (!tail.allFinite()) return;
  const Stretch& q = out.q;
  out.unrounded = {DoubleDouble(q.alpha), DoubleDouble(q.xi, tail[0]),
                   DoubleDouble(q.zeta, tail[1]), DoubleDouble(q.rho, tail[2])};
}

/// A walk needs a state of rest to begin at, which an expression may not have.
template <class Model>
bool no_rest_state(const Model&, double rest_stretch, Equilibrium& out) {
  if (std::isfinite(rest_stretch)) return false;
  out.status = SolveStatus::not_found;
  out.message = is_body_model<Model>
                    ? "no state of rest was found: no minimum of V among stretches in [1e-3, 1e3]"
                    : "no state of rest was found: V has no minimum among the circles xi = zeta in "
                      "[1e-3, 1e3]";
  return true;
}

template <class Plane, class Thickness>
void solve_model(const Separable<Plane, Thickness>& model, const Problem& problem, double nu,
                 const SolveOptions& options, Equilibrium& out) {
  const CentrifugalRates<DoubleDouble> rates = problem.rates(two_product(nu, nu));
  const auto near = options.start ? std::optional(options.start->rho) : std::nullopt;
  const ThicknessBalance thickness = balanced_thickness(model.thickness, rates.rho, near);
  out.counts.extended_residuals += thickness.refined.steps;
  if (!thickness.refined.converged) {
    // Of a built-in model it is known to exist.
    out.status = problem.potential().is_built_in() ? SolveStatus::failed : SolveStatus::not_found;
    out.message = std::string("the thickness balance V_rho'(rho) = J3 nu^2 rho ") + unbalanced;
    return;
  }
  const double r = model.plane.rest_stretch();
  if (!options.start && no_rest_state(model, r, out)) return;
  const Plane part = on_part_of(model.plane, options.start.value_or(Stretch{0.0, r, r, 1.0}));
  const PlanarSystem<Plane> system{part, rates};
  std::optional<ReducedVector<2>> start;
  if (options.start) start = ReducedVector<2>(options.start->xi, options.start->zeta);
  const auto answer =
      ReducedSolve<PlanarSystem<Plane>>(system, ReducedVector<2>(r, r), nu, options, out.counts)
          .run(start);
  adopt(answer, out);
  if (answer.status != SolveStatus::solved) return;
  out.q = {0.0, answer.x[0], answer.x[1], thickness.rho};
  keep_unrounded({answer.tail[0], answer.tail[1], thickness.tail}, out);
  out.error_bound = std::max(out.error_bound, thickness.refined.error_bound);
}

template <class Coupled>
void solve_model(const Coupled& model, const Problem& problem, double nu,
                 const SolveOptions& options, Equilibrium& out) {
  const Stretch at_rest = rest_stretch_of(model);
  const ReducedVector<3> rest(at_rest.xi, at_rest.zeta, at_rest.rho);
  if (!options.start && no_rest_state(model, rest[0], out)) return;
  const Coupled part = on_part_of(model, options.start.value_or(at_rest));
  const CoupledSystem<Coupled> system{part, problem.rates(two_product(nu, nu))};
  std::optional<ReducedVector<3>> start;
  if (options.start) {
    start = ReducedVector<3>(options.start->xi, options.start->zeta, options.start->rho);
  }
  const Circle circle = options.start ? Circle::none : circle_of(problem);
  const auto answer =
      ReducedSolve<CoupledSystem<Coupled>>(system, rest, nu, options, out.counts, circle)
          .run(start);
  adopt(answer, out);
  if (answer.status != SolveStatus::solved) return;
  out.q = {0.0, answer.x[0], answer.x[1], answer.x[2]};
  keep_unrounded(answer.tail, out);
}

/// Of all solutions in the search's box the one nearest to the rest state, and whether the search
/// decided everything. out.message: what was tried before.
SearchStatus search_all(const Problem& problem, double nu, const SolveOptions& options,
                        Equilibrium& out) {
  SearchOptions how;
  how.stop = options.stop;
  const SearchResult all = search(problem, nu, how);
  out.message += "Exhaustive search: " + all.message + ".";
  if (all.status == SearchStatus::interrupted) {  // the nearest may be among those not come to
    out.status = SolveStatus::interrupted;
    return all.status;
  }
  if (all.solutions.empty()) {
    if (all.status == SearchStatus::complete)
      out.message += " None was found beyond that box, which is no proof that none exists.";
    return all.status;
  }
  bool with_rho = problem.unknowns() == 3;
  const Stretch rest = problem.potential().visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      const double r = model.plane.rest_stretch();
      if constexpr (several_thicknesses<std::decay_t<decltype(model)>>) {
        if (model.thickness.is_expression()) {
          with_rho = true;
          return Stretch{0.0, r, r, model.thickness.balanced(0.0)};
        }
      }
      return Stretch{0.0, r, r, 1.0};  // rho is the same for all
    } else {
      return rest_stretch_of(model);
    }
  });
  const auto apart = [](double x, double at_rest) {
    return std::abs(log(std::isfinite(at_rest) ? x / at_rest : x));
  };
  const auto distance = [&](const Equilibrium& at) {
    return std::max({apart(at.q.xi, rest.xi), apart(at.q.zeta, rest.zeta),
                     with_rho ? apart(at.q.rho, rest.rho) : 0.0});
  };
  const Equilibrium& nearest = *std::ranges::min_element(all.solutions, {}, distance);
  out.status = SolveStatus::solved;
  out.q = nearest.q;
  out.error_bound = nearest.error_bound;
  out.message +=
      " This is the one nearest to the rest state; whether it is connected to the rest state is "
      "not "
      "known.";
  return all.status;
}

/// Beside the sheet of the rest state, or far from a start that led nowhere: the exhaustive search,
/// and NLopt's where that leaves boxes undecided.
void solve_elsewhere(const Problem& problem, double nu, const SolveOptions& options,
                     Equilibrium& out) {
  if (!out.message.empty() && !out.message.ends_with(' ')) out.message += ". ";
  if (!options.search) {
    out.message += "Other sheets were not looked for.";
    return;
  }
  const SearchStatus status = search_all(problem, nu, options, out);
  if (out.status != SolveStatus::not_found || status == SearchStatus::complete) return;
  SolveOptions by_nlopt = options;
  by_nlopt.method = Method::nlopt;
  by_nlopt.start.reset();
  const std::string before = out.message;
  problem.potential().visit_parts(
      [&](const auto& model) { solve_model(model, problem, nu, by_nlopt, out); });
  out.message = before + " " + out.message;
}

}  // namespace

Equilibrium solve(const Problem& problem, double nu, const SolveOptions& options) {
  if (!std::isfinite(nu)) throw std::invalid_argument("nu finite");
  const bool isotropic = problem.potential().is_isotropic();
  if (options.start) {
    require_positive_definite(*options.start);
    if (isotropic && options.start->alpha != 0.0)
      throw std::invalid_argument("alpha = 0 in the start: the potential is isotropic");
  }
  Equilibrium out;
  out.nu = angular_velocity(problem.branch(), nu);
  if (const auto reason = nonexistence_reason(problem, nu)) {
    out.status = SolveStatus::none_exists;
    out.message = *reason;
    return out;
  }
  if (!isotropic) return solve_anisotropic(problem, nu, options);
  if (const auto condition = vertical_condition(problem, nu)) {
    out.status = SolveStatus::not_isolated;
    out.message = "at this nu, " + *condition +
                  " with theta_dot = 0, the ellipses of this potential form a vertical branch, one "
                  "for every eccentricity: `continue` follows it from a start on it";
    return out;
  }
  problem.potential().visit_parts(
      [&](const auto& model) { solve_model(model, problem, nu, options, out); });
  if (out.status == SolveStatus::not_found && options.method == Method::automatic)
    solve_elsewhere(problem, nu, options, out);
  if (out.status != SolveStatus::solved) return out;

  // The returned numbers decide, not the solver.
  const BalanceCheck check = check_balance(problem.body(), problem.potential(), out.q, out.nu);
  out.residual = check.residual;
  out.compatibility = check.compatibility;
  if (!(out.residual <= acceptable_residual)) {
    out.status = SolveStatus::failed;
    std::ostringstream text;
    text << "; but the recomputed balance residual " << out.residual << " is no equilibrium's";
    out.message += text.str();
  }
  return out;
}

}  // namespace stationary
