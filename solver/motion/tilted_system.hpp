// The balance of a tilted axis (tilted_balance.hpp) as a reduced system in (ln xi, ln zeta), |nu| given.
#pragma once

#include "lib/balance/tilted_balance.hpp"
#include "lib/number/elementary.hpp"
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
    const auto [b, magnitude] = tied(x);
    return {{b.g_xi, b.g_zeta}, {{b.uu, b.uv, b.vv}}, magnitude};
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x) const {
    const DoubleDouble xi(x[0]);
    const DoubleDouble zeta(x[1]);
    const DoubleDouble rho = tilted_thickness(body, plane, xi, zeta);
    if constexpr (is_body_model<Model>) {
      if (model.volume) {
        const auto b = held_tilted_balance<1>(model, plane, xi, zeta, rho, rates);
        return {double(b.g_xi), double(b.g_zeta)};
      }
    }
    const auto b = tied_to_plane<1>(extended_balance(model, x[0], x[1], rho, rates), plane);
    return {double(b.g_xi), double(b.g_zeta)};
  }
  /// As those of the other systems; the J that tie rho count half each.
  ReducedVector<2> input_sensitivity(const ReducedVector<2>& x) const {
    if constexpr (is_body_model<Model>)
      if (model.volume) return held_sensitivity(x);
    const LogBalance<double> b = all_three(x).balance;
    const CentrifugalRates<double> c = double_rates();
    const ReducedVector<3> at(x[0], x[1], tilted_thickness(body, plane, x[0], x[1]));
    const ReducedVector<3> elastic =
        coefficient_sensitivity<3>(model, at) + decimal_sensitivity<3>(model, at);
    ReducedVector<2> out{elastic[0] + 3.0 * c.xi * x[0] * x[0] + std::abs(b.uw),
                         elastic[1] + 3.0 * c.zeta * x[1] * x[1] + std::abs(b.vw)};
    out[own()] += elastic[2] + std::abs(b.ww);
    return out;
  }

 private:
  int own() const { return axis(in_plane_branch(plane)); }

  SizedBalance tied(const ReducedVector<2>& x) const {
    if constexpr (is_body_model<Model>) {
      if (model.volume) {
        const double rho = tilted_thickness(body, plane, x[0], x[1]);
        const CentrifugalRates<double> c = double_rates();
        const auto at = at_volume(x);
        const LogBalance<double> all = whole(at);
        const double size =
            magnitude_of(all, c.xi * at[0] * at[0], c.zeta * at[1] * at[1], 0.0, false);
        return {held_in_plane<2>(tied_to_plane<2>(all, plane), plane,
                                 log(x[0] * x[1] * rho / *model.volume), model.stiffness),
                4.0 * (size + model.stiffness)};
      }
    }
    const auto [b, magnitude] = all_three(x);
    return {tied_to_plane<2>(b, plane), magnitude};
  }
  std::array<double, 3> at_volume(const ReducedVector<2>& x) const {
    return tilted_at_volume(model, plane, x[0], x[1], tilted_thickness(body, plane, x[0], x[1]));
  }
  /// No volume held.
  LogBalance<double> whole(const std::array<double, 3>& at) const {
    const CentrifugalRates<double> c = double_rates();
    return model.template whole<2>(at[0], at[1], at[2], c.xi, c.zeta, c.rho);
  }
  /// zeta = C/(xi rho) moves with C and, as rho does, with the J that tie rho (in the 1-3 plane).
  ReducedVector<2> held_sensitivity(const ReducedVector<2>& x) const {
    const std::array<double, 3> at = at_volume(x);
    const LogBalance<double> b = whole(at);
    const CentrifugalRates<double> c = double_rates();
    const ReducedVector<3> elastic = unheld_sensitivity(model, {at[0], at[1], at[2]});
    const double pulls[2] = {3.0 * c.xi * at[0] * at[0], 3.0 * c.zeta * at[1] * at[1]};
    const int other = 1 - own();
    const double by_other = std::abs(b.uv) + 2.0 * std::abs(other == 1 ? b.vv : b.uu) +
                            std::abs(other == 1 ? b.vw : b.uw);
    const double by_rho = std::abs(own() == 0 ? b.uw : b.vw) + std::abs(b.ww) +
                          2.0 * std::abs(own() == 0 ? b.vw : b.uw);
    ReducedVector<2> out;
    out[own()] = elastic[own()] + 2.0 * elastic[other] + elastic[2] + pulls[own()] +
                 2.0 * pulls[other] + 2.0 * by_other + by_rho + 4.0 * model.stiffness;
    out[other] = 2.0 * model.stiffness;
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
