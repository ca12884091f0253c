// The constraint det S = d rho = C, held exactly: rho is eliminated from a potential,
//
//   V_C(t, l) = V(t, l, ln C - l),
//
// and stays an unknown beside xi and zeta with the equation l + r = ln C of its own. All three are
// the gradient, in (ln xi, ln zeta, ln rho), of
//
//   V_C - (c_xi xi^2 + c_zeta zeta^2 + c_rho rho_C^2)/2 + (k/2) (l + r - ln C)^2,   rho_C = C/d,
//
// for any stiffness k > 0: at a solution the last term and its gradient vanish, whatever k is. So
// G_xi = Gamma_1 - Gamma_3, G_zeta = Gamma_2 - Gamma_3 with Gamma_k = s_k V_k - c_k s_k^2, and the
// Jacobian is symmetric as that of any other body.
#pragma once

#include "lib/material/models/log_balance.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

/// From derivatives of V in (t, l, r) at r = ln C - l those of V_C.
template <int order, class S>
CoupledDerivatives<S> held(const CoupledDerivatives<S>& V) {
  CoupledDerivatives<S> out = V;
  if constexpr (order >= 1) {
    out.plane.w_l = V.plane.w_l - V.w_r;
    out.w_r = S(0.0);
    if constexpr (order >= 2) {
      out.plane.w_tl = V.plane.w_tl - V.w_tr;
      out.plane.w_ll = V.plane.w_ll - 2.0 * V.w_lr + V.w_rr;
      out.w_tr = out.w_lr = out.w_rr = S(0.0);
    }
  }
  return out;
}

/// From the balance of all three stretches at rho_C that of the held volume, without k.
template <int order, class S>
LogBalance<S> held(const LogBalance<S>& b) {
  LogBalance<S> out;
  out.g_xi = b.g_xi - b.g_rho;
  out.g_zeta = b.g_zeta - b.g_rho;
  out.g_rho = S(0.0);
  if constexpr (order >= 2) {
    out.uu = b.uu - 2.0 * b.uw + b.ww;
    out.uv = b.uv - b.uw - b.vw + b.ww;
    out.vv = b.vv - 2.0 * b.vw + b.ww;
    out.uw = out.vw = out.ww = S(0.0);
  }
  return out;
}

/// With the equation of the volume: excess = l + r - ln C, k > 0.
template <int order, class S>
LogBalance<S> with_volume(LogBalance<S> b, const S& excess, double k) {
  const S pull = k * excess;
  for (S* g : {&b.g_xi, &b.g_zeta, &b.g_rho}) *g += pull;
  if constexpr (order >= 2)
    for (S* slope : {&b.uu, &b.uv, &b.vv, &b.uw, &b.vw, &b.ww}) *slope += S(k);
  return b;
}

}  // namespace stationary
