// What is proven of the spectrum of every stationary motion whose stretches, axis and nu lie in
// given intervals, and of such only: the enclosures of certify.hpp without one motion's certificate.
#pragma once

#include <array>

#include "solver/proof/certify.hpp"

namespace stationary {

/// Stationary motions, at one or many nu.
struct MotionBox {
  StretchBox stretches;
  Interval nu;  ///< >= 0
  /// xi = zeta exactly, about axis 3 with J1 = J2 and V isotropic; stretches then has them equal.
  bool circle = false;
  /// Oblique: nu/|nu| along axes 1 and 2.
  std::array<Interval, 2> axis = {};
};

/// Those along a curve, u in [-1, 1], as sloped.hpp has numbers.
struct MotionArc {
  MotionBox over;
  bool has_slopes = false;  ///< else nothing more is known
  MotionBox at;             ///< u = 0
  StretchBox stretch_slope;
  Interval nu_slope;
};

/// Of motions about the problem's axis.
SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionBox& at,
                                   const Spectrum& approximate, Inputs inputs);
/// Slopes are of use where V is isotropic.
SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionArc& along,
                                   const Spectrum& approximate, Inputs inputs);

/// Of oblique ones.
SpectrumEnclosure enclose_oblique_spectrum(const Body& body, const Potential& potential,
                                           const MotionBox& at, const Spectrum& approximate,
                                           Inputs inputs);

}  // namespace stationary
