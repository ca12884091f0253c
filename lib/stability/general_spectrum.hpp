// The spectrum of any stationary motion, by structure-preserving methods on the leaf
// (symplectic_leaf.hpp):
//
//   E'' = L L^T definite:  x' = J E'' x is similar to the skew-symmetric L^T J L; its eigenvalues
//                          are imaginary by construction
//   else:                  Van Loan's square-reduced form: an orthogonal symplectic similarity
//                          takes (J E'')^2 to [[A, *], [0, A^T]]; the five eigenvalues of A are
//                          the Lambda, each once, so s comes in +- pairs by construction
//
// after a symplectic scaling, in the widest hardware format. Error bounds from left and right
// eigenvectors and the leaf's magnitudes. Source: C. F. Van Loan, Lin. Alg. Appl. 61 (1984) 233.
// The blocks (spectrum.hpp) are faster and sharper wherever they apply; the two agree there.
#pragma once

#include "lib/material/potential.hpp"
#include "lib/stability/spectrum.hpp"
#include "lib/stability/symplectic_leaf.hpp"

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
Spectrum general_spectrum(const GeneralFacts& facts, const Leaf<long double>& leaf);

/// The leaf of a motion: evaluates V_qq in extended precision. q's entries are inputs of their own
/// relative uncertainty; alpha counts as known to that of sqrt(xi zeta).
Leaf<long double> motion_leaf(const Body& body, const Potential& potential,
                              const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu);

/// From a stationary motion (q, nu), whole.
Spectrum general_spectrum(const Body& body, const Potential& potential,
                          const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                          double uncertainty);

}  // namespace stationary
