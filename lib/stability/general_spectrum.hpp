// The spectrum of any stationary motion, from the leaf (symplectic_leaf.hpp) in pairs of doubles:
// the characteristic polynomial of the Lambda, of half the size where a reversing symmetry divides
// the leaf (reversible_leaf.hpp), else of all of it (whole_leaf.hpp); its roots as factors of which
// the nearest share one; vectors in double for energies and error bounds. Lambda is found, and s in
// pairs by construction. Where Lambda do not stand apart, iterations in pairs of doubles take its place
// (iterated_modes.hpp).
// The blocks (spectrum.hpp) are faster and sharper wherever they apply; the two agree there.
#pragma once

#include "lib/leaf/symplectic_leaf.hpp"
#include "lib/material/potential.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

/// What a material symmetry (J1 = J2, isotropic V) means for the motion at hand.
enum class MaterialSymmetry {
  none,
  ellipse,  ///< lambda != mu: it forces a zero pair
  circle    ///< lambda = mu in (iii), nu3 >= 0: no zero, but a second invariant
};

struct GeneralFacts {
  MaterialSymmetry symmetry;
  double uncertainty;  ///< as BlockFacts::uncertainty
};

/// Also of a part of a leaf that the rest of it does not see.
Spectrum general_spectrum(const GeneralFacts& facts, const Leaf& leaf);

/// The leaf of a motion: evaluates V_qq in extended precision. q's entries are inputs of their own
/// relative uncertainty; alpha counts as known to that of sqrt(xi zeta).
Leaf motion_leaf(const Body& body, const Potential& potential, const BasicStretch<DoubleDouble>& q,
                 const Vector3<DoubleDouble>& nu);
/// By the models of a potential that is not isotropic, which may serve many motions.
Leaf motion_leaf(const Body& body, const AnisotropicModel<DoubleDouble>& V,
                 const AnisotropicModel<Conditioned>& conditioned_V,
                 const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu);

/// From a stationary motion (q, nu), whole.
Spectrum general_spectrum(const Body& body, const Potential& potential,
                          const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                          double uncertainty);

}  // namespace stationary
