#include "solver/proof/two_polar_enclosure.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "solver/proof/certificate.hpp"
#include "solver/proof/two_polar_boxes.hpp"

namespace stationary {
namespace {

template <int N>
ReducedVector<N> unknowns_of(const Equilibrium& at) {
  return diagonal(at.q).template head<N>();
}

template <class Unknowns>
StretchBox stretch_box(const Unknowns& plane, const Interval& rho) {
  return {plane[0], plane[1], rho};
}

template <class Model, template <class> class Motion>
void certify_model(const Model& model, const Motion<double>& motion, const Body& body,
                   const Equilibrium& at, Inputs inputs, Certificate& out) {
  const auto system = two_polar_box_system(body.J1, model, motion, inputs);
  constexpr int N = decltype(system)::dimension;
  const ReducedVector<N> x = unknowns_of<N>(at);
  const Krawczyk test(system, x);
  const auto proof = prove_solution(test, x, N == 2 ? "lambda, mu" : "lambda, mu, rho", out);
  if (!proof.proven) return;
  std::optional<StretchBox> unique;
  if constexpr (N == 3) {
    if (const auto all = test.unique_within(proof.error_bound))
      unique = stretch_box(*all, (*all)[2]);
    conclude(unique, stretch_box(proof.solution, proof.solution[2]), proof.error_bound, out);
  } else {
    const auto thickness = interval_model(model.thickness, inputs);
    const ThicknessBoxSystem<std::remove_cv_t<decltype(thickness)>> axial_system{thickness, 0.0};
    const ReducedVector<1> rho(at.q.rho);
    const Krawczyk axial_test(axial_system, rho);
    const auto axial = prove_solution(axial_test, rho, "rho", out);
    if (!axial.proven) return;
    const double bound = std::max(proof.error_bound, axial.error_bound);
    const auto unique_plane = test.unique_within(bound);
    const auto unique_axial = axial_test.unique_within(bound);
    if (unique_plane && unique_axial) unique = stretch_box(*unique_plane, (*unique_axial)[0]);
    conclude(unique, stretch_box(proof.solution, axial.solution[0]), bound, out);
  }
}

/// Apart or equal, as the equilibrium says.
void prove_shape(bool circle, Certificate& out) {
  // The mirror image solves the same equations; within `unique` it is the solution itself.
  out.circle = out.solution.xi.within(out.unique.zeta) && out.solution.zeta.within(out.unique.xi);
  if (circle ? out.circle : out.solution.xi.lo > out.solution.zeta.hi) return;
  out = {};
  out.reason = circle ? "lambda and mu are not proven to be equal"
                      : "lambda > mu is not proven: the circle lambda = mu is too near";
}

bool has_motion(const Equilibrium& at, const TwoPolarMotion& motion) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion))
    return at.two_polar->rates.omega == rates->omega &&
           at.two_polar->rates.theta_dot == rates->theta_dot;
  const auto& momenta = std::get<TwoPolarMomenta<double>>(motion);
  return at.two_polar->momenta.s3 == momenta.s3 && at.two_polar->momenta.p_theta == momenta.p_theta;
}

/// omega and theta' at the solution; on a circle of given momenta their sum and 0.
TwoPolarRates<Interval> rates_at(const Interval& J, const StretchBox& x, bool circle,
                                 const TwoPolarMotion& motion, Inputs inputs) {
  const auto input = [inputs](double number) { return as_input(number, inputs); };
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion))
    return with_numbers(*rates, input);
  const auto& given = std::get<TwoPolarMomenta<double>>(motion);
  if (given.s3 == given.p_theta) {
    const Interval fast = input(given.s3) / (J * square(x.xi + x.zeta));
    return circle ? TwoPolarRates<Interval>{2.0 * fast, 0.0} : TwoPolarRates<Interval>{fast, fast};
  }
  return two_polar_rates(J, Vector3<Interval>{x.xi, x.zeta, x.rho}, with_numbers(given, input));
}

/// Not turning in space, exactly.
bool no_spin(const Equilibrium& at) {
  return at.circle ? at.nu[2] == 0.0 : at.two_polar->momenta.s3 == 0.0;
}

}  // namespace

Certificate certify_two_polar(const Body& body, const Potential& potential,
                              const TwoPolarMotion& motion, const Equilibrium& equilibrium,
                              Inputs inputs) {
  require_two_polar(body, motion);
  Certificate out = begun(potential, equilibrium.q);
  if (!out.reason.empty()) return out;
  if (!equilibrium.two_polar || !has_motion(equilibrium, motion)) {
    out.reason = "its motion is another than the prescribed one";
  } else {
    potential.visit_parts([&](const auto& model) {
      visit_motion(motion, [&](const auto& own) {
        certify_model(model, own, body, equilibrium, inputs, out);
      });
    });
    if (out.proven) prove_shape(equilibrium.circle, out);
  }
  require_assumptions(potential, inputs, out.solution, out);
  return out;
}

SpectrumEnclosure enclose_spectrum(const Body& body, const Potential& potential,
                                   const TwoPolarMotion& motion, const Equilibrium& equilibrium,
                                   const Certificate& certificate, const Spectrum& spectrum,
                                   Inputs inputs) {
  if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
  const auto J = inertia_intervals(body, inputs);
  StretchBox at = certificate.solution;
  if (certificate.circle) at.xi = at.zeta = common(at.xi, at.zeta);
  const auto rates = rates_at(J.J1, at, certificate.circle, motion, inputs);
  const bool still = no_spin(equilibrium);
  return potential.visit_parts([&](const auto& model) {
    const auto coefficients = interval_model(model, inputs);
    if (certificate.circle) {
      const Interval omega = still ? Interval(0.0) : rates.omega + rates.theta_dot;
      return enclose_spectrum({Branch::iii, still, true, true, !potential.is_separable(), true,
                               potential.holds_volume()},
                              straight_state(J, coefficients, at.xi, at.zeta, at.rho, omega),
                              spectrum);
    }
    return enclose_two_polar_spectrum(
        straight_state(J, coefficients, at.xi, at.zeta, at.rho, rates.omega), rates.theta_dot,
        !still, spectrum, potential.holds_volume());
  });
}

}  // namespace stationary
