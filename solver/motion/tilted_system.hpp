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
    const double rho = tilted_thickness(body, plane, x[0], x[1]);
    const auto w = model.template evaluate<2>(planar_invariants(x[0], x[1]), rho);
    const CentrifugalRates<double> c = double_rates();
    const auto b = tilted_log_balance<2>(w, x[0], x[1], rho, plane, c);
    return {{b.g_xi, b.g_zeta}, {{b.uu, b.uv, b.vv}}, coupled_magnitude(w, x[0], x[1], rho, c)};
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x) const {
    const DoubleDouble xi(x[0]);
    const DoubleDouble zeta(x[1]);
    const DoubleDouble rho = tilted_thickness(body, plane, xi, zeta);
    const auto w = model.template evaluate<1>(extended_invariants(x[0], x[1]), rho);
    const auto b = tilted_log_balance<1>(w, xi, zeta, rho, plane, rates);
    return {double(b.g_xi), double(b.g_zeta)};
  }
  /// As those of the other systems; the J that tie rho count half each.
  ReducedVector<2> input_sensitivity(const ReducedVector<2>& x) const {
    const double rho = tilted_thickness(body, plane, x[0], x[1]);
    const auto invariants = planar_invariants(x[0], x[1]);
    const auto b = coupled_log_balance<2>(model.template evaluate<2>(invariants, rho), x[0], x[1],
                                          rho, double_rates());
    const CentrifugalRates<double> c = double_rates();
    const ReducedVector<3> at(x[0], x[1], rho);
    const ReducedVector<3> elastic =
        coefficient_sensitivity<3>(model, at) + decimal_sensitivity<3>(model, at);
    ReducedVector<2> out{elastic[0] + 3.0 * c.xi * x[0] * x[0] + std::abs(b.uw),
                         elastic[1] + 3.0 * c.zeta * x[1] * x[1] + std::abs(b.vw)};
    out[axis(in_plane_branch(plane))] += elastic[2] + std::abs(b.ww);
    return out;
  }

  CentrifugalRates<double> double_rates() const {
    return {double(rates.xi), double(rates.zeta), double(rates.rho)};
  }
};

}  // namespace stationary
