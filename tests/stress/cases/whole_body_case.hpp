// Bodies whose volume is held, or with their own gravity, or both: about a material axis or a tilted
// one, held against 50 digits of a balance written by itself: V_elastic of the models, gravity by
// Carlson's R_D, the constraint by eliminating a stretch.
#pragma once

#include "tests/stress/judge/judge.hpp"

namespace stationary::stress {

Outcome try_held_volume(Random& random);  ///< with gravity in half of the cases
Outcome try_gravity(Random& random);      ///< of a compressible body

}  // namespace stationary::stress
