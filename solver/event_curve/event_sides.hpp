// The family in p1 at an event and on both sides of it: its member, its classes, and the functions
// whose further zeros are other events at the same place.
#pragma once

#include <optional>

#include "solver/event_curve/event_curve.hpp"
#include "solver/proof/event_system.hpp"

namespace stationary {

/// An event as the curve of events has it.
struct EventPlace {
  Stretch q;
  ReducedVector<3> tail;  ///< of xi, zeta, rho; zero where it is not known
  double first;           ///< p1
  double error_bound;     ///< of the stretches
  Circle circle;
};

/// The family's member there; spectrum: with its spectrum.
Member member_at(const SpinningProblem& at, const FamilyParameter& first, const EventPlace& place,
                 bool spectrum);

struct EventSides {
  std::optional<StabilityClass> before;
  std::optional<StabilityClass> after;
};
/// fold: p1 turns at the event. See EventCurvePoint for which is before.
EventSides sides_of(const SpinningProblem& at, const FamilyParameter& first,
                    const EventPlace& place, bool fold);

/// The functions of event.hpp at the event; folds are those of the family in p1. Signs that the
/// errors leave open are marked.
TestValues functions_at(const SpinningProblem& at, const FamilyParameter& first,
                        const EventPlace& place, const Member& member);

/// Of these, the one that vanishes all along the curve of this event.
std::optional<std::size_t> own_function(const EventFunction& function);

}  // namespace stationary
