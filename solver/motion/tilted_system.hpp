// The balance of a tilted axis (balance.hpp) as a reduced system in (ln xi, ln zeta), |nu| given.
#pragma once

#include "solver/newton/reduced_system.hpp"

namespace stationary {

template <class Model>
struct TiltedSystem {
  static constexpr int dimension = 2;
  Model model;
  Body body;
  TiltPlane plane;
  CentrifugalRates<DoubleDouble> rates;  ///< axis_rates() of |nu|^2 in (iii)

  Linearized<2> linearize(const ReducedVector<2>& x) const {
    auto [b, magnitude] = all_three(x);
    b = tied_to_plane<2>(b, plane);
    return {{b.g_xi, b.g_zeta}, {{b.uu, b.uv, b.vv}}, magnitude};
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x) const {
    const DoubleDouble rho = tilted_thickness(body, plane, DoubleDouble(x[0]), DoubleDouble(x[1]));
    const auto b = tied_to_plane<1>(extended_balance(model, x[0], x[1], rho, rates), plane);
    return {double(b.g_xi), double(b.g_zeta)};
  }
  /// As those of the other systems; the J that tie rho count half each.
  ReducedVector<2> input_sensitivity(const ReducedVector<2>& x) const {
    const LogBalance<double> b = all_three(x).balance;
    const CentrifugalRates<double> c = double_rates();
    const ReducedVector<3> at(x[0], x[1], tilted_thickness(body, plane, x[0], x[1]));
    const ReducedVector<3> elastic =
        coefficient_sensitivity<3>(model, at) + decimal_sensitivity<3>(model, at);
    ReducedVector<2> out{elastic[0] + 3.0 * c.xi * x[0] * x[0] + std::abs(b.uw),
                         elastic[1] + 3.0 * c.zeta * x[1] * x[1] + std::abs(b.vw)};
    out[axis(in_plane_branch(plane))] += elastic[2] + std::abs(b.ww);
    return out;
  }

  /// rho untied.
  SizedBalance all_three(const ReducedVector<2>& x) const {
    return sized_balance(model, x[0], x[1], tilted_thickness(body, plane, x[0], x[1]),
                         double_rates());
  }
  CentrifugalRates<double> double_rates() const {
    return {double(rates.xi), double(rates.zeta), double(rates.rho)};
  }
};

}  // namespace stationary
