// The balance of a potential that need not be isotropic over a box of its unknowns, in interval
// arithmetic, with J, coefficients, angles and nu as intervals.
#pragma once

#include <cmath>

#include "solver/interval_system.hpp"
#include "solver/oriented_system.hpp"

namespace stationary {

struct AsIntervals {
  Inputs inputs;

  Interval operator()(double c) const { return as_input(c, inputs); }
  Direction<Interval> direction(double degrees) const {
    const Interval input = as_input(degrees, inputs);
    return direction_interval(degrees, std::max(input.hi - degrees, degrees - input.lo));
  }
};

template <class Layout>
struct OrientedBoxSystem {
  static constexpr int dimension = Layout::dimension;
  static constexpr int N = dimension;

  AnisotropicModel<Interval> model;
  Inertia3<Interval> J;
  Branch branch;
  Interval nu_squared;
  Interval rho = 1.0;  ///< where that is no unknown

  OrientedBoxSystem(const Body& body, const AnisotropicPotential& potential, Branch about,
                    double nu, Inputs inputs)
      : model(potential.model(AsIntervals{inputs})),
        J(inertia_intervals(body, inputs)),
        branch(about),
        nu_squared(square(as_input(nu, inputs))) {}

  GeneralBoxLinearized<N> linearize(const Box<N>& x) const {
    const auto b = balance_at<Layout, 2>(J, model, branch, nu_squared,
                                         all_coordinates<Layout>(x, rho));
    GeneralBoxLinearized<N> out;
    for (std::size_t i = 0; i < Layout::places.size(); ++i) {
      out.g[i] = b.g[Layout::places[i]];
      for (std::size_t j = 0; j < Layout::places.size(); ++j)
        out.slope[i][j] = b.slope[Layout::places[i]][Layout::places[j]];
    }
    return out;
  }

  BasicStretch<Interval> stretch(const Box<N>& x) const {
    const auto y = all_coordinates<Layout>(x, rho);
    return oriented_stretch(y[0], y[1], y[2], y[3]).q;
  }
  /// alpha's own force at alpha = 0: zero where a spin about axis 1 or 2 is possible.
  Interval shear_force(const Box<N>& x) const {
    return potential_derivatives<1>(model, stretch(x)).gradient[0];
  }
};

}  // namespace stationary
