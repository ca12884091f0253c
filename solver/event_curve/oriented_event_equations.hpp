// The equations of an event (extended_event.hpp) of a spin of an anisotropic body about a material
// axis, alpha = 0: the balance and what vanishes at the event (oriented_events.hpp,
// event_functions.hpp).
#pragma once

#include <memory>

#include "solver/proof/extended_event.hpp"

namespace stationary {

/// setting.held: the second parameter.
std::unique_ptr<HeldEventEquations<5>> oriented_event_equations(const EventSetting& setting,
                                                                const EventFunction& function);

}  // namespace stationary
