#include "solver/family/tilted_events.hpp"

#include <cmath>

#include "lib/body/inertia.hpp"

namespace stationary {

KindEvents tilted_events() {
  KindEvents out = axis_events();
  out.set = [](const Member& member, const TestContext&, TestValues& values) {
    // Where J1 = J2 only an end is on the circle.
    if (member.body.symmetric()) return;
    values.value[TestValues::turn] = member.turn;
    const Vector3<double> m = second_moments(member.body, member.q);
    values.value[TestValues::inertia_12] = relative_difference(m[1], m[0]);
  };
  out.turn = EventType::shear;
  out.end = EventType::tilt;
  out.end_reason = [](const Member& at) -> std::string_view {
    return at.tilt_in_plane < at.tilt_normal ? "the axis has come to axis 3, on branch (iii)"
                                             : "the axis has come to the plane of axes 1 and 2";
  };
  return out;
}

std::optional<TiltedEventSystem::Kind> vanishing_at(EventType type, const Member& near) {
  using Kind = TiltedEventSystem::Kind;
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
      return Kind::fold;
    case EventType::fold_momentum:
      return Kind::momentum;
    case EventType::inertia_exchange:
      return Kind::inertia;
    case EventType::tilt:
      return std::abs(near.tilt_in_plane) < std::abs(near.tilt_normal) ? Kind::in_plane
                                                                       : Kind::normal;
    case EventType::shear:
      return Kind::shear;
    default:
      return std::nullopt;
  }
}

}  // namespace stationary
