// The balance of a potential that need not be isotropic over a box of its unknowns, in interval
// arithmetic, with J, coefficients, angles and nu as intervals.
#pragma once

#include <cmath>

#include "lib/balance/principal_forces.hpp"
#include "solver/motion/oriented_system.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/proof/certify.hpp"

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
  /// Valleys of V run aslant to the unknowns: branch and prune needs a third of the boxes so.
  static constexpr bool split_by_slopes = true;

  AnisotropicModel<Interval> model;
  Inertia3<Interval> J;
  Branch branch;
  Interval nu_squared;
  Interval rho = 1.0;                       ///< where that is no unknown, and no volume is held
  Interval rho_range = Interval::entire();  ///< of what a held volume leaves

  OrientedBoxSystem(const Body& body, const AnisotropicPotential& potential, Branch about,
                    double nu, Inputs inputs)
      : model(potential.model(AsIntervals{inputs})),
        J(inertia_intervals(body, inputs)),
        branch(about),
        nu_squared(square(as_input(nu, inputs))) {}

  GeneralBoxLinearized<N> linearize(const Box<N>& x) const { return linearize(x, nu_squared); }
  GeneralBoxLinearized<N> linearize(const Box<N>& x, const Interval& spin_squared) const {
    const auto b =
        balance_at<Layout, 2>(J, model, branch, spin_squared, all_coordinates<Layout>(x, rho));
    GeneralBoxLinearized<N> out;
    for (std::size_t i = 0; i < Layout::places.size(); ++i) {
      out.g[i] = b.g[Layout::places[i]];
      for (std::size_t j = 0; j < Layout::places.size(); ++j)
        out.slope[i][j] = b.slope[Layout::places[i]][Layout::places[j]];
    }
    return out;
  }

  Box<N> residual(const Box<N>& x) const { return residual(x, nu_squared); }
  Box<N> residual(const Box<N>& x, const Interval& spin_squared) const {
    const auto b =
        balance_at<Layout, 1>(J, model, branch, spin_squared, all_coordinates<Layout>(x, rho));
    Box<N> out;
    for (std::size_t i = 0; i < Layout::places.size(); ++i) out[i] = b.g[Layout::places[i]];
    return out;
  }

  OrientedStretch<Interval> at(const Box<N>& x) const {
    const auto y = all_coordinates<Layout>(x, rho);
    const OrientedStretch<Interval> out = oriented_stretch(y[0], y[1], y[2], y[3]);
    return !Layout::thickness && model.body.volume ? at_volume(*model.body.volume, out) : out;
  }

  /// Where the potential is not defined or the volume another, and by the forces along the
  /// principal axes of S, of which no row says as much where S is long and thin.
  bool excludes(const Box<N>& x) const { return excludes(x, nu_squared); }
  bool excludes(const Box<N>& x, const Interval& spin_squared) const {
    const auto y = all_coordinates<Layout>(x, rho);
    OrientedStretch<Interval> at = this->at(x);
    if (const auto& volume = model.body.volume) {
      const OrientedStretch<Interval> whole = at_volume(*volume, at);
      if (whole.q.rho.apart_from(Layout::thickness ? at.q.rho : rho_range)) return true;
      at = whole;
    }
    if (model.outside_box(at.q)) return true;
    const AxisAngle<Interval> axis = axis_angle(y[4]);
    const PrincipalFrame<Interval> frame = principal_frame(at);
    const auto forces =
        principal_forces(J, model, at, frame, spin_squared, Layout::axis ? &axis : nullptr, branch);
    if (!forces) return pull_excludes(at, spin_squared, axis);
    const auto zero = [](const Interval& force) { return force.may_be(0.0); };
    if (!zero(forces->along) || !zero(forces->across) || !zero(forces->sum)) return true;
    if (forces->compatibility && !zero(*forces->compatibility)) return true;
    const bool turns = Layout::axis || frame.large.lo > frame.small.hi;
    return turns && forces->turning && !zero(*forces->turning);
  }

  BasicStretch<Interval> stretch(const Box<N>& x) const { return at(x).q; }
  /// alpha's own force at alpha = 0: zero where a spin about axis 1 or 2 is possible.
  Interval shear_force(const Box<N>& x) const {
    return potential_derivatives<1>(model, stretch(x)).gradient[0];
  }

 private:
  /// By the sum of the rows of u and v, in which a fibre is 2 k n (n + 1) >= -k/2, however stiff,
  /// and whatever the directions.
  bool pull_excludes(const OrientedStretch<Interval>& at, const Interval& spin_squared,
                     const AxisAngle<Interval>& axis) const {
    AnisotropicModel<Interval> without = model;
    without.fibre_count = 0;
    AnisotropicDerivatives<Interval> V = without.template evaluate<1>(at.invariants(), at.q);
    // What a written-out model pulls is narrower as one expression.
    std::optional<Interval> written;
    if (const auto* expression = model.expression(); expression != nullptr && !model.body.any())
      written = expression->plane_pull(at.q);
    if (written) V.directed.gradient.setConstant(Interval(0.0));
    const SpinProducts<Interval> spin =
        Layout::axis ? in_plane_products(spin_squared, axis.cosine, axis.sine)
                     : axis_products(branch, spin_squared);
    const Inertia3<Interval> pulling = gather_thickness(J, without, at.q.rho, spin, V);
    auto b = oriented_balance<1>(pulling, V, at, spin);
    if (model.body.volume) b = held<1>(b, at);
    Interval sum = b.g[oriented::u] + b.g[oriented::v];
    if (written) sum += *written;
    for (std::size_t k = 0; k < model.fibre_count; ++k) {
      const auto& [c, s] = model.fibres[k].along;
      const Interval n = square(at.q.xi * c + at.q.alpha * s) +
                         square(at.q.alpha * c + at.q.zeta * s) - Interval(1.0);
      sum += 2.0 * (model.fibres[k].k * (square(n + Interval(0.5)) - Interval(0.25)));
    }
    return !sum.may_be(0.0);
  }
};

/// How far alpha is from its proven one, over sqrt(xi zeta).
inline Interval shear_error(double alpha, const StretchBox& proven) {
  return (Interval(alpha) - proven.alpha) / sqrt(proven.xi * proven.zeta);
}
/// The angle between nu and its proven axis, where it is small.
inline Interval axis_error(const Vector3<double>& nu, const AxisAngle<Interval>& axis) {
  const Interval size = sqrt(square(Interval(nu[0])) + square(Interval(nu[1])));
  return 1.0000001 * ((axis.cosine * nu[1] - axis.sine * nu[0]) / size);
}

}  // namespace stationary
