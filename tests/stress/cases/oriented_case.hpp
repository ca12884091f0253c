// Bodies with fibres and orthotropic ones about axis 3 and about axes in the plane of axes 1 and 2, held
// against the balance in pairs of doubles, some 30 digits, and against what is proven of them.
#pragma once

#include "tests/stress/judge/judge.hpp"

namespace stationary::stress {

/// A random body (tests/support/bodies/random_anisotropic.hpp) at a random spin.
Outcome try_oriented(Random& random);

}  // namespace stationary::stress
