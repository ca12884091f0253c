// Every tilted motion of one plane at a |nu|, with proof: branch and prune on the balance without
// its tilt (search.hpp) and, of each solution, the signs of nu's squared components. Both proven
// positive: a motion; one proven negative: none; else the box is undecided, as where the axis comes
// to a material one.
#pragma once

#include "lib/body/motion.hpp"
#include "solver/search/search.hpp"

namespace stationary {

/// As search(); all of xi, zeta, rho in the box. nu3 and the other component are taken >= 0: their
/// signs make no other motion. Throws std::invalid_argument unless |nu| is finite and > 0, and for
/// a box search() refuses.
SearchResult search_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const SearchOptions& options = {});

}  // namespace stationary
