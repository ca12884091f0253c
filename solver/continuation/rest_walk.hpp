// A walk along the curve of equilibria through the rest state,
//
//   G(x, tau) = elastic(x) - tau pull(x) = 0,   tau = nu'^2 / nu^2,   from (x_rest, 0) to tau = 1,
//
// by pseudo-arclength in (ln x, tau): tangent predictor, bordered Newton corrector, so a turn of nu
// is passed and not stumbled over. It decides whether the rest state's sheet reaches nu. Steps are
// bounded by what the corrector observed (angle between tangents, size and contraction of the
// corrections, sign of the bordered determinant), which is what keeps it from jumping to a
// neighbouring sheet.
// tau and not nu: at nu = 0 the solution is smooth in nu^2.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/body/circle.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/jump_guard.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

enum class WalkEnd {
  reached,      ///< x lies on the rest sheet at tau = 1
  escaped,      ///< a stretch left [1e-8, 1e8]
  turned_back,  ///< the sheet came back to nu = 0
  at_border,    ///< the domain of the potential ends
  stuck,        ///< the step became too small
  too_long,     ///< max_steps
  interrupted
};

struct WalkOptions {
  double first_step = 0.05;
  double max_step = 0.5;  ///< arclength in (ln x, tau)
  double min_step = 1e-9;
  double max_angle = 0.2;  ///< radians between successive tangents
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
                                                    : options.circle) {
    here_.x = rest;
    here_.tau = 0.0;
  }

  WalkResult<N> run(const std::atomic<bool>* stop) {
    WalkResult<N> out;
    out.x = here_.x;
    Tangent forward = Tangent::Zero();
    forward[N] = 1.0;
    if (!orient(here_, forward)) return out;
    double step = options_.first_step;
    while (out.steps < options_.max_steps) {
      if (stop != nullptr && stop->load(std::memory_order_relaxed)) {
        out.end = WalkEnd::interrupted;
        return out;
      }
      Point next;
      double angle = 0.0;
      if (!advance(step, next, &angle)) {
        step *= 0.5;
        if (step >= options_.min_step) continue;
        out.border = border_ahead();
        if (out.border != nullptr) out.end = WalkEnd::at_border;
        return out;
      }
      ++out.steps;
      if (arrives(step, next, out)) return out;
      here_ = next;
      out.x = here_.x;
      out.largest_tau = std::max(out.largest_tau, here_.tau);
      if (here_.tau < 0.0) {
        out.end = WalkEnd::turned_back;
        return out;
      }
      if (here_.x.minCoeff() < options_.min_stretch || here_.x.maxCoeff() > options_.max_stretch) {
        out.end = WalkEnd::escaped;
        return out;
      }
      const double growth = 0.7 * options_.max_angle / std::max(angle, 1e-12);
      step = std::min(options_.max_step, step * std::clamp(growth, 0.5, 2.0));
    }
    out.end = WalkEnd::too_long;
    return out;
  }

 private:
  using Tangent = Eigen::Matrix<double, N + 1, 1>;
  using Bordered = Eigen::Matrix<double, N + 1, N + 1>;

  struct Point {
    ReducedVector<N> x;
    double tau = 0.0;
    Tangent tangent;
    bool positive = true;  ///< det of bordered() with the tangent: one sign all along a sheet
  };

  /// A circle xi = zeta stays one where both pulls are equal: then rounding must not break it.
  static bool mirror_symmetric(const System& system, const ReducedVector<N>& rest) {
    return system.rates.xi == system.rates.zeta && rest[0] == rest[1];
  }

  void symmetrize(ReducedVector<N>& x) const {
    if (circle_ == Circle::none) return;
    const auto [a, b, other] = places(circle_);
    x[a] = x[b] = 0.5 * (x[a] + x[b]);
  }

  /// [ J      dG/dtau ]
  /// [ border^T       ]   nonsingular at a simple turn of tau
  Bordered bordered(const Linearized<N>& at, const ReducedVector<N>& x,
                    const Tangent& border) const {
    Bordered A;
    A.template topLeftCorner<N, N>() = at.jacobian.matrix() / at.magnitude;
    A.template topRightCorner<N, 1>() = system_.minus_pull(x) / at.magnitude;
    A.row(N) = border.transpose();
    // Where ellipses branch off the circle J is singular along the difference of its two stretches,
    // which a symmetric walk has no part in: any stiffness may be added there.
    if (circle_ != Circle::none) {
      const auto [a, b, other] = places(circle_);
      A(a, a) += 1.0;
      A(b, b) += 1.0;
      A(a, b) -= 1.0;
      A(b, a) -= 1.0;
    }
    return A;
  }

  /// Tangent at p, on the side of `ahead`, and the sign of the determinant.
  bool orient(Point& p, const Tangent& ahead) const {
    const Linearized<N> at = system_.at_fraction(p.tau).linearize(p.x);
    Tangent unit = Tangent::Zero();
    unit[N] = 1.0;
    const auto lu = bordered(at, p.x, ahead).partialPivLu();
    p.tangent = lu.solve(unit);
    p.tangent.normalize();
    p.positive = lu.determinant() > 0.0;
    return p.tangent.allFinite();
  }

  /// One predictor-corrector step of length `step` from here_. False where anything observed says
  /// the step was too long.
  bool advance(double step, Point& next, double* angle) const {
    next.x = moved<N>(here_.x, ReducedVector<N>(step * here_.tangent.template head<N>()));
    next.tau = here_.tau + step * here_.tangent[N];
    double previous = std::numeric_limits<double>::infinity();
    bool converged = false;
    for (int k = 0; k < 8 && !converged; ++k) {
      const Linearized<N> at = system_.at_fraction(next.tau).linearize(next.x);
      Tangent rhs;
      rhs.template head<N>() = -at.g / at.magnitude;
      rhs[N] = 0.0;  // corrections stay in the plane across the predictor
      const Tangent delta = bordered(at, next.x, here_.tangent).partialPivLu().solve(rhs);
      const double size = delta.norm();
      if (!std::isfinite(size)) return false;
      if (k == 0 && size > longest_first_correction(step, options_.max_angle)) return false;
      if (k > 0 && !contracts(size, previous)) return false;
      next.x = moved<N>(next.x, ReducedVector<N>(delta.template head<N>()));
      next.tau += delta[N];
      previous = size;
      converged = size <= 1e-11;
    }
    if (!converged) return false;
    symmetrize(next.x);
    if (!orient(next, here_.tangent) || !same_sheet(here_.positive, next.positive)) return false;
    if (!stays_inside(system_, here_.x, next.x)) return false;
    const double cosine = std::clamp(next.tangent.dot(here_.tangent), -1.0, 1.0);
    *angle = acos(cosine);
    return *angle <= options_.max_angle;
  }

  /// The condition that does not hold a little ahead of where the walk is stuck.
  const expression::TapeCondition* border_ahead() const {
    const auto here = system_conditions(system_, here_.x);
    for (double reach = options_.min_step; reach < 1e-3; reach *= 4.0) {
      const auto ahead = system_conditions(
          system_, moved<N>(here_.x, ReducedVector<N>(reach * here_.tangent.template head<N>())));
      for (std::size_t k = 0; k < ahead.size(); ++k)
        if (!ahead[k].holds() || (ahead[k].value < 0.0) != (here[k].value < 0.0))
          return ahead[k].condition;
    }
    return nullptr;
  }

  /// Whether the step from here_ to next passes tau = 1, also by turning just above it: then the
  /// walk ends, with the point there or stuck before it.
  bool arrives(double step, const Point& next, WalkResult<N>& out) const {
    double far = step;
    if (next.tau < 1.0) {
      if (!(here_.tangent[N] > 0.0 && next.tangent[N] < 0.0)) return false;
      // The sheet turns inside this step: does it turn above tau = 1?
      far = root_in(0.0, step, [](const Point& p) { return p.tangent[N]; });
      Point turn;
      double angle = 0.0;
      if (!advance(far, turn, &angle)) return false;
      out.largest_tau = std::max(out.largest_tau, turn.tau);
      if (turn.tau < 1.0) return false;
    }
    const double s = root_in(0.0, far, [](const Point& p) { return p.tau - 1.0; });
    Point at;
    double angle = 0.0;
    if (!advance(s, at, &angle) || std::abs(at.tau - 1.0) > 1e-9) {
      out.x = here_.x;  // between here_ and next, but not found: `stuck`
      out.largest_tau = std::max(out.largest_tau, here_.tau);
      return true;
    }
    out.x = at.x;
    out.largest_tau = 1.0;
    out.end = WalkEnd::reached;
    return true;
  }

  /// The s in [a, b] where f(point at s) changes sign (it does between the ends).
  template <class F>
  double root_in(double a, double b, F f) const {
    const auto value = [&](double s) {
      if (s == 0.0) return f(here_);
      Point p;
      double angle = 0.0;
      return advance(s, p, &angle) ? f(p) : f(here_);
    };
    const double fa = value(a);
    const double fb = value(b);
    if (fa == 0.0) return a;
    if (!(fa * fb < 0.0)) return b;
    std::uintmax_t evaluations = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        value, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(52), evaluations);
    return 0.5 * (bracket.first + bracket.second);
  }

  System system_;
  WalkOptions options_;
  Circle circle_;
  Point here_;
};

}  // namespace stationary
