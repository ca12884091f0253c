// The proof of where an event of a family of a potential that is not isotropic lies
// (event_enclosure.hpp), from the equations of oriented_events.hpp, and of two modes that meet from
// the leaf's (leaf_meeting.hpp).
#pragma once

#include <optional>

#include "lib/body/motion.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

/// problem: at the member's own parameter, the member a spin about its branch's axis. Nothing where
/// no event of this type has equations.
std::optional<EventEnclosure> enclose_oriented_event(const Problem& problem,
                                                     const FamilyParameter& parameter,
                                                     EventType type, const Member& member,
                                                     Inputs inputs = Inputs::decimals);
/// Likewise, about an oblique axis.
std::optional<EventEnclosure> enclose_oblique_event(const Body& body,
                                                    const AnisotropicPotential& potential,
                                                    const FamilyParameter& parameter,
                                                    EventType type, const Member& member,
                                                    Inputs inputs = Inputs::decimals);

}  // namespace stationary
