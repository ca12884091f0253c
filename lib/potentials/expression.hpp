// Potentials written by their user, as models with the interface of the built-in ones: W(t, l) of
// the plane, V(r) of the thickness, W(t, l, r) of both (derivatives.hpp), evaluated from a tape
// (expression/tape.hpp) in any number type.
//
// A model is a shared tape and its coefficients, the parameters' values: at most
// largest_parameter_count of them, in the order of parameters(). Nothing is allocated by an
// evaluation, nor by making the model with other coefficients.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lib/expression/expression.hpp"
#include "lib/expression/tape_run.hpp"
#include "lib/potentials/derivatives.hpp"
#include "lib/stretch.hpp"

namespace stationary {

/// At most largest_parameter_count numbers.
template <class C>
class CoefficientList {
 public:
  CoefficientList() = default;
  explicit CoefficientList(std::size_t size) : size_(size) {}
  std::size_t size() const { return size_; }
  const C& operator[](std::size_t k) const { return values_[k]; }
  C& operator[](std::size_t k) { return values_[k]; }
  const C* begin() const { return values_.data(); }
  const C* end() const { return values_.data() + size_; }
  const C* data() const { return values_.data(); }

 private:
  std::array<C, expression::largest_parameter_count> values_{};
  std::size_t size_ = 0;
};

/// Throws std::invalid_argument for more than there may be.
inline CoefficientList<double> coefficient_list(std::span<const double> values) {
  if (values.size() > expression::largest_parameter_count)
    throw std::invalid_argument("at most " + std::to_string(expression::largest_parameter_count) +
                                " parameters");
  CoefficientList<double> out(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) out[k] = values[k];
  return out;
}

/// The constants of a tape for coefficients of type C, in the number type of an evaluation. Those
/// of doubles are kept in extended precision: an evaluation in it then solves the same equation.
template <class C>
class TapeConstants {
 public:
  TapeConstants(const expression::Tape& tape, const CoefficientList<C>& coefficients) {
    expression::compute_constants<C>(tape.coefficients, coefficients.data(), values_.data());
  }

  /// f(constants in R).
  template <class R, class F>
  void in(const expression::Tape& tape, const CoefficientList<C>&, F&& f) const {
    if constexpr (std::is_same_v<R, C>) {
      f(values_.data());
    } else {
      std::array<R, expression::largest_constant_count> converted;
      for (std::size_t k = 0; k < tape.coefficients.constants.size(); ++k)
        converted[k] = R(values_[k]);
      f(converted.data());
    }
  }

 private:
  std::array<C, expression::largest_constant_count> values_;
};

/// Dual numbers, which are seldom wanted with more than one evaluation each.
template <class C>
concept CarriesSlopes = requires(const C& c) {
  c.value;
  c.slope;
};

template <CarriesSlopes C>
class TapeConstants<C> {
 public:
  TapeConstants(const expression::Tape&, const CoefficientList<C>&) {}

  template <class R, class F>
  void in(const expression::Tape& tape, const CoefficientList<C>& coefficients, F&& f) const {
    std::array<C, expression::largest_constant_count> values;
    expression::compute_constants<C>(tape.coefficients, coefficients.data(), values.data());
    if constexpr (std::is_same_v<R, C>) {
      f(values.data());
    } else {
      std::array<R, expression::largest_constant_count> converted;
      for (std::size_t k = 0; k < tape.coefficients.constants.size(); ++k)
        converted[k] = R(values[k]);
      f(converted.data());
    }
  }
};

template <>
class TapeConstants<double> {
 public:
  TapeConstants(const expression::Tape& tape, const CoefficientList<double>& coefficients) {
    std::array<DoubleDouble, expression::largest_parameter_count> parameters;
    std::ranges::copy(coefficients, parameters.begin());
    expression::compute_constants<DoubleDouble>(tape.coefficients, parameters.data(),
                                                extended_.data());
    for (std::size_t k = 0; k < tape.coefficients.constants.size(); ++k)
      rounded_[k] = double(extended_[k]);
  }

  template <class R, class F>
  void in(const expression::Tape& tape, const CoefficientList<double>& coefficients, F&& f) const {
    if constexpr (std::is_same_v<R, double>) {
      f(rounded_.data());
    } else if constexpr (std::is_same_v<R, DoubleDouble>) {
      f(extended_.data());
    } else {
      std::array<R, expression::largest_parameter_count> parameters;
      std::array<R, expression::largest_constant_count> constants;
      for (std::size_t k = 0; k < coefficients.size(); ++k) parameters[k] = R(coefficients[k]);
      expression::compute_constants<R>(tape.coefficients, parameters.data(), constants.data());
      f(constants.data());
    }
  }

 private:
  std::array<double, expression::largest_constant_count> rounded_;
  std::array<DoubleDouble, expression::largest_constant_count> extended_;
};

/// What the models below have in common.
template <class C>
class TapeModel {
 public:
  /// As many coefficients as the tape has parameters (std::invalid_argument otherwise).
  TapeModel(std::shared_ptr<const expression::Tape> tape, const CoefficientList<C>& coefficients)
      : tape_(std::move(tape)), coefficients_(coefficients), constants_(*tape_, coefficients) {
    if (coefficients.size() != tape_->parameters.size())
      throw std::invalid_argument("an expression of " + std::to_string(tape_->parameters.size()) +
                                  " parameters");
  }

  const CoefficientList<C>& coefficients() const { return coefficients_; }
  const std::string& text() const { return tape_->text; }
  const std::vector<std::string>& parameters() const { return tape_->parameters; }
  const std::shared_ptr<const expression::Tape>& tape() const { return tape_; }
  /// Then evaluate() has kernels (expression/kernel.hpp) to sum up, and the balance has not.
  bool has_principal_stretches() const { return tape_->has_principal_stretches; }

 protected:
  /// Results of a program on inputs: out(k) gives result k.
  template <class R, class Out, class... Inputs>
  void run(const expression::Program& program, Out&& out, const Inputs&... inputs) const {
    expression::Workspace<R, expression::largest_place_count> workspace;
    R* place = workspace.data();
    std::size_t k = 0;
    ((place[k++] = R(inputs)), ...);
    constants_.template in<R>(*tape_, coefficients_, [&](const R* constants) {
      expression::run<R>(program, tape_->coefficients.literals.data(), constants, place);
      out([&](std::size_t i) -> const R& {
        const expression::Result& result = program.results[i];
        return result.constant ? constants[result.at] : place[result.at];
      });
    });
  }

  /// The balance of xi, zeta and rho.
  template <class R, class S>
  LogBalance<R> coupled_balance(const S& xi, const S& zeta, const S& rho, const S& c_xi,
                                const S& c_zeta, const S& c_rho) const {
    LogBalance<R> out;
    run<R>(
        tape_->balance,
        [&](const auto& result) {
          out.g_xi = result(0);
          out.g_zeta = result(1);
          out.g_rho = result(2);
          out.uu = result(3);
          out.uv = result(4);
          out.uw = result(5);
          out.vv = result(6);
          out.vw = result(7);
          out.ww = result(8);
        },
        xi, zeta, rho, c_xi, c_zeta, c_rho);
    return out;
  }

  /// At a point of doubles, with dual coefficients over them.
  template <class... Inputs>
  static constexpr bool is_of_doubles = (std::is_same_v<Inputs, double> && ...) && requires(C c) {
    { c.value } -> std::same_as<double&>;
    c.slope;
  };

  /// A program of expression/slopes.hpp, of `count` numbers x and their slopes:
  /// out(k, x_k, slope) with slope(i) = dx_k/dp_i. False where the tape has not got it.
  template <class Out, class... Inputs>
  bool run_slopes(const expression::Program& program, const Out& out,
                  const Inputs&... inputs) const {
    if (program.results.empty()) return false;
    expression::Workspace<double, expression::largest_place_count> workspace;
    double* place = workspace.data();
    const double* constants = tape_->fixed_constants.data();
    std::size_t next = 0;
    ((place[next++] = inputs), ...);
    for (const C& c : coefficients_) place[next++] = leading(c);
    expression::run<double>(program, tape_->coefficients.literals.data(), constants, place);
    const auto result = [&](std::size_t i) {
      const expression::Result& at = program.results[i];
      return at.constant ? constants[at.at] : place[at.at];
    };
    const std::size_t count = program.results.size() / (1 + coefficients_.size());
    for (std::size_t k = 0; k < count; ++k)
      out(k, result(k), [&](std::size_t i) { return result((1 + i) * count + k); });
    return true;
  }

  /// Value and gradient as dual numbers, out(k, number k of them), of dual coefficients.
  template <class Out, class... Inputs>
  bool run_dual(const Out& out, const Inputs&... inputs) const {
    return run_slopes(
        tape_->slopes,
        [&](std::size_t k, double value, const auto& slope) {
          C number(value);
          for (std::size_t i = 0; i < coefficients_.size(); ++i)
            for (std::size_t direction = 0; direction < number.slope.size(); ++direction)
              number.slope[direction] += slope(i) * coefficients_[i].slope[direction];
          out(k, number);
        },
        inputs...);
  }

  /// Of each residual the sum over the parameters p of |p dg/dp|; the rates enter none.
  template <std::size_t n, class... Inputs>
  std::optional<std::array<double, n>> sensitivity(const Inputs&... inputs) const {
    std::array<double, n> out{};
    const bool known = run_slopes(
        tape_->residual_slopes,
        [&](std::size_t k, double, const auto& slope) {
          for (std::size_t i = 0; i < coefficients_.size(); ++i)
            out[k] += std::abs(coefficients_[i] * slope(i));
        },
        inputs...);
    if (!known) return {};
    return out;
  }

  const expression::Tape& programs() const { return *tape_; }

 private:
  std::shared_ptr<const expression::Tape> tape_;
  CoefficientList<C> coefficients_;
  TapeConstants<C> constants_;
};

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

  /// The circle xi = zeta nearest to 1 at which W has a minimum along the circles, within
  /// [1e-3, 1e3]; NaN where there is none.
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
    this->template run<R>(
        this->programs().evaluate[order],
        [&](const auto& result) {
          out.w = result(0);
          if constexpr (order >= 1) {
            out.w_t = result(1);
            out.w_l = result(2);
          }
          if constexpr (order >= 2) {
            out.w_tt = result(3);
            out.w_tl = result(4);
            out.w_ll = result(5);
          }
        },
        x.t, x.d, x.e);
    return out;
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
};

template <class C = double>
class ThicknessExpression : public TapeModel<C> {
 public:
  using TapeModel<C>::TapeModel;

  /// The rho nearest to 1 at which V has a minimum, within [1e-3, 1e3]; NaN where there is none.
  double rest_thickness() const requires std::is_same_v<C, double> {
    return rest_thickness_of(*this);
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
    this->template run<R>(
        this->programs().evaluate[order],
        [&](const auto& result) {
          out.v = result(0);
          if constexpr (order >= 1) out.v_r = result(1);
          if constexpr (order >= 2) out.v_rr = result(2);
        },
        rho);
    return out;
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
};

template <class C = double>
class CoupledExpression : public TapeModel<C> {
 public:
  using TapeModel<C>::TapeModel;

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
    this->template run<R>(
        this->programs().evaluate[order],
        [&](const auto& result) {
          out.plane.w = result(0);
          if constexpr (order >= 1) {
            out.plane.w_t = result(1);
            out.plane.w_l = result(2);
            out.w_r = result(3);
          }
          if constexpr (order >= 2) {
            out.plane.w_tt = result(4);
            out.plane.w_tl = result(5);
            out.w_tr = result(6);
            out.plane.w_ll = result(7);
            out.w_lr = result(8);
            out.w_rr = result(9);
          }
        },
        x.t, x.d, x.e, rho);
    return out;
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
};

/// The same model with convert(c, k) for its coefficient c number k.
template <template <class> class Model, class Convert>
requires std::derived_from<Model<double>, TapeModel<double>>
auto with_indexed_coefficients(const Model<double>& model, const Convert& convert) {
  using C = std::remove_cvref_t<decltype(convert(0.0, std::size_t(0)))>;
  CoefficientList<C> coefficients(model.coefficients().size());
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    coefficients[k] = convert(model.coefficients()[k], k);
  return Model<C>(model.tape(), coefficients);
}

}  // namespace stationary

/// The most there may be.
template <class C>
struct std::tuple_size<stationary::CoefficientList<C>>
    : std::integral_constant<std::size_t, stationary::expression::largest_parameter_count> {};
