// What each input p of a potential does to the balance by itself: the vectors p dg/dp, g the gradient of V in
// (ln xi, ln zeta[, ln rho]), whose magnitudes coefficient_sensitivity.hpp sums. One input moves all equations
// together, and of long, thin bodies the solution answers to that far less than to the sum of the parts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <variant>

#include "solver/newton/coefficient_sensitivity.hpp"
#include "solver/newton/reduced_vector.hpp"

namespace stationary {

/// each(p dg/dp) for every coefficient p of the model; the decimals of formulas are left out.
template <int N, class Model, class Each>
void for_each_coefficient(const Model& model, const ReducedVector<N>& x, const Each& each);

/// Of dual numbers: each({row, ...}) with the slopes of every direction.
template <int N, class Each, class... Rows>
void for_each_direction(const Each& each, const Rows&... rows) {
  static_assert(sizeof...(Rows) == N);
  const std::size_t directions = std::min({rows.slope.size()...});
  for (std::size_t k = 0; k < directions; ++k) {
    ReducedVector<N> g;
    int i = 0;
    ((g[i++] = rows.slope[k]), ...);
    each(g);
  }
}

/// Of the numbers of a body with gravity or a held volume.
template <class Each>
void for_each_body_coefficient(const BodyModel<>& model, const ReducedVector<3>& x,
                               const Each& each) {
  const double rho = model.thickness(x[0], x[1], x[2]);
  const auto held = [&](const ReducedVector<3>& g) {
    each(model.volume ? ReducedVector<3>(g[0] - g[2], g[1] - g[2], 0.0) : g);
  };
  if (model.elastic.plane)
    for_each_coefficient<2>(
        *model.elastic.plane, ReducedVector<2>(x[0], x[1]),
        [&](const ReducedVector<2>& g) { held(ReducedVector<3>(g[0], g[1], 0.0)); });
  if (model.elastic.thickness)
    for_each_coefficient<1>(
        *model.elastic.thickness, ReducedVector<1>(rho),
        [&](const ReducedVector<1>& g) { held(ReducedVector<3>(0.0, 0.0, g[0])); });
  std::visit(
      [&](const auto& coupled) {
        if constexpr (requires { coupled.coefficients(); })
          for_each_coefficient<3>(coupled, ReducedVector<3>(x[0], x[1], rho), held);
      },
      model.elastic.coupled);
  if (model.gravitates) {
    const auto b =
        gravity_with_duals(model, x[0], x[1], rho, [](double value, std::size_t) { return value; });
    for_each_direction<3>(held, b.g_xi, b.g_zeta, b.g_rho);
  }
  if (model.volume) {
    const auto b = model.whole<2>(x[0], x[1], rho, 0.0, 0.0, 0.0);
    const double k = model.stiffness;
    each(ReducedVector<3>(b.uw - b.ww - k, b.vw - b.ww - k, -k));
  }
}

template <int N, class Model, class Each>
void for_each_coefficient(const Model& model, const ReducedVector<N>& x, const Each& each) {
  if constexpr (is_body_model<Model>) {
    for_each_body_coefficient(model, x, each);
  } else if constexpr (requires { model.of_any_kind; }) {
    model.visit([&](const auto& own) { for_each_coefficient<N>(own, x, each); });
  } else if constexpr (requires { model.plane; }) {  // N = 3
    for_each_coefficient<2>(
        model.plane, ReducedVector<2>(x[0], x[1]),
        [&](const ReducedVector<2>& g) { each(ReducedVector<3>(g[0], g[1], 0.0)); });
    for_each_coefficient<1>(
        model.thickness, ReducedVector<1>(x[2]),
        [&](const ReducedVector<1>& g) { each(ReducedVector<3>(0.0, 0.0, g[0])); });
  } else if constexpr (N == 1) {
    for_each_direction<1>(each, with_relative_duals(model).template evaluate<1>(x[0]).v_r);
  } else if constexpr (N == 2) {
    const auto w = with_relative_duals(model).template evaluate<1>(planar_invariants(x[0], x[1]));
    for_each_direction<2>(each, x[0] * w.w_t + w.w_l, x[1] * w.w_t + w.w_l);
  } else {
    const auto w =
        with_relative_duals(model).template evaluate<1>(planar_invariants(x[0], x[1]), x[2]);
    for_each_direction<3>(each, x[0] * w.plane.w_t + w.plane.w_l, x[1] * w.plane.w_t + w.plane.w_l,
                          w.w_r);
  }
}

/// Of the decimals of a formula, each equation by itself.
template <int N, class Model, class Each>
void for_each_decimal(const Model& model, const ReducedVector<N>& x, const Each& each) {
  const ReducedVector<N> sum = decimal_sensitivity<N>(model, x);
  for (int k = 0; k < N; ++k) each(ReducedVector<N>(sum[k] * ReducedVector<N>::Unit(k)));
}

/// And of the spin, whose pull_i = c_i x_i^2 the equations take away, c_i = J_i nu^2.
template <int N, class Each>
void for_each_spin_input(const ReducedVector<N>& pull, const Each& each) {
  each(ReducedVector<N>(-2.0 * pull));  // nu
  for (int k = 0; k < N; ++k) each(ReducedVector<N>(-pull[k] * ReducedVector<N>::Unit(k)));
}

}  // namespace stationary
