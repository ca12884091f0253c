// Steady rotations about an axis tilted in a plane of axis 3, as a kind of motion.
#pragma once

#include "solver/kind/kind.hpp"

namespace stationary {

std::unique_ptr<Kind> tilted_kind(const Body& body, const Potential& potential,
                                  const TiltedRotation& motion);

}  // namespace stationary
