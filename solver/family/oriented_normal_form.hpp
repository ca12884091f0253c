// The normal form (normal_form.hpp) of an anisotropic body where motions leave a spin about a
// material axis, V even in alpha. F is the reduced energy V - |nu|^2 n.I n/2 in ln (xi, zeta, rho)
// and two that break the symmetry: a, alpha = sqrt(xi zeta) tanh a, and phi, the angle of the axis
// n from its own in the plane of axes 1 and 2. At the event F_vv = 0 for
//
//   shear    v along a: s = a
//   oblique  v = (a, phi) with F_aa a + F_aphi phi = 0, phi = 1: s = phi
//
// and `fold-nu` as of isotropic bodies, alpha being 0.
#pragma once

#include <optional>

#include "solver/family/normal_form.hpp"

namespace stationary {

/// Nothing where alpha != 0, V is not known to be even in alpha, or the parameter is an angle of
/// fibres.
std::optional<NormalForm> oriented_normal_form(const Problem& problem,
                                               const FamilyParameter& parameter, EventType type,
                                               const Member& member);

}  // namespace stationary
