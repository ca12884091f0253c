// The family of steady rotations about an axis tilted in the plane of axes 1, 3 or 2, 3
// (balance.hpp), in p = |nu|:
//
//   x = (xi, zeta),   rho = sqrt(J1/J3) xi in the 1-3 plane
//
// G knows no tilt and goes on where nu1^2 or nu3^2 has become negative: there the family ends, on
// branch (iii) or (i). Continuation stops at that zero (EventType::tilt). Isotropic V, alpha = 0.
#pragma once

#include <memory>
#include <optional>

#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"
#include "solver/motion/family.hpp"

namespace stationary {

std::unique_ptr<Family<2>> tilted_family(const Body& body, const Potential& potential,
                                         TiltPlane plane, bool spectrum);

/// The plane a branch's axis tilts in at an event `tilt` of its sheet at q, or nothing: the plane of that axis,
/// in (iii) of either, whose two locked inertias are equal.
std::optional<TiltPlane> plane_of_tilt(Branch branch, const Body& body, const Stretch& q);

/// A member of the family that begins where a branch's axis tilts (q, nu), a little along it; within:
/// |nu| that it may have.
std::optional<Member> just_inside(const Family<2>& family, const Stretch& q, double nu,
                                  const Interval& within = Interval::entire());

/// The share that the square of a component has in p^2 = |nu|^2; zero where the rounding of p, which moves
/// q by the bound, leaves no more. condition: what of that moves the share, where it is less than
/// all.
double tilt_share(double square, double p, double error_bound, double condition = 1.0);

}  // namespace stationary
