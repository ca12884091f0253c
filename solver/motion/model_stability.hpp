// The spectrum of a family's member whose model is known by its type: q is brought to extended
// precision by one more correction with the solve's own residual, then lib's block forms are
// evaluated there, and with their conditioning.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lib/balanced/balanced_spectrum.hpp"
#include "lib/balanced/pair_kernels.hpp"
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
template <class S, class C, class Input>
SpinningBody<S, C> spinning_body(const Body& body, Branch branch,
                                 const std::array<DoubleDouble, 3>& q, double nu,
                                 double least_apart, const Input& input) {
  const bool second = branch == Branch::ii;
  return {.J1 = input(second ? body.J2 : body.J1),
          .J2 = input(second ? body.J1 : body.J2),
          .J3 = input(body.J3),
          .xi = input(q[second ? 1 : 0]),
          .zeta = input(q[second ? 0 : 1]),
          .rho = input(q[2]),
          .omega = input(nu),
          .normal = branch == Branch::iii,
          .least_apart = least_apart};
}

/// f(the model's place among the built-in ones, its coefficients) where it is one of them.
template <class Variant, class Model, class F>
bool of_built_in(const Model& model, const F& f) {
  const auto of_own = [&](const auto& own) {
    using Own = std::decay_t<decltype(own)>;
    constexpr std::size_t place = place_among<Own>(static_cast<const Variant*>(nullptr));
    if constexpr (place < std::variant_size_v<Variant>) f(place, own.coefficients());
    return place < std::variant_size_v<Variant>;
  };
  return of_own_kind(model, of_own);
}

/// The curvatures of its potential in pairs: a built-in part's by its kernel, which knows it by its
/// coefficients alone.
template <class Model>
PairCurvatures pair_curvatures(const Model& model, const PairSpin& spin,
                               const PairKernels& kernels) {
  PairCurvatures out;
  const auto own_kernel = [&](const auto& list) {
    return [&](std::size_t place, const std::array<double, 2>& c) { list[place](c, spin, out); };
  };
  if (!of_built_in<PlanarPotential>(model.plane, own_kernel(kernels.plane)))
    add_plane(model.plane, spin, out);
  if (!of_built_in<ThicknessPotential>(model.thickness, own_kernel(kernels.thickness)))
    add_thickness(model.thickness, spin, out);
  return out;
}

/// By the balanced blocks; otherwise() where something leaves the range of doubles. kernel: what
/// makes the blocks.
template <class Blocks, class Model, class Otherwise>
Spectrum spectrum_by_blocks(const BlockFacts& facts, const Model& model, const Body& body,
                            const std::array<DoubleDouble, 3>& q, double nu,
                            PairKernels::Of<Blocks> kernel, const Otherwise& otherwise) {
  const SpinUnits units(facts.branch == Branch::ii ? body.J2 : body.J1, nu);
  // A difference of stretches has ten bits less, of more than a hundred.
  const PairSpin spin = spinning_body<DoubleDouble, double>(body, facts.branch, q, nu, 0x1p-10,
                                                            [](const auto& x) { return x; });
  Blocks blocks;
  kernel(spin, pair_curvatures(model, spin, pair_kernels()), units, facts.material_symmetry,
         blocks);
  if (!in_range(blocks.state)) return otherwise();
  // Its bound is as much larger: from V where that is the better.
  const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
  const auto bound =
      spinning_body<Conditioned, Conditioned>(body, facts.branch, q, nu, 0.125, input);
  Curvatures<Conditioned> curvatures;
  of_own_kind(model.plane, [&](const auto& own) {
    add_plane(with_coefficients(own, Conditioned::input), bound, curvatures);
  });
  of_own_kind(model.thickness, [&](const auto& own) {
    add_thickness(with_coefficients(own, Conditioned::input), bound, curvatures);
  });
  return balanced_spectrum(facts, blocks, balanced_state(bound, curvatures, units), units);
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
                         stretch_uncertainty(bound),
                         sees_no_axes(model),
                         holds_volume(model)};
  // A circle known only to its error is the circle.
  const double apart = std::abs(leading(q[0] - q[1]));
  if (body.symmetric() && apart <= 4.0 * facts.uncertainty * leading(q[0]))
    q[0] = q[1] = 0.5 * (q[0] + q[1]);
  const auto by_entries = [&] {
    const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
    const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
    const auto state = straight_state(J, model, q[0], q[1], q[2], DoubleDouble(nu));
    const Inertia3<Conditioned> J_c{input(body.J1), input(body.J2), input(body.J3)};
    const auto conditioned = straight_state(J_c, conditioned_model(model), input(q[0]), input(q[1]),
                                            input(q[2]), input(nu));
    return block_spectrum(facts, state, conditioned);
  };
  if constexpr (requires { model.plane.log_balance(q[0], q[0], q[0], q[0]); }) {
    const bool circle = body.symmetric() && leading(q[0]) == leading(q[1]);
    const PairKernels& kernels = pair_kernels();
    if (nu != 0.0 && branch != Branch::iii)
      return spectrum_by_blocks(facts, model, body, q, nu, kernels.in_plane_blocks, by_entries);
    if (nu != 0.0 && !circle)
      return spectrum_by_blocks(facts, model, body, q, nu, kernels.normal_blocks, by_entries);
  }
  return by_entries();
}

}  // namespace stationary
