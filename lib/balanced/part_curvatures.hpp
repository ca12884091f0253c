// What the balanced blocks take of a potential's parts: the second derivatives of the balance at
// equilibrium (log_balance.hpp), by that in as few terms as there are,
//
//   X (a_x X + b Z - l_x) = 0 = Z (a_z Z + b X - l_z),  X = xi^p:     uu = p a_x X^2, uv = p b X Z
//   (k - c) xi^2 = c/d = (k - c_zeta) zeta^2:                         uu = vv = 3 c/d, uv = c/d
//   (b - m) rho^2 = a/rho: ww = 3 a/rho;   (k - m) rho = k rest: ww = k rest rho
//
// and without what goes into the balance alone, logarithms mostly. Of a built-in model whose kind
// is known at run time its kind is asked before anything is computed.
#pragma once

#include "lib/balanced/spin_units.hpp"
#include "lib/body/stretch.hpp"
#include "lib/material/models/log_balance.hpp"
#include "lib/material/models/reciprocal_determinant.hpp"
#include "lib/material/models/thickness.hpp"

namespace stationary {

template <class S>
struct PlaneCurvatures {
  S uu, uv, vv;
};
/// Of both parts, in the body's own units.
template <class S>
struct Curvatures {
  PlaneCurvatures<S> plane;
  S w_l;  ///< pressure(), asked for only where xi and zeta are not apart
  S ww;
};

template <class Model, class S>
[[gnu::flatten]] PlaneCurvatures<S> plane_curvatures(const Model& model, const S& xi, const S& zeta,
                                                     const S& c_xi, const S& c_zeta) {
  if constexpr (requires { model.of_any_kind; }) {
    return model.visit(
        [&](const auto& own) { return plane_curvatures(own, xi, zeta, c_xi, c_zeta); });
  } else if constexpr (requires { model.linear_balance(c_xi, c_zeta); }) {
    constexpr int power = Model::balance_power;
    static_assert(power == 1 || power == 2);
    const S X = power == 1 ? xi : square(xi);
    const S Z = power == 1 ? zeta : square(zeta);
    const LinearBalance<S> b = model.linear_balance(c_xi, c_zeta);
    return {by_power(S(b.a_xi * square(X)), power), by_power(S(b.cross * (X * Z)), power),
            by_power(S(b.a_zeta * square(Z)), power)};
  } else {
    const LogBalance<S> b = model.log_balance(xi, zeta, c_xi, c_zeta);
    return {b.uu, b.uv, b.vv};
  }
}
template <class C, class S>
PlaneCurvatures<S> plane_curvatures(const ReciprocalDeterminant<C>& model, const S& xi,
                                    const S& zeta, const S&, const S&) {
  const S reciprocal = model.c / (xi * zeta);
  const S three = by_power(reciprocal, 2.0) + reciprocal;
  return {three, reciprocal, three};
}

template <class Model, class S>
[[gnu::flatten]] S thickness_curvature(const Model& model, const S& rho, const S& pull) {
  if constexpr (requires { model.of_any_kind; }) {
    return model.visit([&](const auto& own) { return thickness_curvature(own, rho, pull); });
  } else {
    const LogBalance<S> b = model.log_balance(rho, pull);
    return b.ww;
  }
}
template <class C, class S>
S thickness_curvature(const ReciprocalQuadratic<C>& model, const S& rho, const S&) {
  const S reciprocal = model.a / rho;
  return by_power(reciprocal, 2.0) + reciprocal;
}
template <class C, class S>
S thickness_curvature(const Harmonic<C>& model, const S& rho, const S&) {
  return S(model.k) * model.rest * rho;
}

/// w_l = dW/d ln d.
template <class Model, class S>
[[gnu::flatten]] S pressure(const Model& model, const S& xi, const S& zeta) {
  if constexpr (requires { model.of_any_kind; }) {
    return model.visit([&](const auto& own) { return pressure(own, xi, zeta); });
  } else {
    return model.template evaluate<1>(planar_invariants(xi, zeta)).w_l;
  }
}

}  // namespace stationary
