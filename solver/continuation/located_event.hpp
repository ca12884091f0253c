// An event of a curve as it is told: where, and how well that is known.
#pragma once

#include <string_view>

#include "solver/motion/event.hpp"

namespace stationary {

enum class EventStatus {
  located,
  bracketed,  ///< the member is one of the curve in or beside the bracket
  unresolved  ///< the function's sign is certain at the bracket's ends only; no member
};
constexpr std::string_view event_status_names[] = {"located", "bracketed", "unresolved"};
constexpr std::string_view name(EventStatus s) { return event_status_names[static_cast<int>(s)]; }

struct Event {
  EventType type = EventType::none;
  Member member;      ///< error_bound: of the event's q
  double before = 0;  ///< bracket of the parameter, ascending
  double after = 0;
  EventStatus status = EventStatus::bracketed;
};

/// Whether the number that the curve is followed in turns there: of a family at given momenta it is they.
inline bool turns_parameter(const Event& event) {
  const auto& two_polar = event.member.two_polar;
  return is_fold(event.type) ||
         (event.type == EventType::fold_momentum && two_polar && two_polar->by_momenta);
}

}  // namespace stationary
