// The body: its inertia J = diag(J1, J2, J3) in the material frame, J_A = integral of (a^A)^2 dm
// (mass times length squared), all three positive.
//
// The paper's section 2, before eq. (12). Thin bodies have small J3; J1 = J2 with an isotropic
// potential makes material rotations about axis 3 a symmetry.
#pragma once

namespace stationary {

struct Body {
  double J1;
  double J2;
  double J3;

  /// Throws std::invalid_argument naming the violated inequality unless all are finite and > 0.
  Body(double inertia_1, double inertia_2, double inertia_3);

  bool symmetric() const { return J1 == J2; }

  friend bool operator==(const Body&, const Body&) = default;
};

}  // namespace stationary
