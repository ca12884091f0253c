// What the exhaustive search of every kind of motion does (search.hpp): its systems pruned one
// after another, the solutions of the plane put together with those of a thickness that is a
// problem of its own, and what the whole says of itself. The kind states its systems, and which
// motion a solution of them is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include "lib/balance/balance.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/search_message.hpp"

namespace stationary {

/// rho of a solution: its own where the thickness is a problem of its own, else that of the whole.
struct FoundThickness {
  double rho;
  Interval solution;
  double error_bound;
  bool proven;
};

class SearchRun {
 public:
  /// The options must outlive it. Throws std::invalid_argument for a box that is none.
  SearchRun(const Potential& potential, const SearchOptions& options)
      : options_(options), assumes_(!potential.assumptions().empty()) {
    require_box(options);
  }

  bool interrupted() const { return out_.status == SearchStatus::interrupted; }

  /// All solutions in a box. factor: of the boxes allowed.
  template <class System, class BoxSystem>
  PruneResult<BoxSystem::dimension> prune(const System& system, const BoxSystem& boxes,
                                          Mirror mirror,
                                          const Box<BoxSystem::dimension>& everything,
                                          long factor = 1) {
    return taken(branch_and_prune<BoxSystem::dimension>(
        SearchedPair<System, BoxSystem>(system, boxes), mirror, prune_options(factor), everything));
  }
  /// With the unknowns in the ranges asked for; first: the stretch that is the first of them.
  template <class System, class BoxSystem>
  PruneResult<BoxSystem::dimension> prune(const System& system, const BoxSystem& boxes,
                                          Mirror mirror, std::size_t first = 0) {
    Box<BoxSystem::dimension> everything;
    for (std::size_t k = 0; k < everything.size(); ++k) everything[k] = options_.range(first + k);
    return prune(system, boxes, mirror, everything);
  }
  /// All solutions of a search in parts (round_search.hpp).
  template <class Parts>
  auto prune(const Parts& parts) {
    return taken(*parts.finished(prune_options(1), nullptr));
  }
  /// No thickness, no ellipsoid: whatever the plane does.
  bool ends_with(const PruneResult<1>& thickness) const {
    return interrupted() || (thickness.solutions.empty() && thickness.undecided.empty());
  }

  /// Each solution of the plane with each thickness is handed to add(solution, thickness); what is
  /// undecided of either is left undecided. at(box): the stretches of a box of the plane's unknowns.
  template <int N, class At, class Add>
  void combine(const PruneResult<N>& plane, const PruneResult<1>& thickness, const At& at,
               const Add& add) {
    for (const auto* planes : {&plane.solutions, &plane.unproven})
      for (const ProvenSolution<N>& each : *planes)
        for (const auto* thicknesses : {&thickness.solutions, &thickness.unproven})
          for (const ProvenSolution<1>& rho : *thicknesses)
            add(each, FoundThickness{rho.x[0], rho.proof.solution[0], rho.proof.error_bound,
                                     rho.proof.proven});
    const auto leave = [&](const Box<N>& box, const Interval& rho) {
      StretchBox out = at(box);
      out.rho = rho;
      leave_undecided(out);
    };
    for (const ProvenSolution<N>& each : plane.solutions)
      for (const Box<1>& rho : thickness.undecided) leave(each.proof.solution, rho[0]);
    for (const Box<N>& box : plane.undecided) {
      for (const ProvenSolution<1>& rho : thickness.solutions) leave(box, rho.proof.solution[0]);
      for (const Box<1>& rho : thickness.undecided) leave(box, rho[0]);
    }
  }
  /// Likewise of systems that hold all unknowns: add(solution).
  template <int N, class At, class Add>
  void each_of(const PruneResult<N>& found, const At& at, const Add& add) {
    for (const auto* list : {&found.solutions, &found.unproven})
      for (const ProvenSolution<N>& each : *list) add(each);
    for (const Box<N>& box : found.undecided) leave_undecided(at(box));
  }

  void leave_undecided(const StretchBox& box) { out_.undecided.push_back(box); }

  /// A motion with the numbers found; what is not proven counts where its residual is accepted.
  void add(const Equilibrium& found, bool proven) {
    // Where the formula is not what the proof takes for granted of it, that is no motion.
    if (proven && assumes_ && !(found.residual <= acceptable_residual)) {
      const auto about = [](double x) {
        const double reach = 1e-12 * std::abs(x);
        return Interval(x - reach, x + reach);
      };
      leave_undecided(
          {about(found.q.xi), about(found.q.zeta), about(found.q.rho), about(found.q.alpha)});
      return;
    }
    if (proven) {
      out_.solutions.push_back(found);
    } else if (found.residual <= acceptable_residual) {
      out_.unproven.push_back(found);
    }
  }

  /// Ascending in key(motion). may_be, names: of search_message().
  template <class Key>
  SearchResult finish(const Key& key,
                      std::string_view may_be =
                          "a fold, a bifurcation, or solutions that are not "
                          "isolated",
                      const std::array<std::string_view, 3>& names = {"xi", "zeta", "rho"}) {
    for (auto* list : {&out_.solutions, &out_.unproven}) std::ranges::sort(*list, {}, key);
    if (!interrupted())
      out_.status = out_.undecided.empty() ? SearchStatus::complete : SearchStatus::undecided;
    out_.message = search_message(options_, out_.status, out_.solutions.size(), out_.undecided,
                                  may_be, names) +
                   unproven_text(out_.unproven.size());
    return std::move(out_);
  }

 private:
  PruneOptions prune_options(long factor) const {
    return {.min_width = options_.min_width,
            .max_boxes = factor * options_.max_boxes,
            .stop = options_.stop};
  }
  template <int N>
  PruneResult<N> taken(PruneResult<N> found) {
    out_.boxes += found.boxes;
    if (found.interrupted) out_.status = SearchStatus::interrupted;
    return found;
  }

  const SearchOptions& options_;
  bool assumes_;  ///< the potential takes for granted what is not proven
  SearchResult out_;
};

/// As every kind reports a solution of its systems.
inline Equilibrium equilibrium_of_search(const Stretch& q, double error_bound, bool proven) {
  Equilibrium out;
  out.status = SolveStatus::solved;
  out.message = found_by_search(proven);
  out.q = q;
  out.error_bound = error_bound;
  return out;
}

/// Of the numbers as they are reported.
inline void recompute_residual(const Body& body, const Potential& potential, Equilibrium& found) {
  const BalanceCheck check = check_balance(body, potential, found.q, found.nu);
  found.residual = check.residual;
  found.compatibility = check.compatibility;
}

}  // namespace stationary
