#include "solver/tube/arc_spectrum.hpp"

#include "lib/number/dual.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {
namespace {

using AlongArc = Dual<Interval, 1>;

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
  const StretchBox& middle = motion.at.stretches;
  const StraightState<Interval> at =
      straight_state(inertia_intervals(body, inputs), interval_model(model, inputs), middle.xi,
                     middle.zeta, middle.rho, motion.at.nu);
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

SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionArc& along,
                                   const Spectrum& approximate, Inputs inputs) {
  if (!along.has_slopes || !problem.potential().is_isotropic())
    return enclose_spectrum(problem, along.over, approximate, inputs);
  return problem.potential().visit_parts([&](const auto& model) {
    return enclose_spectrum(enclosure_facts(problem, along.over),
                            state_along(problem.body(), model, along, inputs), approximate);
  });
}

}  // namespace stationary
