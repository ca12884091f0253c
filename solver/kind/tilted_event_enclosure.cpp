#include "solver/kind/tilted_event_enclosure.hpp"

#include <array>

#include "solver/family/tilted_events.hpp"
#include "solver/kind/leaf_meeting.hpp"
#include "solver/proof/enclosed_event.hpp"
#include "solver/proof/sought_event.hpp"

namespace stationary {
namespace {

/// One for both systems, so that the potentials are compiled for it once: of xi, zeta, |nu|, Lambda.
using TiltedBoxed = BoxDual<4>;

/// The numbers of the problem over boxes.
class Tilted {
 public:
  Tilted(const Body& body, const Potential& potential, TiltPlane plane, Inputs inputs)
      : potential_(&potential),
        plane_(plane),
        inputs_(inputs),
        J_{number(body.J1), number(body.J2), number(body.J3)} {}

  const Inertia3<TiltedBoxed>& J() const { return J_; }
  TiltedBoxed operator()(double value, FamilyParameter::Kind, int) const { return number(value); }
  TiltedParts<TiltedBoxed> parts(const TiltedBoxed& xi, const TiltedBoxed& zeta,
                                 const TiltedBoxed& nu) const {
    return varied_tilted(*potential_, plane_, J_, xi, zeta, square(nu), *this);
  }
  BasicStretch<TiltedBoxed> stretch(const TiltedBoxed& xi, const TiltedBoxed& zeta) const {
    return {TiltedBoxed(0.0), xi, zeta, tilted_thickness(J_, plane_, xi, zeta)};
  }
  /// V's second derivatives, along the volume where it is held.
  Matrix4<TiltedBoxed> V_qq(const BasicStretch<TiltedBoxed>& q) const {
    return with_numbers(*potential_, *this, [&](const auto& model) -> Matrix4<TiltedBoxed> {
      return potential_derivatives<2>(model, q).hessian;
    });
  }
  Vector3<TiltedBoxed> angular_velocity(const TiltSquares<TiltedBoxed>& squares) const {
    Vector3<TiltedBoxed> out =
        stationary::angular_velocity(in_plane_branch(plane_), sqrt(squares.in_plane));
    out[2] = sqrt(squares.normal);
    return out;
  }

 private:
  TiltedBoxed number(double x) const { return TiltedBoxed(as_input(x, inputs_)); }

  const Potential* potential_;
  TiltPlane plane_;
  Inputs inputs_;
  Inertia3<TiltedBoxed> J_;
};

/// One of TiltedEventSystem's functions vanishes.
class TiltedVanishing {
 public:
  static constexpr int dimension = 3;
  using BoxNumber = TiltedBoxed;

  TiltedVanishing(const Tilted& at, TiltedEventSystem::Kind kind) : at_(&at), kind_(kind) {}

  std::array<TiltedBoxed, 3> over_boxes(const std::array<TiltedBoxed, 3>& y, Inputs) const {
    return TiltedEventSystem::equations(kind_, at_->J(), y, at_->parts(y[0], y[1], y[2]));
  }

 private:
  const Tilted* at_;
  TiltedEventSystem::Kind kind_;
};

/// Two modes meet.
class TiltedMeeting {
 public:
  static constexpr int dimension = 4;
  using BoxNumber = TiltedBoxed;

  TiltedMeeting(const Tilted& at, const Potential& potential, const MeetingModes& modes)
      : at_(&at), modes_(modes), leaf_{.volume_held = potential.holds_volume()} {}

  std::array<TiltedBoxed, 4> over_boxes(const std::array<TiltedBoxed, 4>& y, Inputs) const {
    const auto parts = at_->parts(y[0], y[1], y[2]);
    const BasicStretch<TiltedBoxed> q = at_->stretch(y[0], y[1]);
    const auto meeting = leaf_meeting<TiltedBoxed>(
        modes_, leaf_, at_->J(), q, at_->angular_velocity(parts.squares), at_->V_qq(q), y[3]);
    return {parts.balance.g_xi, parts.balance.g_zeta, meeting[0], meeting[1]};
  }

 private:
  const Tilted* at_;
  MeetingModes modes_;
  LeafParts leaf_;
};

}  // namespace

std::optional<EventEnclosure> enclose_tilted_event(const Body& body, const Potential& potential,
                                                   TiltPlane plane, EventType type,
                                                   const Member& member, Inputs inputs) {
  const Tilted at(body, potential, plane, inputs);
  const Inertia3<Interval> J = inertia_intervals(body, inputs);
  const auto stretches = [&](const auto& found) {
    return StretchBox{found[0], found[1], tilted_thickness(J, plane, found[0], found[1])};
  };
  /// An event is one of motions where the squares of nu's components are not negative.
  const auto of_motions = [&](EventEnclosure out) {
    if (!out.proven || type == EventType::tilt) return out;
    const auto squares =
        at.parts(TiltedBoxed(out.q.xi), TiltedBoxed(out.q.zeta), TiltedBoxed(out.parameter))
            .squares;
    if (squares.in_plane.value.positive() && squares.normal.value.positive()) return out;
    out.proven = false;
    out.reason = "a component of nu there is not proven to be real";
    return out;
  };
  if (const auto what = vanishing_at(type, member)) {
    const TiltedVanishing equations(at, *what);
    const ReducedVector<3> y(member.q.xi, member.q.zeta, member.parameter);
    return of_motions(enclosed_event(EventBoxes(equations, inputs), y, 2, member, stretches));
  }
  for (const SoughtEvent& what : sought_events(type, Branch::iii, member)) {
    if (!what.function.spectral()) continue;
    const TiltedMeeting equations(at, potential, what.function.meeting());
    const ReducedVector<4> y(member.q.xi, member.q.zeta, member.parameter, what.lambda);
    return of_motions(enclosed_event(EventBoxes(equations, inputs), y, 2, member, stretches));
  }
  return std::nullopt;
}

}  // namespace stationary
