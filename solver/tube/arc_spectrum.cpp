#include "solver/tube/arc_spectrum.hpp"

#include <utility>

#include "lib/balance/tilted_balance.hpp"
#include "lib/number/dual.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/proof/tilted_enclosure.hpp"

namespace stationary {
namespace {

using AlongArc = Dual<Interval, 1>;

Sloped sloped(const AlongArc& over, const Interval& middle) {
  return Sloped(over.value, middle, over.slope[0]);
}

/// The inputs and motions over the arc, with slopes, and in its middle.
template <class Model>
class Along {
 public:
  Along(const Body& body, const Model& model, const MotionArc& motion, Inputs inputs)
      : number_{inputs},
        over_J_{number_(body.J1), number_(body.J2), number_(body.J3)},
        at_J_(inertia_intervals(body, inputs)),
        over_model_(with_coefficients(model, number_)),
        at_model_(interval_model(model, inputs)),
        xi_(motion.over.stretches.xi, {motion.stretch_slope.xi}),
        zeta_(motion.over.stretches.zeta, {motion.stretch_slope.zeta}),
        rho_(motion.over.stretches.rho, {motion.stretch_slope.rho}),
        nu_(motion.over.nu, {motion.nu_slope}),
        at_(motion.at) {}

  StraightState<Sloped> state() const {
    const auto over = straight_state(over_J_, over_model_, xi_, zeta_, rho_, nu_);
    const StretchBox& middle = at_.stretches;
    const auto at = straight_state(at_J_, at_model_, middle.xi, middle.zeta, middle.rho, at_.nu);
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
  TiltSquares<Sloped> tilt(TiltPlane plane) const {
    const auto over =
        tilt_squares_of(over_model_, over_J_, plane, xi_, zeta_, rho_, AlongArc(nu_ * nu_));
    const StretchBox& middle = at_.stretches;
    const auto at = tilt_squares_of(at_model_, at_J_, plane, middle.xi, middle.zeta, middle.rho,
                                    square(at_.nu));
    return {sloped(over.in_plane, at.in_plane), sloped(over.normal, at.normal)};
  }

 private:
  struct Number {
    Inputs inputs;
    AlongArc operator()(double x) const { return AlongArc(as_input(x, inputs)); }
  };

  Number number_;
  Inertia3<AlongArc> over_J_;
  Inertia3<Interval> at_J_;
  decltype(with_coefficients(std::declval<Model>(), std::declval<Number>())) over_model_;
  decltype(interval_model(std::declval<Model>(), Inputs())) at_model_;
  AlongArc xi_, zeta_, rho_, nu_;
  MotionBox at_;
};

}  // namespace

SpectrumEnclosure enclose_spectrum(const Problem& problem, const MotionArc& along,
                                   const Spectrum& approximate, Inputs inputs) {
  if (!along.has_slopes || !problem.potential().is_isotropic())
    return enclose_spectrum(problem, along.over, approximate, inputs);
  return problem.potential().visit_parts([&](const auto& model) {
    return enclose_spectrum(enclosure_facts(problem, along.over),
                            Along(problem.body(), model, along, inputs).state(), approximate);
  });
}

SpectrumEnclosure enclose_tilted_spectrum(const Body& body, const Potential& potential,
                                          TiltPlane plane, const MotionArc& along,
                                          const Spectrum& approximate, Inputs inputs) {
  if (!along.has_slopes)
    return enclose_tilted_spectrum(body, potential, plane, along.over, approximate, inputs);
  return potential.visit_parts([&](const auto& model) {
    const Along numbers(body, model, along, inputs);
    return enclose_tilted_spectrum(body, potential, plane, numbers.state(), numbers.tilt(plane),
                                   approximate);
  });
}

}  // namespace stationary
