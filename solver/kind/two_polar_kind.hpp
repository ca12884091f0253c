// Two-polar motions at given rates or momenta (J1 = J2), as a kind of motion.
#pragma once

#include "solver/kind/kind.hpp"

namespace stationary {

std::unique_ptr<Kind> two_polar_kind(const Body& body, const Potential& potential,
                                     const TwoPolarMotion& motion);

}  // namespace stationary
