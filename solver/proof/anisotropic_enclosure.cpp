#include "solver/proof/anisotropic_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "lib/number/elementary.hpp"
#include "lib/stability/leaf_enclosure.hpp"
#include "solver/newton/refine.hpp"
#include "solver/proof/certificate.hpp"
#include "solver/proof/oriented_boxes.hpp"

namespace stationary {
namespace {

template <class Layout>
StretchBox stretch_box(const OrientedBoxSystem<Layout>& system, const Box<Layout::dimension>& x) {
  const auto q = system.stretch(x);
  return {q.xi, q.zeta, q.rho, Layout::alpha ? q.alpha : Interval(0.0)};
}

/// The proof, and the errors of the numbers themselves: of each stretch, of alpha over sqrt(xi
/// zeta), of the angle of the axis.
template <class Layout>
void certify_at(const OrientedBoxSystem<Layout>& system, const Stretch& q,
                const Vector3<double>& nu, Certificate& out) {
  constexpr int N = Layout::dimension;
  ReducedVector<N> x = ones<N>();
  x[0] = q.xi;
  x[1] = q.zeta;
  x[Layout::thickness_place] = q.rho;
  if constexpr (Layout::alpha) x[Layout::alpha_place] = shear_coordinate(q);
  if constexpr (Layout::axis) x[Layout::axis_place] = axis_coordinate(atan2(nu[1], nu[0]));
  const Krawczyk test(system, x);
  const auto proof = test.prove();
  if (!proof.proven) {
    out.reason =
        "no solution could be proven near these numbers: there is none, or a second one (a fold, a "
        "bifurcation) is too near";
    return;
  }
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
  double bound = 0.0;
  double least = 0.0;
  const auto add = [&](const Interval& error) {
    bound = std::max(bound, error.magnitude());
    least = std::max(least, error.mignitude());
  };
  for (int i = 0; i < 3; ++i) add(Interval(x[i]) / proof.solution[at(i)] - Interval(1.0));
  const StretchBox solution = stretch_box(system, proof.solution);
  if constexpr (Layout::alpha) add(shear_error(q.alpha, solution));
  if constexpr (Layout::axis) {
    const AxisAngle<Interval> axis = axis_angle(proof.solution[at(Layout::axis_place)]);
    out.axis = {axis.cosine, axis.sine};
    add(axis_error(nu, axis));
  }
  if (least > allowed_error) {
    out.reason = "proven not to be a solution: the nearest is farther off than rounding";
    return;
  }
  if (!(bound < 1e-4)) {
    out.reason = "a second solution (a fold, a bifurcation) may lie within the error bound";
    return;
  }
  // |d ln x| of what is within the bound: alpha's is sech^2 a times that of a, the angle's at most
  // twice.
  std::optional<StretchBox> unique;
  double spread = bound;
  if constexpr (Layout::alpha) {
    const double t = q.alpha / std::sqrt(q.xi * q.zeta);
    spread = 2.5 * bound / (1.0 - t * t);
  }
  if (const auto box = test.unique_within(std::max(spread, proof.error_bound)))
    unique = stretch_box(system, *box);
  conclude(unique, solution, bound, out);
}

/// Whether |nu| may be the one asked for, as far as rounding goes.
bool turns_with(const Vector3<double>& nu, double speed, Inputs inputs) {
  if (speed == 0.0) return nu[0] == 0.0 && nu[1] == 0.0;
  const Interval squares = square(Interval(nu[0])) + square(Interval(nu[1]));
  const Interval off = squares / square(as_input(speed, inputs));
  const double allowed = 2.0 * allowed_error;
  return off.bounded() && !off.apart_from(Interval(1.0 - allowed, 1.0 + allowed));
}

void require_proven(const Certificate& certificate) {
  if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
}

/// parts: about_third and straight of it.
SpectrumEnclosure whole(const Body& body, const AnisotropicPotential& V, const MotionBox& motion,
                        const Vector3<Interval>& axis, LeafParts parts, const Spectrum& spectrum,
                        Inputs inputs) {
  parts.turns = motion.nu.hi > 0.0;
  // Beside rest the leaf of what turns has two dimensions more, of which only about axis 3 something
  // is known.
  if (parts.turns && !parts.about_third && !motion.nu.positive()) return {};
  const StretchBox& at = motion.stretches;
  const BasicStretch<Interval> q{at.alpha, at.xi, at.zeta, at.rho};
  parts.coupled = !V.is_separable();
  parts.volume_held = V.body().volume.has_value();
  return enclose_leaf_spectrum(
      {inertia_intervals(body, inputs), q, motion.nu, axis,
       potential_derivatives<2>(V.model(AsIntervals{inputs}), q).hessian, parts},
      spectrum);
}

}  // namespace

Certificate certify_anisotropic(const Problem& problem, const Equilibrium& equilibrium,
                                Inputs inputs) {
  Certificate out = begun(problem.potential(), equilibrium.q);
  if (!out.reason.empty()) return out;
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const Branch branch = problem.branch();
  const double nu = equilibrium.nu[axis(branch)];
  if (equilibrium.nu != angular_velocity(branch, nu) || !std::isfinite(nu)) {
    out.reason = "nu does not lie along the branch's axis";
    return out;
  }
  if (branch == Branch::iii || nu == 0.0) {
    certify_at(OrientedBoxSystem<ShearedLayout>(problem.body(), V, Branch::iii, nu, inputs),
               equilibrium.q, equilibrium.nu, out);
    // The mirror image solves the same equations; where `unique` holds both they are one.
    if (out.proven && V.even_in_alpha() && equilibrium.q.alpha == 0.0) out.solution.alpha = 0.0;
  } else if (equilibrium.q.alpha != 0.0) {
    out.reason = "alpha != 0: compatibility leaves alpha = 0 only";
  } else if (!V.shear_free()) {
    out.reason = "V_alpha is not proven to vanish there";
  } else {
    const OrientedBoxSystem<StraightLayout> system(problem.body(), V, branch, nu, inputs);
    certify_at(system, equilibrium.q, equilibrium.nu, out);
    const StretchBox& at = out.solution;
    if (out.proven && !system.shear_force({at.xi, at.zeta, at.rho}).may_be(0.0)) {
      out.proven = false;
      out.reason = "proven not to be a solution: V_alpha does not vanish there";
    }
  }
  require_assumptions(problem.potential(), inputs, out.solution, out);
  return out;
}

Certificate certify_oblique(const Body& body, const Potential& potential,
                            const ObliqueRotation& motion, const Equilibrium& equilibrium,
                            Inputs inputs) {
  Certificate out = begun(potential, equilibrium.q);
  if (!out.reason.empty()) return out;
  if (equilibrium.nu[2] != 0.0) {
    out.reason = "nu does not lie in the plane";
  } else if (!turns_with(equilibrium.nu, motion.nu, inputs)) {
    out.reason = "proven not to be a solution: its |nu| is another";
  } else if (motion.nu == 0.0) {  // at rest, about no axis
    certify_at(
        OrientedBoxSystem<ShearedLayout>(body, potential.anisotropic(), Branch::iii, 0.0, inputs),
        equilibrium.q, equilibrium.nu, out);
  } else {
    certify_at(OrientedBoxSystem<ObliqueLayout>(body, potential.anisotropic(), Branch::i, motion.nu,
                                                inputs),
               equilibrium.q, equilibrium.nu, out);
  }
  require_assumptions(potential, inputs, out.solution, out);
  return out;
}

SpectrumEnclosure enclose_anisotropic_spectrum(const Problem& problem, const MotionBox& motion,
                                               const Spectrum& approximate, Inputs inputs) {
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const StretchBox& at = motion.stretches;
  const bool at_rest = motion.nu.hi == 0.0;
  if (!V.shear_free() || at.alpha.lo != 0.0 || at.alpha.hi != 0.0 || at_rest)
    return whole(problem.body(), V, motion, {0.0, 0.0, 1.0}, {.about_third = true}, approximate,
                 inputs);
  if (V.body().volume)
    return whole(problem.body(), V, motion, angular_velocity(problem.branch(), Interval(1.0)),
                 {.about_third = problem.branch() == Branch::iii,
                  .straight = problem.branch() != Branch::iii},
                 approximate, inputs);
  const BasicStretch<Interval> q{0.0, at.xi, at.zeta, at.rho};
  return enclose_spectrum({problem.branch(), false, false, false, !V.is_separable(), false},
                          straight_state(inertia_intervals(problem.body(), inputs),
                                         V.model(AsIntervals{inputs}), q, motion.nu),
                          approximate);
}

SpectrumEnclosure enclose_oblique_spectrum(const Body& body, const Potential& potential,
                                           const ObliqueRotation& motion,
                                           const Certificate& certificate, const Spectrum& spectrum,
                                           Inputs inputs) {
  require_proven(certificate);
  MotionBox box;
  box.stretches = certificate.solution;
  const double nu = std::abs(motion.nu);
  box.nu = nu == 0.0 ? Interval(0.0) : as_input(nu, inputs);
  box.axis = certificate.axis;
  return enclose_oblique_spectrum(body, potential, box, spectrum, inputs);
}

SpectrumEnclosure enclose_oblique_spectrum(const Body& body, const Potential& potential,
                                           const MotionBox& motion, const Spectrum& approximate,
                                           Inputs inputs) {
  return whole(body, potential.anisotropic(), motion, {motion.axis[0], motion.axis[1], 0.0}, {},
               approximate, inputs);
}

}  // namespace stationary
