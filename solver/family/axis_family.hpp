// Families of steady rotations about a material axis, branches (i), (ii), (iii), in nu or in any
// other number of the problem:
//
//   N = 2  x = (xi, zeta)        separable V in (iii), rho untouched by the parameter and unique
//   N = 3  x = (xi, zeta, rho)   otherwise
//
// of an isotropic V; of another: anisotropic_family.hpp.
#pragma once

#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// alpha_free: of an even anisotropic V in (iii), the family with alpha != 0 and not that with
/// alpha = 0.
AnyFamily axis_family(const Problem& problem, const AxisFamilyOptions& options,
                      bool alpha_free = false);

}  // namespace stationary
