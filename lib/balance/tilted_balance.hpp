// A tilted axis, nu = (nu1, 0, nu3), needs I11 = I33, that is rho = sqrt(J1/J3) xi. Of the balance
//   xi V_xi = J1 xi^2 nu3^2,   zeta V_zeta = J2 zeta^2 |nu|^2,   rho V_rho = J3 rho^2 nu1^2
// the second and the sum of the other two hold no tilt, only |nu|; the tilt follows from either of
// the other two. Again a gradient, that of V(xi, zeta, sqrt(J1/J3) xi) - |nu|^2 (J1 xi^2 + J2
// zeta^2)/2. In the 2-3 plane 1 and 2, xi and zeta change places.
//
// Where det S = C is held, the pressure P of the constraint is in all three rows, and zeta = C/(xi
// rho) is eliminated, not rho: with Gamma_k = s_k V_k - c_k s_k^2,
//   Gamma_1 - 2 Gamma_2 + Gamma_3 = 0,   ln(xi zeta rho/C) = 0,
// hold no tilt; Gamma_1 = Gamma_3 gives nu3^2 - nu1^2. As with rho (held_volume.hpp) they are made
// the gradient of a function of (ln xi, ln zeta) with k/2 times the second one's square added.
#pragma once

#include <array>
#include <cmath>

#include "lib/balance/balance.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

/// rho of a tilted motion over the stretch along the plane's own axis.
template <class S, class Inertias>
S tilted_slenderness(const Inertias& J, TiltPlane plane) {
  using std::sqrt;
  return sqrt(S(plane == TiltPlane::one_three ? J.J1 : J.J2) / S(J.J3));
}

/// rho of a tilted motion.
template <class Inertias, class S>
S tilted_thickness(const Inertias& J, TiltPlane plane, const S& xi, const S& zeta) {
  return tilted_slenderness<S>(J, plane) * (plane == TiltPlane::one_three ? xi : zeta);
}

/// The balance of all three stretches with w tied to the plane's own axis, rho being
/// tilted_thickness(): two equations. With axis_rates() of |nu|^2 in (iii) they are those of a
/// tilted axis.
template <int order, class S>
LogBalance<S> tied_to_plane(LogBalance<S> balance, TiltPlane plane) {
  const bool first = plane == TiltPlane::one_three;
  (first ? balance.g_xi : balance.g_zeta) += balance.g_rho;
  if constexpr (order >= 2) {
    (first ? balance.uu : balance.vv) += 2.0 * (first ? balance.uw : balance.vw) + balance.ww;
    balance.uv += first ? balance.vw : balance.uw;
  }
  return balance;
}

/// nu^2 along the plane's own axis and along axis 3. Negative: no tilted motion is there.
template <class S>
struct TiltSquares {
  S in_plane;
  S normal;
};

/// At a solution of these two, from the balance of all three stretches at rest (the
/// elastic force alone) there.
template <class Inertias, class S>
TiltSquares<S> tilt_squares(const Inertias& J, TiltPlane plane, const LogBalance<S>& elastic,
                            const S& xi, const S& zeta, const S& rho) {
  const bool first = plane == TiltPlane::one_three;
  const S& x = first ? xi : zeta;
  return {elastic.g_rho / (J.J3 * (rho * rho)),
          (first ? elastic.g_xi : elastic.g_zeta) / ((first ? J.J1 : J.J2) * (x * x))};
}

/// A model whose determinant of S may be held (body_model.hpp).
template <class Model>
constexpr bool may_hold_volume = requires(const Model& model) {
  model.volume;
  model.stiffness;
};

/// xi, zeta, rho of a tilted motion whose volume is held, from the stretch along the plane's own
/// axis and rho.
template <class Model, class S>
std::array<S, 3> tilted_at_volume(const Model& model, TiltPlane plane, const S& xi, const S& zeta,
                                  const S& rho) {
  const S& own = plane == TiltPlane::one_three ? xi : zeta;
  const S other = S(*model.volume) / (own * rho);
  return plane == TiltPlane::one_three ? std::array<S, 3>{xi, other, rho}
                                       : std::array<S, 3>{other, zeta, rho};
}

/// The two equations of a held volume from tied_to_plane() of the balance at tilted_at_volume();
/// excess = ln(xi zeta rho/C), k > 0.
template <int order, class S>
LogBalance<S> held_in_plane(const LogBalance<S>& tied, TiltPlane plane, const S& excess, double k) {
  const bool first = plane == TiltPlane::one_three;
  LogBalance<S> out = tied;
  const S pull = k * excess;
  (first ? out.g_xi : out.g_zeta) =
      (first ? tied.g_xi : tied.g_zeta) - 2.0 * (first ? tied.g_zeta : tied.g_xi) + 2.0 * pull;
  (first ? out.g_zeta : out.g_xi) = pull;
  if constexpr (order >= 2) {
    const S& own = first ? tied.uu : tied.vv;
    const S& other = first ? tied.vv : tied.uu;
    const S slope = own - 4.0 * tied.uv + 4.0 * other + S(4.0 * k);
    (first ? out.uu : out.vv) = slope;
    (first ? out.vv : out.uu) = S(k);
    out.uv = S(2.0 * k);
  }
  return out;
}

/// The balance of a tilted axis of a model whose volume is held, from the stretches in the box of
/// unknowns and rho = tilted_thickness(); rates: axis_rates() of |nu|^2 in (iii).
template <int order, class Model, class S>
LogBalance<S> held_tilted_balance(const Model& model, TiltPlane plane, const S& xi, const S& zeta,
                                  const S& rho, const CentrifugalRates<S>& rates) {
  const auto [x, z, r] = tilted_at_volume(model, plane, xi, zeta, rho);
  const LogBalance<S> tied = tied_to_plane<order>(
      model.template whole<order>(x, z, r, rates.xi, rates.zeta, rates.rho), plane);
  return held_in_plane<order>(tied, plane, S(log(S(xi * zeta * rho / S(*model.volume)))),
                              model.stiffness);
}

/// tilt_squares() where the volume is held: of |nu|^2 and the balance at rest without the
/// constraint, whole() at tilted_at_volume().
template <class Inertias, class S>
TiltSquares<S> held_tilt_squares(const Inertias& J, TiltPlane plane, const LogBalance<S>& elastic,
                                 const S& rho, const S& square_nu) {
  const S& own = plane == TiltPlane::one_three ? elastic.g_xi : elastic.g_zeta;
  // nu3^2 - nu1^2; J1 xi^2 = J3 rho^2.
  const S excess = (own - elastic.g_rho) / (J.J3 * (rho * rho));
  return {0.5 * (square_nu - excess), 0.5 * (square_nu + excess)};
}

/// The balance of a tilted axis by a model's own balance; rates: axis_rates() of |nu|^2 in (iii).
template <class Model, class S>
LogBalance<S> tilted_balance(const Model& model, TiltPlane plane, const S& xi, const S& zeta,
                             const S& rho, const CentrifugalRates<S>& rates) {
  if constexpr (may_hold_volume<Model>)
    if (model.volume) return held_tilted_balance<2>(model, plane, xi, zeta, rho, rates);
  return tied_to_plane<2>(model.log_balance(xi, zeta, rho, rates.xi, rates.zeta, rates.rho), plane);
}

/// What a spin of these rates takes from its two rows.
template <class Model, class S>
std::array<S, 2> tilted_pull([[maybe_unused]] const Model& model, [[maybe_unused]] TiltPlane plane,
                             const S& xi, const S& zeta, [[maybe_unused]] const S& rho,
                             const CentrifugalRates<S>& rates) {
  if constexpr (may_hold_volume<Model>) {
    if (model.volume) {
      const auto [x, z, r] = tilted_at_volume(model, plane, xi, zeta, rho);
      const S first = rates.xi * (x * x);
      const S second = rates.zeta * (z * z);
      return plane == TiltPlane::one_three ? std::array<S, 2>{first - 2.0 * second, S(0.0)}
                                           : std::array<S, 2>{S(0.0), second - 2.0 * first};
    }
  }
  return {rates.xi * (xi * xi), rates.zeta * (zeta * zeta)};
}

/// The squares of nu's components at a solution of it.
template <class Model, class Inertias, class S>
TiltSquares<S> tilt_squares_of(const Model& model, const Inertias& J, TiltPlane plane, const S& xi,
                               const S& zeta, const S& rho, const S& square_nu) {
  const S none(0.0);
  if constexpr (may_hold_volume<Model>) {
    if (model.volume) {
      const auto [x, z, r] = tilted_at_volume(model, plane, xi, zeta, rho);
      return held_tilt_squares(J, plane, model.template whole<1>(x, z, r, none, none, none), rho,
                               square_nu);
    }
  }
  return tilt_squares(J, plane, model.log_balance(xi, zeta, rho, none, none, none), xi, zeta, rho);
}

}  // namespace stationary
