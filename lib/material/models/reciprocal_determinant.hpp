// reciprocal-determinant:  W = c / d + (k/2) tr S^2,  tr S^2 = t^2 - 2 d.
//
// c / d resists collapse, k growth. Every branch has closed-form equilibria (tests/support).
#pragma once

#include <array>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

template <class C = double>
struct ReciprocalDeterminant {
  C c;
  C k;

  /// W_t > 0 everywhere.
  static constexpr bool rises_with_trace = true;
  static constexpr std::string_view name = "reciprocal-determinant";
  static constexpr std::string_view formula = "c/d + (k/2)(t^2 - 2d)";
  static constexpr std::array<std::string_view, 2> parameters{"c", "k"};
  static constexpr std::array<std::string_view, 2> domain{"c > 0", "k > 0"};

  std::array<C, 2> coefficients() const { return {c, k}; }
  std::array<bool, 2> in_domain() const { return {c > 0.0, k > 0.0}; }
  /// xi = zeta at nu = 0.
  double rest_stretch() const {
    using std::sqrt;
    return sqrt(sqrt(leading(c) / leading(k)));
  }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    const auto reciprocal = c / (xi * zeta);
    const auto square_xi = (k - c_xi) * square(xi);
    const auto square_zeta = (k - c_zeta) * square(zeta);
    return {.g_xi = square_xi - reciprocal,
            .g_zeta = square_zeta - reciprocal,
            .uu = 2.0 * square_xi + reciprocal,
            .uv = reciprocal,
            .vv = 2.0 * square_zeta + reciprocal};
  }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    PlanarDerivatives<Product<C, S>> out;
    const auto reciprocal = c / x.d;
    const auto area = k * x.d;
    out.w = reciprocal + 0.5 * k * (x.t * x.t) - area;
    if constexpr (order >= 1) {
      out.w_t = k * x.t;
      out.w_l = -reciprocal - area;
    }
    if constexpr (order >= 2) {
      out.w_tt = Product<C, S>(k);
      out.w_tl = Product<C, S>(0.0);
      out.w_ll = reciprocal - area;
    }
    return out;
  }
};

}  // namespace stationary
