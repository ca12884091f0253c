// What the inputs of a potential do to the balance: the sum over its coefficients p of
//
//   |p dg/dp|,   g the gradient of V in (ln xi, ln zeta[, ln rho]),
//
// by dual numbers or as a model says it, and what the decimals that a formula is written with do.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "lib/balance/balance.hpp"
#include "lib/material/models/model_coefficients.hpp"
#include "lib/material/potential.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "solver/newton/asked_of_models.hpp"
#include "solver/newton/reduced_vector.hpp"

namespace stationary {

/// A direction for each coefficient.
template <class Model>
using CoefficientDual = Dual<double, most_coefficients<Model>>;

/// model with its coefficients as dual numbers: coefficient k has derivative p_k in direction k, so
/// derivatives come out as sensitivities to relative changes.
template <template <class> class Model>
auto with_relative_duals(const Model<double>& model) {
  return with_indexed_coefficients(model, [](double p, std::size_t k) {
    return CoefficientDual<Model<double>>::along(p, p, k);
  });
}

template <std::size_t N>
double sensitivity(const Dual<double, N>& x) {
  double out = 0.0;
  for (const double slope : x.slope) out += std::abs(slope);
  return out;
}

/// at(the model with exact coefficients) where it has decimals in its formula: what depends on
/// these is then as conditioned as they are uncertain.
template <class Model, class At>
void for_decimals(const Model& model, const At& at) {
  const auto exact = [](double c) { return Conditioned(c); };
  if constexpr (requires {
                  model.plane;
                  model.thickness;
                }) {
    if constexpr (requires { model.plane.has_decimals(); }) {
      if (!model.plane.has_decimals() && !model.thickness.has_decimals()) return;
      const auto plane = with_coefficients(model.plane, exact);
      const auto thickness = with_coefficients(model.thickness, exact);
      at(Separable<std::remove_cv_t<decltype(plane)>, std::remove_cv_t<decltype(thickness)>>{
          plane, thickness});
    }
  } else if constexpr (requires { model.has_decimals(); }) {
    if (model.has_decimals()) at(with_coefficients(model, exact));
  }
}

/// Their part of input_sensitivity(), of the gradient of V in (ln xi, ln zeta[, ln rho]).
template <int N, class Model>
ReducedVector<N> decimal_sensitivity(const Model& model, const ReducedVector<N>& x) {
  ReducedVector<N> out = ReducedVector<N>::Zero();
  for_decimals(model, [&](const auto& conditioned) {
    if constexpr (is_body_model<Model>) {
      const Conditioned none(0.0);
      const auto b = conditioned.template log_balance<1>(Conditioned(x[0]), Conditioned(x[1]),
                                                         Conditioned(x[2]), none, none, none);
      out = {b.g_xi.condition, b.g_zeta.condition, b.g_rho.condition};
    } else if constexpr (N == 1) {
      out[0] = conditioned.template evaluate<1>(Conditioned(x[0])).v_r.condition;
    } else {
      const Conditioned xi(x[0]);
      const Conditioned zeta(x[1]);
      const auto add = [&](const PlanarDerivatives<Conditioned>& w) {
        out[0] = (xi * w.w_t + w.w_l).condition;
        out[1] = (zeta * w.w_t + w.w_l).condition;
      };
      if constexpr (N == 2) {
        add(conditioned.template evaluate<1>(planar_invariants(xi, zeta)));
      } else {
        const auto w =
            conditioned.template evaluate<1>(planar_invariants(xi, zeta), Conditioned(x[2]));
        add(w.plane);
        out[2] = w.w_r.condition;
      }
    }
  });
  return out;
}

template <int N, class Model>
ReducedVector<N> coefficient_sensitivity(const Model& model, const ReducedVector<N>& x);

/// g and J of a body with gravity as dual numbers in this order, slope(value, k) that of number k.
template <class Slope>
auto gravity_with_duals(const BodyModel<>& model, double xi, double zeta, double rho,
                        const Slope& slope) {
  using D = Dual<double, 4>;
  const auto number = [&](double value, std::size_t k) {
    return D::along(value, slope(value, k), k);
  };
  const GravityBalance<D> pull = gravity_balance<1>(
      number(model.g, 0), number(model.J.J1, 1) * (xi * xi), number(model.J.J2, 2) * (zeta * zeta),
      number(model.J.J3, 3) * (rho * rho));
  return LogBalance<D>{.g_xi = pull.pull[0], .g_zeta = pull.pull[1], .g_rho = pull.pull[2]};
}

/// coefficient_sensitivity() of the elastic numbers of a body, at a given rho.
inline ReducedVector<3> elastic_sensitivity(const BodyModel<>& model, const ReducedVector<3>& x) {
  ReducedVector<3> out = ReducedVector<3>::Zero();
  if (model.elastic.plane)
    out.head<2>() = coefficient_sensitivity<2>(*model.elastic.plane, ReducedVector<2>(x[0], x[1]));
  if (model.elastic.thickness)
    out[2] = coefficient_sensitivity<1>(*model.elastic.thickness, ReducedVector<1>(x[2]))[0];
  std::visit(
      [&](const auto& coupled) {
        if constexpr (requires { coupled.coefficients(); })
          out = coefficient_sensitivity<3>(coupled, x);
      },
      model.elastic.coupled);
  return out;
}
/// And of gravity's. held: of what is left along a held volume.
inline ReducedVector<3> gravity_sensitivity(const BodyModel<>& model, const ReducedVector<3>& x,
                                            bool held_volume) {
  if (!model.gravitates) return ReducedVector<3>::Zero();
  LogBalance<Dual<double, 4>> b =
      gravity_with_duals(model, x[0], x[1], x[2], [](double value, std::size_t) { return value; });
  if (held_volume) b = held<1>(b);
  return {sensitivity(b.g_xi), sensitivity(b.g_zeta), sensitivity(b.g_rho)};
}

/// coefficient_sensitivity() of all numbers of a body.
inline ReducedVector<3> body_sensitivity(const BodyModel<>& model, const ReducedVector<3>& x) {
  const double rho = model.thickness(x[0], x[1], x[2]);
  const ReducedVector<3> at(x[0], x[1], rho);
  ReducedVector<3> out = elastic_sensitivity(model, at);
  if (model.volume) {
    // |dG_u| <= |dg_u| + |dg_w|; and the volume itself, by rho and in its own equation.
    const auto b = model.whole<2>(x[0], x[1], rho, 0.0, 0.0, 0.0);
    const double k = model.stiffness;
    out = {out[0] + out[2] + std::abs(b.uw) + std::abs(b.ww) + k,
           out[1] + out[2] + std::abs(b.vw) + std::abs(b.ww) + k, k};
  }
  return out + gravity_sensitivity(model, at, model.volume.has_value());
}

/// Likewise of the rows at x without the constraint, the decimals of formulas among them.
inline ReducedVector<3> unheld_sensitivity(const BodyModel<>& model, const ReducedVector<3>& x) {
  ReducedVector<3> out = elastic_sensitivity(model, x) + gravity_sensitivity(model, x, false);
  for_decimals(model, [&](const auto& conditioned) {
    const Conditioned none(0.0);
    const auto b = conditioned.template whole<1>(Conditioned(x[0]), Conditioned(x[1]),
                                                 Conditioned(x[2]), none, none, none);
    out += ReducedVector<3>(b.g_xi.condition, b.g_zeta.condition, b.g_rho.condition);
  });
  return out;
}

/// Sum over the coefficients p of |p dg/dp|, g the gradient of V in (ln xi, ln zeta[, ln rho]).
template <int N, class Model>
ReducedVector<N> coefficient_sensitivity(const Model& model, const ReducedVector<N>& x) {
  if constexpr (is_body_model<Model>) {
    return body_sensitivity(model, x);
  } else if constexpr (requires { model.of_any_kind; }) {
    return model.visit([&](const auto& own) { return coefficient_sensitivity<N>(own, x); });
  } else if constexpr (requires { model.plane; }) {  // N = 3
    ReducedVector<N> out;
    out.template head<2>() = coefficient_sensitivity<2>(model.plane, ReducedVector<2>(x[0], x[1]));
    out[2] = coefficient_sensitivity<1>(model.thickness, ReducedVector<1>(x[2]))[0];
    return out;
  } else {
    if constexpr (requires { model.residual_sensitivity(x[0]); } && N == 1) {
      if (const auto of_model = model.residual_sensitivity(x[0]))
        return ReducedVector<1>(*of_model);
    }
    if constexpr (requires { model.residual_sensitivity(x[0], x[1]); } && N == 2) {
      if (const auto of_model = model.residual_sensitivity(x[0], x[1]))
        return {(*of_model)[0], (*of_model)[1]};
    }
    if constexpr (requires { model.residual_sensitivity(x[0], x[1], x[2]); } && N == 3) {
      if (const auto of_model = model.residual_sensitivity(x[0], x[1], x[2]))
        return {(*of_model)[0], (*of_model)[1], (*of_model)[2]};
    }
    const auto duals = with_relative_duals(model);
    if constexpr (N == 1) {
      return ReducedVector<1>(sensitivity(duals.template evaluate<1>(x[0]).v_r));
    } else if constexpr (N == 2) {
      const auto w = duals.template evaluate<1>(planar_invariants(x[0], x[1]));
      return {sensitivity(x[0] * w.w_t + w.w_l), sensitivity(x[1] * w.w_t + w.w_l)};
    } else {
      const auto w = duals.template evaluate<1>(planar_invariants(x[0], x[1]), x[2]);
      return {sensitivity(x[0] * w.plane.w_t + w.plane.w_l),
              sensitivity(x[1] * w.plane.w_t + w.plane.w_l), sensitivity(w.w_r)};
    }
  }
}

}  // namespace stationary
