// Certificates of motions with alpha != 0 of an isotropic body (sheared_family.hpp), and what is proven
// of their spectra and of where the events of their families lie.
#pragma once

#include <optional>

#include "solver/family/sheared_family.hpp"
#include "solver/proof/certify.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

/// nu: |nu|, about axis 3 of either sign.
template <int N>
Certificate certify_sheared(const ShearedEquations<N>& equations, double nu,
                            const Equilibrium& equilibrium);

/// Of a proven one; throws std::invalid_argument otherwise.
template <int N>
SpectrumEnclosure enclose_sheared_spectrum(const ShearedEquations<N>& equations, double nu,
                                           const Certificate& certificate,
                                           const Spectrum& spectrum);

/// An end `shear` or `oblique`, by the equations of the family that is left there; nothing of other
/// events. member: located.
std::optional<EventEnclosure> enclose_sheared_event(const Body& body, const Potential& potential,
                                                    ShearedAxis axis, EventType type,
                                                    const Member& member);

}  // namespace stationary
