// Proofs about one stationary ellipsoid of a potential that is not isotropic, as certify.hpp has
// them: existence, uniqueness, error bound and class in every branch and about an oblique axis. The
// spectrum is enclosed block by block where alpha = 0, V_alpha = 0 there and the axis is a material
// one, else by the whole leaf (leaf_enclosure.hpp).
#pragma once

#include "lib/body/motion.hpp"
#include "solver/proof/certify.hpp"
#include "solver/proof/motion_spectrum.hpp"

namespace stationary {

/// As certify(), of a problem whose potential is not isotropic.
Certificate certify_anisotropic(const Problem& problem, const Equilibrium& equilibrium,
                                Inputs inputs);
SpectrumEnclosure enclose_anisotropic_spectrum(const Problem& problem, const MotionBox& motion,
                                               const Spectrum& approximate, Inputs inputs);

/// Of a spin about an axis in the plane of axes 1 and 2, nu = |nu| (cos, sin, 0).
Certificate certify_oblique(const Body& body, const Potential& potential,
                            const ObliqueRotation& motion, const Equilibrium& equilibrium,
                            Inputs inputs = Inputs::decimals);
SpectrumEnclosure enclose_oblique_spectrum(const Body& body, const Potential& potential,
                                           const ObliqueRotation& motion,
                                           const Certificate& certificate, const Spectrum& spectrum,
                                           Inputs inputs = Inputs::decimals);

}  // namespace stationary
