// The balance of a tilted axis (tilted_balance.hpp) over a box of stretches, in interval arithmetic, with
// J, coefficients and |nu| as intervals; and the squares of nu's components, without which positive
// a solution of that balance is no motion.
//
// By it proofs about one tilted motion, as those of certify.hpp: that within the error bound there is
// exactly one with the case's |nu| and plane, its axis proven to be tilted, and that the numbers of
// nu are its components.
#pragma once

#include "lib/balance/tilted_balance.hpp"
#include "lib/body/motion.hpp"
#include "lib/stability/tilted_spectrum_enclosure.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

template <class Model>
struct TiltedBoxSystem {
  static constexpr int dimension = 2;
  Model model;
  Inertia3<Interval> J;
  TiltPlane plane;
  Interval square_nu;
  CentrifugalRates<Interval> rates;  ///< axis_rates() of |nu|^2 in (iii)

  Interval thickness(const Box<2>& x) const { return tilted_thickness(J, plane, x[0], x[1]); }

  BoxLinearized<2> linearize(const Box<2>& x) const {
    const auto b = tilted_balance(model, plane, x[0], x[1], thickness(x), rates);
    return {{b.g_xi, b.g_zeta}, {b.uu, b.uv, b.vv}};
  }
  /// At every solution in x.
  TiltSquares<Interval> squares(const Box<2>& x) const {
    return tilt_squares_of(model, J, plane, x[0], x[1], thickness(x), square_nu);
  }
  /// No solution in x is a motion.
  bool excludes(const Box<2>& x) const {
    if (defined_nowhere(model, x[0], x[1], thickness(x))) return true;
    const TiltSquares<Interval> square = squares(x);
    return square.in_plane.negative() || square.normal.negative();
  }
};

template <class Model>
auto tilted_box_system(const Body& body, const Model& model, TiltPlane plane, double nu,
                       Inputs inputs) {
  const auto J = inertia_intervals(body, inputs);
  const Interval square_nu = square(as_input(nu, inputs));
  return TiltedBoxSystem<decltype(interval_model(model, inputs))>{
      interval_model(model, inputs), J, plane, square_nu, axis_rates(J, Branch::iii, square_nu)};
}

/// At the equilibrium's q and nu; its status and error_bound are not read. Refused besides: an axis
/// that may be a material one (an end of the family).
Certificate certify_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const Equilibrium& equilibrium,
                           Inputs inputs = Inputs::decimals);

/// Enclosures for the modes of `spectrum`, tilted_stability()'s of the same motion. Throws
/// std::invalid_argument unless the certificate is proven.
SpectrumEnclosure enclose_spectrum(const Body& body, const Potential& potential,
                                   const TiltedRotation& motion, const Certificate& certificate,
                                   const Spectrum& spectrum, Inputs inputs = Inputs::decimals);

/// Of all motions with this state and these squares of nu's components, S = Interval or Sloped: nothing is
/// told where one of them may vanish.
template <class S>
SpectrumEnclosure enclose_tilted_spectrum(const Body& body, const Potential& potential,
                                          TiltPlane plane, const StraightState<S>& state,
                                          const TiltSquares<S>& squares,
                                          const Spectrum& approximate) {
  if (!range(squares.in_plane).positive() || !range(squares.normal).positive())
    return SpectrumEnclosure();
  const auto turned = plane == TiltPlane::one_three ? state : state.exchanged();
  const S nu1 = sqrt(squares.in_plane);
  const S nu3 = sqrt(squares.normal);
  return potential.holds_volume() ? enclose_tilted_spectrum(held_tilted_forms(turned, nu1, nu3),
                                                            body.symmetric(), approximate)
                                  : enclose_tilted_spectrum(tilted_forms(turned, nu1, nu3),
                                                            body.symmetric(), approximate);
}

}  // namespace stationary
