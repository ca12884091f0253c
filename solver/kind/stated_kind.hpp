// One motion, all motions and their certificates from the equations of a kind alone
// (stated_family.hpp).
#pragma once

#include <cmath>
#include <optional>

#include "solver/family/stated_family.hpp"
#include "solver/newton/newton.hpp"
#include "solver/proof/certificate.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/search_message.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// A member as an answer. residual: of the balance, rows relative to their own slopes.
template <class Equations>
Equilibrium stated_equilibrium(const Equations& equations,
                               const ReducedVector<Equations::dimension>& x, double p,
                               double error_bound) {
  const Member member = equations.member(x, p);
  Equilibrium out;
  out.q = member.q;
  out.nu = member.angular_velocity;
  out.residual =
      StatedSystem<Equations>{equations, p}.extended_residual(x).template lpNorm<Eigen::Infinity>();
  out.compatibility = 0.0;
  out.error_bound = error_bound;
  out.status = out.residual <= acceptable_residual ? SolveStatus::solved : SolveStatus::failed;
  return out;
}

/// Newton's method from a start.
template <class Equations>
Equilibrium solve_stated(const Equations& equations, double p, const Stretch& start) {
  const StatedSystem<Equations> system{equations, p};
  ReducedVector<Equations::dimension> x = equations.unknowns(start);
  Refined refined;
  if (newton(system, x).converged) refined = refine(system, x);
  if (refined.converged) {
    Equilibrium out = stated_equilibrium(equations, x, p, refined.error_bound);
    out.connection = Connection::given_start;
    return out;
  }
  Equilibrium out;
  out.status = SolveStatus::not_found;
  out.message = "Newton from the given start did not converge";
  return out;
}

/// All motions with every unknown in [min_stretch, max_stretch].
template <class Equations>
SearchResult search_stated(const Equations& equations, double p,
                           const SearchOptions& options = {}) {
  require_box(options);
  constexpr int N = Equations::dimension;
  const StatedSystem<Equations> system{equations, p};
  const StatedBoxes<Equations> boxes{equations, p, options.inputs};
  Box<N> everything;
  everything.fill({options.min_stretch, options.max_stretch});
  const PruneOptions prune{
      .min_width = options.min_width, .max_boxes = options.max_boxes, .stop = options.stop};
  const auto found = branch_and_prune<N>(
      SearchedPair<StatedSystem<Equations>, StatedBoxes<Equations>>(system, boxes), Mirror::none,
      prune, everything);
  SearchResult out;
  out.boxes = found.boxes;
  for (const auto& each : found.solutions) {
    out.solutions.push_back(stated_equilibrium(equations, each.x, p, each.proof.error_bound));
    out.solutions.back().message = found_by_search(true);
  }
  out.status = found.interrupted         ? SearchStatus::interrupted
               : found.undecided.empty() ? SearchStatus::complete
                                         : SearchStatus::undecided;
  return out;
}

/// That near the equilibrium's stretches there is exactly one motion at p; error_bound proven.
template <class Equations>
Certificate certify_stated(const Equations& equations, double p, const Equilibrium& equilibrium,
                           Inputs inputs = Inputs::decimals) {
  Certificate out;
  const ReducedVector<Equations::dimension> x = equations.unknowns(equilibrium.q);
  const StatedBoxes<Equations> boxes{equations, p, inputs};
  const Krawczyk test(boxes, x);
  const auto proof = prove_solution(test, x, "stretches", out);
  if (!proof.proven) return out;
  if (!test.unique_within(proof.error_bound)) {
    out.reason = "a second solution (a fold, a bifurcation) may lie within the error bound";
    return out;
  }
  out.proven = true;
  out.error_bound = proof.error_bound;
  return out;
}

}  // namespace stationary
