// Where a tilted or an oblique family is followed from: a motion of the family the case names, or,
// of the two there may be, of the one that has any.
#pragma once

#include "solver/program/case/case_file.hpp"

namespace stationary::cli {

/// Leaves the plane in `motion`. Throws InputError where both planes have a motion and the case
/// names neither.
Equilibrium tilted_start(const Case& input, const Potential& potential, TiltedMotion& motion,
                         const SolveOptions& options);

/// Likewise the axis it is near at rest, where the case gives no start.
Equilibrium oblique_start(const Case& input, const Body& body, const Potential& potential,
                          ObliqueRotation& motion, const SolveOptions& options);

}  // namespace stationary::cli
