// The interval systems of one problem at one nu, with its inputs as intervals.
#pragma once

#include "solver/motion/problem.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {

/// Rates of C(nu); J and nu as inputs.
inline CentrifugalRates<Interval> rate_intervals(const Problem& problem, double nu, Inputs inputs) {
  const CentrifugalRates<Interval> c = problem.rates(square(as_input(nu, inputs)));
  if (inputs == Inputs::doubles) return c;
  // J within half a unit of its last place: a relative 2^-53 at most.
  const Interval half_unit(1.0 - 0x1p-53, 1.0 + 0x1p-52);
  return {half_unit * c.xi, half_unit * c.zeta, half_unit * c.rho};
}

template <class Coupled>
struct BoxSystems {
  CoupledBoxSystem<decltype(interval_model(std::declval<Coupled>(), Inputs()))> coupled;

  BoxSystems(const Problem& problem, const Coupled& model, double nu, Inputs inputs)
      : coupled{interval_model(model, inputs), rate_intervals(problem, nu, inputs)} {}
};

template <class Plane, class Thickness>
struct BoxSystems<Separable<Plane, Thickness>> {
  PlanarBoxSystem<decltype(interval_model(std::declval<Plane>(), Inputs()))> plane;
  ThicknessBoxSystem<decltype(interval_model(std::declval<Thickness>(), Inputs()))> thickness;

  BoxSystems(const Problem& problem, const Separable<Plane, Thickness>& model, double nu,
             Inputs inputs)
      : plane{interval_model(model.plane, inputs), rate_intervals(problem, nu, inputs)},
        thickness{interval_model(model.thickness, inputs),
                  rate_intervals(problem, nu, inputs).rho} {}
};

}  // namespace stationary
