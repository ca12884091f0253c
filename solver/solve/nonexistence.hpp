// Conditions without which a family has no stationary ellipsoid at a given nu, each from the
// model's own balance (c_i are the centrifugal rates J nu^2 of C(nu)):
//
//   reciprocal-quadratic: (b - m) rho^3 = a           needs m < b,  m = J3 nu^2;  harmonic: m < k
//   reciprocal-determinant: (k - c_i) x_i^2 = c/d      needs c_i < k for both
//   neo-hookean(-3d): (mu - c_i) x_i^2 is one number   needs one sign for all mu - c_i
//   biot: linear in (xi, zeta): its one solution must be positive
//   hencky, (i), (ii): 2 kappa ln x = c x^2 of the pulled stretch needs c <= kappa/e
//
// The first holds beside any planar potential, a written-out or an anisotropic one too, those of
// planar models beside any thickness.
// Proven statements (up to rounding of the inequality itself); no condition found proves nothing.
#pragma once

#include <optional>
#include <string>

#include "solver/motion/problem.hpp"

namespace stationary {

/// The violated condition with its numbers, or nothing.
std::optional<std::string> nonexistence_reason(const Problem& problem, double nu);

}  // namespace stationary
