// Families of stationary ellipsoids of a potential that is not isotropic (anisotropic_balance.hpp),
// in nu or in any other number of the problem:
//
//   x = (xi, zeta, rho)               (i), (ii), where V is even in alpha all along; (iii)
//                                     likewise, alpha = 0
//   x = (xi, zeta, rho, e^a)          (iii) else
//   x = (xi, zeta, rho, e^a, x_phi)   oblique, nu = |nu| (cos phi, sin phi, 0)
//
// The last is regular down to |nu| = 0, where compatibility alone says which axes motions start
// about: those of the in-plane inertia at rest. Where V is even in alpha a family with alpha != 0
// ends where it meets the one with alpha = 0 it branches off (events shear, oblique).
#pragma once

#include "lib/body/motion.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// Whether V_alpha = 0 at alpha = 0 all along a family in this number: a fibre's angle turns V away
/// from the axes, and k of one of a pair of fibres as well.
bool keeps_shear_free(const AnisotropicPotential& potential, const FamilyParameter& parameter);

/// alpha_free: of an even V in (iii), the family with alpha != 0. Throws std::invalid_argument for
/// (i), (ii) unless keeps_shear_free(): no such family exists.
AnyFamily anisotropic_family(const Body& body, const AnisotropicPotential& potential, Branch branch,
                             bool alpha_free, const AxisFamilyOptions& options);

/// near: decides which axis a stretch is taken to spin about where it spins about both (at rest).
std::unique_ptr<Family<5>> oblique_family(const Body& body, const AnisotropicPotential& potential,
                                          const AxisFamilyOptions& options,
                                          Branch near = Branch::i);

}  // namespace stationary
