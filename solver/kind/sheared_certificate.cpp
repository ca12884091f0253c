#include "solver/kind/sheared_certificate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/stability/leaf_enclosure.hpp"
#include "solver/family/sheared_boxes.hpp"
#include "solver/kind/tilted_event_enclosure.hpp"
#include "solver/proof/certificate.hpp"

namespace stationary {

template <int N>
Certificate certify_sheared(const ShearedEquations<N>& equations, double nu,
                            const Equilibrium& equilibrium) {
  Certificate out = begun(equations.potential, equilibrium.q);
  if (!out.reason.empty()) return out;
  const StatedBoxes<ShearedEquations<N>> boxes{equations, nu};
  const ShearedBoxes<N> stated(equations, nu, Inputs::decimals);
  const ReducedVector<N> x = equations.unknowns(equilibrium.q);
  const Krawczyk test(boxes, x);
  const auto proof = prove_solution(test, x, "xi, zeta, alpha", out);
  if (!proof.proven) return out;
  const StretchBox solution = stated.stretch(proof.solution);
  const auto axis = stated.axis(proof.solution);
  if (!axis) {
    out.reason = equations.axis == ShearedAxis::in_no_plane
                     ? "the squares of nu's components are not proven to be positive there"
                     : "the direction of nu is not proven there";
    return out;
  }
  const Interval speed = as_input(std::abs(nu), Inputs::decimals);
  for (int k = 0; k < 3; ++k) {
    const Interval& along = (*axis)[k];
    const Interval own = speed * along;
    const bool same = along.lo == 0.0 && along.hi == 0.0
                          ? equilibrium.nu[k] == 0.0
                          : !(Interval(equilibrium.nu[k]) / own)
                                 .apart_from(Interval(1.0 - allowed_error, 1.0 + allowed_error));
    if (!same || !(own.bounded())) {
      out.reason = "proven not to be a solution: its nu has other components";
      return out;
    }
  }
  const Interval of_rho = Interval(equilibrium.q.rho) / solution.rho - Interval(1.0);
  const double bound =
      std::max(of_rho.magnitude(), ShearedEquations<N>::bound_factor * proof.error_bound);
  // |d ln x| of what is within the bound: alpha's is sech^2 a times that of a.
  const double t = equilibrium.q.alpha / std::sqrt(equilibrium.q.xi * equilibrium.q.zeta);
  const double spread = std::max(2.5 * bound / (1.0 - t * t), proof.error_bound);
  std::optional<StretchBox> unique;
  if (const auto box = test.unique_within(spread)) unique = stated.stretch(*box);
  conclude(unique, solution, bound, out);
  require_assumptions(equations.potential, Inputs::decimals, out.solution, out);
  return out;
}

template <int N>
SpectrumEnclosure enclose_sheared_spectrum(const ShearedEquations<N>& equations, double nu,
                                           const Certificate& certificate,
                                           const Spectrum& spectrum) {
  if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
  const ShearedBoxes<N> stated(equations, nu, Inputs::decimals);
  const StretchBox& at = certificate.solution;
  const BasicStretch<Interval> q{at.alpha, at.xi, at.zeta, at.rho};
  const Interval t = at.alpha / sqrt(at.xi * at.zeta);  // tanh ln x
  Box<N> x;
  x[0] = at.xi;
  x[1] = at.zeta;
  if constexpr (N == 4) x[2] = at.rho;
  x[N - 1] = sqrt((Interval(1.0) + t) / (Interval(1.0) - t));
  const auto axis = stated.axis(x);
  if (!axis) throw std::invalid_argument("a spectrum needs a proven axis");
  const auto model = with_indexed_coefficients(
      equations.model, [](double c, std::size_t) { return as_input(c, Inputs::decimals); });
  return enclose_leaf_spectrum({.J = stated.J(),
                                .q = q,
                                .speed = as_input(std::abs(nu), Inputs::decimals),
                                .axis = *axis,
                                .V_qq = potential_derivatives<2>(model, q).hessian,
                                .parts = {.about_third = equations.axis == ShearedAxis::third,
                                          .coupled = !equations.potential.is_separable(),
                                          .volume_held = N == 3}},
                               spectrum);
}

template Certificate certify_sheared<3>(const ShearedEquations<3>&, double, const Equilibrium&);
template Certificate certify_sheared<4>(const ShearedEquations<4>&, double, const Equilibrium&);
template SpectrumEnclosure enclose_sheared_spectrum<3>(const ShearedEquations<3>&, double,
                                                       const Certificate&, const Spectrum&);
template SpectrumEnclosure enclose_sheared_spectrum<4>(const ShearedEquations<4>&, double,
                                                       const Certificate&, const Spectrum&);

std::optional<EventEnclosure> enclose_sheared_event(const Body& body, const Potential& potential,
                                                    ShearedAxis axis, EventType type,
                                                    const Member& member) {
  if (const auto left = left_at(axis, type, member))
    return enclose_event({body, potential, *left}, {}, Circle::none, type, member);
  if (axis != ShearedAxis::in_no_plane || type != EventType::shear) return std::nullopt;
  const Vector3<double>& nu = member.angular_velocity;
  const bool in_second = std::abs(nu[1]) > std::abs(nu[0]);
  return enclose_tilted_event(
      body, potential, in_second ? TiltPlane::two_three : TiltPlane::one_three, type, member);
}

}  // namespace stationary
