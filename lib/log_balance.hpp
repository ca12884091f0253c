// The balance at alpha = 0 in logarithmic coordinates (u, v, w) = ln (xi, zeta, rho): the gradient
// G and the Hessian of V - (c_xi xi^2 + c_zeta zeta^2 + c_rho rho^2)/2, in units of V.
#pragma once

#include "lib/number.hpp"

namespace stationary {

/// Residual G and the upper triangle of its symmetric Jacobian (order 2; NaN otherwise). Formulas
/// with w belong to coupled potentials; a separable one leaves rho to itself.
template <class S>
struct LogBalance {
  S g_xi;
  S g_zeta;
  S g_rho = poison<S>();
  S uu = poison<S>();
  S uv = poison<S>();
  S vv = poison<S>();
  S uw = poison<S>();
  S vw = poison<S>();
  S ww = poison<S>();
};

}  // namespace stationary
