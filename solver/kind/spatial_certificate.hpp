// Certificates of motions about an axis in no plane, and what is proven of their spectra and of where
// the events of their families lie.
#pragma once

#include <optional>

#include "solver/kind/spatial_family.hpp"
#include "solver/proof/certify.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

Certificate certify_spatial(const SpatialEquations& equations, double nu,
                            const Equilibrium& equilibrium);

/// Of a proven one; throws std::invalid_argument otherwise.
SpectrumEnclosure enclose_spatial_spectrum(const SpatialEquations& equations, double nu,
                                           const Certificate& certificate,
                                           const Spectrum& spectrum);

/// An end `shear`, by the tilted family's equations; nothing of other events. member: located.
std::optional<EventEnclosure> enclose_spatial_event(const SpatialEquations& equations,
                                                    EventType type, const Member& member);

}  // namespace stationary
