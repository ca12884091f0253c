// V = W(t, l) + V_rho(r): a planar model and a thickness model with the interface of a coupled one
// (model_derivatives.hpp).
#pragma once

#include <type_traits>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

/// A planar model and a thickness model as one isotropic model; W_tr = W_lr = 0.
template <class Plane, class Thickness>
struct Separable {
  Plane plane;
  Thickness thickness;

  template <int order, class S>
  auto evaluate(const PlanarInvariants<S>& x, const S& rho) const {
    const auto axial = thickness.template evaluate<order>(rho);
    auto out = joined<order>(plane.template evaluate<order>(x), axial);
    out.plane.w = out.plane.w + axial.v;
    return out;
  }
  template <int order, class S>
  auto forces(const PlanarInvariants<S>& x, const S& rho) const {
    return joined<order>(stationary::forces<order>(plane, x),
                         stationary::forces<order>(thickness, rho));
  }

  template <class S>
  auto log_balance(const S& xi, const S& zeta, const S& rho, const S& c_xi, const S& c_zeta,
                   const S& c_rho) const {
    auto out = plane.log_balance(xi, zeta, c_xi, c_zeta);
    const auto axial = thickness.log_balance(rho, c_rho);
    out.g_rho = axial.g_rho;
    out.uw = out.vw = decltype(out.uw)(0.0);
    out.ww = axial.ww;
    return out;
  }

 private:
  /// All but the sum of the values.
  template <int order>
  static auto joined(const auto& planar, const auto& axial) {
    CoupledDerivatives<std::remove_cvref_t<decltype(planar.w + axial.v)>> out;
    out.plane = planar;
    out.w_r = axial.v_r;
    out.w_rr = axial.v_rr;
    if constexpr (order >= 2) out.w_tr = out.w_lr = decltype(out.w_tr)(0.0);
    return out;
  }
};

}  // namespace stationary
