// Vertical branches: (iii) with J1 = J2, where some potentials have ellipses at one nu only, one
// for every eccentricity. Off the circle the balance of W(t, l) at c = J nu^2 is
//
//   W_t = c t,   W_l = -c d,   t = xi + zeta,  d = e^l = xi zeta,
//
// and a curve solves it where one of the two holds identically and the other somewhere. Where the volume is
// held, of W(t, l) + V_rho(volume/d).
#pragma once

#include <optional>
#include <string>

#include "solver/motion/problem.hpp"

namespace stationary {

/// What holds at this nu if it is a vertical branch's: `theta_dot = 0` is the motion's. Nothing
/// where the ellipses are isolated, or where it is not known that they are not.
std::optional<std::string> vertical_condition(const Problem& problem, double nu);

}  // namespace stationary
