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

/// Solutions descending in lambda/mu (circles last), then ascending in lambda; the xi and zeta of
/// undecided boxes are lambda and mu.
/// Throws as require_two_polar(), and for a box search() refuses.
SearchResult search_two_polar(const Body& body, const Potential& potential,
                              const TwoPolarMotion& motion, const SearchOptions& options = {});

}  // namespace stationary
