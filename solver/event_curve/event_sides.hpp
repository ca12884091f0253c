// The family in p1 at an event and on both sides of it: its member, its classes, and the functions
// whose further zeros are other events at the same place.
#pragma once

#include <optional>

#include "solver/event_curve/event_curve.hpp"

namespace stationary {

/// An event as the curve of events has it.
struct EventPlace {
  using Unknowns = ReducedVector<6>;

  Unknowns x = Unknowns::Ones();     ///< by event_place(), as far as the family has them
  Unknowns tail = Unknowns::Zero();  ///< of them; zero where it is not known
  double first = 0.0;                ///< p1
  double error_bound = 0.0;          ///< of the stretches
  Circle circle = Circle::none;

  /// The family's unknowns among all, of a vector that has them.
  template <int N>
  static ReducedVector<N> of(const auto& all) {
    ReducedVector<N> out;
    for (int k = 0; k < N; ++k) out[k] = all[index(k)];
    return out;
  }
  static void put(const auto& x, Unknowns& all) {
    for (int k = 0; k < x.size(); ++k) all[index(k)] = x[k];
  }
  Stretch straight() const { return {0.0, x[0], x[1], x[2]}; }

 private:
  static Eigen::Index index(int k) {
    return static_cast<Eigen::Index>(event_place(static_cast<std::size_t>(k)));
  }
};

/// The place of a motion of the family: of a member, and of a stretch whose axis is not known.
EventPlace place_of(const AnyFamily& family, const Member& member, Circle circle);
EventPlace place_of(const AnyFamily& family, const Stretch& q, double first, double error_bound,
                    Circle circle);

/// The family's member there.
Member member_at(const AnyFamily& family, const EventPlace& place);

struct EventSides {
  std::optional<StabilityClass> before;
  std::optional<StabilityClass> after;
};
/// fold: p1 turns at the event. See EventCurvePoint for which is before.
EventSides sides_of(const AnyFamily& family, const EventPlace& place, bool fold);

/// The functions of event.hpp at the event, and what says of which events they are; folds are those
/// of the family in p1. Signs that the errors leave open are marked.
struct EventFunctions {
  TestValues values;
  TestContext context;
  double turning = 0.0;  ///< the value of what vanishes where p1 turns, whichever function that is
};
EventFunctions functions_at(const AnyFamily& family, const EventPlace& place, const Member& member);

}  // namespace stationary
