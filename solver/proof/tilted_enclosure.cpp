#include "solver/proof/tilted_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/proof/certificate.hpp"
#include "solver/proof/motion_spectrum.hpp"

namespace stationary {
namespace {

/// Of x, which is proven to be in `proven`; not bounded for a NaN.
Interval relative_error(double x, const Interval& proven) {
  return Interval(x) / proven - Interval(1.0);
}
bool agrees(const Interval& error) { return error.bounded() && error.mignitude() <= allowed_error; }

/// That the numbers of nu are the roots of its proven squares.
bool components_match(const TiltSquares<Interval>& square, TiltPlane plane,
                      const Vector3<double>& nu, Certificate& out) {
  if (!square.in_plane.positive() || !square.normal.positive()) {
    out.reason =
        "the squares of nu's components there are not proven to be both positive: the "
        "axis is a material one, or too near it";
    return false;
  }
  const int own = axis(in_plane_branch(plane));
  for (const auto& [value, root] :
       {std::pair{nu[own], sqrt(square.in_plane)}, std::pair{nu[2], sqrt(square.normal)}}) {
    if (agrees(relative_error(std::abs(value), root))) continue;
    out.reason = "proven not to be a solution: its nu has other components";
    return false;
  }
  return true;
}

template <class Model>
void certify_model(const Model& model, const Body& body, const TiltedRotation& motion,
                   const Equilibrium& equilibrium, Inputs inputs, Certificate& out) {
  const Stretch& q = equilibrium.q;
  const auto system = tilted_box_system(body, model, motion.plane, motion.nu, inputs);
  const ReducedVector<2> x(q.xi, q.zeta);
  const Krawczyk test(system, x);
  const auto proof = prove_solution(test, x, "xi, zeta", out);
  if (!proof.proven) return;
  const Interval rho = system.thickness(proof.solution);
  const Interval off = relative_error(q.rho, rho);
  if (!agrees(off)) {
    out.reason = "proven not to be a solution: compatibility asks for another rho";
    return;
  }
  if (!components_match(system.squares(proof.solution), motion.plane, equilibrium.nu, out)) return;
  const double bound = std::max(proof.error_bound, off.magnitude());
  std::optional<StretchBox> unique;
  if (const auto plane = test.unique_within(bound))
    unique = {
        (*plane)[0], (*plane)[1],
        hull(system.thickness(*plane), q.rho * Interval(1.0 - 2.0 * bound, 1.0 + 2.0 * bound))};
  conclude(unique, {proof.solution[0], proof.solution[1], rho}, bound, out);
}

}  // namespace

Certificate certify_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const Equilibrium& equilibrium,
                           Inputs inputs) {
  Certificate out = begun(potential, equilibrium.q);
  if (!out.reason.empty()) return out;
  const int own = axis(in_plane_branch(motion.plane));
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)) || equilibrium.nu[1 - own] != 0.0) {
    out.reason = "nu does not lie in the plane";
  } else if (equilibrium.q.alpha != 0.0) {
    out.reason = "alpha != 0: the axis lies in a plane of material axes";
  } else {
    potential.visit_parts(
        [&](const auto& model) { certify_model(model, body, motion, equilibrium, inputs, out); });
  }
  require_assumptions(potential, inputs, out.solution, out);
  return out;
}

SpectrumEnclosure enclose_spectrum(const Body& body, const Potential& potential,
                                   const TiltedRotation& motion, const Certificate& certificate,
                                   const Spectrum& spectrum, Inputs inputs) {
  if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
  return enclose_tilted_spectrum(
      body, potential, motion.plane,
      {.stretches = certificate.solution, .nu = as_input(motion.nu, inputs)}, spectrum, inputs);
}

SpectrumEnclosure enclose_tilted_spectrum(const Body& body, const Potential& potential,
                                          TiltPlane plane, const MotionBox& motion,
                                          const Spectrum& approximate, Inputs inputs) {
  const StretchBox& at = motion.stretches;
  return potential.visit_parts([&](const auto& model) {
    auto system = tilted_box_system(body, model, plane, 0.0, inputs);
    system.square_nu = square(motion.nu);
    const auto state = straight_state(system.J, system.model, at.xi, at.zeta, at.rho, motion.nu);
    return enclose_tilted_spectrum(body, potential, plane, state, system.squares({at.xi, at.zeta}),
                                   approximate);
  });
}

}  // namespace stationary
