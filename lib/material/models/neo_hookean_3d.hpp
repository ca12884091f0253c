// neo-hookean-3d:  V = (mu/2) (tr S^2 + rho^2 - 3 - 2 ln(d rho)) + (lambda/2) ln^2 (d rho),
// tr S^2 = t^2 - 2 d in the plane; the thickness is coupled to it through the volume d rho.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

template <class C = double>
struct NeoHookean3d {
  C mu;
  C lambda;

  /// W_t > 0 everywhere.
  static constexpr bool rises_with_trace = true;
  static constexpr std::string_view name = "neo-hookean-3d";
  static constexpr std::string_view formula =
      "(mu/2) (tr S^2 + rho^2 - 3 - 2 ln(d rho)) + (lambda/2) ln^2 (d rho)";
  static constexpr std::array<std::string_view, 2> parameters{"mu", "lambda"};
  static constexpr std::array<std::string_view, 2> domain{"mu > 0", "2 mu + 3 lambda > 0"};

  std::array<C, 2> coefficients() const { return {mu, lambda}; }
  std::array<bool, 2> in_domain() const { return {mu > 0.0, 2.0 * mu + 3.0 * lambda > 0.0}; }
  double rest_stretch() const { return 1.0; }
  double rest_thickness() const { return 1.0; }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& rho, const S& c_xi,
                                        const S& c_zeta, const S& c_rho) const {
    using R = Product<C, S>;
    const auto pressure = lambda * log(xi * zeta * rho) - mu;
    const auto square_xi = (mu - c_xi) * square(xi);
    const auto square_zeta = (mu - c_zeta) * square(zeta);
    const auto square_rho = (mu - c_rho) * square(rho);
    return {.g_xi = square_xi + pressure,
            .g_zeta = square_zeta + pressure,
            .g_rho = square_rho + pressure,
            .uu = 2.0 * square_xi + lambda,
            .uv = R(lambda),
            .vv = 2.0 * square_zeta + lambda,
            .uw = R(lambda),
            .vw = R(lambda),
            .ww = 2.0 * square_rho + lambda};
  }

  template <int order, class S>
  CoupledDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x, const S& rho) const {
    CoupledDerivatives<Product<C, S>> out;
    const S volume = log(x.d * rho);
    const auto area = mu * x.d;
    const auto square = mu * (rho * rho);
    const auto pressure = lambda * volume - mu;
    out.plane.w =
        0.5 * mu * (x.t * x.t - 3.0) - area + 0.5 * square + (0.5 * lambda * volume - mu) * volume;
    if constexpr (order >= 1) {
      out.plane.w_t = mu * x.t;
      out.plane.w_l = pressure - area;
      out.w_r = pressure + square;
    }
    if constexpr (order >= 2) {
      using R = Product<C, S>;
      out.plane.w_tt = R(mu);
      out.plane.w_tl = R(0.0);
      out.plane.w_ll = lambda - area;
      out.w_rr = lambda + 2.0 * square;
      out.w_tr = R(0.0);
      out.w_lr = R(lambda);
    }
    return out;
  }
};

}  // namespace stationary
