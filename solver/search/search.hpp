// Every stationary ellipsoid of a family at one nu, with proof: all solutions of the balance with
// stretches in a box, each shown to exist and to be the only one near by, and everything else of
// the box shown to hold none (branch_and_prune.hpp), but for the boxes the result names as
// undecided.
//
// A double root (a fold, a bifurcation) and a continuum of solutions cannot be decided this way and
// end as undecided boxes after a bounded amount of work. Where xi and zeta may be exchanged
// (mirror_symmetric()), the mirror image of a solution is one too; both are listed.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/motion/equilibrium.hpp"
#include "solver/motion/problem.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

struct SearchOptions {
  double min_stretch = 1e-3;  ///< of each of xi, zeta, rho
  double max_stretch = 1e3;
  /// Of each its own range instead (two-polar: lambda, mu, rho).
  std::optional<std::array<Interval, 3>> box = {};
  Inputs inputs = Inputs::decimals;
  double min_width = 0x1p-26;               ///< of ln x, below which a box stays undecided
  long max_boxes = 10000;                   ///< of each system searched
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: return with status interrupted

  /// Of stretch k of the three.
  Interval range(std::size_t k) const {
    return box ? (*box)[k] : Interval(min_stretch, max_stretch);
  }
  /// Where alpha = sqrt(xi zeta) tanh a, the greatest e^|a|: such that every S is sought whose
  /// principal stretches are within these two numbers, or in the hull of the plane's ranges.
  double most_shear() const {
    const Interval plane = hull(range(0), range(1));
    return std::sqrt(std::max(max_stretch / min_stretch, plane.hi / plane.lo));
  }
};

enum class SearchStatus {
  not_run,
  complete,   ///< every box decided: `solutions` are all there are in the box
  undecided,  ///< `solutions` are all there are outside the undecided boxes
  interrupted
};

constexpr std::string_view search_status_names[] = {"not run", "complete", "undecided",
                                                    "interrupted"};
constexpr std::string_view name(SearchStatus s) { return search_status_names[static_cast<int>(s)]; }

struct SearchResult {
  SearchStatus status = SearchStatus::not_run;
  std::string message;  ///< for a person
  /// Ascending in xi, then zeta, then rho; error_bound proven.
  std::vector<Equilibrium> solutions;
  std::vector<StretchBox> undecided;  ///< touching ones merged into their hull
  /// Found by Newton's method in the undecided boxes, ascending likewise: error_bound estimated,
  /// and not proven to exist, nor to be all.
  std::vector<Equilibrium> unproven;
  long boxes = 0;        ///< examined
  bool on_line = false;  ///< nothing was searched: two-polar rates on a line of solutions
};

/// Of an isotropic potential those with alpha = 0; where it may_shear() there may be others about axis 3,
/// which that branch's kind looks for (solver/kind/kind.hpp).
///
/// Throws std::invalid_argument for a nu that is not finite, or a range of a stretch that is not
/// 1e-100 <= min < max <= 1e100.
SearchResult search(const Problem& problem, double nu, const SearchOptions& options = {});

}  // namespace stationary
