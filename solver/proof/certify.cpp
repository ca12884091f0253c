#include "solver/proof/certify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "solver/proof/anisotropic_enclosure.hpp"
#include "solver/proof/axis_boxes.hpp"
#include "solver/proof/certificate.hpp"
#include "solver/proof/motion_spectrum.hpp"

namespace stationary {
namespace {

template <class Plane, class Thickness>
void certify_model(const Separable<Plane, Thickness>& model, const Problem& problem,
                   const Stretch& q, double nu, Inputs inputs, Certificate& out) {
  const BoxSystems<Separable<Plane, Thickness>> systems(problem, model, nu, inputs);
  const ReducedVector<1> rho(q.rho);
  const Krawczyk axial_test(systems.thickness, rho);
  const auto axial = prove_solution(axial_test, rho, "rho", out);
  if (!axial.proven) return;
  const ReducedVector<2> x(q.xi, q.zeta);
  const Krawczyk plane_test(systems.plane, x);
  const auto plane = prove_solution(plane_test, x, "xi, zeta", out);
  if (!plane.proven) return;
  const double bound = std::max(plane.error_bound, axial.error_bound);
  std::optional<StretchBox> unique;
  const auto unique_axial = axial_test.unique_within(bound);
  const auto unique_plane = plane_test.unique_within(bound);
  if (unique_axial && unique_plane)
    unique = {(*unique_plane)[0], (*unique_plane)[1], (*unique_axial)[0]};
  conclude(unique, {plane.solution[0], plane.solution[1], axial.solution[0]}, bound, out);
}

template <class Coupled>
void certify_model(const Coupled& model, const Problem& problem, const Stretch& q, double nu,
                   Inputs inputs, Certificate& out) {
  const BoxSystems<Coupled> systems(problem, model, nu, inputs);
  const ReducedVector<3> x(q.xi, q.zeta, q.rho);
  const Krawczyk test(systems.coupled, x);
  const auto proof = prove_solution(test, x, "xi, zeta, rho", out);
  if (!proof.proven) return;
  std::optional<StretchBox> unique;
  if (const auto all = test.unique_within(proof.error_bound))
    unique = {(*all)[0], (*all)[1], (*all)[2]};
  conclude(unique, {proof.solution[0], proof.solution[1], proof.solution[2]}, proof.error_bound,
           out);
}

}  // namespace

Certificate certify(const Problem& problem, const Equilibrium& equilibrium, Inputs inputs) {
  if (!problem.potential().is_isotropic()) return certify_anisotropic(problem, equilibrium, inputs);
  const Stretch& q = equilibrium.q;
  Certificate out = begun(problem.potential(), q);
  const double nu = equilibrium.nu[axis(problem.branch())];
  if (!out.reason.empty()) return out;
  if (equilibrium.nu != angular_velocity(problem.branch(), nu) || !std::isfinite(nu)) {
    out.reason = "nu does not lie along the branch's axis";
  } else if (q.alpha != 0.0) {
    out.reason = "alpha != 0: compatibility or the gauge leaves alpha = 0 only";
  } else {
    problem.potential().visit_parts(
        [&](const auto& model) { certify_model(model, problem, q, nu, inputs, out); });
  }
  require_assumptions(problem.potential(), inputs, out.solution, out);
  if (out.proven && mirror_symmetric(problem, nu)) {
    // The mirror image solves the same equations; within `unique` it is the solution itself.
    out.circle = out.solution.xi.within(out.unique.zeta) && out.solution.zeta.within(out.unique.xi);
  }
  return out;
}

SpectrumEnclosure enclose_spectrum(const Problem& problem, const Equilibrium& equilibrium,
                                   const Certificate& certificate, const Spectrum& spectrum,
                                   Inputs inputs) {
  if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
  MotionBox motion;
  motion.stretches = certificate.solution;
  const double nu = std::abs(equilibrium.nu[axis(problem.branch())]);
  motion.nu = nu == 0.0 ? Interval(0.0) : as_input(nu, inputs);
  motion.circle = certificate.circle;
  if (motion.circle)
    motion.stretches.xi = motion.stretches.zeta =
        common(motion.stretches.xi, motion.stretches.zeta);
  return enclose_spectrum(problem, motion, spectrum, inputs);
}

EnclosureFacts enclosure_facts(const Problem& problem, const MotionBox& motion) {
  const BodyModel<>* body_model = problem.potential().body_model();
  return {problem.branch(),
          motion.nu.hi == 0.0,
          problem.body().symmetric(),
          motion.circle,
          !problem.potential().is_separable(),
          body_model == nullptr || body_model->isotropic(),
          problem.potential().holds_volume()};
}

SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionBox& motion,
                                   const Spectrum& approximate, Inputs inputs) {
  if (!problem.potential().is_isotropic())
    return enclose_anisotropic_spectrum(problem, motion, approximate, inputs);
  const Inertia3<Interval> J = inertia_intervals(problem.body(), inputs);
  const StretchBox& at = motion.stretches;
  return problem.potential().visit_parts([&](const auto& model) {
    const auto state =
        straight_state(J, interval_model(model, inputs), at.xi, at.zeta, at.rho, motion.nu);
    return enclose_spectrum(enclosure_facts(problem, motion), state, approximate);
  });
}

}  // namespace stationary
