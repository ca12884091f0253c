// The spectrum of a stationary motion of a potential that is not isotropic: by blocks where alpha =
// 0, V is even in alpha and the spin is about a material axis, else as a whole.
#pragma once

#include "lib/stability/general_spectrum.hpp"
#include "lib/stability/leaf_parts.hpp"
#include "solver/motion/oriented_system.hpp"

namespace stationary {

struct OrientedSpin {
  Body body;
  Branch branch;    ///< where the axis is a material one
  bool about_axis;  ///< it is
};

/// q, nu in extended precision. bound: as model_stability()'s.
Spectrum oriented_stability(const OrientedSpin& spin, const OrientedModels& models,
                            const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                            double bound);

/// By the parts that a reflection divides the leaf into. (iii), at any alpha: that in the plane of axes 1
/// and 2 leaves pi1, pi2 to themselves, and of a separable V rho. (i), (ii) at alpha = 0, V even in
/// alpha: likewise in their planes.
Spectrum spectrum_by_parts(const Leaf& whole, LeafParts parts, double uncertainty);

/// Member::turn of a motion with alpha = 0, and its turn_condition.
struct Turn {
  double value;
  double condition;
};
Turn turn_of(const Body& body, Branch branch, double V_aa, const Stretch& q, double nu);

}  // namespace stationary
