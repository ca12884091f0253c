// A walk along the curve of equilibria through the rest state,
//
//   G(x, tau) = elastic(x) - tau pull(x) = 0,   tau = nu'^2 / nu^2,   from (x_rest, 0) to tau = 1,
//
// by pseudo-arclength in y = (ln x, tau), so a turn of nu is passed and not stumbled over. It decides whether the rest
// state's sheet reaches nu. Predictor, corrector, guard and step control are the continuation's (path_step.hpp,
// bordered_newton.hpp, domain_guard.hpp). Two things differ: the tolerance, for the points on the way are no rows of a
// table, and that a step predicted to come to tau = 1 is corrected there, with tau held.
// tau and not nu: at nu = 0 the solution is smooth in nu^2.
#pragma once

#include <algorithm>
#include <atomic>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "lib/body/circle.hpp"
#include "solver/continuation/circle_part.hpp"
#include "solver/continuation/domain_guard.hpp"
#include "solver/continuation/path_step.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

enum class WalkEnd {
  reached,      ///< x lies on the rest sheet at tau = 1
  escaped,      ///< a stretch left [min_stretch, max_stretch]
  turned_back,  ///< the sheet came back to nu = 0
  at_border,    ///< the domain of the potential ends
  stuck,        ///< the step became too small
  too_long,     ///< max_steps
  interrupted
};

struct WalkOptions {
  /// tolerance: how far the path may be from what was predicted, in y.
  StepOptions step{.tolerance = 0.01, .first = 1.5, .max = 1.5, .min = 1e-9, .growth = 3.0};
  int max_steps = 5000;
  double min_stretch = 1e-8;
  double max_stretch = 1e8;
  Circle circle = Circle::none;  ///< that the body may be; xi = zeta is seen by itself
};

template <int N>
struct WalkResult {
  WalkEnd end = WalkEnd::stuck;
  ReducedVector<N> x;        ///< last point (at tau = 1 if reached)
  double largest_tau = 0.0;  ///< how far in nu^2 the sheet went
  int steps = 0;
  int linearizations = 0;
  const expression::TapeCondition* border = nullptr;  ///< what does not hold beyond it
};

template <class System>
class RestWalk {
 public:
  static constexpr int N = System::dimension;

  /// system: at the target nu. rest: the rest state, refined.
  RestWalk(const System& system, const ReducedVector<N>& rest, const WalkOptions& options)
      : system_(system),
        options_(options),
        circle_(mirror_symmetric(system, rest)      ? Circle::xi_zeta
                : options.circle == Circle::xi_zeta ? Circle::none
                                                    : options.circle),
        step_(options.step),
        guard_([this](const ReducedVector<N>& x, double) { return system_conditions(system_, x); },
               1.0) {
    here_.x = rest;
    out_.x = rest;
  }
  RestWalk(const RestWalk&) = delete;
  RestWalk& operator=(const RestWalk&) = delete;

  WalkResult<N> run(const std::atomic<bool>* stop) {
    if (!leave_rest()) return out_;
    while (out_.steps < options_.max_steps) {
      if (stop != nullptr && stop->load(std::memory_order_relaxed)) {
        out_.end = WalkEnd::interrupted;
        return out_;
      }
      if (step_.too_short()) {
        out_.border = border_ahead();
        if (out_.border != nullptr) out_.end = WalkEnd::at_border;
        return out_;
      }
      if (step_to_end()) return out_;
      Attempt attempt;
      if (!try_step(attempt)) continue;
      const std::optional<Turn> turn = turn_in(attempt);
      if (turn) out_.largest_tau = std::max(out_.largest_tau, turn->tau);
      if (passes_end(attempt, turn)) {
        if (out_.end == WalkEnd::reached) return out_;
        step_.refuse("tau = 1 was passed, but the point there not found");
        continue;
      }
      settle(attempt);
      // Where stretches escape while nu falls to 0, tau is rounding.
      const double least = turn ? std::min(turn->tau, here_.tau) : here_.tau;
      if (least < -1e-9 * out_.largest_tau) {
        out_.end = WalkEnd::turned_back;
        return out_;
      }
      if (here_.x.minCoeff() < options_.min_stretch || here_.x.maxCoeff() > options_.max_stretch) {
        out_.end = WalkEnd::escaped;
        return out_;
      }
    }
    out_.end = WalkEnd::too_long;
    return out_;
  }

 private:
  using Y = ArcVector<N>;

  struct Point {
    ReducedVector<N> x;
    double tau = 0.0;
    Y tangent;
    bool positive = true;  ///< see ArcPoint
  };
  struct Attempt {
    Point point;
    Arc<N> arc;
    double length = 0.0;  ///< of what was predicted
    double first_correction = 0.0;
    double D = 0.0;  ///< fourth derivative shown
    CorrectorStatus status = CorrectorStatus::not_finite;
  };
  struct Linearization {
    ReducedVector<N> g;
    Eigen::Matrix<double, N, N> jacobian;
    ReducedVector<N> slope;  ///< dG/dtau
  };

  /// A circle xi = zeta stays one where both pulls are equal: then rounding must not break it.
  static bool mirror_symmetric(const System& system, const ReducedVector<N>& rest) {
    return system.rates.xi == system.rates.zeta && rest[0] == rest[1];
  }

  static Y along_tau() {
    Y out = Y::Zero();
    out[N] = 1.0;
    return out;
  }

  Linearization linearize(const Point& p) {
    ++out_.linearizations;
    const Linearized<N> at = system_.at_fraction(p.tau).linearize(p.x);
    Linearization out{at.g, at.jacobian.matrix(), system_.minus_pull(p.x)};
    keep_to_circle<N>(circle_, out, false, at.magnitude);
    return out;
  }

  /// Tangent and sign of the determinant, from the bordered matrix beside p.
  void orient(Point& p, const BorderedInverse<N>& inverse) const {
    p.tangent = inverse.kernel();
    make_equal(circle_, p.tangent);
    p.tangent.normalize();
    p.positive = inverse.positive();
  }

  bool leave_rest() {
    const Linearization at = linearize(here_);
    orient(here_, BorderedInverse<N>(at.jacobian, at.slope, along_tau()));
    guard_.enter(here_.x, 0.0);
    return here_.tangent.allFinite();
  }

  /// The point of the curve in the plane across the border, from that predicted `ahead` of here, along a path this long.
  Attempt corrected(const Y& ahead, const Y& border, double length) {
    Attempt out;
    out.length = length;
    Point& next = out.point;
    next.x = moved<N>(here_.x, ReducedVector<N>(ahead.template head<N>()));
    next.tau = here_.tau + ahead[N];
    Y chord = ahead;
    const NewtonCourse<N> course = bordered_newton<N>(
        border, step_.longest_correction(length), [&] { return linearize(next); },
        [&](Y delta) {
          make_equal(circle_, delta);
          next.x = moved<N>(next.x, ReducedVector<N>(delta.template head<N>()));
          next.tau += delta[N];
          chord += delta;
        });
    out.status = course.status;
    out.first_correction = course.first_correction;
    if (course.status != CorrectorStatus::converged) return out;
    orient(next, course.last);
    out.arc = Arc<N>(chord, here_.tangent, next.tangent);
    return out;
  }

  /// Whether nothing observed says that it led elsewhere.
  bool accepts(const Attempt& attempt) const {
    return attempt.status == CorrectorStatus::converged && step_.straight(attempt.arc.turned) &&
           same_sheet(here_.positive, attempt.point.positive) &&
           guard_.broken_on(attempt.arc) == nullptr;
  }

  /// Whether the path between here and there is what was predicted, by the fourth derivative shown: of the first step by
  /// its middle, of the others by the first correction.
  bool bends_little(Attempt& attempt) {
    if (step_.has_arc()) {
      attempt.D = step_.shown(attempt.first_correction, attempt.length, [] { return 0.0; });
    } else {
      const Attempt middle = on_arc(attempt.arc, 0.5);
      if (!accepts(middle)) return false;
      attempt.D = StepControl::fourth_derivative_in_middle(middle.first_correction, attempt.length);
    }
    return step_.fits(attempt.D, attempt.length);
  }

  bool try_step(Attempt& out) {
    const double h = step_.length();
    out = corrected(step_.ahead(here_.tangent, h), here_.tangent, h);
    if (!accepts(out)) return step_.refuse("led elsewhere");
    return bends_little(out) || step_.refuse_bend(out.D);
  }

  void settle(const Attempt& attempt) {
    ++out_.steps;
    here_ = attempt.point;
    guard_.enter(here_.x, here_.tau);
    step_.take(attempt.arc);
    step_.lengthen(attempt.D, attempt.arc.turned);
    out_.x = here_.x;
    out_.largest_tau = std::max(out_.largest_tau, here_.tau);
  }

  /// Corrected once more, to rounding, with tau held: whoever solves from there has less to do. Not beside a turn of tau.
  ReducedVector<N> sharpened(const Point& p) {
    const Linearization at = linearize(p);
    Y delta = BorderedInverse<N>(at.jacobian, at.slope, along_tau()).correction(at.g);
    if (!(delta.norm() <= last_correction)) return p.x;
    make_equal(circle_, delta);
    return moved<N>(p.x, ReducedVector<N>(delta.template head<N>()));
  }

  bool reach(const Attempt& attempt) {
    if (!(std::abs(attempt.point.tau - 1.0) <= 1e-9)) return false;
    ++out_.steps;
    out_.x = sharpened(attempt.point);
    out_.largest_tau = 1.0;
    out_.end = WalkEnd::reached;
    return true;
  }

  /// To where the next step is predicted to pass tau = 1, if it does. Where that is refused, as beside a turn of tau, a
  /// step like any other is taken.
  bool step_to_end() {
    const double left = 1.0 - here_.tau;
    double s = step_.length();
    Y ahead = step_.ahead(here_.tangent, s);
    if (!(ahead[N] >= left)) return false;
    for (int k = 0; k < 3; ++k) {  // the corrector does the rest
      s = std::min(s * left / ahead[N], step_.length());
      if (!(s > 0.0)) return false;
      ahead = step_.ahead(here_.tangent, s);
    }
    ahead[N] = left;
    Attempt attempt = corrected(ahead, along_tau(), s);
    return accepts(attempt) && bends_little(attempt) && reach(attempt);
  }

  /// Where tau turns inside a step, at a fraction u of its arc.
  struct Turn {
    double u;
    double tau;
  };
  /// Nothing where it does not, or not far enough to matter: to fall again from more than rounding above the ends, or to
  /// rise again from below 0.
  std::optional<Turn> turn_in(const Attempt& step) {
    const double from = here_.tangent[N];
    const double to = step.point.tangent[N];
    if (!(from * to < 0.0)) return std::nullopt;
    const double beyond_ends = step.arc.length * std::min(std::abs(from), std::abs(to));
    const double lower_end = std::min(here_.tau, step.point.tau);
    if (from > 0.0 ? beyond_ends <= 0x1p-50 * here_.tau : beyond_ends < lower_end)
      return std::nullopt;
    const double u = root_on(step.arc, 1.0, [](const Point& p) { return p.tangent[N]; });
    const Attempt at = on_arc(step.arc, u);
    if (!accepts(at)) return std::nullopt;
    return Turn{u, at.point.tau};
  }

  /// Whether the step passes tau = 1, also by turning just above it. Then the walk ends there, if the point is found.
  bool passes_end(const Attempt& step, const std::optional<Turn>& turn) {
    double far = 1.0;
    if (step.point.tau < 1.0) {
      if (!turn || turn->tau < 1.0) return false;
      far = turn->u;
    }
    const double u = root_on(step.arc, far, [](const Point& p) { return p.tau - 1.0; });
    const Attempt end = on_arc(step.arc, u);
    if (accepts(end)) reach(end);
    return true;
  }

  /// The point of the curve beside a fraction u of the arc of a step.
  Attempt on_arc(const Arc<N>& arc, double u) {
    return corrected(arc.at(u), arc.direction(u), arc.length);
  }

  /// The fraction u in [0, far] of the arc where f(point there) changes sign (it does between the ends).
  template <class F>
  double root_on(const Arc<N>& arc, double far, F f) {
    const auto value = [&](double u) {
      const Attempt at = on_arc(arc, u);
      return f(accepts(at) ? at.point : here_);
    };
    const double from = f(here_);
    const double to = value(far);
    if (from == 0.0) return 0.0;
    if (!(from * to < 0.0)) return far;
    std::uintmax_t evaluations = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        value, 0.0, far, from, to, boost::math::tools::eps_tolerance<double>(52), evaluations);
    return 0.5 * (bracket.first + bracket.second);
  }

  /// The condition that does not hold a little ahead of where the walk is stuck.
  const expression::TapeCondition* border_ahead() const {
    for (double reach = options_.step.min; reach < 1e-3; reach *= 4.0)
      if (const auto* broken = guard_.broken_along(here_.tangent, reach)) return broken;
    return nullptr;
  }

  System system_;
  WalkOptions options_;
  Circle circle_;
  PathStep<N> step_;
  DomainGuard<N> guard_;
  Point here_;
  WalkResult<N> out_;
};

}  // namespace stationary
