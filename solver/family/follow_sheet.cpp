#include "solver/family/follow_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "lib/matrix/elementwise.hpp"
#include "solver/continuation/curve_start.hpp"
#include "solver/continuation/known_signs.hpp"

namespace stationary {
namespace {

template <int N>
class Follower {
 public:
  Follower(const Family<N>& family, const Stretch& q, double p, const FollowOptions& options)
      : options_(options),
        family_(family),
        curve_(family, scale_of(family, q, p, options.continuation), circle_at(family, q),
               std::nullopt, options.events) {
    const ReducedVector<N> x = family.coordinates(q, p);
    if (may_be_vertical(family, q)) {
      if (const auto pinned = pinned_parameter(curve_, x, p)) {
        curve_ = Curve<N>(family, curve_.corrector().scale(), Circle::none, pinned, options.events);
        report_.vertical = true;
      }
    }
    const Corrected<N> start = start_of(curve_, x, p);
    if (start.status != CorrectorStatus::converged) {
      report_.failure =
          "the start is no regular point of a curve: " + std::string(name(start.status));
      return;
    }
    start_ = curve_.complete(start.point);
    report_.counts.members = 1;
  }

  FollowReport both(CurveSink& sink) {
    if (!report_.failure.empty()) return report_;
    begin_beside();
    report_.points = 1;  // the start, written when what is before it is known
    HeldBack held;
    report_.backward = one(-1, held);
    std::ranges::reverse(report_.events);
    held.give(sink);
    sink.row(start_.member, event_at_start(held.empty()));
    const bool closed = report_.backward.event == EventType::closed;
    if (closed) report_.forward = report_.backward;
    if (!report_.interrupted && !closed) report_.forward = one(+1, sink);
    return report_;
  }

  FollowReport onward(const OpenEnd& end, CurveSink& sink) {
    if (!report_.failure.empty()) return report_;
    if (!is_at(family_.coordinates(end.at.q, end.at.p))) {
      report_.failure = "the end of the table is no point of the curve: another solves there";
      return report_;
    }
    written_opposite_ = is_opposite(end.at.angular_velocity);
    int direction = end.direction;
    if (end.neighbour) {
      ArcVector<N> ahead;
      ahead.template head<N>() = logarithms(family_.coordinates(end.at.q, end.at.p).array() /
                                            beside_start(*end.neighbour).array())
                                     .matrix();
      ahead[N] = (end.at.p - end.neighbour->p) / curve_.corrector().scale();
      StepOptions& step = options_.continuation.step;
      step.first = std::clamp(ahead.norm(), 1e-6, step.max);
      direction = start_.arc.tangent.dot(ahead) < 0.0 ? -1 : 1;
    }
    report_.forward = one(direction, sink);
    return report_;
  }

 private:
  /// A step from a start that is an event: there its functions vanish, or have a sign by chance, and from
  /// beside it is met like any other; inside the first step back, which is longer.
  void begin_beside() {
    const FunctionBits open = open_at_start();
    if (!options_.from_event && open == 0) return;
    ContinuationOptions how = options_.continuation;
    how.step.first *= 0.6;
    for (const int direction : {+1, -1}) {
      Continuation<N> walk(curve_, start_, direction, how);
      if (!walk.step() || walk.end() != EventType::none) continue;
      const Corrected<N> beside = start_of(curve_, walk.point().arc.x, walk.point().arc.p);
      if (beside.status != CorrectorStatus::converged) continue;
      const CurvePoint<N> point = curve_.complete(beside.point);
      const SignBits signs = SignBits::of(point.tests);
      // Of a function that vanishes all along nothing is met.
      if (!options_.from_event && (open & (signs.positive | signs.negative)) == 0) continue;
      start_ = point;
      return;
    }
  }

  /// Functions of the events sought that have a value and no certain sign at the start: it may be one of them. At
  /// rest, where the two sides are alike, none is; the passage of J1 = J2 is told of the start itself.
  FunctionBits open_at_start() const {
    if (start_.member.nu == 0.0 || report_.vertical) return 0;
    FunctionBits out = 0;
    for (std::size_t k = 0; k < TestValues::count; ++k)
      if (curve_.context().seeks(k)) out |= bit_of(k);
    if (start_.tests.value[TestValues::turn] == 0.0) out &= ~bit_of(TestValues::turn);
    return out & SignBits::of(start_.tests).open();
  }

  /// Whether a place's axis is written as the opposite of the start's.
  bool is_opposite(const Vector3<double>& angular_velocity) const {
    return angular_velocity.dot(start_.member.angular_velocity) < 0.0;
  }
  /// x of a place beside the start, its axis on the start's side.
  ReducedVector<N> beside_start(const CurvePlace& place) const {
    if (!place.angular_velocity.allFinite()) return family_.coordinates(place.q, place.p);
    Member out = start_.member;
    out.q = place.q;
    out.parameter = place.p;
    out.angular_velocity =
        (is_opposite(place.angular_velocity) ? -1.0 : 1.0) * place.angular_velocity;
    return family_.coordinates_of(out);
  }

  /// Whether the start is this x; near a fold the rounding of p moves it by some 1e-8.
  bool is_at(const ReducedVector<N>& x) const {
    constexpr double same = 1e-6;
    return (logarithms(start_.arc.x.array() / x.array()).abs() <= same).all();
  }

  /// Of p in the distance along the curve: the range asked for, where it is neither nothing but
  /// rounding nor far beyond what changes the body.
  static double scale_of(const Family<N>& family, const Stretch& q, double p,
                         const ContinuationOptions& range) {
    constexpr double least = 1e-9;
    constexpr double most = 1e3;
    const double largest = std::max(std::abs(range.from), std::abs(range.to));
    const double length = std::max(range.to - range.from, least * largest);
    if (!family.along_nu()) return length;
    // The centrifugal share of the balance, about half of it at a spin of the body's own scale.
    const ReducedVector<N> x = family.coordinates(q, p);
    double nu = length;
    for (int k = 0; k < 600; ++k, nu *= 0.5) {
      const double share =
          0.5 * nu * family.linearize(x, nu).nu_slope.template lpNorm<Eigen::Infinity>();
      if (share <= 0.25) break;
    }
    return std::min(length, most * nu);
  }

  static Circle circle_at(const Family<N>& family, const Stretch& q) {
    const Circle circle = family.circle();
    // About an axis of the plane the two are solved for by equations that are not alike.
    const double within = circle == Circle::xi_zeta ? 8.0 * 0x1p-53 : 1e-12;
    return is_on(circle, q, within) ? circle : Circle::none;
  }

  /// Some potentials have all ellipses of a body with J1 = J2 at one nu, or all those that have
  /// turned away from the axes of an even V.
  static bool may_be_vertical(const Family<N>& family, const Stretch& q) {
    if (family.branch() != Branch::iii || !family.along_nu()) return false;
    if (family.mirrored()) return q.alpha != 0.0;
    return family.material_symmetry() && circle_at(family, q) == Circle::none;
  }

  /// The start's own event: it may be an end of the sheet, in either direction.
  EventType end_at_start(bool nothing_behind) const {
    if (nothing_behind || report_.backward.event == EventType::closed)
      return report_.backward.event;
    return Continuation<N>(curve_, start_, +1, options_.continuation).end();
  }

  /// Likewise where the parameter's start is J1 = J2, of a family that passes it.
  EventType event_at_start(bool nothing_behind) {
    const EventType end = end_at_start(nothing_behind);
    constexpr std::size_t turn = TestValues::turn;
    if (end != EventType::none || start_.tests.value[turn] != 0.0) return end;
    const EventType type = event_type(turn, curve_.context(), start_.tests);
    if (type == EventType::ellipse || !options_.events.has(type)) return end;
    const double p = start_.member.parameter;
    // Found to be a number of the inputs, it moves with that.
    const auto bracket = bracket_of(p, 0x1p-53 * std::abs(p));
    report_.events.push_back({type, p, bracket[0], bracket[1], EventStatus::located});
    return type;
  }

  /// Of an event that ends the sheet. Where it has no equations: half a unit of what it was taken
  /// at, and what the inputs' rounding may do to its stretches.
  std::array<double, 2> bracket_at_end(EventType event, const Member& at) const {
    constexpr double rounding = 0x1p-53;
    double p = at.parameter;
    double bound = rounding * std::abs(p);
    if (const auto known = family_.event_at(event, broken_circle(event), at)) {
      p = double(known->parameter);
      bound = (rounding + known->parameter_bound) * std::abs(p);
    } else if (at.error_bound > 0.0) {
      bound += at.error_bound * std::max(std::abs(p), curve_.corrector().scale());
    }
    return bracket_of(p, bound);
  }

  /// The class half way between two members that no other row lies between: marginal where that
  /// point of the curve is not found.
  std::optional<StabilityClass> class_between(const Member& a, const Member& b) {
    if (!a.spectrum && !b.spectrum) return std::nullopt;  // of one of them it may be left out
    const ReducedVector<N> x = family_.coordinates_of(a);
    const double scale = curve_.corrector().scale();
    ArcVector<N> chord;
    chord.template head<N>() = logarithms(family_.coordinates_of(b).array() / x.array()).matrix();
    chord[N] = (b.parameter - a.parameter) / scale;
    const double length = chord.norm();
    if (!(length > 0.0)) return std::nullopt;
    ++report_.counts.members;
    const Corrected<N> middle = curve_.corrector().correct(
        moved<N>(x, ReducedVector<N>(0.5 * chord.template head<N>())),
        a.parameter + 0.5 * scale * chord[N], chord / length, 0.5 * length);
    report_.counts.linearizations += middle.linearizations;
    if (middle.status != CorrectorStatus::converged) return StabilityClass::marginal;
    ArcVector<N> way;
    way.template head<N>() = logarithms(middle.point.x.array() / x.array()).matrix();
    way[N] = (middle.point.p - a.parameter) / scale;
    const double along = way.dot(chord) / (length * length);
    if (!(along > 0.0 && along < 1.0)) return StabilityClass::marginal;
    const CurvePoint<N> point = curve_.complete(middle.point);
    if (point.member.beyond_end() || !point.member.spectrum) return std::nullopt;
    return point.member.spectrum->verdict;
  }

  /// A member of a walk, its axis as it has turned from the first row of the table.
  void emit(CurveSink& sink, const Continuation<N>& walk, const Member& member, EventType event) {
    if (has_class_of_curve(event, member)) {
      open_.reset();
    } else {
      if (const auto verdict = open_ ? class_between(*open_, member) : std::nullopt)
        sink.between(*verdict);
      open_ = member;
    }
    if (walk.has_opposite_axis() != written_opposite_) {
      Member turned = member;
      turned.angular_velocity *= -1.0;
      sink.row(turned, event);
    } else {
      sink.row(member, event);
    }
    ++report_.points;
  }

  void record(const Event& event) {
    if (!options_.events.has(event.type)) return;
    report_.events.push_back(
        {event.type, event.member.parameter, event.before, event.after, event.status});
  }

  SheetEnd one(int direction, CurveSink& sink) {
    Continuation<N> walk(curve_, start_, direction, options_.continuation);
    open_ = start_.member;
    SheetEnd out;
    while (walk.end() == EventType::none) {
      if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
        report_.interrupted = true;
        out.reason = "interrupted";
        break;
      }
      if (report_.points >= options_.max_points) {
        report_.out_of_points = true;
        out.reason = "continuation.max_points is reached";
        break;
      }
      if (!walk.step()) {  // given up at the last point, which is written already
        last_is_end_ = true;
        break;
      }
      for (const Event& event : walk.unlocated()) record(event);
      for (const Event& event : walk.events()) {
        if (!options_.events.has(event.type)) {  // looked for to know where a sheet ends
          open_.reset();
          continue;
        }
        emit(sink, walk, event.member, event.type);
        record(event);
      }
      emit(sink, walk, walk.point().member, walk.end());
      if (options_.progress && report_.points % 256 == 0)
        options_.progress(walk.point().arc.p, report_.points);
    }
    if (walk.end() != EventType::none) {
      out = {walk.end(), walk.reason()};
      // A failure is found beyond the last point: the row says so, once more.
      if (last_is_end_) emit(sink, walk, walk.point().member, walk.end());
    }
    last_is_end_ = false;
    if (out.event != EventType::none && !is_end(out.event)) {  // an event proper ends the sheet
      const Member& m = walk.point().member;
      const auto bracket = bracket_at_end(out.event, m);
      report_.events.push_back(
          {out.event, m.parameter, bracket[0], bracket[1], EventStatus::located});
    }
    report_.counts += walk.counts();
    return out;
  }

  FollowOptions options_;
  const Family<N>& family_;
  Curve<N> curve_;
  CurvePoint<N> start_;
  FollowReport report_;
  std::optional<Member> open_;  ///< the last row, where what it begins has no class yet
  bool last_is_end_ = false;
  bool written_opposite_ = false;  ///< in the table gone on with, the start's axis
};

}  // namespace

void HeldBack::give(CurveSink& sink) const {
  for (auto each = rows_.rbegin(); each != rows_.rend(); ++each) {
    if (each != rows_.rbegin() && each->between) sink.between(*each->between);
    sink.row(each->member, each->event);
  }
  if (before_) sink.between(*before_);
}

template <int N>
FollowReport follow_family(const Family<N>& family, const Stretch& q, double p,
                           const FollowOptions& options, CurveSink& sink) {
  return Follower<N>(family, q, p, options).both(sink);
}
template FollowReport follow_family(const Family<2>&, const Stretch&, double, const FollowOptions&,
                                    CurveSink&);
template FollowReport follow_family(const Family<3>&, const Stretch&, double, const FollowOptions&,
                                    CurveSink&);
template FollowReport follow_family(const Family<4>&, const Stretch&, double, const FollowOptions&,
                                    CurveSink&);
template FollowReport follow_family(const Family<5>&, const Stretch&, double, const FollowOptions&,
                                    CurveSink&);

FollowReport follow(const AnyFamily& family, const Stretch& q, double p,
                    const FollowOptions& options, CurveSink& sink) {
  return std::visit([&](const auto& f) { return follow_family(*f, q, p, options, sink); }, family);
}

FollowReport resume(const AnyFamily& family, const OpenEnd& end, const FollowOptions& options,
                    CurveSink& sink) {
  return std::visit(
      [&](const auto& f) { return Follower(*f, end.at.q, end.at.p, options).onward(end, sink); },
      family);
}

}  // namespace stationary
