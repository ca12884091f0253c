// The reduced balance of a family as a small square system in logarithmic coordinates,
//
//   G(x; nu^2) = elastic(x) - pull(x),   pull_i = c_i x_i^2,   unknowns ln x,
//
// symmetric Jacobian dG/d ln x. Three systems, by what a Problem leaves coupled:
//   ThicknessSystem  x = (rho)             V_rho' = m rho, of a separable V
//   PlanarSystem     x = (xi, zeta)        of a separable V
//   CoupledSystem    x = (xi, zeta, rho)   of a coupled V
// All formulas are lib's (balance.hpp); these only gather them for the solvers, in double, in
// extended precision and for ceres::Jet. x > 0 throughout; not checked here.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "lib/balance.hpp"
#include "lib/conditioned_functions.hpp"
#include "lib/model_coefficients.hpp"
#include "lib/potential.hpp"
#include "solver/dual.hpp"
#include "solver/small_symmetric.hpp"

namespace stationary {

template <int N>
using ReducedVector = Eigen::Matrix<double, N, 1>;

/// Residual, Jacobian and a magnitude of the terms that enter them (and, all being products of
/// powers and logarithms of x, of their further derivatives in ln x).
template <int N>
struct Linearized {
  ReducedVector<N> g;
  SmallSymmetric<N> jacobian;
  double magnitude;
};

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

/// The same directions in either part.
template <class Plane, class Thickness>
auto with_relative_duals(const Separable<Plane, Thickness>& model) {
  const auto plane = with_relative_duals(model.plane);
  const auto thickness = with_relative_duals(model.thickness);
  return Separable<std::remove_cv_t<decltype(plane)>, std::remove_cv_t<decltype(thickness)>>{
      plane, thickness};
}

template <std::size_t N>
double sensitivity(const Dual<double, N>& x) {
  double out = 0.0;
  for (const double slope : x.slope) out += std::abs(slope);
  return out;
}

/// at(the model with exact coefficients) where it has decimals in its formula: what depends on
/// these is then as conditioned as they are uncertain. Their part of input_sensitivity().
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

/// Likewise of the gradient of V in (ln xi, ln zeta[, ln rho]).
template <int N, class Model>
ReducedVector<N> decimal_sensitivity(const Model& model, const ReducedVector<N>& x) {
  ReducedVector<N> out = ReducedVector<N>::Zero();
  for_decimals(model, [&](const auto& conditioned) {
    if constexpr (N == 1) {
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

/// Linearized::magnitude of the planar equations. w_l is left out: at a solution it is the
/// difference of terms that are in, and without it a Jacobian needs no logarithm.
inline double planar_magnitude(const PlanarDerivatives<double>& w, double xi, double zeta,
                               const CentrifugalRates<double>& c) {
  const double t = xi + zeta;
  return t * (std::abs(w.w_t) + t * std::abs(w.w_tt) + 2.0 * std::abs(w.w_tl)) + std::abs(w.w_ll) +
         2.0 * (c.xi * xi * xi + c.zeta * zeta * zeta);
}

/// Of all three.
inline double coupled_magnitude(const CoupledDerivatives<double>& w, double xi, double zeta,
                                double rho, const CentrifugalRates<double>& c) {
  return planar_magnitude(w.plane, xi, zeta, c) + std::abs(w.w_r) + std::abs(w.w_rr) +
         (xi + zeta) * std::abs(w.w_tr) + std::abs(w.w_lr) + 2.0 * c.rho * rho * rho;
}

template <class Thickness>
struct ThicknessSystem {
  static constexpr int dimension = 1;
  Thickness model;
  DoubleDouble rate;  ///< m = J3 (nu1^2 + nu2^2)

  Linearized<1> linearize(const ReducedVector<1>& x) const {
    const auto v = model.template evaluate<2>(x[0]);
    const double pull = double(rate) * x[0] * x[0];
    return {ReducedVector<1>(v.v_r - pull), {{v.v_rr - 2.0 * pull}}, std::abs(v.v_rr) + 2.0 * pull};
  }
  ReducedVector<1> extended_residual(const ReducedVector<1>& x) const {
    const auto v = model.template evaluate<1>(DoubleDouble(x[0]));
    return ReducedVector<1>(double(v.v_r - rate * two_product(x[0], x[0])));
  }
  /// Sum over the inputs p of |p dG/dp|: a coefficient once, and the decimals of a formula, J once,
  /// nu twice (as nu^2).
  ReducedVector<1> input_sensitivity(const ReducedVector<1>& x) const {
    const auto v = with_relative_duals(model).template evaluate<1>(x[0]);
    return ReducedVector<1>(sensitivity(v.v_r) + 3.0 * double(rate) * x[0] * x[0]) +
           decimal_sensitivity<1>(model, x);
  }
};

template <class Plane>
struct PlanarSystem {
  static constexpr int dimension = 2;
  using ModelType = Plane;
  Plane model;
  CentrifugalRates<DoubleDouble> rates;

  template <class S>
  std::array<S, 2> residual(const std::array<S, 2>& x) const {
    const auto w = model.template evaluate<1>(planar_invariants(x[0], x[1]));
    const CentrifugalRates<S> c{S(double(rates.xi)), S(double(rates.zeta)), S(0.0)};
    const auto b = planar_log_balance<1>(w, x[0], x[1], c);
    return {b.g_xi, b.g_zeta};
  }
  Linearized<2> linearize(const ReducedVector<2>& x) const {
    const auto w = model.template evaluate<2>(planar_invariants(x[0], x[1]));
    const CentrifugalRates<double> c{double(rates.xi), double(rates.zeta), 0.0};
    const auto b = planar_log_balance<2>(w, x[0], x[1], c);
    return {{b.g_xi, b.g_zeta}, {{b.uu, b.uv, b.vv}}, planar_magnitude(w, x[0], x[1], c)};
  }
  LogBalance<DoubleDouble> extended_balance(const ReducedVector<2>& x) const {
    if constexpr (requires { model.has_principal_stretches(); }) {
      if (model.has_principal_stretches())
        return model.residual(DoubleDouble(x[0]), DoubleDouble(x[1]), rates.xi, rates.zeta);
    }
    const auto w = model.template evaluate<1>(extended_invariants(x[0], x[1]));
    return planar_log_balance<1>(w, DoubleDouble(x[0]), DoubleDouble(x[1]), rates);
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x) const {
    const auto b = extended_balance(x);
    return {double(b.g_xi), double(b.g_zeta)};
  }
  ReducedVector<2> input_sensitivity(const ReducedVector<2>& x) const {
    return coefficient_sensitivity(x) + decimal_sensitivity<2>(model, x);
  }
  ReducedVector<2> coefficient_sensitivity(const ReducedVector<2>& x) const {
    if constexpr (requires { model.has_principal_stretches(); }) {
      if (model.has_principal_stretches()) {
        if (const auto of_model = model.residual_sensitivity(x[0], x[1]))
          return {(*of_model)[0] + 3.0 * double(rates.xi) * x[0] * x[0],
                  (*of_model)[1] + 3.0 * double(rates.zeta) * x[1] * x[1]};
      }
    }
    const auto w = with_relative_duals(model).template evaluate<1>(planar_invariants(x[0], x[1]));
    return {sensitivity(x[0] * w.w_t + w.w_l) + 3.0 * double(rates.xi) * x[0] * x[0],
            sensitivity(x[1] * w.w_t + w.w_l) + 3.0 * double(rates.zeta) * x[1] * x[1]};
  }
  /// The system at a fraction tau of nu^2.
  PlanarSystem at_fraction(double tau) const {
    return {model, {rates.xi * tau, rates.zeta * tau, rates.rho * tau}};
  }
  /// dG/dtau of at_fraction: minus the centrifugal pull at tau = 1.
  ReducedVector<2> minus_pull(const ReducedVector<2>& x) const {
    return {-double(rates.xi) * x[0] * x[0], -double(rates.zeta) * x[1] * x[1]};
  }
};

template <class Coupled>
struct CoupledSystem {
  static constexpr int dimension = 3;
  using ModelType = Coupled;
  Coupled model;
  CentrifugalRates<DoubleDouble> rates;

  template <class S>
  std::array<S, 3> residual(const std::array<S, 3>& x) const {
    const auto w = model.template evaluate<1>(planar_invariants(x[0], x[1]), x[2]);
    const CentrifugalRates<S> c{S(double(rates.xi)), S(double(rates.zeta)), S(double(rates.rho))};
    const auto b = coupled_log_balance<1>(w, x[0], x[1], x[2], c);
    return {b.g_xi, b.g_zeta, b.g_rho};
  }
  Linearized<3> linearize(const ReducedVector<3>& x) const {
    const auto w = model.template evaluate<2>(planar_invariants(x[0], x[1]), x[2]);
    const CentrifugalRates<double> c{double(rates.xi), double(rates.zeta), double(rates.rho)};
    const auto b = coupled_log_balance<2>(w, x[0], x[1], x[2], c);
    return {{b.g_xi, b.g_zeta, b.g_rho},
            {{b.uu, b.uv, b.uw, b.vv, b.vw, b.ww}},
            coupled_magnitude(w, x[0], x[1], x[2], c)};
  }
  LogBalance<DoubleDouble> extended_balance(const ReducedVector<3>& x) const {
    const DoubleDouble rho(x[2]);
    if constexpr (requires { model.has_principal_stretches(); }) {
      if (model.has_principal_stretches())
        return model.residual(DoubleDouble(x[0]), DoubleDouble(x[1]), rho, rates.xi, rates.zeta,
                              rates.rho);
    }
    const auto w = model.template evaluate<1>(extended_invariants(x[0], x[1]), rho);
    return coupled_log_balance<1>(w, DoubleDouble(x[0]), DoubleDouble(x[1]), rho, rates);
  }
  ReducedVector<3> extended_residual(const ReducedVector<3>& x) const {
    const auto b = extended_balance(x);
    return {double(b.g_xi), double(b.g_zeta), double(b.g_rho)};
  }
  ReducedVector<3> input_sensitivity(const ReducedVector<3>& x) const {
    return coefficient_sensitivity(x) + decimal_sensitivity<3>(model, x);
  }
  ReducedVector<3> coefficient_sensitivity(const ReducedVector<3>& x) const {
    if constexpr (requires { model.has_principal_stretches(); }) {
      if (model.has_principal_stretches()) {
        if (const auto of_model = model.residual_sensitivity(x[0], x[1], x[2]))
          return {(*of_model)[0] + 3.0 * double(rates.xi) * x[0] * x[0],
                  (*of_model)[1] + 3.0 * double(rates.zeta) * x[1] * x[1],
                  (*of_model)[2] + 3.0 * double(rates.rho) * x[2] * x[2]};
      }
    }
    const auto w =
        with_relative_duals(model).template evaluate<1>(planar_invariants(x[0], x[1]), x[2]);
    return {sensitivity(x[0] * w.plane.w_t + w.plane.w_l) + 3.0 * double(rates.xi) * x[0] * x[0],
            sensitivity(x[1] * w.plane.w_t + w.plane.w_l) + 3.0 * double(rates.zeta) * x[1] * x[1],
            sensitivity(w.w_r) + 3.0 * double(rates.rho) * x[2] * x[2]};
  }
  CoupledSystem at_fraction(double tau) const {
    return {model, {rates.xi * tau, rates.zeta * tau, rates.rho * tau}};
  }
  ReducedVector<3> minus_pull(const ReducedVector<3>& x) const {
    return {-double(rates.xi) * x[0] * x[0], -double(rates.zeta) * x[1] * x[1],
            -double(rates.rho) * x[2] * x[2]};
  }
};

}  // namespace stationary
