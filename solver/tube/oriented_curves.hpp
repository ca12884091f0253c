// The motions of a body that need not be isotropic as curves (curve_equations.hpp) in the logarithms
// of the unknowns of oriented_system.hpp. Where an even V lets sheared or oblique motions go the
// balance is singular, and a neighbourhood of that point is left undecided.
#pragma once

#include <vector>

#include "lib/material/anisotropic_potential.hpp"
#include "solver/tube/axis_curves.hpp"

namespace stationary {

/// About the branch's axis; oblique: about one in the plane of axes 1 and 2 instead. Empty where
/// that takes five unknowns: rho, alpha and the axis beside xi and zeta. As axis_curves().
std::vector<CurveFactor> oriented_curves(const Body& body, const AnisotropicPotential& potential,
                                         Branch branch, bool oblique, double from, double to,
                                         const SearchOptions& options);

}  // namespace stationary
