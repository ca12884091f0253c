// saint-venant-kirchhoff:  W = mu tr E^2 + (lambda/2) (tr E)^2,  E = (S^2 - 1)/2 in the plane.
//
// With I = tr S^2 = t^2 - 2 d:  tr E = (I - 2)/2,  tr E^2 = (I^2 - 2 d^2 - 2 I + 2)/4. Polynomial.
#pragma once

#include <array>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

template <class C = double>
struct SaintVenantKirchhoff {
  C mu;
  C lambda;

  static constexpr std::string_view name = "saint-venant-kirchhoff";
  static constexpr std::string_view formula = "mu tr E^2 + (lambda/2) (tr E)^2,  E = (S^2 - 1)/2";
  static constexpr std::array<std::string_view, 2> parameters{"mu", "lambda"};
  static constexpr std::array<std::string_view, 2> domain{"mu > 0", "mu + lambda > 0"};

  std::array<C, 2> coefficients() const { return {mu, lambda}; }
  std::array<bool, 2> in_domain() const { return {mu > 0.0, mu + lambda > 0.0}; }
  double rest_stretch() const { return 1.0; }

  /// In the squares of the stretches.
  static constexpr int balance_power = 2;
  template <class S>
  LinearBalance<Product<C, S>> linear_balance(const S& c_xi, const S& c_zeta) const {
    // Sums in the wider type: S may be more precise than the coefficients.
    const Product<C, S> own = Product<C, S>(mu) + 0.5 * lambda;
    const Product<C, S> load = Product<C, S>(mu) + lambda;
    return {own, own, 0.5 * lambda, load + c_xi, load + c_zeta};
  }
  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    return stationary::log_balance<balance_power>(linear_balance(c_xi, c_zeta), square(xi),
                                                  square(zeta));
  }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    PlanarDerivatives<Product<C, S>> out;
    const auto I = x.t * x.t - 2.0 * x.d;
    const auto d2 = x.d * x.d;
    const auto trace = 0.5 * (I - 2.0);
    out.w = mu * (0.25 * ((I - 2.0) * I + 2.0) - 0.5 * d2) + 0.5 * lambda * (trace * trace);
    if constexpr (order >= 1) {
      const auto w_I = 0.5 * (mu * (I - 1.0) + lambda * trace);  // at fixed d
      out.w_t = 2.0 * w_I * x.t;
      out.w_l = -2.0 * w_I * x.d - mu * d2;
      if constexpr (order >= 2) {
        const auto w_II = Product<C, S>(0.5 * mu) + 0.25 * lambda;
        out.w_tt = 2.0 * w_I + 4.0 * w_II * (x.t * x.t);
        out.w_tl = -4.0 * w_II * (x.t * x.d);
        out.w_ll = out.w_l + (4.0 * w_II - mu) * d2;
      }
    }
    return out;
  }
};

}  // namespace stationary
