// What is proven of the spectrum of any stationary motion whose state is known in intervals, as
// spectrum_enclosure.hpp where no reflection makes blocks: alpha != 0, an oblique axis, rest.
//
// From the second variation on the leaf (symplectic_leaf.hpp), part by part (leaf_parts.hpp): its
// negative directions by Sylvester's law (enclosure_collector.hpp), and the modes as the roots of
// det(s - J E'') = P(s^2) by discs (root_discs.hpp).
#pragma once

#include "lib/body/inertia.hpp"
#include "lib/stability/leaf_parts.hpp"
#include "lib/stability/spectrum_enclosure.hpp"

namespace stationary {

/// A stationary motion, and only such (not checked): nu an eigenvector of the locked inertia.
struct EnclosedMotion {
  Inertia3<Interval> J;
  BasicStretch<Interval> q;
  /// |nu|: > 0, or exactly 0. About axis 3, of motions that turn, 0 may be its end.
  Interval speed;
  Vector3<Interval> axis;  ///< nu/|nu|
  Matrix4<Interval> V_qq;  ///< along the volume where it is held
  LeafParts parts;
};

/// V without a material symmetry (not isotropic, or at rest about no axis of one). approximate is
/// only used for the order of the modes.
SpectrumEnclosure enclose_leaf_spectrum(const EnclosedMotion& motion, const Spectrum& approximate);

}  // namespace stationary
