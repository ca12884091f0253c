// The proof of where an event of a two-polar family lies (event_enclosure.hpp), from the equations of
// two_polar_events.hpp.
#pragma once

#include <optional>

#include "solver/motion/two_polar_motion.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

/// The proof that the event is there; nothing where there are no equations for it.
std::optional<EventEnclosure> enclose_two_polar_event(const Body& body, const Potential& potential,
                                                      const TwoPolarMotion& motion,
                                                      const FamilyParameter& parameter,
                                                      EventType type, const Member& member,
                                                      Inputs inputs = Inputs::decimals);

}  // namespace stationary
