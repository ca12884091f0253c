// The equations of an event (event_system.hpp) of a spin about a material axis at points in extended
// precision (event_equations.hpp):
//
//   y = (xi, zeta, rho, p, Lambda)
//
// On circles the second equation is zeta = xi; where Lambda is no unknown, the last is Lambda = 1.
#pragma once

#include <memory>

#include "solver/motion/event_equations.hpp"
#include "solver/proof/sought_event.hpp"

namespace stationary {

std::unique_ptr<HeldEventEquations<5>> extended_event_equations(const EventSetting& setting,
                                                                const EventFunction& function);

/// Of a located member; its parameter is p.
ExtendedVector<5> event_unknowns(const Member& member, const SoughtEvent& what);

}  // namespace stationary
