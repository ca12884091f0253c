// What is proven of the spectrum of any stationary motion whose state is known in intervals, as
// spectrum_enclosure.hpp where no reflection makes blocks: alpha != 0, an oblique axis, rest.
//
// From the second variation on the leaf (symplectic_leaf.hpp): its negative directions by
// Sylvester's law, and of the modes
//
//   det(s - J E'') = p(s^2),   p of degree 5 (4 at rest; one less of a held volume),
//
// p and the negative directions as interval_form.hpp has them, its roots by discs (root_discs.hpp).
// Parts of the leaf that do not see each other (about axis 3: b; alpha, xi, zeta; rho) have each
// their own. Where det S is held rho is no coordinate (symplectic_leaf.hpp).
#pragma once

#include "lib/body/inertia.hpp"
#include "lib/stability/spectrum_enclosure.hpp"

namespace stationary {

/// A stationary motion, and only such (not checked): nu an eigenvector of the locked inertia.
struct EnclosedMotion {
  Inertia3<Interval> J;
  BasicStretch<Interval> q;
  Interval speed;          ///< |nu|: > 0, or exactly 0
  Vector3<Interval> axis;  ///< nu/|nu|
  Matrix4<Interval> V_qq;  ///< along the volume where it is held
  bool rho_coupled;
  bool volume_held = false;
  /// About axis 1 or 2 with alpha = 0 and V even in alpha: (b, alpha) and (xi, zeta) do not see each
  /// other. Asked where the volume is held.
  bool straight = false;

  bool spins() const { return speed.lo > 0.0; }
  bool about_third() const { return axis[2].lo == 1.0; }
};

/// V without a material symmetry (not isotropic, or at rest about no axis of one). approximate is
/// only used for the order of the modes.
SpectrumEnclosure enclose_leaf_spectrum(const EnclosedMotion& motion, const Spectrum& approximate);

}  // namespace stationary
