// What a potential returns: value, first and second derivatives from one evaluation.
//
// An isotropic potential is W(t, l, r) with t = xi + zeta, l = ln d, r = ln rho. The logarithms
// cost nothing (d and rho are positive), and what a solve needs is W_l = d dW/dd and W_r = rho
// dW/drho, in which most models have no division at all. order = 0, 1, 2 says how far to
// differentiate; what was not asked for is NaN.
//
// A model also gives its balance at alpha = 0 directly, log_balance(xi, zeta, c_xi, c_zeta): in the
// stretches themselves, the centrifugal terms gathered with the elastic ones, each variable as
// rarely as can be. Evaluated over intervals that is far narrower than the way through t and l,
// where tr S^2 = t^2 - 2 d cancels.
#pragma once

#include "lib/material/models/log_balance.hpp"
#include "lib/number/number.hpp"

namespace stationary {

/// Of a planar isotropic potential W(t, l): w_l = dW/dl at fixed t, and so on.
template <class S>
struct PlanarDerivatives {
  S w = poison<S>();
  S w_t = poison<S>();
  S w_l = poison<S>();
  S w_tt = poison<S>();
  S w_tl = poison<S>();
  S w_ll = poison<S>();
};

/// Of a thickness potential V(r), r = ln rho.
template <class S>
struct ThicknessDerivatives {
  S v = poison<S>();
  S v_r = poison<S>();
  S v_rr = poison<S>();
};

/// Of an isotropic potential W(t, l, r) of the whole stretch.
template <class S>
struct CoupledDerivatives {
  PlanarDerivatives<S> plane;
  S w_r = poison<S>();
  S w_rr = poison<S>();
  S w_tr = poison<S>();
  S w_lr = poison<S>();
};

/// evaluate<order>() for who has no use for the value: a formula leaves it NaN, and computes nothing
/// that it alone takes.
template <int order, class Model, class... At>
[[gnu::always_inline]] inline auto forces(const Model& model, const At&... at) {
  if constexpr (requires { model.template forces<order>(at...); }) {
    return model.template forces<order>(at...);
  } else {
    return model.template evaluate<order>(at...);
  }
}

}  // namespace stationary
