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
#include <algorithm>
#include <array>
#include <cmath>

#include "lib/balance/balance.hpp"
#include "lib/material/potential.hpp"
#include "lib/matrix/small_symmetric.hpp"
#include "lib/number/elementary.hpp"
#include "solver/newton/asked_of_models.hpp"
#include "solver/newton/coefficient_sensitivity.hpp"
#include "solver/newton/input_directions.hpp"
#include "solver/newton/reduced_vector.hpp"

namespace stationary {

/// Residual, Jacobian and a magnitude of the terms that enter them (and, all being products of
/// powers and logarithms of x, of their further derivatives in ln x).
template <int N>
struct Linearized {
  ReducedVector<N> g;
  SmallSymmetric<N> jacobian;
  double magnitude;
};

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

/// A formula that takes the principal stretches apart (has_principal_stretches()) is linearized and
/// evaluated from xi and zeta (log_balance(), residual()). By the invariants t and d its
/// derivatives far from the circle are small differences, the second ones to (zeta/xi)^2 units.
///
/// Linearized::magnitude from the balance itself, of which a plane alone has no parts of rho.
inline double magnitude_of(const LogBalance<double>& b, double pull_xi, double pull_zeta,
                           double pull_rho, bool plane_only) {
  const auto of = [](double g, double second, double pull) {
    return std::abs(g + pull) + std::abs(second + 2.0 * pull) + 2.0 * pull;
  };
  const double plane =
      of(b.g_xi, b.uu, pull_xi) + of(b.g_zeta, b.vv, pull_zeta) + 2.0 * std::abs(b.uv);
  if (plane_only) return plane;
  return plane + of(b.g_rho, b.ww, pull_rho) + 2.0 * (std::abs(b.uw) + std::abs(b.vw));
}

/// Whether the model is such a formula, or its plane where that stands by itself.
template <class Model>
bool takes_stretches_apart(const Model& model) {
  if constexpr (requires { model.plane.has_principal_stretches(); }) {
    return model.plane.has_principal_stretches();
  } else if constexpr (requires { model.has_principal_stretches(); }) {
    return model.has_principal_stretches();
  } else {
    return false;
  }
}

/// The balance of all three stretches, of a coupled model or a Separable, with
/// Linearized::magnitude.
struct SizedBalance {
  LogBalance<double> balance;
  double magnitude;
};
template <class Model>
SizedBalance sized_balance(const Model& model, double xi, double zeta, double rho,
                           const CentrifugalRates<double>& c) {
  if constexpr (is_body_model<Model>) {
    const double thickness = model.thickness(xi, zeta, rho);
    const auto all = model.template whole<2>(xi, zeta, thickness, c.xi, c.zeta, c.rho);
    const double magnitude = magnitude_of(all, c.xi * xi * xi, c.zeta * zeta * zeta,
                                          c.rho * thickness * thickness, false);
    return {model.template held_of<2>(all, xi, zeta, rho),
            model.volume ? magnitude + model.stiffness : magnitude};
  } else if (takes_stretches_apart(model)) {
    const auto b = model.log_balance(xi, zeta, rho, c.xi, c.zeta, c.rho);
    return {b, magnitude_of(b, c.xi * xi * xi, c.zeta * zeta * zeta, c.rho * rho * rho, false)};
  }
  if constexpr (!is_body_model<Model>) {
    const auto w = forces<2>(model, planar_invariants(xi, zeta), rho);
    return {coupled_log_balance<2>(w, xi, zeta, rho, c), coupled_magnitude(w, xi, zeta, rho, c)};
  }
}
/// Its residuals in extended precision.
template <class Model>
LogBalance<DoubleDouble> extended_balance(const Model& model, double xi, double zeta,
                                          const DoubleDouble& rho,
                                          const CentrifugalRates<DoubleDouble>& c) {
  const DoubleDouble wide_xi(xi);
  const DoubleDouble wide_zeta(zeta);
  if constexpr (is_body_model<Model>) {
    return model.residual(wide_xi, wide_zeta, rho, c.xi, c.zeta, c.rho);
  } else if (takes_stretches_apart(model)) {
    if constexpr (requires { model.residual(wide_xi, wide_zeta, rho, c.xi, c.zeta, c.rho); }) {
      return model.residual(wide_xi, wide_zeta, rho, c.xi, c.zeta, c.rho);
    } else {
      return model.log_balance(wide_xi, wide_zeta, rho, c.xi, c.zeta, c.rho);
    }
  }
  if constexpr (!is_body_model<Model>) {
    const auto w = forces<1>(model, extended_invariants(xi, zeta), rho);
    return coupled_log_balance<1>(w, wide_xi, wide_zeta, rho, c);
  }
}

template <class Thickness>
struct ThicknessSystem {
  static constexpr int dimension = 1;
  Thickness model;
  DoubleDouble rate;  ///< m = J3 (nu1^2 + nu2^2)

  Linearized<1> linearize(const ReducedVector<1>& x) const {
    const auto v = forces<2>(model, x[0]);
    const double pull = double(rate) * x[0] * x[0];
    return {ReducedVector<1>(v.v_r - pull), {{v.v_rr - 2.0 * pull}}, std::abs(v.v_rr) + 2.0 * pull};
  }
  ReducedVector<1> extended_residual(const ReducedVector<1>& x) const {
    const auto v = forces<1>(model, DoubleDouble(x[0]));
    return ReducedVector<1>(double(v.v_r - rate * two_product(x[0], x[0])));
  }
  /// Sum over the inputs p of |p dG/dp|: a coefficient once, and the decimals of a formula, J once,
  /// nu twice (as nu^2).
  ReducedVector<1> input_sensitivity(const ReducedVector<1>& x) const {
    const auto elastic = coefficient_sensitivity<1>(model, x);
    return ReducedVector<1>(elastic[0] + 3.0 * double(rate) * x[0] * x[0]) +
           decimal_sensitivity<1>(model, x);
  }
};

template <class Plane>
struct PlanarSystem {
  static constexpr int dimension = 2;
  using ModelType = Plane;
  Plane model;
  CentrifugalRates<DoubleDouble> rates;

  Linearized<2> linearize(const ReducedVector<2>& x) const {
    if constexpr (requires { model.has_principal_stretches(); }) {
      if (model.has_principal_stretches()) {
        const double c_xi = double(rates.xi);
        const double c_zeta = double(rates.zeta);
        const auto b = model.log_balance(x[0], x[1], c_xi, c_zeta);
        return {{b.g_xi, b.g_zeta},
                {{b.uu, b.uv, b.vv}},
                magnitude_of(b, c_xi * x[0] * x[0], c_zeta * x[1] * x[1], 0.0, true)};
      }
    }
    const auto w = forces<2>(model, planar_invariants(x[0], x[1]));
    const CentrifugalRates<double> c{double(rates.xi), double(rates.zeta), 0.0};
    const auto b = planar_log_balance<2>(w, x[0], x[1], c);
    return {{b.g_xi, b.g_zeta}, {{b.uu, b.uv, b.vv}}, planar_magnitude(w, x[0], x[1], c)};
  }
  LogBalance<DoubleDouble> extended_balance(const ReducedVector<2>& x) const {
    if constexpr (requires { model.has_principal_stretches(); }) {
      if (model.has_principal_stretches())
        return model.residual(DoubleDouble(x[0]), DoubleDouble(x[1]), rates.xi, rates.zeta);
    }
    const auto w = forces<1>(model, extended_invariants(x[0], x[1]));
    return planar_log_balance<1>(w, DoubleDouble(x[0]), DoubleDouble(x[1]), rates);
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x) const {
    const auto b = extended_balance(x);
    return {double(b.g_xi), double(b.g_zeta)};
  }
  ReducedVector<2> input_sensitivity(const ReducedVector<2>& x) const {
    const ReducedVector<2> pull(double(rates.xi) * x[0] * x[0], double(rates.zeta) * x[1] * x[1]);
    return coefficient_sensitivity<2>(model, x) + 3.0 * pull + decimal_sensitivity<2>(model, x);
  }
  /// each(p dG/dp) for the same inputs p.
  template <class Each>
  void for_each_input(const ReducedVector<2>& x, const Each& each) const {
    for_each_coefficient<2>(model, x, each);
    for_each_decimal<2>(model, x, each);
    for_each_spin_input<2>(
        ReducedVector<2>(double(rates.xi) * x[0] * x[0], double(rates.zeta) * x[1] * x[1]), each);
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

  Linearized<3> linearize(const ReducedVector<3>& x) const {
    const CentrifugalRates<double> c{double(rates.xi), double(rates.zeta), double(rates.rho)};
    const auto [b, magnitude] = sized_balance(model, x[0], x[1], x[2], c);
    return {{b.g_xi, b.g_zeta, b.g_rho}, {{b.uu, b.uv, b.uw, b.vv, b.vw, b.ww}}, magnitude};
  }
  LogBalance<DoubleDouble> extended_balance(const ReducedVector<3>& x) const {
    return stationary::extended_balance(model, x[0], x[1], DoubleDouble(x[2]), rates);
  }
  ReducedVector<3> extended_residual(const ReducedVector<3>& x) const {
    const auto b = extended_balance(x);
    return {double(b.g_xi), double(b.g_zeta), double(b.g_rho)};
  }
  ReducedVector<3> input_sensitivity(const ReducedVector<3>& x) const {
    ReducedVector<3> pull(double(rates.xi) * x[0] * x[0], double(rates.zeta) * x[1] * x[1],
                          double(rates.rho) * x[2] * x[2]);
    if constexpr (is_body_model<Coupled>) {
      // Along a held volume rho and its pull change with C as well.
      if (model.volume) pull = {pull[0] + 2.0 * pull[2], pull[1] + 2.0 * pull[2], 0.0};
    }
    return coefficient_sensitivity<3>(model, x) + 3.0 * pull + decimal_sensitivity<3>(model, x);
  }
  template <class Each>
  void for_each_input(const ReducedVector<3>& x, const Each& each) const {
    const ReducedVector<3> pull(double(rates.xi) * x[0] * x[0], double(rates.zeta) * x[1] * x[1],
                                double(rates.rho) * x[2] * x[2]);
    for_each_coefficient<3>(model, x, each);
    for_each_decimal<3>(model, x, each);
    if (!holds_volume(model)) {
      for_each_spin_input<3>(pull, each);
      return;
    }
    // Along a held volume rho and its pull change with the volume as well.
    for_each_spin_input<3>(pull, [&](const ReducedVector<3>& g) {
      each(ReducedVector<3>(g[0] - g[2], g[1] - g[2], 0.0));
    });
    each(ReducedVector<3>(2.0 * pull[2], 2.0 * pull[2], 0.0));
  }
  CoupledSystem at_fraction(double tau) const {
    return {model, {rates.xi * tau, rates.zeta * tau, rates.rho * tau}};
  }
  ReducedVector<3> minus_pull(const ReducedVector<3>& x) const {
    const auto pull = centrifugal_pull(
        model, {double(rates.xi), double(rates.zeta), double(rates.rho)}, x[0], x[1], x[2]);
    return {-pull[0], -pull[1], -pull[2]};
  }
};

/// The conditions under which the potential of a system is defined, at x.
template <class System>
std::vector<ConditionValue> system_conditions(const System& system,
                                              const ReducedVector<System::dimension>& x) {
  if constexpr (System::dimension == 3) {
    return model_conditions(system.model, {0.0, x[0], x[1], x[2]});
  } else {
    return model_conditions(system.model, {0.0, x[0], x[1], 1.0});
  }
}

/// Whether these hold between two points too, in the logarithms.
template <class System>
bool stays_inside(const System& system, const ReducedVector<System::dimension>& from,
                  const ReducedVector<System::dimension>& to) {
  if constexpr (!requires { system.model.conditions_at(Stretch()); }) return true;
  if (system_conditions(system, to).empty()) return true;
  for (const double u : {0.25, 0.5, 0.75}) {
    ReducedVector<System::dimension> x;
    for (int i = 0; i < System::dimension; ++i) x[i] = from[i] * pow(to[i] / from[i], u);
    if (!std::ranges::all_of(system_conditions(system, x), &ConditionValue::holds)) return false;
  }
  return true;
}

}  // namespace stationary
