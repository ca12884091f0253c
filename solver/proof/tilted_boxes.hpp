// The balance of a tilted axis (balance.hpp) over a box of stretches, in interval arithmetic, with
// J, coefficients and |nu| as intervals; and the squares of nu's components, without which positive
// a solution of that balance is no motion.
#pragma once

#include "solver/proof/box_balance.hpp"

namespace stationary {

/// x = (xi, zeta). Model: of all three stretches.
template <class Model>
struct TiltedBoxSystem {
  static constexpr int dimension = 2;
  Model model;
  Inertia3<Interval> J;
  TiltPlane plane;
  CentrifugalRates<Interval> rates;  ///< axis_rates() of |nu|^2 in (iii)

  Interval thickness(const Box<2>& x) const { return tilted_thickness(J, plane, x[0], x[1]); }

  BoxLinearized<2> linearize(const Box<2>& x) const {
    const auto b = tied_to_plane<2>(
        model.log_balance(x[0], x[1], thickness(x), rates.xi, rates.zeta, rates.rho), plane);
    return {{b.g_xi, b.g_zeta}, {b.uu, b.uv, b.vv}};
  }
  /// At every solution in x.
  TiltSquares<Interval> squares(const Box<2>& x) const {
    const Interval rho = thickness(x);
    const Interval rest(0.0);
    return tilt_squares(J, plane, model.log_balance(x[0], x[1], rho, rest, rest, rest), x[0], x[1],
                        rho);
  }
  /// No solution in x is a motion.
  bool excludes(const Box<2>& x) const {
    if (defined_nowhere(model, x[0], x[1], thickness(x))) return true;
    const TiltSquares<Interval> square = squares(x);
    return square.in_plane.negative() || square.normal.negative();
  }
};

template <class Model>
auto tilted_box_system(const Body& body, const Model& model, TiltPlane plane, double nu,
                       Inputs inputs) {
  const auto J = inertia_intervals(body, inputs);
  return TiltedBoxSystem<decltype(interval_model(model, inputs))>{
      interval_model(model, inputs), J, plane,
      axis_rates(J, Branch::iii, square(as_input(nu, inputs)))};
}

}  // namespace stationary
