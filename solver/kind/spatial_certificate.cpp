#include "solver/kind/spatial_certificate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/stability/leaf_enclosure.hpp"
#include "solver/kind/spatial_boxes.hpp"
#include "solver/kind/tilted_event_enclosure.hpp"
#include "solver/proof/certificate.hpp"

namespace stationary {

Certificate certify_spatial(const SpatialEquations& equations, double nu,
                            const Equilibrium& equilibrium) {
  Certificate out = begun(equations.potential, equilibrium.q);
  if (!out.reason.empty()) return out;
  const StatedBoxes<SpatialEquations> boxes{equations, nu};
  const SpatialBoxes stated(equations, nu, Inputs::decimals);
  const ReducedVector<3> x = equations.unknowns(equilibrium.q);
  const Krawczyk test(boxes, x);
  const auto proof = prove_solution(test, x, "xi, zeta, alpha", out);
  if (!proof.proven) return out;
  const StretchBox solution = stated.stretch(proof.solution);
  const auto axis = stated.axis(proof.solution);
  if (!axis) {
    out.reason = "the squares of nu's components are not proven to be positive there";
    return out;
  }
  const Interval speed = as_input(nu, Inputs::decimals);
  for (int k = 0; k < 3; ++k) {
    const Interval off = Interval(equilibrium.nu[k]) / (speed * (*axis)[k]);
    if (!off.bounded() || off.apart_from(Interval(1.0 - allowed_error, 1.0 + allowed_error))) {
      out.reason = "proven not to be a solution: its nu has other components";
      return out;
    }
  }
  const Interval of_rho = Interval(equilibrium.q.rho) / solution.rho - Interval(1.0);
  const double bound =
      std::max(of_rho.magnitude(), SpatialEquations::bound_factor * proof.error_bound);
  // |d ln x| of what is within the bound: alpha's is sech^2 a times that of a.
  const double t = equilibrium.q.alpha / std::sqrt(equilibrium.q.xi * equilibrium.q.zeta);
  const double spread = std::max(2.5 * bound / (1.0 - t * t), proof.error_bound);
  std::optional<StretchBox> unique;
  if (const auto box = test.unique_within(spread)) unique = stated.stretch(*box);
  conclude(unique, solution, bound, out);
  require_assumptions(equations.potential, Inputs::decimals, out);
  return out;
}

SpectrumEnclosure enclose_spatial_spectrum(const SpatialEquations& equations, double nu,
                                           const Certificate& certificate,
                                           const Spectrum& spectrum) {
  if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
  const SpatialBoxes stated(equations, nu, Inputs::decimals);
  const StretchBox& at = certificate.solution;
  const BasicStretch<Interval> q{at.alpha, at.xi, at.zeta, at.rho};
  const Interval t = at.alpha / sqrt(at.xi * at.zeta);  // tanh ln x
  const Box<3> x{at.xi, at.zeta, sqrt((Interval(1.0) + t) / (Interval(1.0) - t))};
  const auto axis = stated.axis(x);
  if (!axis) throw std::invalid_argument("a spectrum needs a proven axis");
  const auto model = with_indexed_coefficients(
      *equations.potential.body_model(),
      [](double c, std::size_t) { return as_input(c, Inputs::decimals); });
  return enclose_leaf_spectrum({.J = stated.J(),
                                .q = q,
                                .speed = as_input(nu, Inputs::decimals),
                                .axis = *axis,
                                .V_qq = potential_derivatives<2>(model, q).hessian,
                                .parts = {.volume_held = true}},
                               spectrum);
}

std::optional<EventEnclosure> enclose_spatial_event(const SpatialEquations& equations,
                                                    EventType type, const Member& member) {
  if (type != EventType::shear) return std::nullopt;
  const Vector3<double>& nu = member.angular_velocity;
  const TiltPlane plane =
      std::abs(nu[1]) < std::abs(nu[0]) ? TiltPlane::one_three : TiltPlane::two_three;
  return enclose_tilted_event(equations.body, equations.potential, plane, type, member);
}

}  // namespace stationary
