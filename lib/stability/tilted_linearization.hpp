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
#pragma once

#include <array>

#include "lib/stability/linearization.hpp"

namespace stationary {

template <class S>
using Form5 = std::array<std::array<S, 5>, 5>;

template <class S>
struct TiltedForms {
  Form5<S> A;  ///< of (b1, xi, zeta, rho, p_alpha)
  Form5<S> B;  ///< of (b2, p_xi, p_zeta, p_rho, -alpha)
};

/// s.omega is |nu|; nu1, nu3 > 0 its components. s must be a tilted motion (not checked).
template <class S>
TiltedForms<S> tilted_forms(const StraightState<S>& s, const S& nu1, const S& nu3) {
  using std::sqrt;
  const auto& [J1, J2, J3] = s.J;
  const S inertia = s.I3();
  const S own = s.I2();
  const S P = inertia * s.omega;
  const S root = sqrt(P);
  const S n1 = nu1 / s.omega;
  const S n3 = nu3 / s.omega;
  const S g = J1 * s.xi - J2 * s.zeta;
  const S h = J1 * s.xi + J2 * s.zeta;
  const S D = J1 * J2 * ((s.xi + s.zeta) * (s.xi + s.zeta));
  const S none(0.0);
  const std::array<S, 5> w1{-(root * n3), none, -2.0 * (J2 * s.zeta * nu1),
                            -2.0 * (J3 * s.rho * nu1), none};
  const std::array<S, 5> w3{root * n1, -2.0 * (J1 * s.xi * nu3), -2.0 * (J2 * s.zeta * nu3), none,
                            none};
  const std::array<S, 5> wa{none, J1 * nu3, -(J2 * nu3), none, S(1.0)};
  const S nu3_squared = nu3 * nu3;
  const S stiffness[3][3] = {{s.V_xx - J1 * nu3_squared, s.V_xz, s.V_xr},
                             {s.V_xz, s.V_zz - J2 * (s.omega * s.omega), s.V_zr},
                             {s.V_xr, s.V_zr, s.V_rr - J3 * (nu1 * nu1)}};
  TiltedForms<S> out;
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < 5; ++j) {
      out.A[i][j] = w1[i] * w1[j] / inertia +
                    ((J1 + J2) * (w3[i] * w3[j]) + g * (w3[i] * wa[j] + wa[i] * w3[j]) +
                     inertia * (wa[i] * wa[j])) /
                        D;
      if (i >= 1 && i <= 3 && j >= 1 && j <= 3) out.A[i][j] += stiffness[i - 1][j - 1];
    }
    out.B[i].fill(none);
  }
  out.A[0][0] = P * (n1 * n1) * (g * g) / (D * inertia);
  out.B[0][0] = P * (inertia - own) / (inertia * own);
  out.B[1][1] = S(1.0) / J1;
  out.B[2][2] = S(1.0) / J2;
  out.B[3][3] = S(1.0) / J3;
  out.B[4][4] = h * h * (nu1 * nu1) / own + s.V_aa - J1 * (nu1 * nu1);
  out.B[0][4] = out.B[4][0] = root * h * nu1 / own;
  out.B[1][4] = out.B[4][1] = nu3;
  out.B[2][4] = out.B[4][2] = -nu3;
  return out;
}

}  // namespace stationary
