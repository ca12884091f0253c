// biot-log:  W = mu tr(S - 1)^2 + (lambda/2) ln^2 d in the plane.
//
// tr(S - 1)^2 = t^2 - 2 d - 2 t + 2. For lambda > 0 the logarithm resists collapse.
#pragma once

#include <array>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

template <class C = double>
struct BiotLog {
  C mu;
  C lambda;

  static constexpr std::string_view name = "biot-log";
  static constexpr std::string_view formula = "mu tr(S - 1)^2 + (lambda/2) ln^2 d";
  static constexpr std::array<std::string_view, 2> parameters{"mu", "lambda"};
  static constexpr std::array<std::string_view, 2> domain{"mu > 0", "mu + lambda > 0"};

  std::array<C, 2> coefficients() const { return {mu, lambda}; }
  std::array<bool, 2> in_domain() const { return {mu > 0.0, mu + lambda > 0.0}; }
  double rest_stretch() const { return 1.0; }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    const auto volumetric = lambda * log(xi * zeta);
    const auto force_xi = (2.0 * mu - c_xi) * xi;
    const auto force_zeta = (2.0 * mu - c_zeta) * zeta;
    return {.g_xi = xi * (force_xi - 2.0 * mu) + volumetric,
            .g_zeta = zeta * (force_zeta - 2.0 * mu) + volumetric,
            .uu = xi * (2.0 * force_xi - 2.0 * mu) + lambda,
            .uv = Product<C, S>(lambda),
            .vv = zeta * (2.0 * force_zeta - 2.0 * mu) + lambda};
  }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    PlanarDerivatives<Product<C, S>> out;
    const S l = log(x.d);
    const auto area = 2.0 * mu * x.d;
    const auto volumetric = lambda * l;
    out.w = mu * ((x.t - 2.0) * x.t + 2.0) - area + 0.5 * volumetric * l;
    if constexpr (order >= 1) {
      out.w_t = 2.0 * mu * (x.t - 1.0);
      out.w_l = volumetric - area;
    }
    if constexpr (order >= 2) {
      out.w_tt = Product<C, S>(2.0 * mu);
      out.w_tl = Product<C, S>(0.0);
      out.w_ll = lambda - area;
    }
    return out;
  }
};

}  // namespace stationary
