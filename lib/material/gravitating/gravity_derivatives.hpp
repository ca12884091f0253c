// The self-gravity of self_energy.hpp as a potential of the whole stretch, in
//
//   T = I33 = J1 (xi^2 + alpha^2) + J2 (zeta^2 + alpha^2),   l = ln d,   r = ln rho,
//
// V_g = -g F(T, J1 J2 d^2, J3 rho^2): with l and r for D and z what an isotropic potential has in
// (t, l, r), and T in the place of t. Isotropic itself only where J1 = J2.
#pragma once

#include "lib/body/stretch.hpp"
#include "lib/gravity/ellipsoid_integral.hpp"
#include "lib/gravity/moment_units.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

/// Derivatives of V_g in (T, l, r), named as those of an isotropic potential in (t, l, r).
/// order 0, 1, 2 as in evaluate().
template <int order, class S, class Inertias>
CoupledDerivatives<S> gravity_derivatives(const S& g, const Inertias& J, const S& T, const S& d,
                                          const S& rho) {
  if (const MomentUnits units(leading(T)); !units.are_own()) {
    const double u = units.moment;
    CoupledDerivatives<S> out = gravity_derivatives<order>(
        S(units.strength * g), Inertias{u * J.J1, u * J.J2, u * J.J3}, S(u * T), d, rho);
    // Those by T once more for each T.
    out.plane.w_t = u * out.plane.w_t;
    out.plane.w_tt = u * (u * out.plane.w_tt);
    out.plane.w_tl = u * out.plane.w_tl;
    out.w_tr = u * out.w_tr;
    return out;
  }
  const S D = J.J1 * J.J2 * (d * d);
  const S z = J.J3 * (rho * rho);
  const PowerSeries<S, order> F = ellipsoid_integral<order>(T, D, z);
  CoupledDerivatives<S> out;
  out.plane.w = -(g * F.derivative({0, 0, 0}));
  if constexpr (order >= 1) {
    const S of_d = 2.0 * D;
    const S of_rho = 2.0 * z;
    const S l = of_d * F.derivative({0, 1, 0});
    const S r = of_rho * F.derivative({0, 0, 1});
    out.plane.w_t = -(g * F.derivative({1, 0, 0}));
    out.plane.w_l = -(g * l);
    out.w_r = -(g * r);
    if constexpr (order >= 2) {
      out.plane.w_tt = -(g * F.derivative({2, 0, 0}));
      out.plane.w_tl = -(g * (of_d * F.derivative({1, 1, 0})));
      out.plane.w_ll = -(g * (2.0 * l + of_d * of_d * F.derivative({0, 2, 0})));
      out.w_tr = -(g * (of_rho * F.derivative({1, 0, 1})));
      out.w_lr = -(g * (of_d * of_rho * F.derivative({0, 1, 1})));
      out.w_rr = -(g * (2.0 * r + of_rho * of_rho * F.derivative({0, 0, 2})));
    }
  }
  return out;
}

/// Derivatives in (T, l, r) as derivatives in (t, l, r) at J1 = J2 = J, T = J (t^2 - 2 d).
template <int order, class S>
CoupledDerivatives<S> gravity_of_trace(const CoupledDerivatives<S>& V, const S& J, const S& t,
                                       const S& d) {
  CoupledDerivatives<S> out = V;
  if constexpr (order >= 1) {
    const S T_t = 2.0 * (J * t);
    const S T_l = -2.0 * (J * d);
    out.plane.w_t = T_t * V.plane.w_t;
    out.plane.w_l = V.plane.w_l + T_l * V.plane.w_t;
    if constexpr (order >= 2) {
      out.plane.w_tt = T_t * T_t * V.plane.w_tt + 2.0 * (J * V.plane.w_t);
      out.plane.w_tl = T_t * (V.plane.w_tl + T_l * V.plane.w_tt);
      out.plane.w_ll = V.plane.w_ll + T_l * (2.0 * V.plane.w_tl + T_l * V.plane.w_tt + V.plane.w_t);
      out.w_tr = T_t * V.w_tr;
      out.w_lr = V.w_lr + T_l * V.w_tr;
    }
  }
  return out;
}

/// I33 of a stretch.
template <class S, class Inertias>
S planar_moment(const Inertias& J, const BasicStretch<S>& q) {
  const S shear = square(q.alpha);
  return J.J1 * (square(q.xi) + shear) + J.J2 * (square(q.zeta) + shear);
}

}  // namespace stationary
