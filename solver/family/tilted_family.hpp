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

/// A member of the family that begins where a branch's axis tilts (q, nu), a little along it; within:
/// |nu| that it may have.
std::optional<Member> just_inside(const Family<2>& family, const Stretch& q, double nu,
                                  const Interval& within = Interval::entire());

/// The share that the square of a component has in p^2 = |nu|^2; zero where the rounding of p, which moves
/// q by the bound, leaves no more. condition: by how much more than that the share is moved.
double tilt_share(double square, double p, double error_bound, double condition = 1.0);

}  // namespace stationary
