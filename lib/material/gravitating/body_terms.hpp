// What a body is beside its elastic energy: its own gravity, V_g = -g F(T, D, z)
// (gravity_derivatives.hpp), and a held volume, det S = C (held_volume.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "lib/body/inertia.hpp"
#include "lib/material/gravitating/gravity_derivatives.hpp"
#include "lib/material/models/potential_derivatives.hpp"

namespace stationary {

/// The mass distribution by itself: J1, J2, J3.
template <class C>
struct GravitatingInertia {
  C J1;
  C J2;
  C J3;
};

template <class C>
struct BodyTerms {
  bool gravitates = false;  ///< else g and J do not enter
  C g = C(0.0);
  GravitatingInertia<C> J{};
  std::optional<C> volume;
  /// k of the volume's equation: of the size of V's second derivatives.
  double stiffness = 1.0;

  bool any() const { return gravitates || volume; }
};

/// From derivatives of V_g in (T, l, r) those in q, added.
template <int order, class R>
void add_gravity(const CoupledDerivatives<R>& V, const GravitatingInertia<R>& J,
                 const BasicStretch<R>& q, PotentialDerivatives<R>& out) {
  // By l and r as of any potential, T being none of q's traces.
  CoupledDerivatives<R> without = V;
  without.plane.w_t = without.plane.w_tt = without.plane.w_tl = without.w_tr = R(0.0);
  const PotentialDerivatives<R> rest = in_stretch<order>(without, q);
  out.value += rest.value;
  if constexpr (order >= 1) {
    const Vector4<R> T{2.0 * ((J.J1 + J.J2) * q.alpha), 2.0 * (J.J1 * q.xi), 2.0 * (J.J2 * q.zeta),
                       R(0.0)};
    out.gradient += rest.gradient + V.plane.w_t * T;
    if constexpr (order >= 2) {
      const R inverse_d = R(1.0) / planar_invariants(q).d;
      const Vector4<R> l{-2.0 * q.alpha * inverse_d, q.zeta * inverse_d, q.xi * inverse_d, R(0.0)};
      const Vector4<R> r{R(0.0), R(0.0), R(0.0), R(1.0) / q.rho};
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          out.hessian(i, j) += rest.hessian(i, j) + V.plane.w_tt * (T[i] * T[j]) +
                               V.plane.w_tl * (T[i] * l[j] + l[i] * T[j]) +
                               V.w_tr * (T[i] * r[j] + r[i] * T[j]);
      out.hessian(0, 0) += 2.0 * ((J.J1 + J.J2) * V.plane.w_t);
      out.hessian(1, 1) += 2.0 * (J.J1 * V.plane.w_t);
      out.hessian(2, 2) += 2.0 * (J.J2 * V.plane.w_t);
    }
  }
}

/// From derivatives in q at rho = C/d those along the held volume, rho following alpha, xi and zeta.
template <int order, class R>
PotentialDerivatives<R> along_volume(const PotentialDerivatives<R>& V, const BasicStretch<R>& q) {
  PotentialDerivatives<R> out = V;
  if constexpr (order >= 1) {
    // rho_k = -rho l_k with l = ln d; rho_kl = rho (2 l_k l_l - d_kl/d).
    const R inverse_d = R(1.0) / planar_invariants(q).d;
    const std::array<R, 3> l{-2.0 * q.alpha * inverse_d, q.zeta * inverse_d, q.xi * inverse_d};
    for (int i = 0; i < 3; ++i)
      out.gradient[i] -= q.rho * l[static_cast<std::size_t>(i)] * V.gradient[3];
    out.gradient[3] = R(0.0);
    if constexpr (order >= 2) {
      const R pull = V.gradient[3] * q.rho;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const R& l_i = l[static_cast<std::size_t>(i)];
          const R& l_j = l[static_cast<std::size_t>(j)];
          out.hessian(i, j) += q.rho * (q.rho * V.hessian(3, 3) * l_i * l_j -
                                        V.hessian(i, 3) * l_j - V.hessian(j, 3) * l_i) +
                               2.0 * (pull * l_i * l_j);
        }
        out.hessian(i, 3) = out.hessian(3, i) = R(0.0);
      }
      out.hessian(3, 3) = R(0.0);
      out.hessian(0, 0) += 2.0 * (pull * inverse_d);
      out.hessian(1, 2) -= pull * inverse_d;
      out.hessian(2, 1) -= pull * inverse_d;
    }
  }
  return out;
}

// Compiled once, in material/compiled_models.cpp: they are long, and every solver comes by them.
#define STATIONARY_COMPILED_TERM(keyword, S)                                                   \
  keyword PotentialDerivatives<S> in_stretch<2>(const CoupledDerivatives<S>&,                  \
                                                const BasicStretch<S>&);                       \
  keyword CoupledDerivatives<S> gravity_derivatives<2>(const S&, const GravitatingInertia<S>&, \
                                                       const S&, const S&, const S&);          \
  keyword void add_gravity<2>(const CoupledDerivatives<S>&, const GravitatingInertia<S>&,      \
                              const BasicStretch<S>&, PotentialDerivatives<S>&);               \
  keyword PotentialDerivatives<S> along_volume<2>(const PotentialDerivatives<S>&,              \
                                                  const BasicStretch<S>&);
#define STATIONARY_COMPILED_TERMS(keyword)        \
  STATIONARY_COMPILED_TERM(keyword, DoubleDouble) \
  STATIONARY_COMPILED_TERM(keyword, Interval)     \
  STATIONARY_COMPILED_TERM(keyword, Conditioned)
STATIONARY_COMPILED_TERMS(extern template)

}  // namespace stationary
