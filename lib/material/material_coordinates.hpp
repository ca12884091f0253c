// A fluid's J is a choice of material coordinates. With V = U(d rho) + V_gravity the motions Phi of a
// body with J are those Phi' = Phi sqrt(J/s) of the body with (s, s, s), s^3 = J1 J2 J3, whose
// volume, energies and momenta are the same: of diagonal S, S' = S sqrt(J/s). So Phi sqrt(J)^-1 R
// sqrt(J), R any rotation, is a symmetry, which the program knows of the body with (s, s, s) as that
// of any isotropic one. It computes that body, and tells S in the coordinates of the case's own J.
#pragma once

#include <array>

#include "lib/body/body.hpp"
#include "lib/body/stretch.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

struct MaterialCoordinates {
  std::array<double, 3> unit{1.0, 1.0, 1.0};  ///< S of the case is S' diag(unit)

  bool are_own() const { return unit == std::array{1.0, 1.0, 1.0}; }
  Stretch told(const Stretch& q) const {
    return {q.alpha, q.xi * unit[0], q.zeta * unit[1], q.rho * unit[2]};
  }
  Stretch computed(const Stretch& q) const {
    return {q.alpha, q.xi / unit[0], q.zeta / unit[1], q.rho / unit[2]};
  }
};

/// Whether a body with gravity or a held volume resists nothing but a change of its volume; seen at
/// points, to 20 digits.
bool is_fluid(const Potential& potential);

/// (s, s, s), and the coordinates of S in which it is the body with J.
Body round_body(const Body& body);
MaterialCoordinates coordinates_of(const Body& body);

}  // namespace stationary
