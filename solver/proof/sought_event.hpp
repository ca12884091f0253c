// Which function of the event's equations (event_system.hpp) vanishes at a located event of a spin
// about a material axis, and near which Lambda.
#pragma once

#include <limits>
#include <vector>

#include "solver/motion/event.hpp"
#include "solver/proof/event_system.hpp"

namespace stationary {

struct SoughtEvent {
  EventFunction function;
  /// Where Lambda is among the unknowns.
  double lambda = std::numeric_limits<double>::quiet_NaN();
};

/// What may vanish at a located event of the type, the likeliest first. None where the type has no
/// equations; those of the Lambdas take a member with its spectrum.
std::vector<SoughtEvent> sought_events(EventType type, Branch branch, const Member& member);

}  // namespace stationary
