#include "solver/proof/motion_spectrum.hpp"

#include "lib/number/dual.hpp"
#include "solver/proof/anisotropic_enclosure.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {
namespace {

using AlongArc = Dual<Interval, 1>;

EnclosureFacts facts_of(const Problem& problem, const MotionBox& motion) {
  const BodyModel<>* body_model = problem.potential().body_model();
  return {problem.branch(),
          motion.nu.hi == 0.0,
          problem.body().symmetric(),
          motion.circle,
          !problem.potential().is_separable(),
          body_model == nullptr || body_model->isotropic(),
          problem.potential().holds_volume()};
}

template <class Model>
StraightState<Interval> state_over(const Body& body, const Model& model, const MotionBox& motion,
                                   Inputs inputs) {
  const StretchBox& at = motion.stretches;
  return straight_state(inertia_intervals(body, inputs), interval_model(model, inputs), at.xi,
                        at.zeta, at.rho, motion.nu);
}

template <class Model>
StraightState<Sloped> state_along(const Body& body, const Model& model, const MotionArc& motion,
                                  Inputs inputs) {
  const auto number = [inputs](double x) { return AlongArc(as_input(x, inputs)); };
  const StretchBox& x = motion.over.stretches;
  const StretchBox& slope = motion.stretch_slope;
  const StraightState<AlongArc> over = straight_state(
      Inertia3<AlongArc>{number(body.J1), number(body.J2), number(body.J3)},
      with_coefficients(model, number), AlongArc(x.xi, {slope.xi}), AlongArc(x.zeta, {slope.zeta}),
      AlongArc(x.rho, {slope.rho}), AlongArc(motion.over.nu, {motion.nu_slope}));
  const StraightState<Interval> at = state_over(body, model, motion.at, inputs);
  const auto sloped = [](const AlongArc& range, const Interval& middle) {
    return Sloped(range.value, middle, range.slope[0]);
  };
  return {{sloped(over.J.J1, at.J.J1), sloped(over.J.J2, at.J.J2), sloped(over.J.J3, at.J.J3)},
          sloped(over.xi, at.xi),
          sloped(over.zeta, at.zeta),
          sloped(over.rho, at.rho),
          sloped(over.omega, at.omega),
          sloped(over.V_aa, at.V_aa),
          sloped(over.V_xx, at.V_xx),
          sloped(over.V_xz, at.V_xz),
          sloped(over.V_zz, at.V_zz),
          sloped(over.V_xr, at.V_xr),
          sloped(over.V_zr, at.V_zr),
          sloped(over.V_rr, at.V_rr)};
}

}  // namespace

SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionBox& motion,
                                   const Spectrum& approximate, Inputs inputs) {
  if (!problem.potential().is_isotropic())
    return enclose_anisotropic_spectrum(problem, motion, approximate, inputs);
  return problem.potential().visit_parts([&](const auto& model) {
    return enclose_spectrum(facts_of(problem, motion),
                            state_over(problem.body(), model, motion, inputs), approximate);
  });
}

SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionArc& along,
                                   const Spectrum& approximate, Inputs inputs) {
  if (!along.has_slopes || !problem.potential().is_isotropic())
    return enclose_spectrum(problem, along.over, approximate, inputs);
  return problem.potential().visit_parts([&](const auto& model) {
    return enclose_spectrum(facts_of(problem, along.over),
                            state_along(problem.body(), model, along, inputs), approximate);
  });
}

}  // namespace stationary
