// Where a tilted family is followed from: a motion in the case's plane, or in the one of the two
// planes that has any.
#pragma once

#include "solver/case_file.hpp"

namespace stationary::cli {

/// Leaves the plane in `motion`. Throws InputError where both have one and the case names neither.
Equilibrium tilted_start(const Case& input, const Potential& potential, TiltedMotion& motion,
                         const SolveOptions& options);

}  // namespace stationary::cli
