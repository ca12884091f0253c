// biot:  W = mu tr(S - 1)^2 + (lambda/2) (tr(S - 1))^2 in the plane; quadratic in S.
//
// tr(S - 1)^2 = t^2 - 2 d - 2 t + 2,  tr(S - 1) = t - 2. Nothing resists collapse (d -> 0).
#pragma once

#include <array>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

template <class C = double>
struct Biot {
  C mu;
  C lambda;

  static constexpr std::string_view name = "biot";
  static constexpr std::string_view formula = "mu tr(S - 1)^2 + (lambda/2) (tr(S - 1))^2";
  static constexpr std::array<std::string_view, 2> parameters{"mu", "lambda"};
  static constexpr std::array<std::string_view, 2> domain{"mu > 0", "mu + lambda > 0"};

  std::array<C, 2> coefficients() const { return {mu, lambda}; }
  std::array<bool, 2> in_domain() const { return {mu > 0.0, mu + lambda > 0.0}; }
  double rest_stretch() const { return 1.0; }

  /// In the stretches themselves.
  static constexpr int balance_power = 1;
  template <class S>
  LinearBalance<Product<C, S>> linear_balance(const S& c_xi, const S& c_zeta) const {
    // Sums in the wider type: S may be more precise than the coefficients.
    const Product<C, S> stiffness = Product<C, S>(2.0 * mu) + lambda;
    const Product<C, S> load = 2.0 * (Product<C, S>(mu) + lambda);
    return {stiffness - c_xi, stiffness - c_zeta, lambda, load, load};
  }
  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    return stationary::log_balance<balance_power>(linear_balance(c_xi, c_zeta), xi, zeta);
  }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    PlanarDerivatives<Product<C, S>> out;
    const auto trace = x.t - 2.0;
    const auto area = 2.0 * mu * x.d;
    out.w = mu * (trace * x.t + 2.0) - area + 0.5 * lambda * (trace * trace);
    if constexpr (order >= 1) {
      out.w_t = 2.0 * mu * (x.t - 1.0) + lambda * trace;
      out.w_l = -area;
    }
    if constexpr (order >= 2) {
      out.w_tt = Product<C, S>(2.0 * mu) + lambda;
      out.w_tl = Product<C, S>(0.0);
      out.w_ll = -area;
    }
    return out;
  }
};

}  // namespace stationary
