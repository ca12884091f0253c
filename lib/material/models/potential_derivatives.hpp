// What a potential of the whole stretch returns in q = (alpha, xi, zeta, rho), and the chain rule
// from an isotropic one's own variables t, l = ln d, r = ln rho:
//
//   V_q = W_t t_q + W_l l_q + W_r r_q,   l_q = (-2 alpha, zeta, xi)/d,  r_q = 1/rho,
//   V_qq = W_tt t_q t_q + W_tl (t_q l_q + l_q t_q) + (W_ll - W_l) l_q l_q + W_l d_qq/d + ...
#pragma once

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"

namespace stationary {

/// V(q), its gradient (4) and Hessian (4x4) in q = (alpha, xi, zeta, rho).
template <class S>
struct PotentialDerivatives {
  S value;
  Vector4<S> gradient;
  Matrix4<S> hessian;
};

/// The chain rule above. order 0, 1, 2 as in evaluate(); what was not asked for is NaN. first = 1: without
/// the derivatives in alpha.
template <int order, int first = 0, class R, class S>
PotentialDerivatives<R> in_stretch(const CoupledDerivatives<R>& w, const BasicStretch<S>& q) {
  PotentialDerivatives<R> out{w.plane.w, Vector4<R>::Constant(poison<R>()),
                              Matrix4<R>::Constant(poison<R>())};
  if constexpr (order >= 1) {
    const S inverse_d = S(1.0) / planar_invariants(q).d;
    const S inverse_rho = S(1.0) / q.rho;
    const S l[3] = {-2.0 * q.alpha * inverse_d, q.zeta * inverse_d, q.xi * inverse_d};
    const R w_l = w.plane.w_l;
    if constexpr (first == 0) out.gradient[0] = w_l * l[0];
    out.gradient[1] = w.plane.w_t + w_l * l[1];
    out.gradient[2] = w.plane.w_t + w_l * l[2];
    out.gradient[3] = w.w_r * inverse_rho;
    if constexpr (order >= 2) {
      const R curvature = w.plane.w_ll - w_l;
      auto& H = out.hessian;
      for (int i = first; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
          R h = curvature * (l[i] * l[j]);
          if (i > 0) h += w.plane.w_tl * l[j];
          if (j > 0) h += w.plane.w_tl * l[i];
          if (i > 0 && j > 0) h += w.plane.w_tt;
          H(i, j) = h;
        }
        R h = w.w_lr * l[i];
        if (i > 0) h += w.w_tr;
        H(i, 3) = h * inverse_rho;
      }
      if constexpr (first == 0) H(0, 0) += -2.0 * w_l * inverse_d;
      H(1, 2) += w_l * inverse_d;
      H(3, 3) = (w.w_rr - w.w_r) * (inverse_rho * inverse_rho);
      for (int i = first + 1; i < 4; ++i)
        for (int j = first; j < i; ++j) H(i, j) = H(j, i);
    }
  }
  return out;
}

}  // namespace stationary
