// The circles xi = zeta and the ellipses of a body with J1 = J2 over boxes, each by themselves. Where ellipses
// branch off the circle the balance in (xi, zeta) is singular; these two are not:
//
//   circles    x = (xi[, rho]):     the sum of the two planar rows at zeta = xi
//   ellipses   x = (g, r[, rho]):   g = sqrt(xi zeta), r = (xi + zeta)/(2 g) >= 1, in t = 2 g r, d = g^2
//                t W_t - J t^2 (omega^2 + theta'^2) = 0,   W_l + J d (omega - theta')^2 = 0[,   W_r = 0]
//
// (two_polar_system.hpp), l = ln d. A spin nu about axis 3 is omega = nu, theta' = 0. The ellipses' equations
// hold beyond r = 1 too, where no stretches are: there nothing is said.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/proof/two_polar_boxes.hpp"

namespace stationary {

/// The same on both unknowns of the plane.
template <class T, std::size_t N>
std::array<T, N + 1> on_circle(const std::array<T, N>& x) {
  std::array<T, N + 1> out;
  out[0] = out[1] = x[0];
  std::copy(x.begin() + 1, x.end(), out.begin() + 2);
  return out;
}

/// Boxes: of all ellipsoids, symmetric in x_0 and x_1. It refers to them.
template <class Boxes>
struct CircleBoxSystem {
  static constexpr int dimension = Boxes::dimension - 1;
  static constexpr int N = dimension;
  const Boxes& boxes;

  BoxLinearized<N> linearize(const Box<N>& x) const {
    const BoxLinearized<N + 1> all = boxes.linearize(on_circle(x));
    BoxLinearized<N> out;
    out.g[0] = all.g[0] + all.g[1];
    out.jacobian[0] = all(0, 0) + all(1, 1) + 2.0 * all(0, 1);
    if constexpr (N == 2) {
      out.g[1] = all.g[2];
      out.jacobian[1] = all(0, 2) + all(1, 2);
      out.jacobian[2] = all(2, 2);
    }
    return out;
  }
  bool excludes(const Box<N>& x) const { return boxes.excludes(on_circle(x)); }

  bool varies() const {
    if constexpr (requires { boxes.varies(); }) return boxes.varies();
    return false;
  }
  VariedResidual<N> varied(const Box<N>& x) const {
    VariedResidual<N> out;
    if constexpr (requires { boxes.varied(on_circle(x)); }) {
      const VariedResidual<N + 1> all = boxes.varied(on_circle(x));
      out.offset = all.offset;
      out.at[0] = all.at[0] + all.at[1];
      out.slope[0] = all.slope[0] + all.slope[1];
      if constexpr (N == 2) {
        out.at[1] = all.at[2];
        out.slope[1] = all.slope[2];
      }
    }
    return out;
  }
};

/// Elastic: a planar model in intervals, or a coupled one.
template <class Elastic, int dimensions>
struct EllipseBoxSystem {
  static constexpr int dimension = dimensions;
  static constexpr int N = dimensions;
  Elastic model;
  Interval J;
  TwoPolarRates<Interval> motion;
  std::optional<int> varied_number = {};  ///< as TwoPolarBoxSystem's

  GeneralBoxLinearized<N> linearize(const Box<N>& x) const { return linearize_at(motion, x); }

  bool varies() const { return varied_number.has_value(); }
  VariedResidual<N> varied(const Box<N>& x) const {
    TwoPolarRates<Interval> middle = motion;
    Interval& number = number_of(middle, *varied_number);
    const Interval whole = number;
    number = Interval(whole.mid());
    VariedResidual<N> out{linearize_at(middle, x).g, {}, whole - number};
    const Interval d = square(x[0]);
    const Interval slip = motion.omega - motion.theta_dot;
    out.slope[0] = -8.0 * (J * whole * d * square(x[1]));
    out.slope[1] = (*varied_number == 0 ? 2.0 : -2.0) * (J * slip * d);
    return out;
  }

 private:
  GeneralBoxLinearized<N> linearize_at(const TwoPolarRates<Interval>& at, const Box<N>& x) const {
    GeneralBoxLinearized<N> out;
    if (!(x[1].lo >= 1.0)) {
      out.g.fill(Interval::entire());
      for (Box<N>& row : out.slope) row.fill(Interval::entire());
      return out;
    }
    const Interval d = square(x[0]);
    const Interval r2 = square(x[1]);
    const Interval t = 2.0 * (x[0] * x[1]);
    const Interval beyond = r2 - 1.0;
    const Interval e = 4.0 * (d * Interval(std::max(beyond.lo, 0.0), beyond.hi));
    const PlanarInvariants<Interval> invariants{t, d, {std::max(e.lo, 0.0), e.hi}};
    const auto plane = [&](const PlanarDerivatives<Interval>& w) {
      const Interval pull = 4.0 * (J * (square(at.omega) + square(at.theta_dot)) * (d * r2));
      const Interval push = J * square(at.omega - at.theta_dot) * d;
      out.g[0] = t * w.w_t - pull;
      out.g[1] = w.w_l + push;
      const Interval mixed = t * w.w_tl;
      out.slope[0][1] = t * w.w_t + square(t) * w.w_tt - 2.0 * pull;
      out.slope[0][0] = out.slope[0][1] + 2.0 * mixed;
      out.slope[1][1] = mixed;
      out.slope[1][0] = mixed + 2.0 * (w.w_ll + push);
    };
    if constexpr (N == 2) {
      plane(forces<2>(model, invariants));
    } else {
      const auto w = forces<2>(model, invariants, x[2]);
      plane(w.plane);
      const Interval mixed = t * w.w_tr;
      out.g[2] = w.w_r;
      out.slope[0][2] = out.slope[2][1] = mixed;
      out.slope[1][2] = w.w_lr;
      out.slope[2][0] = mixed + 2.0 * w.w_lr;
      out.slope[2][2] = w.w_rr;
    }
    return out;
  }
};

/// (xi, zeta[, rho]) of boxes (g, r[, rho]), xi >= zeta.
template <std::size_t N>
std::array<Interval, N> stretches_of_ellipses(const std::array<Interval, N>& x) {
  std::array<Interval, N> out = x;
  const Interval beyond = square(x[1]) - 1.0;
  const Interval half = x[1] + sqrt(Interval(std::max(beyond.lo, 0.0), beyond.hi));
  out[0] = x[0] * half;
  out[1] = x[0] / half;
  return out;
}

/// The boxes (g, r[, rho]) of ellipses xi >= zeta in a box; nothing where it has none.
template <std::size_t N>
std::optional<std::array<Interval, N>> ellipses_of_stretches(const std::array<Interval, N>& x) {
  std::array<Interval, N> out = x;
  out[0] = sqrt(x[0] * x[1]);
  const Interval ratio = x[0] / x[1];
  if (!(ratio.hi >= 1.0)) return std::nullopt;
  const auto half = [](double q) {
    const Interval root = sqrt(Interval(q));
    return 0.5 * (root + 1.0 / root);
  };
  out[1] = {std::max(half(std::max(ratio.lo, 1.0)).lo, 1.0), half(ratio.hi).hi};
  return out;
}

}  // namespace stationary
