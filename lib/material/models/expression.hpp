// Potentials written by their user, as models with the interface of the built-in ones: W(t, l) of
// the plane, V(r) of the thickness, W(t, l, r) of both (model_derivatives.hpp), evaluated from a
// tape (material/models/tape_model.hpp) in any number type.
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "lib/body/stretch.hpp"
#include "lib/material/models/model_derivatives.hpp"
#include "lib/material/models/tape_model.hpp"

namespace stationary {

template <class C>
class PlanarExpression;
template <class C>
class ThicknessExpression;
template <class C>
class CoupledExpression;

double rest_stretch_of(const PlanarExpression<double>& model);
double rest_thickness_of(const ThicknessExpression<double>& model);
double balanced_thickness_of(const ThicknessExpression<double>& model, const DoubleDouble& m);
std::array<double, 2> rest_of(const CoupledExpression<double>& model);

template <class C = double>
class PlanarExpression : public TapeModel<C> {
 public:
  using TapeModel<C>::TapeModel;

  std::vector<ConditionValue> conditions_at(
      const Stretch& q) const requires std::is_same_v<C, double> {
    const auto x = planar_invariants(q);
    return this->conditions(x.t, x.d, x.e);
  }
  /// Restricted to the part of its domain that q lies in.
  PlanarExpression on_part_of(const Stretch& q) const requires std::is_same_v<C, double> {
    const auto x = planar_invariants(q);
    return {this->tape(), this->coefficients(), this->part_of(x.t, x.d, x.e)};
  }
  /// Whether it is defined nowhere in a box.
  bool outside_in(const Interval& xi,
                  const Interval& zeta) const requires std::is_same_v<C, Interval> {
    return this->outside(this->programs().balance, xi, zeta, Interval(0.0), Interval(0.0));
  }

  /// The circle xi = zeta nearest to 1 at which W has a minimum along the circles, within
  /// about [1e-3, 1e3]; NaN where there is none.
  double rest_stretch() const requires std::is_same_v<C, double> { return rest_stretch_of(*this); }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    using R = Product<C, S>;
    PlanarDerivatives<R> out;
    if constexpr (order == 1 && TapeModel<C>::template is_of_doubles<S>) {
      const std::array<R*, 3> places{&out.w, &out.w_t, &out.w_l};
      if (this->run_dual([&](std::size_t k, const R& x) { *places[k] = x; }, x.t, x.d, x.e))
        return out;
    }
    return derivatives_by<order, true>(this->programs().evaluate[order], x);
  }
  template <int order, class S>
  PlanarDerivatives<Product<C, S>> forces(const PlanarInvariants<S>& x) const {
    return derivatives_by<order, false>(this->programs().forces[order - 1], x);
  }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& c_xi,
                                        const S& c_zeta) const {
    using R = Product<C, S>;
    LogBalance<R> out;
    this->template run<R>(
        this->programs().balance,
        [&](const auto& result) {
          out.g_xi = result(0);
          out.g_zeta = result(1);
          out.uu = result(2);
          out.uv = result(3);
          out.vv = result(4);
        },
        xi, zeta, c_xi, c_zeta);
    return out;
  }

  /// Sum over the parameters p of |p dg/dp|, g = (g_xi, g_zeta) of log_balance(); none where a
  /// parameter enters by abs, min or max.
  std::optional<std::array<double, 2>> residual_sensitivity(
      double xi, double zeta) const requires std::is_same_v<C, double> {
    return this->template sensitivity<2>(xi, zeta, 0.0, 0.0);
  }

  /// g_xi and g_zeta of log_balance() alone.
  template <class S>
  LogBalance<Product<C, S>> residual(const S& xi, const S& zeta, const S& c_xi,
                                     const S& c_zeta) const {
    using R = Product<C, S>;
    LogBalance<R> out;
    this->template run<R>(
        this->programs().residual,
        [&](const auto& result) {
          out.g_xi = result(0);
          out.g_zeta = result(1);
        },
        xi, zeta, c_xi, c_zeta);
    return out;
  }

 private:
  /// valued: whether the program's first result is the value.
  template <int order, bool valued, class S>
  PlanarDerivatives<Product<C, S>> derivatives_by(const expression::Program& program,
                                                  const PlanarInvariants<S>& x) const {
    using R = Product<C, S>;
    PlanarDerivatives<R> out;
    this->template run<R>(
        program,
        [&](const auto& result) {
          constexpr std::size_t first = valued ? 1 : 0;
          if constexpr (valued) out.w = result(0);
          if constexpr (order >= 1) {
            out.w_t = result(first);
            out.w_l = result(first + 1);
          }
          if constexpr (order >= 2) {
            out.w_tt = result(first + 2);
            out.w_tl = result(first + 3);
            out.w_ll = result(first + 4);
          }
        },
        x.t, x.d, x.e);
    return out;
  }
};

template <class C = double>
class ThicknessExpression : public TapeModel<C> {
 public:
  using TapeModel<C>::TapeModel;

  std::vector<ConditionValue> conditions_at(
      const Stretch& q) const requires std::is_same_v<C, double> {
    return this->conditions(q.rho);
  }
  /// As of PlanarExpression.
  ThicknessExpression on_part_of(const Stretch& q) const requires std::is_same_v<C, double> {
    return {this->tape(), this->coefficients(), this->part_of(q.rho)};
  }
  bool outside_box(const BasicStretch<Interval>& q) const requires std::is_same_v<C, Interval> {
    return outside_in(q.rho);
  }
  bool outside_in(const Interval& rho) const requires std::is_same_v<C, Interval> {
    return this->outside(this->programs().balance, rho, Interval(0.0));
  }

  /// The rho nearest to 1 at which V has a minimum, within about [1e-3, 1e3]; NaN where there
  /// is none.
  double rest_thickness() const requires std::is_same_v<C, double> {
    return rest_thickness_of(*this);
  }

  /// Sum over the parameters p of |p dV_r/dp|; none where a parameter enters by abs, min or max.
  std::optional<double> residual_sensitivity(double rho) const requires std::is_same_v<C, double> {
    const auto force = this->template sensitivity<1>(rho, 0.0);
    return force ? std::optional((*force)[0]) : std::nullopt;
  }

  /// The solution of V' = m rho, m >= 0, that is connected to the rest thickness by solutions for
  /// smaller m, to double precision; NaN where there is none or no rest thickness.
  double balanced(const DoubleDouble& m) const requires std::is_same_v<C, double> {
    return balanced_thickness_of(*this, m);
  }

  template <int order, class S>
  ThicknessDerivatives<Product<C, S>> evaluate(const S& rho) const {
    using R = Product<C, S>;
    ThicknessDerivatives<R> out;
    if constexpr (order == 1 && TapeModel<C>::template is_of_doubles<S>) {
      const std::array<R*, 2> places{&out.v, &out.v_r};
      if (this->run_dual([&](std::size_t k, const R& x) { *places[k] = x; }, rho)) return out;
    }
    return derivatives_by<order, true>(this->programs().evaluate[order], rho);
  }
  template <int order, class S>
  ThicknessDerivatives<Product<C, S>> forces(const S& rho) const {
    return derivatives_by<order, false>(this->programs().forces[order - 1], rho);
  }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& rho, const S& m) const {
    using R = Product<C, S>;
    LogBalance<R> out;
    this->template run<R>(
        this->programs().balance,
        [&](const auto& result) {
          out.g_rho = result(0);
          out.ww = result(1);
        },
        rho, m);
    return out;
  }

 private:
  /// As of PlanarExpression.
  template <int order, bool valued, class S>
  ThicknessDerivatives<Product<C, S>> derivatives_by(const expression::Program& program,
                                                     const S& rho) const {
    using R = Product<C, S>;
    ThicknessDerivatives<R> out;
    this->template run<R>(
        program,
        [&](const auto& result) {
          constexpr std::size_t first = valued ? 1 : 0;
          if constexpr (valued) out.v = result(0);
          if constexpr (order >= 1) out.v_r = result(first);
          if constexpr (order >= 2) out.v_rr = result(first + 1);
        },
        rho);
    return out;
  }
};

template <class C = double>
class CoupledExpression : public TapeModel<C> {
 public:
  using TapeModel<C>::TapeModel;

  std::vector<ConditionValue> conditions_at(
      const Stretch& q) const requires std::is_same_v<C, double> {
    const auto x = planar_invariants(q);
    return this->conditions(x.t, x.d, x.e, q.rho);
  }
  /// As of PlanarExpression.
  CoupledExpression on_part_of(const Stretch& q) const requires std::is_same_v<C, double> {
    const auto x = planar_invariants(q);
    return {this->tape(), this->coefficients(), this->part_of(x.t, x.d, x.e, q.rho)};
  }
  bool outside_in(const Interval& xi, const Interval& zeta,
                  const Interval& rho) const requires std::is_same_v<C, Interval> {
    const Interval none(0.0);
    return this->outside(this->programs().balance, xi, zeta, rho, none, none, none);
  }

  /// xi = zeta and rho at the minimum of V among (xi, xi, rho) nearest to (1, 1, 1), within
  /// [1e-3, 1e3]; NaN where none was found.
  double rest_stretch() const requires std::is_same_v<C, double> { return rest()[0]; }
  double rest_thickness() const requires std::is_same_v<C, double> { return rest()[1]; }
  std::array<double, 2> rest() const requires std::is_same_v<C, double> { return rest_of(*this); }

  template <int order, class S>
  CoupledDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x, const S& rho) const {
    using R = Product<C, S>;
    CoupledDerivatives<R> out;
    if constexpr (order == 1 && TapeModel<C>::template is_of_doubles<S>) {
      const std::array<R*, 4> places{&out.plane.w, &out.plane.w_t, &out.plane.w_l, &out.w_r};
      if (this->run_dual([&](std::size_t k, const R& x) { *places[k] = x; }, x.t, x.d, x.e, rho))
        return out;
    }
    return derivatives_by<order, true>(this->programs().evaluate[order], x, rho);
  }
  template <int order, class S>
  CoupledDerivatives<Product<C, S>> forces(const PlanarInvariants<S>& x, const S& rho) const {
    return derivatives_by<order, false>(this->programs().forces[order - 1], x, rho);
  }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& xi, const S& zeta, const S& rho, const S& c_xi,
                                        const S& c_zeta, const S& c_rho) const {
    return this->template coupled_balance<Product<C, S>>(xi, zeta, rho, c_xi, c_zeta, c_rho);
  }

  /// As of PlanarExpression, g = (g_xi, g_zeta, g_rho).
  std::optional<std::array<double, 3>> residual_sensitivity(
      double xi, double zeta, double rho) const requires std::is_same_v<C, double> {
    return this->template sensitivity<3>(xi, zeta, rho, 0.0, 0.0, 0.0);
  }

  /// g_xi, g_zeta and g_rho of log_balance() alone.
  template <class S>
  LogBalance<Product<C, S>> residual(const S& xi, const S& zeta, const S& rho, const S& c_xi,
                                     const S& c_zeta, const S& c_rho) const {
    using R = Product<C, S>;
    LogBalance<R> out;
    this->template run<R>(
        this->programs().residual,
        [&](const auto& result) {
          out.g_xi = result(0);
          out.g_zeta = result(1);
          out.g_rho = result(2);
        },
        xi, zeta, rho, c_xi, c_zeta, c_rho);
    return out;
  }

 private:
  /// As of PlanarExpression.
  template <int order, bool valued, class S>
  CoupledDerivatives<Product<C, S>> derivatives_by(const expression::Program& program,
                                                   const PlanarInvariants<S>& x,
                                                   const S& rho) const {
    using R = Product<C, S>;
    CoupledDerivatives<R> out;
    this->template run<R>(
        program,
        [&](const auto& result) {
          constexpr std::size_t first = valued ? 1 : 0;
          if constexpr (valued) out.plane.w = result(0);
          if constexpr (order >= 1) {
            out.plane.w_t = result(first);
            out.plane.w_l = result(first + 1);
            out.w_r = result(first + 2);
          }
          if constexpr (order >= 2) {
            out.plane.w_tt = result(first + 3);
            out.plane.w_tl = result(first + 4);
            out.w_tr = result(first + 5);
            out.plane.w_ll = result(first + 6);
            out.w_lr = result(first + 7);
            out.w_rr = result(first + 8);
          }
        },
        x.t, x.d, x.e, rho);
    return out;
  }
};

/// The same model with convert(c, k) for its coefficient c number k.
template <template <class> class Model, class Convert>
requires std::derived_from<Model<double>, TapeModel<double>>
auto with_indexed_coefficients(const Model<double>& model, const Convert& convert) {
  using C = std::remove_cvref_t<decltype(convert(0.0, std::size_t(0)))>;
  CoefficientList<C> coefficients(model.coefficients().size());
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    coefficients[k] = convert(model.coefficients()[k], k);
  return Model<C>(model.tape(), coefficients, model.part());
}

}  // namespace stationary
