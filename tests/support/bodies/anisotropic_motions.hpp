// Random bodies with anisotropic potentials, slow enough that the family from rest reaches them.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "solver/solve/anisotropic_equilibrium.hpp"
#include "tests/support/bodies/random_anisotropic.hpp"

namespace stationary::testing {

struct OrientedBody {
  Body body;
  AnisotropicPotential V;
  double nu;
  std::string text;

  Potential potential() const { return Potential(V); }
  Problem problem(Branch branch) const { return {body, potential(), branch}; }
};

inline OrientedBody random_oriented_body(support::Random& random, int kind) {
  const auto of = support::random_anisotropic(random, kind);
  const Body body = random.body(2.0);
  std::ostringstream text;
  text.precision(17);
  const double nu = random.uniform(0.05, 0.3);
  text << of.text << ", J " << body.J1 << " " << body.J2 << " " << body.J3 << ", nu " << nu;
  return {body, of.V, nu, text.str()};
}

/// A planar model of two numbers with one fibre.
inline Potential fibred(const AnisotropicPotential::Plane& plane, double k, double degrees) {
  return Potential(AnisotropicPotential(plane, ReciprocalQuadratic<>{1.0, 3.0}, {{k, degrees}}));
}

/// No global search where following from rest comes to nothing.
inline SolveOptions without_search(std::optional<Stretch> start = std::nullopt) {
  SolveOptions out;
  out.start = start;
  out.search = false;
  return out;
}

/// About axis 3, or oblique.
inline Equilibrium solved_motion(const OrientedBody& at, std::optional<Branch> near) {
  if (near) return solve_oblique(at.body, at.potential(), {at.nu, near}, without_search());
  return solve(at.problem(Branch::iii), at.nu, without_search());
}

/// Largest relative difference, of alpha over sqrt(xi zeta).
inline double stretch_difference(const Stretch& a, const Stretch& b) {
  return std::max({std::abs(a.xi / b.xi - 1.0), std::abs(a.zeta / b.zeta - 1.0),
                   std::abs(a.rho / b.rho - 1.0),
                   std::abs(a.alpha - b.alpha) / std::sqrt(b.xi * b.zeta)});
}

}  // namespace stationary::testing
