// Proofs about one tilted motion, as those of certify.hpp: that within the error bound there is
// exactly one with the case's |nu| and plane, its axis proven to be tilted, and that the numbers of
// nu are its components.
#pragma once

#include "lib/body/motion.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

/// At the equilibrium's q and nu; its status and error_bound are not read. Refused besides: an axis
/// that may be a material one (an end of the family).
Certificate certify_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const Equilibrium& equilibrium,
                           Inputs inputs = Inputs::decimals);

/// Enclosures for the modes of `spectrum`, tilted_stability()'s of the same motion. Throws
/// std::invalid_argument unless the certificate is proven.
SpectrumEnclosure enclose_spectrum(const Body& body, const Potential& potential,
                                   const TiltedRotation& motion, const Certificate& certificate,
                                   const Spectrum& spectrum, Inputs inputs = Inputs::decimals);

}  // namespace stationary
