// The proof of where an event of a tilted family lies (event_enclosure.hpp), from the equations of
// tilted_events.hpp, and of two modes that meet from the leaf's (leaf_meeting.hpp).
#pragma once

#include <optional>

#include "lib/body/motion.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

/// member: located, of the family in |nu|. Nothing where no event of this type has equations.
std::optional<EventEnclosure> enclose_tilted_event(const Body& body, const Potential& potential,
                                                   TiltPlane plane, EventType type,
                                                   const Member& member,
                                                   Inputs inputs = Inputs::decimals);

}  // namespace stationary
