#include "solver/event_curve/event_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "lib/matrix/elementwise.hpp"
#include "solver/continuation/continuation.hpp"
#include "solver/continuation/curve_start.hpp"
#include "solver/continuation/sheet_end.hpp"
#include "solver/event_curve/event_curve_family.hpp"

namespace stationary {
namespace {

/// What changes its sign at a special point.
struct Signs {
  double first_speed = 0.0;   ///< dp1/ds
  double second_speed = 0.0;  ///< dp2/ds
  double pitchfork = 0.0;     ///< of a circle that breaks; else 0
  EventFunctions functions;
  bool beyond_end = false;  ///< of the family in p1: no motion is there
};

template <int N>
class Follower {
 public:
  Follower(const EventCurveSetting& setting, EventCurveSystem<N> system, double second,
           Circle circle, const EventCurveOptions& options)
      : setting_(setting),
        circle_(circle),
        options_(options),
        second_(second),
        family_(std::move(system), options.second_to - options.second_from),
        curve_(family_, options.second_to - options.second_from, Circle::none, std::nullopt,
               EventSet::none()) {}

  EventCurve both() {
    const Corrected<N> start = start_of(curve_, family_.coordinates({}, second_), second_);
    if (start.status != CorrectorStatus::converged) {
      out_.failure = "the event's equations are singular here: " + std::string(name(start.status));
      return std::move(out_);
    }
    start_ = curve_.complete(start.point);
    const Signs first = signs_at(start_.arc);
    if (first.beyond_end) {
      out_.failure =
          "the event's equations hold here beyond an end of the family, where no motion is";
      return std::move(out_);
    }
    out_.last = one(-1);
    std::ranges::reverse(out_.points);
    out_.first = std::exchange(out_.last, {});
    out_.points.push_back(completed(start_.arc, first, SpecialPoint::none));
    if (out_.first.event == EventType::closed) {
      out_.last = out_.first;
    } else if (!out_.interrupted) {
      out_.last = one(+1);
    }
    return std::move(out_);
  }

 private:
  const EventCurveSystem<N>& what() const { return family_.system(); }
  double first_of(const ArcPoint<N>& arc) const { return family_.first_parameter(arc.x); }

  EventPlace place_at(const ArcPoint<N>& arc) const {
    EventPlace out{.first = first_of(arc), .circle = circle_};
    out.x.template head<N>() = family_.signed_unknowns(arc.x);
    if (circle_ != Circle::none) {
      const auto [a, b, other] = places(circle_);
      out.x[b] = out.x[a];
    }
    if (arc.tail.allFinite()) out.tail.template head<N>() = family_.signed_unknowns(arc.tail);
    // At a turn of p2 the bound is of x at the row's p2; on the curve x is far better known.
    out.error_bound = arc.at_turn ? curve_.corrector().curve_error(arc) : arc.error_bound;
    return out;
  }

  Signs signs_at(const ArcPoint<N>& arc) const {
    Signs out;
    out.first_speed = arc.tangent[EventCurveFamily<N>::first];
    out.second_speed = arc.tangent[N];
    const EventPlace place = place_at(arc);
    if (what().pitchfork) out.pitchfork = what().pitchfork(place, arc.p);
    const AnyFamily family =
        setting_.family(place.first, arc.p, !what().spectral && options_.spectrum);
    const Member member = member_at(family, place);
    out.functions = functions_at(family, place, member);
    out.beyond_end = member.beyond_end() && out.functions.context.kind.end != setting_.type;
    if (const auto own = what().own_function)
      out.functions.values.value[*own] = std::numeric_limits<double>::quiet_NaN();
    return out;
  }

  /// Whether a function has the same sign at points around, as far away as the point's numbers are
  /// uncertain: far out, or where sheets merge, a determinant is rounding.
  bool keeps_sign(const ArcPoint<N>& arc, std::size_t k, double value) const {
    const EventPlace place = place_at(arc);
    const double move = 4.0 * std::max(place.error_bound, 0x1p-51);
    // Each number up or down: the unknowns, p1, p2. No pattern is another's opposite.
    for (const unsigned pattern : {0x00U, 0x15U, 0x4cU, 0xa6U, 0x79U, 0x87U, 0xdeU, 0x6bU}) {
      for (const double side : {move, -move}) {
        const auto moved = [&, bits = pattern](double number, Eigen::Index bit) {
          return number * (1.0 + (((bits >> static_cast<unsigned>(bit)) & 1U) != 0 ? side : -side));
        };
        EventPlace there = place;
        const Eigen::Index size = there.x.size();
        for (Eigen::Index i = 0; i < size; ++i) there.x[i] = moved(there.x[i], i);
        if (circle_ != Circle::none) {
          const auto [a, b, other] = places(circle_);
          there.x[b] = there.x[a];
        }
        there.first = moved(there.first, size);
        const AnyFamily family = setting_.family(there.first, moved(arc.p, size + 1), false);
        const double value_there =
            functions_at(family, there, member_at(family, there)).values.value[k];
        if (!(value_there * value > 0.0)) return false;
      }
    }
    return true;
  }

  /// What is not certain to have changed its sign keeps that of the point before, and has none before it
  /// is certain: the functions whose errors are in no bound, and the pitchfork's, 0 where it is rounding.
  void keep_uncertain(const Signs* before, Signs& at, const ArcPoint<N>& arc) const {
    if (before != nullptr && at.pitchfork == 0.0) at.pitchfork = before->pitchfork;
    for (const std::size_t k : {TestValues::fold, TestValues::momentum, TestValues::ellipse}) {
      double& value = at.functions.values.value[k];
      const double last = before != nullptr ? before->functions.values.value[k]
                                            : std::numeric_limits<double>::quiet_NaN();
      if (last * value > 0.0 || std::isnan(value)) continue;
      if (!keeps_sign(arc, k, value)) value = last;
    }
  }

  EventCurvePoint completed(const ArcPoint<N>& arc, const Signs& signs,
                            SpecialPoint special) const {
    EventPlace place = place_at(arc);
    // What is 0 at an end of the family is so within the bound of the row's own numbers.
    if (signs.functions.context.kind.end == setting_.type)
      place.error_bound = std::max(place.error_bound, arc.error_bound);
    const AnyFamily family = setting_.family(place.first, arc.p, options_.spectrum);
    EventCurvePoint out;
    out.member = member_at(family, place);
    // A turn itself is known as the curve is.
    if (special != SpecialPoint::turn && special != SpecialPoint::cusp)
      out.member.error_bound = std::max(out.member.error_bound, arc.error_bound);
    out.second = arc.p;
    out.special = special;
    if (options_.spectrum && special == SpecialPoint::none) {
      const EventSides sides = sides_of(family, place, what().turns && signs.first_speed != 0.0);
      out.before = sides.before;
      out.after = sides.after;
    }
    return out;
  }

  struct Special {
    double u;
    SpecialPoint type;
    EventType other = EventType::none;
  };

  /// Where a function of the point changes its sign on the arc, by bisection; nothing where a point
  /// between is not found. The zero itself need not be: where inertias are equal the equations of
  /// some events are singular.
  template <class Function>
  std::optional<double> zero_of(const Function& function, const ArcPoint<N>& from,
                                const Arc<N>& arc, double at_from) const {
    constexpr double near = 0x1p-30;
    const auto value_at = [&](double u) -> std::optional<double> {
      const Corrected<N> there = curve_.at(from, arc, u);
      if (there.status != CorrectorStatus::converged) return std::nullopt;
      const double value = function(there.point);
      return std::isnan(value) ? std::nullopt : std::optional(value);
    };
    double a = 0.0;
    double b = 1.0;
    for (int k = 0; k < 50 && b - a > 0x1p-44; ++k) {
      const double middle = 0.5 * (a + b);
      const std::optional<double> value = value_at(middle);
      if (!value) return b - a < near ? std::optional(a) : std::nullopt;
      ((*value < 0.0) == (at_from < 0.0) ? a : b) = middle;
    }
    const double middle = 0.5 * (a + b);
    return value_at(middle) ? middle : a;
  }

  static bool changes(double a, double b) { return a * b < 0.0; }
  static double first_speed(const ArcPoint<N>& at) {
    return at.tangent[EventCurveFamily<N>::first];
  }
  static double second_speed(const ArcPoint<N>& at) { return at.tangent[N]; }

  /// Where both speeds vanish. One of them, that across the cusp's tangent, may do so without a change of
  /// its sign: as s^3 is p across, and as s^2 along.
  std::optional<double> cusp_of(const ArcPoint<N>& from, const Signs& here, const Signs& next,
                                const Arc<N>& arc) const {
    constexpr double together = 1e-4;
    const auto both_vanish = [&](const auto& speed, double at_from, const auto& other,
                                 double other_size) -> std::optional<double> {
      const auto u = zero_of(speed, from, arc, at_from);
      if (!u) return std::nullopt;
      const Corrected<N> there = curve_.at(from, arc, *u);
      if (there.status != CorrectorStatus::converged) return std::nullopt;
      return std::abs(other(there.point)) < together * other_size ? u : std::nullopt;
    };
    if (changes(here.second_speed, next.second_speed))
      return both_vanish(second_speed, here.second_speed, first_speed,
                         std::max(std::abs(here.first_speed), std::abs(next.first_speed)));
    if (changes(here.first_speed, next.first_speed))
      return both_vanish(first_speed, here.first_speed, second_speed,
                         std::max(std::abs(here.second_speed), std::abs(next.second_speed)));
    return std::nullopt;
  }

  /// Of one step, in order.
  std::vector<Special> specials(const ArcPoint<N>& from, const Signs& here, const Signs& next,
                                const Arc<N>& arc) const {
    std::vector<Special> out;
    const auto add = [&](const std::optional<double>& u, SpecialPoint type,
                         EventType other = EventType::none) {
      if (u) out.push_back({*u, type, other});
    };
    if (what().turns) {
      if (const auto u = cusp_of(from, here, next, arc)) add(u, SpecialPoint::cusp);
    } else if (what().spectral && changes(here.second_speed, next.second_speed)) {
      add(zero_of(second_speed, from, arc, here.second_speed), SpecialPoint::turn);
    }
    if (changes(here.pitchfork, next.pitchfork)) {
      add(zero_of([this](const ArcPoint<N>& at) { return signs_at(at).pitchfork; }, from, arc,
                  here.pitchfork),
          SpecialPoint::degenerate_pitchfork);
    }
    const TestValues& before = here.functions.values;
    const TestValues& after = next.functions.values;
    for (std::size_t k = 0; k < TestValues::crossings; ++k) {
      if (before.sign(k) * after.sign(k) != -1) continue;
      // A block's pairs that are none at one end have no common function.
      if (k == TestValues::collision && before.collides_imaginary != after.collides_imaginary)
        continue;
      add(zero_of(
              [this, k](const ArcPoint<N>& at) { return signs_at(at).functions.values.value[k]; },
              from, arc, before.value[k]),
          SpecialPoint::double_event, event_type(k, here.functions.context, before));
    }
    std::ranges::sort(out, {}, &Special::u);
    return out;
  }

  EventCurvePoint special_point(const ArcPoint<N>& from, const Arc<N>& arc,
                                const Special& special) const {
    const Corrected<N> at = curve_.at(from, arc, special.u);
    EventCurvePoint out = completed(at.point, signs_at(at.point), special.type);
    out.other = special.other;
    return out;
  }

  /// Ends the curve on this arc where the family in p1 ends: beyond are no motions, though the equations
  /// hold on. Nothing where that point is not found.
  std::optional<EventCurveEnd> end_of_family(const ArcPoint<N>& from, const Signs& here,
                                             const Signs& next, const Arc<N>& arc) {
    const auto beyond = [this](const ArcPoint<N>& at) {
      return signs_at(at).beyond_end ? 1.0 : -1.0;
    };
    const auto u = zero_of(beyond, from, arc, -1.0);
    if (!u) return std::nullopt;
    for (double inside = *u; inside > 0.0; inside -= 4.0 * (*u - inside) + 0x1p-44) {
      const Corrected<N> at = curve_.at(from, arc, inside);
      if (at.status != CorrectorStatus::converged) return std::nullopt;
      const Signs signs = signs_at(at.point);
      if (signs.beyond_end) continue;
      const KindEvents& kind = next.functions.context.kind;
      for (const Special& special : specials(from, here, next, arc))
        if (special.u < inside && special.other != kind.end)
          out_.points.push_back(special_point(from, arc, special));
      EventCurvePoint last = completed(at.point, signs, SpecialPoint::double_event);
      last.other = kind.end;
      const EventCurveEnd end{kind.end, std::string(kind.end_reason(last.member))};
      out_.points.push_back(std::move(last));
      return end;
    }
    return std::nullopt;
  }

  /// p1 is followed by its logarithm, which has no end at 0: a range with 0 in it ends a little before.
  static constexpr double beside_zero = 1e-4;
  bool at_zero(double first) const {
    const double from = options_.first_from;
    const double to = options_.first_to;
    const double size = std::min(std::max(-from, to), std::abs(first_of(start_.arc)));
    return from <= 0.0 && to >= 0.0 && std::abs(first) < beside_zero * size;
  }
  EventCurveEnd end_at_zero() const {
    if (options_.first_from < 0.0 && options_.first_to > 0.0)
      return {EventType::stalled,
              "the first number comes to 0, which its logarithm does not pass: start beyond it"};
    return {EventType::limit, "the range asked for, but for a ten-thousandth of it at 0"};
  }

  /// Of a walk that has ended.
  EventCurveEnd end_of(const Continuation<N>& walk, const ArcPoint<N>& last) const {
    EventCurveEnd out{walk.end(), walk.reason()};
    constexpr double small = 1e-4;
    if (circle_ == Circle::none && out.event == EventType::stalled &&
        std::abs(log(last.x[0] / last.x[1])) < small)
      out.reason += "; xi and zeta nearly are one, where ellipses come to their circle";
    constexpr int Lambda = EventCurveFamily<N>::first + 1;
    if (what().spectral && std::abs(last.x[Lambda] / start_.arc.x[Lambda]) < small)
      out = {EventType::stalled, "the frequencies that meet come to 0"};
    return out;
  }
  bool outside(double first) const {
    return first < options_.first_from || first > options_.first_to || at_zero(first);
  }

  /// The point where p1 comes to the end of its range on the arc.
  std::optional<ArcPoint<N>> at_first_limit(const ArcPoint<N>& from, const Arc<N>& arc) const {
    const auto beyond = [this](const ArcPoint<N>& at) {
      return outside(first_of(at)) ? 1.0 : -1.0;
    };
    const auto u = zero_of(beyond, from, arc, -1.0);
    if (!u) return std::nullopt;
    const Corrected<N> at = curve_.at(from, arc, *u);
    if (at.status != CorrectorStatus::converged) return std::nullopt;
    return at.point;
  }

  /// p1 where the arc passes the p2 of the start.
  void note_crossing(const ArcPoint<N>& from, const ArcPoint<N>& to, const Arc<N>& arc) {
    if (from.p == second_) return;
    if (to.p != second_ && (from.p < second_) == (to.p < second_)) return;
    const auto u = zero_of([this](const ArcPoint<N>& at) { return at.p - second_; }, from, arc,
                           from.p - second_);
    if (!u) return;
    const Corrected<N> at = curve_.at(from, arc, *u);
    const EventPlace place = place_at(at.point);
    out_.crossings.push_back(member_at(setting_.family(place.first, at.point.p, false), place));
  }

  /// Whether short steps lead far out at one p1, whose rounding then is all that they show.
  static bool creeps(const Stretch& q, const Arc<N>& arc) {
    constexpr double short_step = 0.01;
    Arc<N> in_first = arc;
    in_first.chord[N] = arc.chord[EventCurveFamily<N>::first];
    return arc.length < short_step && is_unresolved(q, in_first, StretchWindow(1.0), 1.0, 1.0, 0.0);
  }

  EventCurveEnd one(int direction) {
    ContinuationOptions how;
    how.from = options_.second_from;
    how.to = options_.second_to;
    how.step.tolerance = options_.tolerance;
    Continuation<N> walk(curve_, start_, direction, how);
    ArcPoint<N> here = start_.arc;
    if (direction < 0) here.tangent = -here.tangent;
    Signs signs = signs_at(here);
    keep_uncertain(nullptr, signs, here);
    constexpr int longest_creep = 64;  // steps
    int creeping = 0;
    while (walk.end() == EventType::none) {
      if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
        out_.interrupted = true;
        return {EventType::none, "interrupted"};
      }
      if (static_cast<long>(out_.points.size()) >= options_.max_points)
        return {EventType::none, "as many points as were asked for"};
      if (!walk.step()) break;
      ArcPoint<N> next = walk.point().arc;
      ArcVector<N> chord;
      chord.template head<N>() = logarithms(next.x.array() / here.x.array()).matrix();
      chord[N] = (next.p - here.p) / curve_.corrector().scale();
      Arc<N> arc(chord, here.tangent, next.tangent);
      std::optional<EventCurveEnd> at_limit;
      if (outside(first_of(next))) {
        at_limit = at_zero(first_of(next)) ? end_at_zero()
                                           : EventCurveEnd{EventType::limit, "the range asked for"};
        const auto limit = at_first_limit(here, arc);
        if (!limit) return {EventType::stalled, "the end of the range was not reached"};
        next = *limit;
        chord.template head<N>() = logarithms(next.x.array() / here.x.array()).matrix();
        chord[N] = (next.p - here.p) / curve_.corrector().scale();
        arc = Arc<N>(chord, here.tangent, next.tangent);
      }
      Signs there = signs_at(next);
      keep_uncertain(&signs, there, next);
      if (there.beyond_end) {
        const auto end = end_of_family(here, signs, there, arc);
        return end ? *end
                   : EventCurveEnd{EventType::stalled, "the end of the family was not reached"};
      }
      for (const Special& special : specials(here, signs, there, arc))
        out_.points.push_back(special_point(here, arc, special));
      note_crossing(here, next, arc);
      if (walk.end() != EventType::closed)
        out_.points.push_back(completed(next, there, SpecialPoint::none));
      if (at_limit) return *at_limit;
      creeping = creeps(walk.point().member.q, arc) ? creeping + 1 : 0;
      if (creeping == longest_creep) {
        const SheetEnd end = unresolved_end(walk.point().member.q, arc, StretchWindow(1.0));
        return {end.event, end.reason};
      }
      here = next;
      signs = there;
    }
    return end_of(walk, here);
  }

  const EventCurveSetting& setting_;
  Circle circle_;
  EventCurveOptions options_;
  double second_;
  EventCurveFamily<N> family_;
  Curve<N> curve_;
  CurvePoint<N> start_;
  EventCurve out_;
};

/// Of a spin about a material axis, alpha = 0.
EventCurve follow_of_spin(const EventCurveSetting& setting, const Member& event, double second,
                          Circle circle, const EventCurveOptions& options) {
  EventCurve out;
  out.failure = "the event has no equations, or no spectrum was computed";
  for (EventCurveSystem<5>& system : spin_event_systems(setting, event, second, circle)) {
    out = Follower<5>(setting, std::move(system), second, circle, options).both();
    if (out.failure.empty()) break;
  }
  return out;
}

}  // namespace

bool has_event_curve(EventType type, bool spin, bool isotropic) {
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
    case EventType::fold_momentum:
    case EventType::tilt:
    case EventType::inertia_exchange:
    case EventType::shear:
      return true;
    case EventType::oblique:
    case EventType::hamiltonian_hopf:
    case EventType::real_collision:
    case EventType::krein_pass:
      return spin;
    case EventType::ellipse:
      return isotropic;
    case EventType::ellipse_23:
    case EventType::ellipse_13:
      return spin && isotropic;
    case EventType::zero_momentum:
      return !spin;
    default:
      return false;
  }
}

EventCurve follow_event_curve(const EventCurveSetting& setting, const Member& event, double second,
                              Circle circle, const EventCurveOptions& options) {
  // Where alpha is an unknown, by the family's own equations.
  if (setting.spin && event.q.alpha == 0.0)
    return follow_of_spin(setting, event, second, circle, options);
  const AnyFamily family = setting.family(event.parameter, second, false);
  return std::visit(
      [&]<int N>(const std::unique_ptr<Family<N>>&) {
        EventCurve out;
        out.failure = "the family has no equations for it";
        if (auto system = family_event_system<N>(setting, event, second, circle))
          out = Follower<event_dimension<N>>(setting, std::move(*system), second, circle, options)
                    .both();
        return out;
      },
      family);
}

}  // namespace stationary
