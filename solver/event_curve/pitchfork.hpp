// On which side of an event where a circle breaks (body/circle.hpp) the ellipses lie. F the reduced
// energy in logarithms, F_i = G_i, v the direction that breaks it, (1, -1, 0) where xi = zeta, K the
// Hessian of F on the circles' own directions. At the event F_vv = 0, and near it
//
//   F = F(circle) + a s^4/24 + (dF_vv/dp) (p - p_event) s^2/2 + ...,
//   a = F_vvvv - 3 F_vv. K^-1 F_vv.
//
// so that the ellipses, s^2 = -6 (dF_vv/dp) (p - p_event)/a, change sides where a changes its sign
// through zero. Where det K = 0 the circle itself turns: there a and dF_vv/dp change their signs
// through infinity, both, and the ellipses do not change sides.
#pragma once

#include "lib/body/circle.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// a divided by the size of its terms and with the sign of a det K, of an isotropic potential; q on the circle.
/// Exact to some 1e-14 of that size; 0 where it is zero to rounding, as all along a vertical branch.
double pitchfork_coefficient(const Problem& problem, double nu, const Stretch& q,
                             Circle circle = Circle::xi_zeta);

}  // namespace stationary
