// The balance at alpha = 0 in logarithmic coordinates (u, v, w) = ln (xi, zeta, rho): the gradient
// G and the Hessian of V - (c_xi xi^2 + c_zeta zeta^2 + c_rho rho^2)/2, in units of V.
#pragma once

#include "lib/number/number.hpp"

namespace stationary {

/// Residual G and the upper triangle of its symmetric Jacobian (order 2; NaN otherwise). A
/// separable potential leaves rho to itself: its plane has none of the rows with w, its thickness
/// only those.
template <class S>
struct LogBalance {
  S g_xi = poison<S>();
  S g_zeta = poison<S>();
  S g_rho = poison<S>();
  S uu = poison<S>();
  S uv = poison<S>();
  S vv = poison<S>();
  S uw = poison<S>();
  S vw = poison<S>();
  S ww = poison<S>();
};

/// A balance that is linear in X = xi^p, Z = zeta^p:
///   G_xi = X (a_xi X + cross Z - load_xi),  G_zeta = Z (a_zeta Z + cross X - load_zeta).
template <class S>
struct LinearBalance {
  S a_xi;
  S a_zeta;
  S cross;
  S load_xi;
  S load_zeta;
};

template <int p, class S, class Q>
LogBalance<S> log_balance(const LinearBalance<S>& b, const Q& X, const Q& Z) {
  const S stiff_xi = b.a_xi * X;
  const S stiff_zeta = b.a_zeta * Z;
  const S rest_xi = b.cross * Z - b.load_xi;
  const S rest_zeta = b.cross * X - b.load_zeta;
  constexpr double power = p;
  return {.g_xi = X * (stiff_xi + rest_xi),
          .g_zeta = Z * (stiff_zeta + rest_zeta),
          .uu = power * X * (2.0 * stiff_xi + rest_xi),
          .uv = power * b.cross * (X * Z),
          .vv = power * Z * (2.0 * stiff_zeta + rest_zeta)};
}

}  // namespace stationary
