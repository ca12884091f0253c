#include "lib/potentials/expression.hpp"

#include <cmath>
#include <optional>

namespace stationary {
namespace {

constexpr double largest_logarithm = 6.907755278982137;  // of 1e3
constexpr int grid_steps = 160;

/// Where g(x) crosses from minus to plus between e^a and e^b, a < b: by bisection to neighbouring
/// doubles, g in extended precision deciding; the end with the smaller |g|.
template <class Slope>
double crossing(const Slope& g, double a, double b) {
  double lo = std::exp(a);
  double hi = std::exp(b);
  for (;;) {
    const double middle = std::sqrt(lo) * std::sqrt(hi);
    const double next = middle > lo && middle < hi ? middle : lo + 0.5 * (hi - lo);
    if (!(next > lo) || !(next < hi)) break;
    (g(next) < 0.0 ? lo : hi) = next;
  }
  return std::abs(g(lo)) < std::abs(g(hi)) ? lo : hi;
}

/// The crossing nearest to x = 1, in ln x; NaN without one. NaN values of g hide what is beside
/// them.
template <class Slope>
double nearest_minimum(const Slope& g) {
  constexpr double step = largest_logarithm / grid_steps;
  std::optional<double> found;
  const auto consider = [&](int k) {
    // Cells are centred, so that 1 is inside the first one.
    const double a = (k - 0.5) * step;
    const double b = (k + 0.5) * step;
    if (!(g(std::exp(a)) <= 0.0) || !(g(std::exp(b)) > 0.0)) return;
    const double x = crossing(g, a, b);
    if (!found || std::abs(std::log(x)) < std::abs(std::log(*found))) found = x;
  };
  for (int k = 0; k <= grid_steps && !found; ++k) {
    consider(k);
    if (k > 0) consider(-k);
  }
  return found ? *found : poison<double>();
}

}  // namespace

double rest_stretch_of(const PlanarExpression<double>& model) {
  return nearest_minimum([&](double r) {
    const auto w = model.evaluate<1>(extended_invariants(r, r));
    return double(2.0 * (w.w_t * r + w.w_l));
  });
}

double rest_thickness_of(const ThicknessExpression<double>& model) {
  return nearest_minimum(
      [&](double rho) { return double(model.evaluate<1>(DoubleDouble(rho)).v_r); });
}

double balanced_thickness_of(const ThicknessExpression<double>& model, const DoubleDouble& m) {
  // m(rho) = V'/rho = V_r/rho^2 increases from 0 at rest along the connected solutions; a maximum
  // of it is a fold.
  const double rest = rest_thickness_of(model);
  if (!(double(m) > 0.0)) return rest;
  constexpr double step = 0.03125;
  const auto excess = [&](double rho) {
    return double(model.evaluate<1>(DoubleDouble(rho)).v_r - m * two_product(rho, rho));
  };
  double a = std::log(rest);
  while (a < largest_logarithm) {
    const double b = a + step;
    const auto v = model.evaluate<2>(std::exp(b));
    if (excess(std::exp(b)) > 0.0) return crossing(excess, a, b);
    if (!(v.v_rr > 2.0 * v.v_r)) break;
    a = b;
  }
  return poison<double>();
}

std::array<double, 2> rest_of(const CoupledExpression<double>& model) {
  struct Start {
    double u, w;
  };
  std::vector<Start> starts;
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j) starts.push_back({0.5 * i, 0.5 * j});
  std::ranges::stable_sort(starts, {}, [](const Start& s) { return s.u * s.u + s.w * s.w; });
  for (const Start& start : starts) {
    double u = start.u;
    double w = start.w;
    for (int k = 0; k < 60; ++k) {
      const double r = std::exp(u);
      const double rho = std::exp(w);
      // Along (u, u, w): t = 2 e^u, l = 2 u.
      const auto x = model.evaluate<2>(planar_invariants(r, r), rho);
      const auto fine = model.evaluate<1>(extended_invariants(r, r), DoubleDouble(rho));
      const double g_u = double(2.0 * (fine.plane.w_t * r + fine.plane.w_l));
      const double g_w = double(fine.w_r);
      const double t = 2.0 * r;
      const double uu =
          t * t * x.plane.w_tt + 4.0 * t * x.plane.w_tl + 4.0 * x.plane.w_ll + t * x.plane.w_t;
      const double uw = t * x.w_tr + 2.0 * x.w_lr;
      const double ww = x.w_rr;
      const double det = uu * ww - uw * uw;
      if (!(det > 0.0) || !(uu > 0.0)) break;
      double du = -(ww * g_u - uw * g_w) / det;
      double dw = -(uu * g_w - uw * g_u) / det;
      const double size = std::max(std::abs(du), std::abs(dw));
      if (!(size < 1e3)) break;
      if (size <= 0x1p-40) {
        const std::array<double, 2> out{r + r * du, rho + rho * dw};
        if (std::abs(u) <= largest_logarithm && std::abs(w) <= largest_logarithm) return out;
        break;
      }
      const double damping = size > 0.5 ? 0.5 / size : 1.0;
      u += damping * du;
      w += damping * dw;
    }
  }
  return {poison<double>(), poison<double>()};
}

}  // namespace stationary
