// How the modes of a stationary motion move the body. The motion is Phi = L S U^-1, L turning
// steadily (U = 1, or the material's turn of a two-polar motion); beside it, to first order in e,
//
//   Phi(t) = L (S + e Re[D exp(st)]) U^-1.
//
// Of a rotation D = hat(chi) S + dS: dS from a vector of the leaf (symplectic_leaf.hpp), and chi,
// how L turns, from the momentum in space, which stays where it is:
//   chi x pi = -delta pi,    s chi . n = -delta nu . n,    n = nu/|nu|,
//   delta nu = I^-1 (delta pi - (s B + N) dq)              (B, N, I: inertia.hpp).
// Of a two-polar motion D = hat(chi) S + dS - phi S hat(e3): dS from the pencil, the wobble's chi
// likewise, and along axis 3 s chi = -delta omega, s phi = delta theta', s3 and p_theta kept.
// nu is minus the usual angular velocity (conventions.md).
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "lib/body/body.hpp"
#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

struct ModeShape {
  std::complex<double> s;
  /// D, in phase and size such that Re D S^-1 is at its largest, of Frobenius norm 1.
  Matrix3<std::complex<double>> displacement;
  double residual;  ///< as LeafVector has it: not small where no vector belongs to s
};

/// Of a stationary motion (not checked), for each s, which are eigenvalues of it, not 0; equal ones
/// have vectors of their own as far as there are.
std::vector<ModeShape> mode_shapes(const Body& body, const Potential& potential, const Stretch& q,
                                   const Vector3<double>& nu,
                                   std::span<const std::complex<double>> s);

/// Of a two-polar motion, lambda != mu. q: xi, zeta are lambda, mu.
std::vector<ModeShape> mode_shapes(const Body& body, const Potential& potential, const Stretch& q,
                                   const TwoPolarRates<double>& rates,
                                   std::span<const std::complex<double>> s);

}  // namespace stationary
