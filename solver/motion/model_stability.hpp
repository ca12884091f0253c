// The spectrum of a family's member whose model is known by its type: q is brought to extended
// precision by one more correction with the solve's own residual, then lib's block forms are
// evaluated there, and with their conditioning.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/balanced/balanced_spectrum.hpp"
#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

/// f(the model) whose kind may be known at run time only: what is computed of it is then asked for
/// once, and nothing is that f leaves unused.
template <class Model, class F>
auto of_own_kind(const Model& model, const F& f) {
  if constexpr (requires { model.of_any_kind; }) {
    return model.visit(f);
  } else {
    return f(model);
  }
}

/// q = (xi, zeta, rho) corrected to extended precision at nu along the branch's axis.
template <class Model>
std::array<DoubleDouble, 3> extended_q(const Body& body, Branch branch, const Model& model,
                                       const Stretch& q, double nu) {
  const auto rates = axis_rates(body, branch, two_product(nu, nu));
  if constexpr (requires { model.plane; }) {
    const auto x = of_own_kind(model.plane, [&](const auto& plane) {
      return extended_solution(PlanarSystem<std::decay_t<decltype(plane)>>{plane, rates},
                               ReducedVector<2>(q.xi, q.zeta));
    });
    const auto rho = of_own_kind(model.thickness, [&](const auto& thickness) {
      return extended_solution(
          ThicknessSystem<std::decay_t<decltype(thickness)>>{thickness, rates.rho},
          ReducedVector<1>(q.rho));
    });
    return {x[0], x[1], rho[0]};
  } else {
    return extended_solution(CoupledSystem<Model>{model, rates},
                             ReducedVector<3>(q.xi, q.zeta, q.rho));
  }
}

/// What the balanced blocks take of a motion, for (ii) with axes 1 and 2 exchanged. input: what each
/// of its numbers is made.
template <class S, class C, class Model, class Input>
BalancedState<S, C> balanced_motion(const Body& body, Branch branch, const Model& model,
                                    const std::array<DoubleDouble, 3>& q, double nu,
                                    const SpinUnits& units, double least_apart,
                                    const Input& input) {
  const bool second = branch == Branch::ii;
  return balanced_state(SpinningBody<S, C, Model>{.model = model,
                                                  .J1 = input(second ? body.J2 : body.J1),
                                                  .J2 = input(second ? body.J1 : body.J2),
                                                  .J3 = input(body.J3),
                                                  .xi = input(q[second ? 1 : 0]),
                                                  .zeta = input(q[second ? 0 : 1]),
                                                  .rho = input(q[2]),
                                                  .omega = input(nu),
                                                  .normal = branch == Branch::iii,
                                                  .least_apart = least_apart},
                        units);
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
  const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
  if constexpr (requires { model.plane.log_balance(q[0], q[0], q[0], q[0]); }) {
    const bool circle = body.symmetric() && leading(q[0]) == leading(q[1]);
    if (nu != 0.0 && !(branch == Branch::iii && circle)) {
      const SpinUnits units(branch == Branch::ii ? body.J2 : body.J1, nu);
      // A difference of stretches has ten bits less, of more than a hundred.
      const auto state = balanced_motion<DoubleDouble, double>(
          body, branch, model, q, nu, units, 0x1p-10, [](const auto& x) { return x; });
      if (in_range(state)) {
        // Its bound is as much larger: from V where that is the better.
        const auto bound = balanced_motion<Conditioned, Conditioned>(
            body, branch, conditioned_model(model), q, nu, units, 0.125, input);
        return balanced_spectrum(facts, state, bound, units);
      }
    }
  }
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  const auto state = straight_state(J, model, q[0], q[1], q[2], DoubleDouble(nu));
  const Inertia3<Conditioned> J_c{input(body.J1), input(body.J2), input(body.J3)};
  const auto conditioned = straight_state(J_c, conditioned_model(model), input(q[0]), input(q[1]),
                                          input(q[2]), input(nu));
  return block_spectrum(facts, state, conditioned);
}

}  // namespace stationary
