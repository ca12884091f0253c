// Tilted motions at a distance from where their family begins, held against 50 digits and against
// what is proven of them.
#pragma once

#include "tests/stress/judge/judge.hpp"

namespace stationary::stress {

/// A tilt of a random sheet and the tilted family that begins there, |nu| on either side at a
/// relative distance of 1e-12 ... 0.1: beyond the family's end there is none.
Outcome try_tilted(Random& random);

}  // namespace stationary::stress
