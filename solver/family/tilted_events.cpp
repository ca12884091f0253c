#include "solver/family/tilted_events.hpp"

#include <cmath>

#include "lib/body/inertia.hpp"
#include "solver/proof/enclosed_event.hpp"

namespace stationary {

std::array<BoxDual<3>, 3> TiltedEventSystem::over_boxes(const std::array<BoxDual<3>, 3>& y,
                                                        Inputs inputs) const {
  const auto number = [&](double x) { return BoxDual<3>(as_input(x, inputs)); };
  const Inertia3<BoxDual<3>> J{number(J_[0]), number(J_[1]), number(J_[2])};
  return equations(
      J, y,
      varied_tilted(potential_, plane_, J, y[0], y[1], square(y[2]),
                    [&](double value, FamilyParameter::Kind, int) { return number(value); }));
}

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

std::optional<EventEnclosure> enclose_tilted_event(const Body& body, const Potential& potential,
                                                   TiltPlane plane, EventType type,
                                                   const Member& member, Inputs inputs) {
  const auto what = vanishing_at(type, member);
  if (!what) return std::nullopt;
  const TiltedEventSystem equations(body, potential, plane, *what);
  const Inertia3<Interval> J = inertia_intervals(body, inputs);
  const ReducedVector<3> y(member.q.xi, member.q.zeta, member.parameter);
  return enclosed_event(EventBoxes(equations, inputs), y, 2, member, [&](const Box<3>& found) {
    return StretchBox{found[0], found[1], tilted_thickness(J, plane, found[0], found[1])};
  });
}

}  // namespace stationary
