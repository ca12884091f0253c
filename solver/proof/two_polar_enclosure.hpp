// Proofs about one two-polar motion, as those of certify.hpp: that within the error bound of its
// stretches there is exactly one with the case's rates or momenta, whether it is a circle, and
// where its spectrum lies. Of s3 = p_theta the proof is for equal ones.
#pragma once

#include "solver/motion/two_polar_motion.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

/// At the equilibrium's q, circle and the prescribed two of its numbers; the others, status and
/// error_bound are not read. Refused besides: lambda and mu neither proven apart nor proven equal,
/// as `circle` says. Throws as require_two_polar().
Certificate certify_two_polar(const Body& body, const Potential& potential,
                              const TwoPolarMotion& motion, const Equilibrium& equilibrium,
                              Inputs inputs = Inputs::decimals);

/// Enclosures for the modes of `spectrum`, stability()'s of the same equilibrium. Throws
/// std::invalid_argument unless the certificate is proven.
SpectrumEnclosure enclose_spectrum(const Body& body, const Potential& potential,
                                   const TwoPolarMotion& motion, const Equilibrium& equilibrium,
                                   const Certificate& certificate, const Spectrum& spectrum,
                                   Inputs inputs = Inputs::decimals);

}  // namespace stationary
