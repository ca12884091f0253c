// Steady rotations about a material axis, branches (i), (ii), (iii), as a kind of motion.
#pragma once

#include "solver/kind/kind.hpp"

namespace stationary {

std::unique_ptr<Kind> axis_kind(const Body& body, const Potential& potential,
                                const AxisRotation& motion);

}  // namespace stationary
