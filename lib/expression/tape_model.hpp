// A tape and its coefficients: what the models of potentials written by their user
// (potentials/expression.hpp) have in common.
//
// A model is a shared tape and its coefficients, the parameters' values: at most
// largest_parameter_count of them, in the order of parameters(). Nothing is allocated by an
// evaluation, nor by making the model with other coefficients.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lib/expression/expression.hpp"
#include "lib/expression/tape_run.hpp"
#include "lib/log_balance.hpp"

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
  /// Numbers in the formula ("0.1") are inputs then, as uncertain as its parameters.
  bool has_decimals() const { return tape_->coefficients.has_decimals; }

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

}  // namespace stationary

/// The most there may be.
template <class C>
struct std::tuple_size<stationary::CoefficientList<C>>
    : std::integral_constant<std::size_t, stationary::expression::largest_parameter_count> {};
