// Proofs about one stationary ellipsoid: that near the numbers of an Equilibrium there is exactly
// one (Krawczyk's test, krawczyk.hpp), how far from it the numbers are at most, and where its
// spectrum lies.
//
// Inputs (J, coefficients, nu) are by default decimals within half a unit of the last place of the
// doubles they were read as, as for Equilibrium::error_bound: the proof is for every such case (of
// J1 = J2, for equal ones).
// Refused: of an isotropic V alpha != 0 (without gravity it is no stationary motion, or another choice
// of the angle; with gravity it is another kind's, sheared_kind.hpp), numbers proven to be no solution
// to working precision, and what the intervals do not decide (a fold within rounding errors).
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "lib/material/potential.hpp"
#include "lib/stability/spectrum_enclosure.hpp"
#include "solver/motion/equilibrium.hpp"
#include "solver/motion/problem.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {

struct StretchBox {
  Interval xi;
  Interval zeta;
  Interval rho;
  Interval alpha = 0.0;  ///< anisotropic V: may be another
};

struct Certificate {
  bool proven = false;
  std::string reason;  ///< why not
  /// Identities of the potential's formula that the proof takes for granted: known at points only
  /// (Potential::assumptions), mostly none.
  std::vector<std::string> assuming;
  StretchBox unique;    ///< holds all within error_bound, and exactly one solution with alpha = 0
  StretchBox solution;  ///< where it lies in there
  bool circle = false;  ///< proven: xi = zeta, by symmetry
  /// Of an oblique motion: where nu/|nu| lies, along axes 1 and 2.
  std::array<Interval, 2> axis = {};
  /// Proven bound of the relative error of each of xi, zeta, rho (of alpha over sqrt(xi zeta), of
  /// an oblique axis' angle); NaN where not proven.
  double error_bound = std::numeric_limits<double>::quiet_NaN();
};

/// At the equilibrium's q and nu; its status and error_bound are not read.
Certificate certify(const Problem& problem, const Equilibrium& equilibrium,
                    Inputs inputs = Inputs::decimals);

/// Enclosures for the modes of `spectrum`, stability()'s of the same equilibrium. Throws
/// std::invalid_argument unless the certificate is proven.
SpectrumEnclosure enclose_spectrum(const Problem& problem, const Equilibrium& equilibrium,
                                   const Certificate& certificate, const Spectrum& spectrum,
                                   Inputs inputs = Inputs::decimals);

}  // namespace stationary
