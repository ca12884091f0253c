// The second variation E'' of a motion about an axis tilted in the 1-3 plane (alpha = 0, isotropic
// V) in two halves. Reflection in that plane with time reversed leaves the motion as it is; it
// tells
//
//   u = (b1, xi, zeta, rho, p_alpha)  from  v = (b2, p_xi, p_zeta, p_rho, -alpha),
//   E'' = u^T A u + v^T B v,   u' = B v,  v' = -A u,   so the Lambda are the eigenvalues of -B A,
//
// with the leaf's coordinates (symplectic_leaf.hpp): delta pi = sqrt|pi| (b1 e1 + b2 e2), e1 in the
// plane. With I = I1 = I3 (what compatibility asks for), n = nu/|nu|, P = |pi| = I |nu|,
// g = J1 xi - J2 zeta, h = J1 xi + J2 zeta, D = J1 J2 (xi + zeta)^2 and the linear forms of u that
// the momenta leave,
//   w1 = -sqrt P n3 b1 - 2 J2 zeta nu1 dzeta - 2 J3 rho nu1 drho,
//   w3 =  sqrt P n1 b1 - 2 J1 xi nu3 dxi - 2 J2 zeta nu3 dzeta,
//   wa =  p_alpha + J1 nu3 dxi - J2 nu3 dzeta,
//   A  =  w1^2/I + [(J1 + J2) w3^2 + 2 g w3 wa + I wa^2]/D
//         + V_xx - diag(J1 nu3^2, J2 |nu|^2, J3 nu1^2) - P b1^2/I,
// whose b1 b1 entry is P n1^2 g^2/(D I).
// The 2-3 plane: axes 1 and 2 exchanged.
//
// Of a held volume rho = C/(xi zeta): drho = -rho (dxi/xi + dzeta/zeta), V_xx is V's along the volume
// with the pull of nu1 on rho (held_linearization.hpp), p_rho is none, and from B goes
//   (rho p_xi/(J1 xi) + rho p_zeta/(J2 zeta) - nu3 (rho/xi - rho/zeta) dalpha)^2
//     / (1/J3 + rho^2/(J1 xi^2) + rho^2/(J2 zeta^2)):
// u = (b1, xi, zeta, p_alpha), v = (b2, p_xi, p_zeta, -alpha).
#pragma once

#include <array>

#include "lib/matrix/characteristic.hpp"
#include "lib/stability/held_linearization.hpp"

namespace stationary {

/// n = 5; 4 of a held volume, without rho and p_rho.
template <class S, std::size_t n>
struct TiltedForms {
  SquareForm<S, n> A;  ///< of (b1, xi, zeta, rho, p_alpha)
  SquareForm<S, n> B;  ///< of (b2, p_xi, p_zeta, p_rho, -alpha)
};

namespace tilted_detail {

/// Linear forms of u, and V_xx less C(nu).
template <class S, std::size_t n>
struct Parts {
  std::array<S, n> w1;
  std::array<S, n> w3;
  std::array<S, n> wa;
  SquareForm<S, n - 2> stiffness;
};

template <class S, std::size_t n>
TiltedForms<S, n> forms(const StraightState<S>& s, const S& nu1, const S& nu3,
                        const Parts<S, n>& parts) {
  const auto& [J1, J2, J3] = s.J;
  const S inertia = s.I3();
  const S own = s.I2();
  const S P = inertia * s.omega;
  const S n1 = nu1 / s.omega;
  const S g = J1 * s.xi - J2 * s.zeta;
  const S h = J1 * s.xi + J2 * s.zeta;
  const S D = J1 * J2 * ((s.xi + s.zeta) * (s.xi + s.zeta));
  const S none(0.0);
  TiltedForms<S, n> out;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      out.A[i][j] = parts.w1[i] * parts.w1[j] / inertia +
                    ((J1 + J2) * (parts.w3[i] * parts.w3[j]) +
                     g * (parts.w3[i] * parts.wa[j] + parts.wa[i] * parts.w3[j]) +
                     inertia * (parts.wa[i] * parts.wa[j])) /
                        D;
      if (i >= 1 && i < n - 1 && j >= 1 && j < n - 1) out.A[i][j] += parts.stiffness[i - 1][j - 1];
    }
    out.B[i].fill(none);
  }
  constexpr std::size_t alpha = n - 1;
  using std::sqrt;
  out.A[0][0] = P * (n1 * n1) * (g * g) / (D * inertia);
  out.B[0][0] = P * (inertia - own) / (inertia * own);
  out.B[1][1] = S(1.0) / J1;
  out.B[2][2] = S(1.0) / J2;
  if constexpr (n == 5) out.B[3][3] = S(1.0) / J3;
  out.B[alpha][alpha] = h * h * (nu1 * nu1) / own + s.V_aa - J1 * (nu1 * nu1);
  out.B[0][alpha] = out.B[alpha][0] = S(sqrt(P)) * h * nu1 / own;
  out.B[1][alpha] = out.B[alpha][1] = nu3;
  out.B[2][alpha] = out.B[alpha][2] = -nu3;
  return out;
}

}  // namespace tilted_detail

/// s.omega is |nu|; nu1, nu3 > 0 its components. s must be a tilted motion (not checked).
template <class S>
TiltedForms<S, 5> tilted_forms(const StraightState<S>& s, const S& nu1, const S& nu3) {
  using std::sqrt;
  const auto& [J1, J2, J3] = s.J;
  const S root = sqrt(S(s.I3() * s.omega));
  const S none(0.0);
  const S nu3_squared = nu3 * nu3;
  return tilted_detail::forms<S, 5>(
      s, nu1, nu3,
      {{-(root * (nu3 / s.omega)), none, -2.0 * (J2 * s.zeta * nu1), -2.0 * (J3 * s.rho * nu1),
        none},
       {root * (nu1 / s.omega), -2.0 * (J1 * s.xi * nu3), -2.0 * (J2 * s.zeta * nu3), none, none},
       {none, J1 * nu3, -(J2 * nu3), none, S(1.0)},
       {{{s.V_xx - J1 * nu3_squared, s.V_xz, s.V_xr},
         {s.V_xz, s.V_zz - J2 * (s.omega * s.omega), s.V_zr},
         {s.V_xr, s.V_zr, s.V_rr - J3 * (nu1 * nu1)}}}});
}

/// Of a held volume: s has V's second derivatives along it.
template <class S>
TiltedForms<S, 4> held_tilted_forms(const StraightState<S>& along, const S& nu1, const S& nu3) {
  using std::sqrt;
  const StraightState<S> s = with_thickness_pull(along, S(along.J.J3 * (nu1 * nu1)));
  const auto& [J1, J2, J3] = s.J;
  const S root = sqrt(S(s.I3() * s.omega));
  const S none(0.0);
  const S per_xi = s.rho / s.xi;
  const S per_zeta = s.rho / s.zeta;
  const S thick = 2.0 * (J3 * s.rho * nu1);
  TiltedForms<S, 4> out = tilted_detail::forms<S, 4>(
      s, nu1, nu3,
      {{-(root * (nu3 / s.omega)), thick * per_xi, thick * per_zeta - 2.0 * (J2 * s.zeta * nu1),
        none},
       {root * (nu1 / s.omega), -2.0 * (J1 * s.xi * nu3), -2.0 * (J2 * s.zeta * nu3), none},
       {none, J1 * nu3, -(J2 * nu3), S(1.0)},
       {{{s.V_xx - J1 * (nu3 * nu3), s.V_xz}, {s.V_xz, s.V_zz - J2 * (s.omega * s.omega)}}}});
  // Of v; the last is -alpha.
  const std::array<S, 4> across{none, per_xi / J1, per_zeta / J2, nu3 * (per_xi - per_zeta)};
  const S size = S(1.0) / J3 + per_xi * per_xi / J1 + per_zeta * per_zeta / J2;
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = 1; j < 4; ++j) out.B[i][j] -= across[i] * across[j] / size;
  return out;
}

}  // namespace stationary
