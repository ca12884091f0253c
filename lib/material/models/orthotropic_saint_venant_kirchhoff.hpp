// orthotropic-saint-venant-kirchhoff:
//   V = (1/2)(c11 E11^2 + c22 E22^2) + c12 E11 E22 + 2 c66 E12^2,   E = (S^2 - 1)/2 in the plane,
//   E11 = (xi^2 + alpha^2 - 1)/2,  E22 = (zeta^2 + alpha^2 - 1)/2,  E12 = alpha (xi + zeta)/2.
//
// The material axes 1, 2 are its axes of symmetry: even in alpha. Polynomial. Isotropic where
// c11 = c22 = c12 + 2 c66: saint-venant-kirchhoff with mu = c66, lambda = c12.
#pragma once

#include <array>
#include <string_view>

#include "lib/material/models/potential_derivatives.hpp"

namespace stationary {

template <class C = double>
struct OrthotropicSaintVenantKirchhoff {
  C c11;
  C c22;
  C c12;
  C c66;

  static constexpr std::string_view name = "orthotropic-saint-venant-kirchhoff";
  static constexpr std::string_view formula =
      "(1/2)(c11 E11^2 + c22 E22^2) + c12 E11 E22 + 2 c66 E12^2,  E = (S^2 - 1)/2";
  static constexpr std::array<std::string_view, 4> parameters{"c11", "c22", "c12", "c66"};
  static constexpr std::array<std::string_view, 4> domain{"c11 > 0", "c22 > 0", "c11 c22 > c12^2",
                                                          "c66 > 0"};

  std::array<C, 4> coefficients() const { return {c11, c22, c12, c66}; }
  std::array<bool, 4> in_domain() const {
    return {c11 > 0.0, c22 > 0.0, c11 * c22 > c12 * c12, c66 > 0.0};
  }
  double rest_stretch() const { return 1.0; }

  /// Adds V and its derivatives to `out`.
  template <int order>
  void add(const BasicStretch<C>& q, PotentialDerivatives<C>& out) const {
    const C& a = q.alpha;
    const C& x = q.xi;
    const C& z = q.zeta;
    const C t = x + z;
    const C E11 = 0.5 * (square(x) + square(a) - C(1.0));
    const C E22 = 0.5 * (square(z) + square(a) - C(1.0));
    const C E12 = 0.5 * (a * t);
    // dV/dE of each.
    const C s11 = c11 * E11 + c12 * E22;
    const C s22 = c12 * E11 + c22 * E22;
    const C s12 = 4.0 * (c66 * E12);
    out.value += 0.5 * (s11 * E11 + s22 * E22 + s12 * E12);
    if constexpr (order >= 1) {
      out.gradient[0] += (s11 + s22) * a + 0.5 * (s12 * t);
      out.gradient[1] += s11 * x + 0.5 * (s12 * a);
      out.gradient[2] += s22 * z + 0.5 * (s12 * a);
      if constexpr (order >= 2) {
        auto& H = out.hessian;
        const C a2 = square(a);
        const C alpha_xi = (c11 + c12) * (a * x) + c66 * (a * t) + 0.5 * s12;
        const C alpha_zeta = (c22 + c12) * (a * z) + c66 * (a * t) + 0.5 * s12;
        const C xi_zeta = c12 * (x * z) + c66 * a2;
        H(0, 0) += (c11 + 2.0 * c12 + c22) * a2 + c66 * square(t) + s11 + s22;
        H(0, 1) += alpha_xi;
        H(1, 0) += alpha_xi;
        H(0, 2) += alpha_zeta;
        H(2, 0) += alpha_zeta;
        H(1, 1) += c11 * square(x) + c66 * a2 + s11;
        H(2, 2) += c22 * square(z) + c66 * a2 + s22;
        H(1, 2) += xi_zeta;
        H(2, 1) += xi_zeta;
      }
    }
  }
};

}  // namespace stationary
