// Certificates of motions about an axis in no plane, and what is proven of their spectra.
#pragma once

#include "solver/kind/spatial_family.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

Certificate certify_spatial(const SpatialEquations& equations, double nu,
                            const Equilibrium& equilibrium);

/// Of a proven one; throws std::invalid_argument otherwise.
SpectrumEnclosure enclose_spatial_spectrum(const SpatialEquations& equations, double nu,
                                           const Certificate& certificate,
                                           const Spectrum& spectrum);

}  // namespace stationary
