#include "solver/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "solver/box_systems.hpp"
#include "solver/krawczyk.hpp"

namespace stationary {
namespace {

/// Units in the last place by which a solution may be off before it is none.
constexpr double allowed_error = 0x1p-50;

/// The proof at x, or why there is none.
template <class BoxSystem>
Proof<BoxSystem::dimension> prove(const Krawczyk<BoxSystem>& test,
                                  const ReducedVector<BoxSystem::dimension>& x, const char* names,
                                  Certificate& out) {
  auto proof = test.prove();
  if (!proof.proven) {
    out.reason = std::string("no solution could be proven near these ") + names +
                 ": there is none, or a second one (a fold, a bifurcation) is too near";
    return proof;
  }
  double least = 0.0;  // the error is at least this
  for (int i = 0; i < BoxSystem::dimension; ++i)
    least = std::max(least, log(proof.solution[static_cast<std::size_t>(i)] / x[i]).mignitude());
  if (least > allowed_error) {
    std::ostringstream text;
    text.precision(2);
    text << "proven not to be a solution: the nearest has " << names << " farther off than "
         << std::scientific << least << " of themselves";
    out.reason = text.str();
    proof.proven = false;
  }
  return proof;
}

/// That there is no second solution within the error bound of any of the stretches.
void conclude(const std::optional<StretchBox>& unique, const StretchBox& solution, double bound,
              Certificate& out) {
  if (!unique) {
    out.reason = "a second solution (a fold, a bifurcation) may lie within the error bound";
    return;
  }
  out.proven = true;
  out.unique = *unique;
  out.solution = solution;
  out.error_bound = bound;
}

template <class Plane, class Thickness>
void certify_model(const Separable<Plane, Thickness>& model, const Problem& problem,
                   const Stretch& q, double nu, Inputs inputs, Certificate& out) {
  const BoxSystems<Separable<Plane, Thickness>> systems(problem, model, nu, inputs);
  const ReducedVector<1> rho(q.rho);
  const Krawczyk axial_test(systems.thickness, rho);
  const auto axial = prove(axial_test, rho, "rho", out);
  if (!axial.proven) return;
  const ReducedVector<2> x(q.xi, q.zeta);
  const Krawczyk plane_test(systems.plane, x);
  const auto plane = prove(plane_test, x, "xi, zeta", out);
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
  const auto proof = prove(test, x, "xi, zeta, rho", out);
  if (!proof.proven) return;
  std::optional<StretchBox> unique;
  if (const auto all = test.unique_within(proof.error_bound))
    unique = {(*all)[0], (*all)[1], (*all)[2]};
  conclude(unique, {proof.solution[0], proof.solution[1], proof.solution[2]}, proof.error_bound,
           out);
}

}  // namespace

bool mirror_symmetric(const Problem& problem, double nu) {
  return nu == 0.0 || (problem.branch() == Branch::iii && problem.body().symmetric());
}

Certificate certify(const Problem& problem, const Equilibrium& equilibrium, Inputs inputs) {
  Certificate out;
  const Stretch& q = equilibrium.q;
  const double nu = equilibrium.nu[axis(problem.branch())];
  if (equilibrium.nu != angular_velocity(problem.branch(), nu) || !std::isfinite(nu)) {
    out.reason = "nu does not lie along the branch's axis";
  } else if (const char* inequality = violated_inequality(q)) {
    out.reason = std::string("S is not positive definite: it needs ") + inequality;
  } else if (q.alpha != 0.0) {
    out.reason = "alpha != 0: compatibility or the gauge leaves alpha = 0 only";
  } else {
    problem.potential().visit(
        [&](const auto& model) { certify_model(model, problem, q, nu, inputs, out); });
  }
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
  const double nu = equilibrium.nu[axis(problem.branch())];
  const Body& body = problem.body();
  const EnclosureFacts facts{problem.branch(), nu == 0.0, body.symmetric(), certificate.circle,
                             !problem.potential().is_separable()};
  const Inertia3<Interval> J{as_input(body.J1, inputs), as_input(body.J2, inputs),
                             as_input(body.J3, inputs)};
  StretchBox at = certificate.solution;
  if (certificate.circle) at.xi = at.zeta = common(at.xi, at.zeta);
  return problem.potential().visit([&](const auto& model) {
    const auto state = straight_state(J, interval_model(model, inputs), at.xi, at.zeta, at.rho,
                                      as_input(nu, inputs));
    return enclose_spectrum(facts, state, spectrum);
  });
}

}  // namespace stationary
