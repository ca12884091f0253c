// Every two-polar motion at given rates or momenta, with proof (branch_and_prune.hpp): ellipses
// lambda > mu, each for itself and its mirror image (mu, lambda), and circles lambda = mu, which
// only rates or s3 = p_theta have (as decimals they are taken to be equal where they are as
// doubles).
//
// Rates on a line of solutions (rates_verdict()) are not searched and said by name; another
// continuum ends as undecided boxes.
#pragma once

#include "solver/motion/two_polar_motion.hpp"
#include "solver/search/search.hpp"

namespace stationary {

struct TwoPolarSearchResult {
  SearchStatus status = SearchStatus::not_run;
  bool on_line = false;  ///< nothing was searched: the rates lie on a line of solutions
  std::string message;   ///< for a person
  /// Descending in lambda/mu (circles last), then ascending in lambda; error_bound proven.
  std::vector<TwoPolarEquilibrium> solutions;
  std::vector<StretchBox> undecided;          ///< xi, zeta: lambda, mu
  std::vector<TwoPolarEquilibrium> unproven;  ///< as of SearchResult
  long boxes = 0;                             ///< examined
};

/// Throws as require_two_polar(), and for a box search() refuses.
TwoPolarSearchResult search_two_polar(const Body& body, const Potential& potential,
                                      const TwoPolarMotion& motion,
                                      const SearchOptions& options = {});

}  // namespace stationary
