// The spectrum of every stationary motion along a piece of a curve, as motion_spectrum.hpp has it of
// those in intervals, but with slopes along the curve (lib/number/sloped.hpp).
#pragma once

#include "solver/proof/motion_spectrum.hpp"

namespace stationary {

/// Motions along a curve, u in [-1, 1], as sloped.hpp has numbers.
struct MotionArc {
  MotionBox over;
  bool has_slopes = false;   ///< else nothing more is known
  MotionBox at;              ///< u = 0
  StretchBox stretch_slope;  ///< of an isotropic V: alpha is 0
  Interval nu_slope;
};

/// Of motions about an axis tilted in the plane, V isotropic; nothing is told where nu may lie along a
/// material axis.
SpectrumEnclosure enclose_tilted_spectrum(const Body& body, const Potential& potential,
                                          TiltPlane plane, const MotionArc& along,
                                          const Spectrum& approximate, Inputs inputs);

/// Of motions about the problem's axis; slopes are of use where V is isotropic.
SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionArc& along,
                                   const Spectrum& approximate, Inputs inputs);

}  // namespace stationary
