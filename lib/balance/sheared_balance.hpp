// Motions with alpha != 0 of a body with J1 != J2 and a potential W(t, d, rho) that is isotropic but for
// its gravity V_g(T, D, z); V = W + V_g. With S and J of the plane of axes 1 and 2, n = (nu1, nu2) and
//
//   B = S J S,   T = trace B,   tau = J3 rho^2,   w = |nu|^2 - 2 V_T          (V_T of gravity)
//   c = d V_d,   f = rho V_rho                                                (V_T left out)
//
// compatibility makes n zero or an eigenvector of B; sigma is the eigenvalue across it. The balance of
// the plane times S is then a symmetric M, ((w - |n|^2)(T - sigma) - c) along n and (w sigma - c) across
// it, with S^-1 M + M S^-1 = 2 W_t: M = W_t S. That commutes with B, and S does not unless alpha = 0: so
// M = 0, and with rho's own balance
//
//   W_t = 0,   c = w sigma,   (w - |n|^2)(T - sigma) = w sigma,   f = |n|^2 tau,
//
// of a held volume f - c alone, its pressure taking the rest. By the axis:
//
//   axis 3         n = 0          w = 0 (B is no multiple of 1)
//   oblique        nu3 = 0        D e^2 = -2 T^2 V_T w, so that w < 0,  sigma = 2 V_T T/e, the larger of the
//                                 eigenvalues,  e = 4 V_T - |nu|^2
//   in no plane    B n = tau n    T = tau + sigma, sigma = D/tau;  |n|^2 = (1 - sigma/tau) w,
//                                 nu3^2 = 2 V_T + (sigma/tau) w
//
// The first two need V_T > 0, gravity. All of it is a matter of (t, d, T, rho), t = xi + zeta, from which
//
//   J1 xi + J2 zeta = (T + (J1 + J2) d)/t,   alpha^2 = xi zeta - d:
//
// these are the unknowns of a search, and xi, zeta, rho and a (anisotropic_balance.hpp) those of a family,
// at |nu|; of a held volume rho = C/d. The equations are even in a: alpha -> -alpha, nu2 -> -nu2 is a
// mirror image. At a = 0 they hold where W_t = 0 on the motions with alpha = 0 about that axis, or in its
// plane.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/body/motion.hpp"
#include "lib/material/gravitating/body_model.hpp"

namespace stationary {

enum class ShearedAxis : std::uint8_t { third, oblique, in_no_plane };

/// All that the equations are made of.
template <class S>
struct ShearedState {
  S moment;  ///< T
  S tau;
  S area;           ///< D
  S sigma;          ///< about axis 3: not used
  S trace_force;    ///< t W_t
  S plane_pull;     ///< c
  S thick_pull;     ///< f
  S gravity_slope;  ///< V_T, zero without gravity

  S w(const S& square_nu) const { return square_nu - 2.0 * gravity_slope; }
  /// e.
  S excess(const S& square_nu) const { return 4.0 * gravity_slope - square_nu; }
};

template <class S>
ShearedState<S> sheared_state(ShearedAxis axis, const Inertia3<S>& J, const BodyModel<S>& model,
                              const PlanarInvariants<S>& x, const S& moment, const S& rho,
                              const S& square_nu) {
  ShearedState<S> out;
  out.moment = moment;
  out.area = J.J1 * J.J2 * square(x.d);
  out.tau = J.J3 * square(rho);
  const CoupledDerivatives<S> W = model.elastic.template evaluate<1>(x, rho);
  out.trace_force = x.t * W.plane.w_t;
  out.plane_pull = W.plane.w_l;
  out.thick_pull = W.w_r;
  out.gravity_slope = S(0.0);
  if (model.gravitates) {
    const CoupledDerivatives<S> V = gravity_derivatives<1>(model.g, J, moment, x.d, rho);
    out.gravity_slope = V.plane.w_t;
    out.plane_pull += V.plane.w_l;
    out.thick_pull += V.w_r;
  }
  out.sigma = S(0.0);
  if (axis == ShearedAxis::in_no_plane) out.sigma = out.area / out.tau;
  if (axis == ShearedAxis::oblique)
    out.sigma = 2.0 * (out.gravity_slope * moment) / out.excess(square_nu);
  return out;
}

/// Likewise at a stretch, at the volume held where it is.
template <class S>
struct ShearedPoint : ShearedState<S> {
  OrientedStretch<S> at;
};
template <class S>
ShearedPoint<S> sheared_point(ShearedAxis axis, const Inertia3<S>& J, const BodyModel<S>& model,
                              const S& xi, const S& zeta, const S& rho, const S& x_a,
                              const S& square_nu) {
  OrientedStretch<S> at = oriented_stretch<S>(xi, zeta, rho, x_a);
  if (model.volume) at = at_volume<S>(*model.volume, at);
  const S moment = planar_moment(J, at.q);
  return {sheared_state<S>(axis, J, model, at.invariants(), moment, at.q.rho, square_nu), at};
}

/// The equations: three of a held volume, four of another body.
template <int N, class S>
std::array<S, static_cast<std::size_t>(N)> sheared_balance(ShearedAxis axis,
                                                           const ShearedState<S>& at,
                                                           const S& square_nu) {
  static_assert(N == 3 || N == 4);
  const S w = at.w(square_nu);
  S of_axis;
  S plane(0.0);  // what c is to be
  S thick(0.0);  // and f
  S held(0.0);   // their difference
  switch (axis) {
    case ShearedAxis::third:
      of_axis = at.moment * w;
      break;
    case ShearedAxis::oblique:
      of_axis =
          at.area * square(at.excess(square_nu)) + 2.0 * square(at.moment) * at.gravity_slope * w;
      plane = w * at.sigma;
      thick = square_nu * at.tau;
      held = thick - plane;
      break;
    case ShearedAxis::in_no_plane:
      of_axis = at.moment - at.tau - at.sigma;
      plane = w * at.sigma;
      thick = w * (at.tau - at.sigma);
      held = (at.tau - 2.0 * at.sigma) * w;
      break;
  }
  if constexpr (N == 3) {
    return {at.trace_force, of_axis, held - (at.thick_pull - at.plane_pull)};
  } else {
    return {at.trace_force, of_axis, plane - at.plane_pull, thick - at.thick_pull};
  }
}

/// |n|^2 and nu3^2 at a solution. Negative: there is no motion.
template <class S>
struct ShearedSquares {
  S in_plane;
  S normal;
};
template <class S>
ShearedSquares<S> sheared_squares(ShearedAxis axis, const ShearedState<S>& at, const S& square_nu) {
  if (axis == ShearedAxis::third) return {S(0.0), square_nu};
  if (axis == ShearedAxis::oblique) return {square_nu, S(0.0)};
  const S share = at.sigma / at.tau;
  const S w = at.w(square_nu);
  return {(1.0 - share) * w, 2.0 * at.gravity_slope + share * w};
}

/// At alpha = 0, about axis 1, 2 or 3, of a body with gravity: by the balance
///
///   K = (spin - gravity)(J1 - J2)(xi + zeta)/(xi - zeta),
///
/// K being K_aa in (iii) and K_aa (I1 - I2) - h^2 omega^2 in (i), that exchanged in (ii): where it is
/// zero these motions begin. Both are equal where xi = zeta too, and K is finite there. square_nu: of nu;
/// V_T > 0.
template <class S>
struct TurningForces {
  S spin;
  S gravity;
};
template <class S>
TurningForces<S> turning_forces(Branch branch, const Inertia3<S>& J, const S& xi, const S& zeta,
                                const S& square_nu, const S& V_T) {
  if (branch == Branch::iii) return {square_nu, 2.0 * V_T};
  const S first = J.J1 * square(xi);
  const S second = J.J2 * square(zeta);
  if (branch == Branch::i) return {square_nu * second, 2.0 * V_T * (second - first)};
  return {square_nu * first, 2.0 * V_T * (first - second)};
}

/// A vector along n, nu1 >= 0 for alpha > 0: the columns of B - sigma, the longer of them. Not about
/// axis 3.
template <class S>
std::array<S, 2> sheared_direction(const Inertia3<S>& J, const ShearedPoint<S>& at) {
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
