// Every stationary ellipsoid of a potential that is not isotropic at one nu, with proof, as
// search.hpp has it: xi, zeta, rho in the box, and alpha such that d/(xi zeta) is in all of it, so
// that every S with principal stretches in the box is. Oblique: every axis in the plane that is not
// a material one.
//
// About axis 1 or 2 the balance is solved at alpha = 0; a solution is a motion only where V_alpha =
// 0 there, which a V that is even in alpha has everywhere and another as good as nowhere: then the
// message says how far from a motion the nearest one is.
#pragma once

#include "lib/body/motion.hpp"
#include "solver/search/search.hpp"

namespace stationary {

/// As search(), of a problem whose potential is not isotropic.
SearchResult search_anisotropic(const Problem& problem, double nu, const SearchOptions& options);

/// Throws std::invalid_argument for an isotropic potential, or a nu that is not finite and > 0.
SearchResult search_oblique(const Body& body, const Potential& potential,
                            const ObliqueRotation& motion, const SearchOptions& options);

}  // namespace stationary
