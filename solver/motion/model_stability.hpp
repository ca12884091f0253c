// The spectrum of a family's member whose model is known by its type: q is brought to extended
// precision by one more correction with the solve's own residual, then lib's block forms are
// evaluated there, and with their conditioning.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

/// q = (xi, zeta, rho) corrected to extended precision at nu along the branch's axis.
template <class Model>
std::array<DoubleDouble, 3> extended_q(const Body& body, Branch branch, const Model& model,
                                       const Stretch& q, double nu) {
  const auto rates = axis_rates(body, branch, two_product(nu, nu));
  if constexpr (requires { model.plane; }) {
    const auto x =
        extended_solution(PlanarSystem<std::decay_t<decltype(model.plane)>>{model.plane, rates},
                          ReducedVector<2>(q.xi, q.zeta));
    const auto rho = extended_solution(
        ThicknessSystem<std::decay_t<decltype(model.thickness)>>{model.thickness, rates.rho},
        ReducedVector<1>(q.rho));
    return {x[0], x[1], rho[0]};
  } else {
    return extended_solution(CoupledSystem<Model>{model, rates},
                             ReducedVector<3>(q.xi, q.zeta, q.rho));
  }
}

/// q: (xi, zeta, rho) in extended precision. bound: relative uncertainty of every input that bounds
/// and classes allow for; NaN counts as 1e-15.
template <class Model>
Spectrum model_stability(const Body& body, Branch branch, const Model& model,
                         std::array<DoubleDouble, 3> q, double nu, double bound) {
  constexpr bool separable = requires { model.plane; };
  const BlockFacts facts{branch,
                         body.symmetric(),
                         !separable,
                         std::isnan(bound) ? 1e-15 : std::max(bound, 0x1p-53),
                         sees_no_axes(model),
                         holds_volume(model)};
  // A circle known only to its error is the circle.
  const double apart = std::abs(leading(q[0] - q[1]));
  if (body.symmetric() && apart <= 4.0 * facts.uncertainty * leading(q[0]))
    q[0] = q[1] = 0.5 * (q[0] + q[1]);
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  const auto state = straight_state(J, model, q[0], q[1], q[2], DoubleDouble(nu));
  const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
  const Inertia3<Conditioned> J_c{input(body.J1), input(body.J2), input(body.J3)};
  const auto conditioned = straight_state(J_c, conditioned_model(model), input(q[0]), input(q[1]),
                                          input(q[2]), input(nu));
  return block_spectrum(facts, state, conditioned);
}

}  // namespace stationary
