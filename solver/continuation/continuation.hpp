// Pseudo-arclength continuation of a family from a point, in one direction:
//
//   corrector      bordered Newton, then extended precision (corrector.hpp)
//   step           predicted, guarded, and made longer or shorter (path_step.hpp)
//   events         between the last two points (event_search.hpp)
//
// step() advances one point; whoever calls it writes, reports and stops. A step is taken back and
// halved where anything the corrector observed could be a jump to another sheet (jump_guard.hpp), or
// the tangent turned too far.
#pragma once

#include <exception>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/border_end.hpp"
#include "solver/continuation/domain_guard.hpp"
#include "solver/continuation/ellipse_end.hpp"
#include "solver/continuation/event_search.hpp"
#include "solver/continuation/path_step.hpp"
#include "solver/continuation/range_limit.hpp"
#include "solver/continuation/sheet_end.hpp"

namespace stationary {

struct ContinuationOptions {
  double from = 0.0;  ///< range of the parameter, from <= to
  double to = 1.0;
  StepOptions step;
  double min_stretch = 1e-6;  ///< a sheet ends (collapse, escape) where a stretch leaves these,
  double max_stretch = 1e6;   ///< wider where the body's own stretch is beyond 1
  double unit = 1.0;          ///< that stretch, at rest
};

struct ContinuationCounts {
  long steps = 0;
  long rejected = 0;        ///< steps taken back
  long linearizations = 0;  ///< of G, the extended-precision corrections' not counted
  long members = 0;         ///< points completed, those of event searches included

  ContinuationCounts& operator+=(const ContinuationCounts& other) {
    steps += other.steps;
    rejected += other.rejected;
    linearizations += other.linearizations;
    members += other.members;
    return *this;
  }
};

template <int N>
class Continuation {
 public:
  /// start: a completed point of the curve. direction: +1 along its tangent, -1 against.
  Continuation(const Curve<N>& curve, const CurvePoint<N>& start, int direction,
               const ContinuationOptions& options)
      : curve_(&curve),
        options_(options),
        step_(options.step),
        events_in_(curve),
        guard_(curve),
        start_(start),
        here_(start),
        window_(options.unit) {
    if (direction < 0) reverse(here_);
    start_ = here_;
    guard_.enter(here_.arc);
    travelled_.setZero();
    if (leaves_range(here_)) finish(EventType::limit, "the start is at the end of the range");
  }

  /// Advances to the next point. False where the sheet has ended: before, or in a failure (end()
  /// and reason()). The step that reaches an end returns true and sets end().
  bool step() {
    events_.clear();
    unlocated_.clear();
    if (end_.event != EventType::none) return false;
    for (;;) {
      if (step_.too_short()) {
        finish(EventType::stalled, "the step became too small: " + step_.refusal());
        return false;
      }
      try {
        keep_axis_in_range();
        Attempt attempt;
        if (try_step(attempt)) {
          accept(attempt);
          return !ended_before_step_;
        }
      } catch (const std::exception& error) {  // a failed step like any other
        step_.refuse(error.what());
      }
      ++counts_.rejected;
      constexpr double near_border = 1e-6;
      if (step_.length() < near_border && end_at_border(4.0 * step_.length())) return true;
      if (end_.event != EventType::none) return false;
    }
  }

  const CurvePoint<N>& point() const { return here_; }
  /// Whether its axis, and that of the events, is written as the opposite of what has turned
  /// continuously from the start.
  bool has_opposite_axis() const { return opposite_axis_; }
  /// Those between the last point and this one, in order.
  std::span<const Event> events() const { return events_; }
  /// Those known from this point to lie somewhere before it (EventStatus::unresolved).
  std::span<const Event> unlocated() const { return unlocated_; }
  EventType end() const { return end_.event; }
  const std::string& reason() const { return end_.reason; }
  ContinuationCounts counts() const {
    ContinuationCounts out = counts_;
    out.members += events_in_.evaluations();
    return out;
  }

 private:
  struct Attempt {
    Corrected<N> corrected;
    Arc<N> arc;
    double D = 0.0;        ///< fourth derivative shown
    bool mirrors = false;  ///< a sheet of ellipses passes through its circle
  };

  void reverse(CurvePoint<N>& point) const {
    point.arc.tangent = -point.arc.tangent;
    point.arc.positive = !point.arc.positive;
    // Those that follow the tangent; the cofactors' do not.
    if (!curve_->family().along_nu()) return;
    point.tests.value[TestValues::fold] *= -1.0;
    point.tests.value[TestValues::momentum] *= -1.0;
  }

  /// One predictor-corrector step from here_. Where it is refused the next is shorter.
  bool try_step(Attempt& out) {
    const double h = step_.length();
    const ArcVector<N> ahead = step_.ahead(here_.arc.tangent, h);
    out.corrected = corrected_from(ahead, ResidualIn::doubles);
    counts_.linearizations += out.corrected.linearizations;
    if (out.corrected.status != CorrectorStatus::converged)
      return step_.refuse(std::string(name(out.corrected.status)));
    const ArcPoint<N>& next = out.corrected.point;
    out.arc = Arc<N>(ahead + out.corrected.correction, here_.arc.tangent, next.tangent);
    if (!step_.straight(out.arc.turned)) return step_.refuse("the tangent turned too far");
    if (const auto* broken = guard_.broken_on(out.arc))
      return step_.refuse("beyond the domain of the potential: " + broken->text);
    out.mirrors = crosses_mirror(next);
    if (!same_sheet(here_.arc.positive, next.positive) && !out.mirrors)
      return step_.refuse(
          "the bordered determinant changed sign: another sheet, or a branch point");
    if (step_.has_arc()) {
      const auto rounding = [&] { return curve_->corrector().correction_rounding(next); };
      double correction = out.corrected.first_correction;
      // Where that is G's rounding rather than the curve's bend, G is had without it.
      if (step_.is_coarse(correction, h) && rounding() > 0.1 * correction) {
        const Corrected<N> again = corrected_from(ahead, ResidualIn::pairs);
        counts_.linearizations += again.linearizations;
        if (again.status == CorrectorStatus::converged) correction = again.first_correction;
      }
      out.D = step_.shown(correction, h, rounding);
    } else {
      // The first step shows no fourth derivative: its middle does, against the cubic.
      const Corrected<N> middle = curve_->at(here_.arc, out.arc, 0.5);
      counts_.linearizations += middle.linearizations;
      if (middle.status != CorrectorStatus::converged)
        return step_.refuse(std::string(name(middle.status)));
      out.D = StepControl::fourth_derivative_in_middle(middle.first_correction, h);
    }
    return step_.fits(out.D, h) || step_.refuse_bend(out.D);
  }

  /// The point that is predicted so far ahead, corrected.
  Corrected<N> corrected_from(const ArcVector<N>& ahead, ResidualIn residual) const {
    return curve_->corrector().correct(
        moved<N>(here_.arc.x, ReducedVector<N>(ahead.template head<N>())),
        here_.arc.p + curve_->corrector().scale() * ahead[N], here_.arc.tangent,
        step_.longest_correction(step_.length()), residual);
  }

  void accept(Attempt& attempt) {
    if (!resolves(attempt.corrected.point)) {
      end_unresolved(attempt.arc);
      return;
    }
    CurvePoint<N> next = completed(attempt.corrected.point);
    ++counts_.steps;
    if (const auto k = curve_->family().mirrored(); attempt.mirrors && k) {
      end_at_mirror(attempt, *k);
      return;
    }
    if (attempt.mirrors) {
      end_at_circle(attempt, next);
      return;
    }
    find_events(next, attempt.arc);
    if (const auto limit = passed_limit(options_.from, options_.to, next, attempt.arc, events())) {
      if (limit->p == 0.0 && end_at_rest(attempt)) return;
      if (!stop_at(*limit, attempt)) return;
      next = here_next_;
      find_events(next, attempt.arc);
      if (ends_family(next, attempt)) return;
      settle(next, attempt.arc);
      finish(EventType::limit, "the range asked for");
      return;
    }
    if (ends_family(next, attempt)) return;
    const double h = step_.length();
    settle(next, attempt.arc);
    step_.lengthen(attempt.D, attempt.arc.turned);
    end_if_closed(h);
    if (end_.event == EventType::none) end_if_out_of_bounds();
  }

  /// An axis that turns on leaves the range of its angle: before that it is written as its opposite.
  void keep_axis_in_range() {
    const auto x = curve_->family().with_opposite_axis(here_.arc.x);
    if (!x) return;
    const Corrected<N> same = curve_->corrector().correct_at(*x, here_.arc.p, here_.arc.tangent);
    if (same.status != CorrectorStatus::converged) return;
    travelled_.template head<N>() +=
        logarithms(same.point.x.array() / here_.arc.x.array()).matrix();
    here_ = completed(same.point);
    guard_.enter(here_.arc);
    step_.forget_arc();
    opposite_axis_ = !opposite_axis_;
  }

  CurvePoint<N> completed(const ArcPoint<N>& arc) {
    ++counts_.members;
    return curve_->complete(arc);
  }

  void find_events(const CurvePoint<N>& next, const Arc<N>& arc) {
    events_ = events_in_.run(here_, next, arc, step_.has_arc() ? &earlier_tests_ : nullptr,
                             step_.arc().length, !begun_);
    unlocated_ = events_in_.unresolved();
  }

  /// Those of the step before its end where gap(x) of the stretches is 0, as near to it as the signs of
  /// functions are certain: there the curve meets another, and they vanish or say nothing.
  template <class Gap>
  void find_events_before(const Gap& gap, const Attempt& attempt) {
    const auto f = [&](double u) { return gap(curve_->at(here_.arc, attempt.arc, u).point.x); };
    std::uintmax_t evaluations = 30;
    const auto close = [](double low, double high) { return high - low <= 0x1p-20; };
    const auto [low, high] = boost::math::tools::toms748_solve(
        f, 0.0, 1.0, gap(here_.arc.x), gap(attempt.corrected.point.x), close, evaluations);
    std::optional<CurvePoint<N>> last;
    double reached = 0.0;
    // What the rates of two equal momenta are made of is 0/0 at the circle.
    const double nearest = curve_->context().kind.circle_on_own_leaf ? 0.1 : 1e-6;
    for (double left = 0.1; left >= nearest; left *= 0.1) {
      const double u = (1.0 - left) * low;
      const Corrected<N> at = curve_->at(here_.arc, attempt.arc, u);
      const bool before = (gap(at.point.x) > 0.0) == (gap(here_.arc.x) > 0.0);
      if (at.status != CorrectorStatus::converged || !before) break;
      CurvePoint<N> next = completed(at.point);
      if (last && SignBits::of(next.tests).open() != SignBits::of(last->tests).open()) break;
      last = std::move(next);
      reached = u;
    }
    if (!last) return;
    find_events(*last, Arc<N>(attempt.arc.at(reached), here_.arc.tangent, last->arc.tangent));
  }

  void settle(const CurvePoint<N>& next, const Arc<N>& arc) {
    events_in_.settle();
    begun_ = true;
    earlier_tests_ = here_.tests;
    here_ = next;
    guard_.enter(here_.arc);
    step_.take(arc);
    travelled_ += arc.chord;
    farthest_ = std::max(farthest_, travelled_.norm());
  }

  // Ends.

  void finish(EventType end, std::string reason) { end_ = {end, std::move(reason)}; }
  void finish(SheetEnd end) { end_ = std::move(end); }

  bool leaves_range(const CurvePoint<N>& at) const {
    const double ahead = at.arc.tangent[N];
    return (at.arc.p <= options_.from && ahead < 0.0) || (at.arc.p >= options_.to && ahead > 0.0);
  }

  /// Ends it at p = 0, of a family whose balance is singular there. False: it is not, or the point
  /// was not found.
  bool end_at_rest(const Attempt& attempt) {
    const double u = here_.arc.p / (here_.arc.p - attempt.corrected.point.p);
    const ArcVector<N> y = attempt.arc.at(u);
    const auto at =
        curve_->family().rest_point(moved<N>(here_.arc.x, ReducedVector<N>(y.template head<N>())));
    if (!at) return false;
    std::erase_if(events_, [&](const Event& event) {  // those of the mirror image beyond
      return event.member.parameter * here_.arc.p <= 0.0;
    });
    here_.member = *at;
    here_.arc.p = 0.0;
    finish(EventType::limit, "the range asked for");
    return true;
  }

  /// Ends the attempt at the limit instead. False: the point there was not found.
  bool stop_at(const RangeLimit& limit, Attempt& attempt) {
    const auto [at, arc] = at_limit(*curve_, here_.arc, attempt.arc, limit);
    if (at.status != CorrectorStatus::converged) {
      finish(EventType::stalled,
             "the end of the range was not reached: " + std::string(name(at.status)));
      return false;
    }
    here_next_ = completed(at.point);
    attempt.arc = arc;
    return true;
  }

  /// Ends a family that has an end of its own inside the step: at the event located there, if the
  /// point beyond is none of the family.
  bool ends_family(const CurvePoint<N>& next, Attempt& attempt) {
    const KindEvents& kind = curve_->context().kind;
    if (kind.end == EventType::none) return false;
    const auto at = std::ranges::find(events_, kind.end, &Event::type);
    if (at == events_.end() && !next.member.beyond_end()) return false;
    const Member end = at == events_.end() ? here_.member : at->member;
    std::string reason(kind.end_reason(end));
    if (at == events_.end()) {  // it was there at the start
      finish(kind.end, std::move(reason));
      return true;
    }
    const ReducedVector<N> x = curve_->family().coordinates(end.q, end.parameter);
    const Corrected<N> corrected = curve_->corrector().correct_at(x, end.parameter, attempt.arc.to);
    if (corrected.status == CorrectorStatus::converged) {
      ArcVector<N> chord;
      chord.template head<N>() = logarithms(x.array() / here_.arc.x.array()).matrix();
      chord[N] = (end.parameter - here_.arc.p) / curve_->corrector().scale();
      attempt.arc = Arc<N>(chord, here_.arc.tangent, corrected.point.tangent);
      CurvePoint<N> last = completed(corrected.point);
      last.member.spectrum.reset();    // a pair is zero there, and of no sign
      find_events(last, attempt.arc);  // once more, of what is left of the step
      if (!unlocated_.empty() && stops_short(attempt.arc)) return true;
      settle(last, attempt.arc);
    }
    finish(kind.end, std::move(reason));
    std::erase_if(events_, [&](const Event& event) { return event.type == kind.end; });
    here_.member = end;
    return true;
  }

  /// Where an event before the family's end is not located, for want of a sign at the end: first takes a step of
  /// 31/32 of the way, at whose end the class before the family's end is told. False: that was done before, or
  /// the point was not found.
  bool stops_short(const Arc<N>& arc) {
    constexpr double part = 31.0 / 32.0;
    if (std::exchange(stopped_short_, true)) return false;
    const Corrected<N> at = curve_->at(here_.arc, arc, part);
    if (at.status != CorrectorStatus::converged) return false;
    const CurvePoint<N> next = completed(at.point);
    const Arc<N> way(arc.at(part), here_.arc.tangent, at.point.tangent);
    find_events(next, way);
    settle(next, way);
    return true;
  }

  /// Ends the sheet where the domain of the potential ends within `reach`: at the last point of the
  /// curve inside. False where it does not end there, and at the point reached already.
  bool end_at_border(double reach) {
    const auto border = border_within(*curve_, guard_, here_.arc, reach);
    if (!border) return false;
    finish(EventType::domain, "the domain of the potential ends: " + border->broken->text);
    if (border->inside == 0.0) {
      here_.member.error_bound += border->outside;
      return false;
    }
    CurvePoint<N> next = completed(border->corrected.point);
    next.member.error_bound += border->outside - border->inside;
    events_.clear();
    settle(next, border->arc);
    return true;
  }

  void end_if_closed(double h) {
    if (counts_.steps < 4 || farthest_ < 4.0 * h || travelled_.norm() > h) return;
    if (here_.arc.tangent.dot(start_.arc.tangent) < 0.9) return;
    // Not past the start yet: one more step.
    if (travelled_.dot(start_.arc.tangent) < 0.0) return;
    // What the last step has met beyond the start the first one has met already.
    std::erase_if(events_, [this](const Event& each) {
      return (each.member.parameter - start_.member.parameter) * start_.arc.tangent[N] > 0.0;
    });
    here_ = start_;
    finish(EventType::closed, "the sheet is closed: back at the start");
  }

  void end_if_out_of_bounds() {
    const Arc<N>& arc = step_.arc();
    if (auto end = end_out_of_bounds(here_.member.q, arc, window_, options_.min_stretch,
                                     options_.max_stretch)) {
      finish(std::move(*end));
      return;
    }
    const Corrector<N>& corrector = curve_->corrector();
    if (corrector.vertical() || options_.from == options_.to) return;
    if (is_unresolved(here_.member.q, arc, window_, corrector.scale(), here_.arc.p,
                      here_.arc.error_bound))
      finish(unresolved_end(here_.member.q, arc, window_));
  }

  /// Whether a bound of x at the point's p was found.
  static bool resolves(const ArcPoint<N>& point) { return std::isfinite(point.error_bound); }

  /// Ends the sheet at the last point: the next is none of a known p.
  void end_unresolved(const Arc<N>& arc) {
    ended_before_step_ = true;
    finish(unresolved_end(here_.member.q, arc, window_));
  }

  /// A sheet of ellipses that reaches the circle its family may be (xi = zeta, say) meets it there
  /// and goes on as its own mirror image.
  /// One with alpha != 0 of an even V likewise meets alpha = 0.
  bool crosses_mirror(const ArcPoint<N>& next) const {
    const TestContext& context = curve_->context();
    if (const auto k = curve_->family().mirrored())
      return (here_.arc.x[*k] < 1.0) != (next.x[*k] < 1.0);
    const Circle circle = curve_->family().circle();
    if (context.circle != Circle::none || circle == Circle::none) return false;
    const auto [a, b, c] = places(circle);
    return (here_.arc.x[a] < here_.arc.x[b]) != (next.x[a] < next.x[b]);
  }

  void end_at_mirror(const Attempt& attempt, int k) {
    const double gap = log(here_.arc.x[k]);
    find_events_before([&](const ReducedVector<N>& x) { return log(x[k]); }, attempt);
    const ArcVector<N> y = attempt.arc.at(gap / (gap - log(attempt.corrected.point.x[k])));
    const auto at =
        curve_->family().mirror_point(moved<N>(here_.arc.x, ReducedVector<N>(y.template head<N>())),
                                      here_.arc.p + curve_->corrector().scale() * y[N]);
    if (!at) {
      finish(EventType::stalled, "alpha = 0 was passed, but the point there not found");
      return;
    }
    here_.member = *at;
    here_.arc.p = at->parameter;
    const KindEvents& kind = curve_->context().kind;
    finish(kind.mirror, std::string(kind.mirror_reason));
  }

  void end_at_circle(const Attempt& attempt, const CurvePoint<N>& next) {
    const auto [first, second, other] = places(curve_->family().circle());
    find_events_before(
        [a = first, b = second](const ReducedVector<N>& x) { return log(x[a] / x[b]); }, attempt);
    if (const auto at = curve_->family().circle_point(next.arc.x)) {
      here_.member = *at;
      here_.member.spectrum.reset();
      here_.arc.p = at->parameter;
      finish(EventType::ellipse, "the momenta are equal: the ellipses have come to the circle");
      return;
    }
    const auto circle = circle_within(*curve_, here_, next, attempt.arc);
    if (!circle) {
      finish(EventType::stalled, "a circle was passed, but its own point not found");
      return;
    }
    here_ = *circle;
    if (curve_->context().kind.circle_on_own_leaf) here_.member.spectrum.reset();
    finish(ellipse_event(curve_->family().circle()),
           "the ellipses meet the circle here and go on as mirror images");
  }

  const Curve<N>* curve_;
  ContinuationOptions options_;
  PathStep<N> step_;
  EventSearch<N> events_in_;
  DomainGuard<N> guard_;
  CurvePoint<N> start_;
  CurvePoint<N> here_;
  StretchWindow window_;  ///< for where the sheet ends
  CurvePoint<N> here_next_;
  TestValues earlier_tests_{};
  ArcVector<N> travelled_;
  double farthest_ = 0.0;
  std::vector<Event> events_;
  std::vector<Event> unlocated_;
  SheetEnd end_;
  bool begun_ = false;  ///< a step has been taken
  bool ended_before_step_ = false;
  bool stopped_short_ = false;  ///< before the family's own end
  bool opposite_axis_ = false;
  ContinuationCounts counts_;
};

}  // namespace stationary
