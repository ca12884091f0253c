// neo-hookean:  W = (mu/2) (tr S^2 - 2 - 2 ln d) + (lambda/2) ln^2 d in the plane.
//
// tr S^2 = t^2 - 2 d. Its families have folds in nu.
#pragma once

#include <array>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

template <class C = double>
struct NeoHookean {
  C mu;
  C lambda;

  /// W_t > 0 everywhere.
  static constexpr bool rises_with_trace = true;
  static constexpr std::string_view name = "neo-hookean";
  static constexpr std::string_view formula = "(mu/2) (tr S^2 - 2 - 2 ln d) + (lambda/2) ln^2 d";
  static constexpr std::array<std::string_view, 2> parameters{"mu", "lambda"};
  static constexpr std::array<std::string_view, 2> domain{"mu > 0", "mu + lambda > 0"};

  std::array<C, 2> coefficients() const { return {mu, lambda}; }
  std::array<bool, 2> in_domain() const { return {mu > 0.0, mu + lambda > 0.0}; }
  double rest_stretch() const { return 1.0; }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    const auto pressure = lambda * log(xi * zeta) - mu;
    const auto square_xi = (mu - c_xi) * square(xi);
    const auto square_zeta = (mu - c_zeta) * square(zeta);
    return {.g_xi = square_xi + pressure,
            .g_zeta = square_zeta + pressure,
            .uu = 2.0 * square_xi + lambda,
            .uv = Product<C, S>(lambda),
            .vv = 2.0 * square_zeta + lambda};
  }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    PlanarDerivatives<Product<C, S>> out;
    const S l = log(x.d);
    const auto area = mu * x.d;
    const auto volumetric = lambda * l;
    out.w = 0.5 * mu * (x.t * x.t - 2.0) - area + (0.5 * volumetric - mu) * l;
    if constexpr (order >= 1) {
      out.w_t = mu * x.t;
      out.w_l = volumetric - mu - area;
    }
    if constexpr (order >= 2) {
      out.w_tt = Product<C, S>(mu);
      out.w_tl = Product<C, S>(0.0);
      out.w_ll = lambda - area;
    }
    return out;
  }
};

}  // namespace stationary
