#include "lib/material/models/expression.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/first_order_bound_functions.hpp"

namespace stationary {
namespace {

constexpr double largest_logarithm = 6.907755278982137;  // of 1e3
constexpr int grid_steps = 160;

/// Where g(x) crosses from minus to plus between e^a and e^b, a < b: by bisection to neighbouring
/// doubles, g in extended precision deciding; the end with the smaller |g|.
template <class Slope>
double crossing(const Slope& g, double a, double b) {
  double lo = exp(a);
  double hi = exp(b);
  for (;;) {
    const double middle = std::sqrt(lo) * std::sqrt(hi);
    const double next = middle > lo && middle < hi ? middle : lo + 0.5 * (hi - lo);
    if (!(next > lo) || !(next < hi)) break;
    (g(next) < 0.0 ? lo : hi) = next;
  }
  return std::abs(g(lo)) < std::abs(g(hi)) ? lo : hi;
}

/// V_u and V_uu of W(t, l) along the circles, xi = zeta = e^u.
template <class R, class S>
R circle_slope(const PlanarDerivatives<R>& w, const S& t) {
  return w.w_t * t + 2.0 * w.w_l;
}
template <class R, class S>
R circle_curvature(const PlanarDerivatives<R>& w, const S& t) {
  return t * (t * w.w_tt + 4.0 * w.w_tl + w.w_t) + 4.0 * w.w_ll;
}

/// The line along which a minimum is looked for: slope and curvature in the logarithm, in extended
/// precision, and the size of the terms of the slope.
struct Circles {
  const PlanarExpression<double>& model;

  double slope(double r) const {
    const auto x = extended_invariants(r, r);
    return double(circle_slope(model.evaluate<1>(x), x.t));
  }
  double curvature(double r) const {
    const auto x = extended_invariants(r, r);
    return double(circle_curvature(model.evaluate<2>(x), x.t));
  }
  double slope_size(double r) const {
    const auto x = planar_invariants(Conditioned::input(r), Conditioned::input(r));
    return circle_slope(conditioned_model(model).evaluate<1>(x), x.t).condition;
  }
};

struct Thicknesses {
  const ThicknessExpression<double>& model;

  double slope(double rho) const { return double(model.evaluate<1>(DoubleDouble(rho)).v_r); }
  double curvature(double rho) const { return double(model.evaluate<2>(DoubleDouble(rho)).v_rr); }
  double slope_size(double rho) const {
    return conditioned_model(model).evaluate<1>(Conditioned::input(rho)).v_r.condition;
  }
};

/// Whether the slope's change of sign at x, between a and b, is a minimum: it is no rounding noise
/// and passes through 0, instead of jumping as at a kink or a pole.
template <class Line>
bool is_minimum(const Line& line, double x, double a, double b) {
  const double slope_a = std::abs(line.slope(a));
  const double slope_b = std::abs(line.slope(b));
  const bool noise =
      !(slope_a > 0x1p-66 * line.slope_size(a)) && !(slope_b > 0x1p-66 * line.slope_size(b));
  const bool jump = !(std::abs(line.slope(x)) <= 0x1p-20 * std::max(slope_a, slope_b));
  return !noise && !jump && line.curvature(x) >= 0.0;
}

/// The minimum nearest to x = 1, in ln x, of those a cell of the grid holds one of; NaN without
/// one. NaN values of the slope hide what is beside them.
template <class Line>
double nearest_minimum(const Line& line) {
  constexpr double step = largest_logarithm / grid_steps;
  const auto slope = [&](double x) { return line.slope(x); };
  std::optional<double> found;
  const auto consider = [&](int k) {
    // Cells are centred, so that 1 is inside the first one.
    const double a = (k - 0.5) * step;
    const double b = (k + 0.5) * step;
    if (!(slope(exp(a)) <= 0.0) || !(slope(exp(b)) > 0.0)) return;
    const double x = crossing(slope, a, b);
    if (!is_minimum(line, x, exp(a), exp(b))) return;
    if (!found || std::abs(log(x)) < std::abs(log(*found))) found = x;
  };
  for (int k = 0; k <= grid_steps && !found; ++k) {
    consider(k);
    if (k > 0) consider(-k);
  }
  return found ? *found : poison<double>();
}

/// ln xi = ln zeta and ln rho.
struct LogStretches {
  double u = 0.0;
  double w = 0.0;
  /// From rest at 1, in (ln xi, ln zeta, ln rho).
  double distance() const { return std::sqrt(2.0 * u * u + w * w); }
};

constexpr double start_spacing = 0.5;

/// Nearest to 1 first.
std::vector<LogStretches> starts() {
  std::vector<LogStretches> out;
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j) out.push_back({start_spacing * i, start_spacing * j});
  std::ranges::stable_sort(out, {}, &LogStretches::distance);
  return out;
}

struct CoupledRest {
  LogStretches at;
  std::array<double, 2> stretches;
};

/// The minimum among (xi, xi, rho) to which Newton's method comes through points where V is convex.
std::optional<CoupledRest> minimum_from(const CoupledExpression<double>& model,
                                        const LogStretches& start) {
  LogStretches at = start;
  for (int k = 0; k < 60; ++k) {
    const double r = exp(at.u);
    const double rho = exp(at.w);
    const double t = 2.0 * r;
    const auto x = model.evaluate<2>(planar_invariants(r, r), rho);
    const auto fine = model.evaluate<1>(extended_invariants(r, r), DoubleDouble(rho));
    const double g_u = double(circle_slope(fine.plane, t));
    const double g_w = double(fine.w_r);
    const double uu = circle_curvature(x.plane, t);
    const double uw = t * x.w_tr + 2.0 * x.w_lr;
    const double ww = x.w_rr;
    const double det = uu * ww - uw * uw;
    if (!(det > 0.0) || !(uu > 0.0)) return {};
    const double du = -(ww * g_u - uw * g_w) / det;
    const double dw = -(uu * g_w - uw * g_u) / det;
    const double size = std::max(std::abs(du), std::abs(dw));
    if (!(size < 1e3)) return {};
    if (size <= 0x1p-40) {
      if (!(std::abs(at.u) <= largest_logarithm && std::abs(at.w) <= largest_logarithm)) return {};
      return CoupledRest{at, {r + r * du, rho + rho * dw}};
    }
    const double damping = size > 0.5 ? 0.5 / size : 1.0;
    at.u += damping * du;
    at.w += damping * dw;
  }
  return {};
}

}  // namespace

double rest_stretch_of(const PlanarExpression<double>& model) {
  return nearest_minimum(Circles{model});
}

double rest_thickness_of(const ThicknessExpression<double>& model) {
  return nearest_minimum(Thicknesses{model});
}

double balanced_thickness_of(const ThicknessExpression<double>& model, const DoubleDouble& m) {
  // m(rho) = V'/rho = V_r/rho^2 increases from 0 at rest along the connected solutions; a maximum
  // of it is a fold.
  const double rest = rest_thickness_of(model);
  if (!(double(m) > 0.0)) return rest;
  constexpr double step = 0x1p-8;
  const ThicknessExpression<double> part = model.on_part_of({0.0, 1.0, 1.0, rest});
  const auto excess = [&](double rho) {
    return double(part.evaluate<1>(DoubleDouble(rho)).v_r - m * two_product(rho, rho));
  };
  const auto rises = [&](double at) {
    const auto v = part.evaluate<2>(exp(at));
    return v.v_rr > 2.0 * v.v_r;
  };
  double a = log(rest);
  while (a < largest_logarithm) {
    double b = a + step;
    if (excess(exp(b)) > 0.0) return crossing(excess, a, b);
    if (rises(b)) {
      a = b;
      continue;
    }
    double turn = a;  // the fold is in this step, and the solution may be before it
    for (double middle = 0.5 * (turn + b); turn < middle && middle < b; middle = 0.5 * (turn + b))
      (rises(middle) ? turn : b) = middle;
    if (turn > a && excess(exp(turn)) > 0.0) return crossing(excess, a, turn);
    break;
  }
  return poison<double>();
}

std::array<double, 2> rest_of(const CoupledExpression<double>& model) {
  static const std::vector<LogStretches> all = starts();
  std::optional<CoupledRest> nearest;
  for (const LogStretches& start : all) {
    // A nearer minimum has starts beside it that are no further away than this.
    if (nearest && start.distance() > nearest->at.distance() + 2.0 * start_spacing) break;
    const auto found = minimum_from(model, start);
    // The same one from elsewhere differs by rounding.
    if (found && (!nearest || found->at.distance() < nearest->at.distance() - 1e-9))
      nearest = found;
  }
  if (!nearest) return {poison<double>(), poison<double>()};
  return nearest->stretches;
}

}  // namespace stationary
