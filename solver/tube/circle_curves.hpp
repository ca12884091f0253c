// The spins about axis 3 of an isotropic body with J1 = J2 as curves (curve_equations.hpp). At
// xi = r e^s, zeta = r e^-s the difference of the balance's rows is odd in s, so that circles s = 0
// let ellipses go at pitchforks, where the balance is singular. Divided by its odd factor,
//
//   xi V_xi - zeta V_zeta - c (xi^2 - zeta^2) = (xi - zeta) (W_t - c t),   c = J nu^2,
//
// it leaves two families of regular curves:
//
//   circles   s = 0:  xi V_xi = c xi^2             [, rho V_rho = 0]
//   ellipses  W_t = c t,  zeta V_zeta = c zeta^2   [, rho V_rho = 0]
//
// with t = 2 r cosh s, d = e^l = r^2, and rho where V couples the thickness. Of a held volume
// (held_plane.hpp) V is what is left in xi and zeta. With s so has -s an
// ellipse: the curves pass s = 0 into their own mirror images, at the event `ellipse` of the circles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/tube/curve_equations.hpp"
#include "solver/tube/curve_terms.hpp"
#include "solver/tube/held_curves.hpp"

namespace stationary {

/// cosh s and sinh s.
struct HyperbolicRange {
  Interval cosine;
  Interval sine;
};
inline HyperbolicRange hyperbolic_range(const Interval& s) {
  if (!s.bounded()) return {Interval::entire(), Interval::entire()};
  const auto half_sum = [](double x, double sign) {
    const Interval grown = exp(Interval(x));
    return 0.5 * (grown + sign / grown);
  };
  const double nearest = s.mignitude();
  const double farthest = s.magnitude();
  return {{std::max(1.0, half_sum(nearest, 1.0).lo), half_sum(farthest, 1.0).hi},
          {half_sum(s.lo, -1.0).lo, half_sum(s.hi, -1.0).hi}};
}

/// r e^s and r e^-s of a place (ln r, s, ...).
struct EllipseAxes {
  Interval log_xi;
  Interval log_zeta;
};

/// Narrows (ln r, s) to where its stretches are; false where nothing is left.
inline bool narrow_axes(const EllipseAxes& to, Interval& log_r, Interval& s) {
  const Interval mean = 0.5 * (to.log_xi + to.log_zeta);
  const Interval half = 0.5 * (to.log_xi - to.log_zeta);
  if (mean.apart_from(log_r) || half.apart_from(s)) return false;
  log_r = common(log_r, mean);
  s = common(s, half);
  return true;
}

/// Thickness: coupled, N = 2 with ln rho; else N = 1.
template <class Model, int N>
class CircleCurves final : public CurveEquations<N> {
 public:
  static constexpr bool coupled = N == 2;

  CircleCurves(const Model& model, const CentrifugalRates<Interval>& rates,
               const HeldThickness& thickness, Inputs inputs)
      : model_(interval_model(model, inputs)),
        rate_(rates.xi),
        thickness_(thickness),
        terms_(model_terms<N + 1>(model, inputs)) {}

  CurveLinearized<N> linearize(const CurveBox<N>& y) const override {
    const auto [b, pull] = at<2>(y);
    CurveLinearized<N> out;
    if constexpr (coupled) {
      out.g = {b.g_xi, b.g_rho};
      out.slope[0] = {b.uu + b.uv, b.uw, -pull};
      out.slope[1] = {2.0 * b.uw, b.ww, Interval(0.0)};
    } else {
      out.g = {b.g_xi};
      out.slope[0] = {b.uu + b.uv, -pull};
    }
    return out;
  }
  CurveForces<N> forces(const CurveBox<N>& y) const override {
    const auto [b, pull] = at<1>(y);
    if constexpr (coupled) {
      return {{b.g_xi, b.g_rho}, {-pull, Interval(0.0)}};
    } else {
      return {{b.g_xi}, {-pull}};
    }
  }
  std::vector<Interval> conditions(const CurveBox<N>& y) const override {
    std::vector<Interval> out;
    thickness_.add_conditions(2.0 * y[0], out);
    return out;
  }
  bool excludes(const CurveBox<N>& y) const override {
    const Interval r = exp(y[0]);
    if constexpr (coupled) {
      return defined_nowhere(model_, r, r, exp(y[1]));
    } else {
      return defined_nowhere(model_, r, r);
    }
  }
  bool contract(CurveBox<N>& y) const override {
    const Interval c = y[N] * rate_;
    std::array<Interval, N + 1> x{y[0], y[0]};
    if constexpr (coupled) x[2] = y[1];
    if (!terms_.contract(with_plane_rate<N + 1>(c), x)) return false;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      if (x[k].apart_from(y[0])) return false;
      y[0] = common(y[0], x[k]);
    }
    if constexpr (coupled) y[1] = x[2];
    return true;
  }
  void place(const CurveCoordinates<N>& y, PlacedMotions& motions) const override {
    motions.circle = true;
    motions.xi = motions.zeta = exp(y[0]);
    if constexpr (coupled) motions.rho = exp(y[1]);
    thickness_.place(2.0 * y[0], motions);
  }

 private:
  struct Balance {
    LogBalance<Interval> rows;
    Interval pull;  ///< of the spin, over q
  };
  template <int order>
  Balance at(const CurveBox<N>& y) const {
    const Interval r = exp(y[0]);
    const Interval c = y[N] * rate_;
    const Interval pull = rate_ * square(r);
    if constexpr (coupled) {
      return {balance_of<order>(model_, r, r, exp(y[1]), c, c, Interval(0.0)), pull};
    } else {
      return {balance_of<order>(model_, r, r, c, c), pull};
    }
  }

  decltype(interval_model(std::declval<Model>(), Inputs())) model_;
  Interval rate_;
  HeldThickness thickness_;
  CurveTerms<N + 1> terms_;
};

/// x = (ln r, s[, ln rho]).
template <class Model, int N>
class EllipseCurves final : public CurveEquations<N> {
 public:
  static constexpr bool coupled = N == 3;

  /// xi, zeta: where the stretches are wanted.
  EllipseCurves(const Model& model, const CentrifugalRates<Interval>& rates, const LogRange& xi,
                const LogRange& zeta, const HeldThickness& thickness, Inputs inputs)
      : model_(interval_model(model, inputs)),
        rate_(rates.xi),
        xi_(xi),
        zeta_(zeta),
        thickness_(thickness),
        terms_(model_terms<N>(model, inputs)) {}

  CurveLinearized<N> linearize(const CurveBox<N>& y) const override {
    const Stretches at = stretches(y);
    const Interval c = y[N] * rate_;
    const auto plane = invariants(at);
    const auto b = balance<2>(at, c);
    CurveLinearized<N> out;
    const auto divided = [&](const PlanarDerivatives<Interval>& w) {
      // dt = t d(ln r) + (xi - zeta) ds,  dl = 2 d(ln r).
      const Interval stiffness = w.w_tt - c;
      out.g[0] = w.w_t - c * plane.t;
      out.slope[0][0] = plane.t * stiffness + 2.0 * w.w_tl;
      out.slope[0][1] = difference(at) * stiffness;
    };
    out.g[1] = b.g_zeta;
    out.slope[1][0] = b.uv + b.vv;
    out.slope[1][1] = b.uv - b.vv;
    if constexpr (coupled) {
      const auto w = model_.template evaluate<2>(plane, at.rho);
      divided(w.plane);
      out.slope[0][2] = w.w_tr;
      out.slope[1][2] = b.vw;
      out.g[2] = b.g_rho;
      out.slope[2] = {b.uw + b.vw, b.uw - b.vw, b.ww};
    } else {
      divided(model_.template evaluate<2>(plane));
    }
    const Box<N> pull = by_q(at, plane.t);
    for (std::size_t i = 0; i < pull.size(); ++i) out.slope[i][N] = pull[i];
    return out;
  }
  CurveForces<N> forces(const CurveBox<N>& y) const override {
    const Stretches at = stretches(y);
    const Interval c = y[N] * rate_;
    const auto plane = invariants(at);
    const auto b = balance<1>(at, c);
    const Box<N> pull = by_q(at, plane.t);
    if constexpr (coupled) {
      const auto w = model_.template evaluate<1>(plane, at.rho).plane;
      return {{w.w_t - c * plane.t, b.g_zeta, b.g_rho}, pull};
    } else {
      return {{model_.template evaluate<1>(plane).w_t - c * plane.t, b.g_zeta}, pull};
    }
  }
  std::vector<Interval> conditions(const CurveBox<N>& y) const override {
    const EllipseAxes at = axes(y);
    std::vector<Interval> out{at.log_xi - xi_.lower, xi_.upper - at.log_xi,
                              at.log_zeta - zeta_.lower, zeta_.upper - at.log_zeta};
    thickness_.add_conditions(2.0 * y[0], out);
    return out;
  }
  /// By the other row too, which the two above imply.
  bool excludes(const CurveBox<N>& y) const override {
    const Stretches at = stretches(y);
    bool outside = false;
    if constexpr (coupled) {
      outside = defined_nowhere(model_, at.xi, at.zeta, at.rho);
    } else {
      outside = defined_nowhere(model_, at.xi, at.zeta);
    }
    return outside || !balance<1>(at, y[N] * rate_).g_xi.may_be(0.0);
  }
  bool contract(CurveBox<N>& y) const override {
    const Interval c = y[N] * rate_;
    EllipseAxes at = axes(y);
    std::array<Interval, N> x{at.log_xi, at.log_zeta};
    if constexpr (coupled) x[2] = y[2];
    if (!terms_.contract(with_plane_rate<N>(c), x)) return false;
    if constexpr (coupled) y[2] = x[2];
    return narrow_axes({x[0], x[1]}, y[0], y[1]);
  }
  void place(const CurveCoordinates<N>& y, PlacedMotions& motions) const override {
    motions.xi = exp(y[0] + y[1]);
    motions.zeta = exp(y[0] - y[1]);
    if constexpr (coupled) motions.rho = exp(y[2]);
    thickness_.place(2.0 * y[0], motions);
  }

 private:
  struct Stretches {
    Interval r;
    HyperbolicRange h;
    Interval xi;
    Interval zeta;
    Interval rho;  ///< coupled
  };
  static Stretches stretches(const CurveBox<N>& y) {
    const EllipseAxes at = axes(y);
    return {exp(y[0]), hyperbolic_range(y[1]), exp(at.log_xi), exp(at.log_zeta),
            coupled ? exp(y[N - 1]) : Interval(1.0)};
  }
  /// xi - zeta.
  static Interval difference(const Stretches& at) { return 2.0 * (at.r * at.h.sine); }
  static PlanarInvariants<Interval> invariants(const Stretches& at) {
    return {2.0 * (at.r * at.h.cosine), square(at.r), square(difference(at))};
  }
  template <int order>
  auto balance(const Stretches& at, const Interval& c) const {
    if constexpr (coupled) {
      return balance_of<order>(model_, at.xi, at.zeta, at.rho, c, c, Interval(0.0));
    } else {
      return balance_of<order>(model_, at.xi, at.zeta, c, c);
    }
  }
  Box<N> by_q(const Stretches& at, const Interval& t) const {
    Box<N> out{-(rate_ * t), -(rate_ * square(at.zeta))};
    if constexpr (coupled) out[2] = Interval(0.0);
    return out;
  }
  static EllipseAxes axes(const CurveBox<N>& y) { return {y[0] + y[1], y[0] - y[1]}; }

  decltype(interval_model(std::declval<Model>(), Inputs())) model_;
  Interval rate_;
  LogRange xi_;
  LogRange zeta_;
  HeldThickness thickness_;
  CurveTerms<N> terms_;
};

}  // namespace stationary
