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

/// What is known exactly of such motions about the problem's axis, V isotropic.
EnclosureFacts enclosure_facts(const Problem& problem, const MotionBox& motion);

/// Of motions about the problem's axis.
SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionBox& at,
                                   const Spectrum& approximate, Inputs inputs);

/// Of those about an axis tilted in the plane, V isotropic; nothing is told where nu may lie along a
/// material axis.
SpectrumEnclosure enclose_tilted_spectrum(const Body& body, const Potential& potential,
                                          TiltPlane plane, const MotionBox& at,
                                          const Spectrum& approximate, Inputs inputs);

/// Of oblique ones.
SpectrumEnclosure enclose_oblique_spectrum(const Body& body, const Potential& potential,
                                           const MotionBox& at, const Spectrum& approximate,
                                           Inputs inputs);

}  // namespace stationary
