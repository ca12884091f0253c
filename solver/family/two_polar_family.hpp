// Families of two-polar motions (J1 = J2, lib/balance/two_polar.hpp) in one of the motion's two
// numbers, in J3 or in a coefficient of the potential, the others held: x = (lambda, mu[, rho]),
// rho among the unknowns where the potential couples it.
//
// At fixed rates a family may start on the circle lambda = mu, where only omega + theta' matters.
// At fixed momenta it keeps off it, for s3 != p_theta; where one of these is followed, it may end on it.
#pragma once

#include "solver/family/axis_family.hpp"
#include "solver/motion/two_polar_motion.hpp"

namespace stationary {

struct TwoPolarFamilyOptions {
  TwoPolarMotion motion;
  /// Kind nu: the motion's first (omega, s3) or second number, by index; inertia: J3 only, index 2.
  FamilyParameter parameter;
  bool spectrum = true;
};

/// Throws as require_two_polar(), and std::invalid_argument for an inertia other than J3.
AnyFamily two_polar_family(const Body& body, const Potential& potential,
                           const TwoPolarFamilyOptions& options);

}  // namespace stationary
