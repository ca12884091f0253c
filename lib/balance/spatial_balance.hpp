// An axis in no material plane, nu1 nu2 nu3 != 0. Compatibility leaves it to bodies with det S = C
// held, J1 != J2 and a potential W(t, d) + V_rho that is isotropic but for its gravity V_g(T, D, z).
// With S and J of the plane of axes 1 and 2, n = (nu1, nu2) and
//
//   B = S J S,   B n = tau n,   tau = J3 rho^2,   sigma = J1 J2 d^2/tau   (the eigenvalues of B)
//   w = |nu|^2 - 2 V_T                                                    (V_T of gravity)
//
// the balance of the plane times S is a symmetric M = (w tau - tau |n|^2 - c) along n, (w sigma - c)
// across it, with S^-1 M + M S^-1 = 2 W_t: M = W_t S. That commutes with B, and S does not unless
// alpha = 0: so M = 0, and with rho's own balance
//
//   W_t = 0,   trace B = tau + sigma,   (tau - 2 sigma) w = rho V_rho - d V_d
//   nu3^2 = 2 V_T + (sigma/tau) w,   |n|^2 = (1 - sigma/tau) w.
//
// The first three have the unknowns xi, zeta and a (anisotropic_balance.hpp) at |nu|, and are even
// in a: alpha -> -alpha, nu2 -> -nu2 is a mirror image. rho = C/d.
#pragma once

#include <array>
#include <cmath>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/material/gravitating/body_model.hpp"

namespace stationary {

/// All that the equations and the axis are made of.
template <class S>
struct SpatialState {
  OrientedStretch<S> at;  ///< at the volume held
  S tau;
  S sigma;
  S moment;         ///< trace B
  S trace_force;    ///< t W_t, of the elastic energy alone
  S plane_force;    ///< d W_d, likewise, a size to compare it with
  S difference;     ///< rho V_rho - d V_d
  S gravity_slope;  ///< V_T, zero without gravity

  S w(const S& square_nu) const { return square_nu - 2.0 * gravity_slope; }
};

template <class S>
SpatialState<S> spatial_state(const Inertia3<S>& J, const BodyModel<S>& model, const S& xi,
                              const S& zeta, const S& x_a) {
  SpatialState<S> out;
  out.at = at_volume<S>(*model.volume, oriented_stretch<S>(xi, zeta, S(1.0), x_a));
  const BasicStretch<S>& q = out.at.q;
  const S t = xi + zeta;
  const S d = xi * zeta * square(out.at.sech);
  out.tau = J.J3 * square(q.rho);
  out.sigma = J.J1 * J.J2 * square(d) / out.tau;
  out.moment = planar_moment(J, q);
  const CoupledDerivatives<S> W =
      model.elastic.template evaluate<1>(PlanarInvariants<S>{t, d, out.at.invariants().e}, q.rho);
  out.trace_force = t * W.plane.w_t;
  out.plane_force = W.plane.w_l;
  out.difference = W.w_r - W.plane.w_l;
  out.gravity_slope = S(0.0);
  if (model.gravitates) {
    const CoupledDerivatives<S> V = gravity_derivatives<1>(model.g, J, out.moment, d, q.rho);
    out.gravity_slope = V.plane.w_t;
    out.difference += V.w_r - V.plane.w_l;
  }
  return out;
}

/// The three equations.
template <class S>
std::array<S, 3> spatial_balance(const SpatialState<S>& at, const S& square_nu) {
  return {at.trace_force, at.moment - at.tau - at.sigma,
          (at.tau - 2.0 * at.sigma) * at.w(square_nu) - at.difference};
}

/// |n|^2 and nu3^2 at a solution. Negative: there is no motion.
template <class S>
struct SpatialSquares {
  S in_plane;
  S normal;
};
template <class S>
SpatialSquares<S> spatial_squares(const SpatialState<S>& at, const S& square_nu) {
  const S share = at.sigma / at.tau;
  const S w = at.w(square_nu);
  return {(1.0 - share) * w, 2.0 * at.gravity_slope + share * w};
}

/// A vector along n, nu1 >= 0 for alpha > 0: the columns of B - sigma, the longer of them.
template <class S>
std::array<S, 2> spatial_direction(const Inertia3<S>& J, const SpatialState<S>& at) {
  const BasicStretch<S>& q = at.at.q;
  const S shear = square(q.alpha);
  const S first = J.J1 * square(q.xi) + J.J2 * shear - at.sigma;
  const S second = J.J1 * shear + J.J2 * square(q.zeta) - at.sigma;
  const S product = (J.J1 * q.xi + J.J2 * q.zeta) * q.alpha;
  if (std::abs(leading(first)) >= std::abs(leading(second)))
    return leading(first) < 0.0 ? std::array<S, 2>{-first, -product}
                                : std::array<S, 2>{first, product};
  return leading(product) < 0.0 ? std::array<S, 2>{-product, -second}
                                : std::array<S, 2>{product, second};
}

}  // namespace stationary
