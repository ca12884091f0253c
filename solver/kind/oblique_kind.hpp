// Steady rotations about an axis in the plane of axes 1 and 2, of a potential that is not
// isotropic, as a kind of motion.
#pragma once

#include "solver/kind/kind.hpp"

namespace stationary {

std::unique_ptr<Kind> oblique_kind(const Body& body, const Potential& potential,
                                   const ObliqueRotation& motion);

}  // namespace stationary
