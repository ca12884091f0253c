// A tape and its coefficients: what the models of potentials written by their user
// (material/models/expression.hpp) have in common.
//
// A model is a shared tape and its coefficients, the parameters' values: at most
// largest_parameter_count of them, in the order of parameters(). Nothing is allocated by an
// evaluation, nor by making the model with other coefficients.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lib/body/stretch.hpp"
#include "lib/formula/expression.hpp"
#include "lib/material/models/log_balance.hpp"
#include "lib/tape/tape_run.hpp"

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

  const C* values() const { return values_.data(); }

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

  const double* values() const { return rounded_.data(); }

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

/// The sign of what is certain to have one: of a number its own, of an interval that of all of it.
template <class R>
int certain_sign(const R& x) {
  if constexpr (expression::over_intervals<R>() && !std::is_same_v<R, Interval>) {
    return certain_sign(x.value);
  } else if constexpr (std::is_same_v<R, Interval>) {
    return x.positive() ? 1 : x.negative() ? -1 : 0;
  } else {
    const double value = leading(x);
    return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
  }
}

/// A part of the domain of a formula: the signs of what must not be 0 in it. Bit k is for condition
/// k of the tape.
struct DomainPart {
  std::uint32_t chosen = 0;    ///< which signs are asked for
  std::uint32_t negative = 0;  ///< and which of these are minus

  template <class R>
  bool has(const expression::TapeCondition& condition, std::size_t k, const R& value) const {
    const int sign = certain_sign(value);
    if (condition.positive) return sign > 0;
    const std::uint32_t bit = std::uint32_t{1} << k;
    return sign != 0 && ((chosen & bit) == 0 || ((negative & bit) != 0) == (sign < 0));
  }
};

/// The value of a condition of a formula at a point; it holds where that is positive, or not 0.
struct ConditionValue {
  const expression::TapeCondition* condition;
  double value;

  bool holds() const { return condition->positive ? value > 0.0 : value != 0.0; }
};

/// Of a model that may be an expression, or of a sum of two; none of a built-in one.
template <class Model>
std::vector<ConditionValue> model_conditions(const Model& model, const Stretch& q) {
  if constexpr (requires { model.conditions_at(q); }) {
    return model.conditions_at(q);
  } else if constexpr (requires { model.plane; }) {
    std::vector<ConditionValue> out = model_conditions(model.plane, q);
    const std::vector<ConditionValue> axial = model_conditions(model.thickness, q);
    out.insert(out.end(), axial.begin(), axial.end());
    return out;
  } else {
    return {};
  }
}

/// The model restricted to the part of its domain that q lies in.
template <class Model>
Model on_part_of(const Model& model, const Stretch& q) {
  if constexpr (requires { model.on_part_of(q); }) {
    return model.on_part_of(q);
  } else if constexpr (requires { model.plane; }) {
    return {on_part_of(model.plane, q), on_part_of(model.thickness, q)};
  } else {
    return model;
  }
}

/// What the models below have in common. Where a condition of the formula does not hold, or not for
/// certain all over an interval, every result is no number.
template <class C>
class TapeModel {
 public:
  /// As many coefficients as the tape has parameters (std::invalid_argument otherwise).
  TapeModel(std::shared_ptr<const expression::Tape> tape, const CoefficientList<C>& coefficients,
            const DomainPart& part = {})
      : tape_(std::move(tape)),
        coefficients_(coefficients),
        constants_(*tape_, coefficients),
        part_(part) {
    if (coefficients.size() != tape_->parameters.size())
      throw std::invalid_argument("an expression of " + std::to_string(tape_->parameters.size()) +
                                  " parameters");
    if constexpr (requires { constants_.values(); }) {
      for (const auto& each : tape_->coefficient_conditions) {
        const int sign = certain_sign(constants_.values()[each.constant]);
        empty_domain_ = empty_domain_ || (each.condition.positive ? sign <= 0 : sign == 0);
      }
    }
  }

  /// The signs of what must not be 0 that it is restricted to.
  const DomainPart& part() const { return part_; }

  const CoefficientList<C>& coefficients() const { return coefficients_; }
  const std::string& text() const { return tape_->text; }
  const std::vector<std::string>& parameters() const { return tape_->parameters; }
  const std::shared_ptr<const expression::Tape>& tape() const { return tape_; }
  /// Then evaluate() has kernels (expression/symmetric_kernel.hpp) to sum up, and the balance has
  /// not.
  bool has_principal_stretches() const { return tape_->has_principal_stretches; }
  /// Numbers in the formula ("0.1") are inputs then, as uncertain as its parameters.
  bool has_decimals() const { return tape_->coefficients.has_decimals; }
  /// Whether it is not defined everywhere: it may be steep without bound at a border or a pole.
  bool has_conditions() const { return !tape_->conditions.empty(); }

 protected:
  /// Results of a program on inputs: out(k) gives result k, and no number outside the domain.
  template <class R, class Out, class... Inputs>
  void run(const expression::Program& program, Out&& out, const Inputs&... inputs) const {
    run_anywhere<R>(
        program,
        [&](const auto& result) {
          const std::size_t count = tape_->conditions.size();
          if (count == 0 && !empty_domain_) {
            out(result);
            return;
          }
          const std::size_t first = program.results.size() - count;
          if constexpr (expression::Packed<R>) {
            R beyond = outside_in_lanes<R>(empty_domain_, result(0));
            for (std::size_t k = 0; k < count; ++k)
              beyond = beyond + beyond_condition(k, result(first + k));
            out([&](std::size_t i) { return R(result(i) + beyond); });
          } else {
            bool inside = !empty_domain_;
            for (std::size_t k = 0; k < count; ++k)
              inside = inside && part_.has(tape_->conditions[k], k, result(first + k));
            const R none = poison<R>();
            out([&](std::size_t i) -> const R& { return inside ? result(i) : none; });
          }
        },
        inputs...);
  }

  /// The same of a program without conditions, or whatever they say.
  template <class R, class Out, class... Inputs>
  void run_anywhere(const expression::Program& program, Out&& out, const Inputs&... inputs) const {
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

  /// The values of the conditions, of doubles.
  template <class... Inputs>
  std::vector<ConditionValue> conditions(const Inputs&... inputs) const {
    std::vector<ConditionValue> out;
    const expression::Program& program = tape_->evaluate[0];
    run_anywhere<double>(
        program,
        [&](const auto& result) {
          const std::size_t first = program.results.size() - tape_->conditions.size();
          for (std::size_t k = 0; k < tape_->conditions.size(); ++k)
            out.push_back({&tape_->conditions[k], result(first + k)});
        },
        inputs...);
    if constexpr (requires { constants_.values(); })
      for (const auto& each : tape_->coefficient_conditions)
        out.push_back({&each.condition, leading(constants_.values()[each.constant])});
    return out;
  }
  /// The part of the domain that inputs lie in.
  template <class... Inputs>
  DomainPart part_of(const Inputs&... inputs) const {
    DomainPart out;
    const std::vector<ConditionValue> values = conditions(inputs...);
    for (std::size_t k = 0; k < tape_->conditions.size(); ++k) {
      if (tape_->conditions[k].positive) continue;
      out.chosen |= std::uint32_t{1} << k;
      if (values[k].value < 0.0) out.negative |= std::uint32_t{1} << k;
    }
    return out;
  }
  /// Whether a condition holds nowhere in a box of intervals: by the program of the balance.
  template <class... Inputs>
  bool outside(const expression::Program& program, const Inputs&... inputs) const {
    bool out = false;
    if (tape_->conditions.empty()) return out;
    run_anywhere<Interval>(
        program,
        [&](const auto& result) {
          const std::size_t first = program.results.size() - tape_->conditions.size();
          for (std::size_t k = 0; k < tape_->conditions.size(); ++k)
            if (tape_->conditions[k].positive) out = out || result(first + k).hi <= 0.0;
        },
        inputs...);
    return out;
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

  /// A program of expression/slopes.hpp, of the inputs and the parameters: out(result).
  template <class Out, class... Inputs>
  void run_slopes(const expression::Program& program, const Out& out,
                  const Inputs&... inputs) const {
    expression::Workspace<double, expression::largest_place_count> workspace;
    double* place = workspace.data();
    const double* constants = tape_->fixed_constants.data();
    std::size_t next = 0;
    ((place[next++] = inputs), ...);
    for (const C& c : coefficients_) place[next++] = leading(c);
    expression::run<double>(program, tape_->coefficients.literals.data(), constants, place);
    out([&](std::size_t i) {
      const expression::Result& at = program.results[i];
      return at.constant ? constants[at.at] : place[at.at];
    });
  }

  /// Value and gradient as dual numbers, out(k, number k of them), of dual coefficients. False where
  /// the tape has no slopes, or one is no number: then out has been told nothing of use.
  template <class Out, class... Inputs>
  bool run_dual(const Out& out, const Inputs&... inputs) const {
    const expression::Program& program = tape_->slopes;
    if (program.results.empty()) return false;
    const std::size_t count = program.results.size() / (1 + coefficients_.size());
    bool finite = true;
    run_slopes(
        program,
        [&](const auto& result) {
          for (std::size_t k = 0; k < count; ++k) {
            C number(result(k));
            for (std::size_t i = 0; i < coefficients_.size(); ++i)
              for (std::size_t direction = 0; direction < number.slope.size(); ++direction)
                if (coefficients_[i].slope[direction] != 0.0)
                  number.slope[direction] +=
                      result((1 + i) * count + k) * coefficients_[i].slope[direction];
            for (const auto& slope : number.slope) finite = finite && std::isfinite(slope);
            out(k, number);
          }
        },
        inputs...);
    return finite;
  }

  /// Of each residual g the sum over the parameters p of |p dg/dp|, none of which is by a p = 0; nothing where the
  /// tape has not got their slopes, or one is no number.
  template <std::size_t n, class... Inputs>
  std::optional<std::array<double, n>> sensitivity(const Inputs&... inputs) const {
    std::array<double, n> out{};
    if (coefficients_.size() == 0) return out;
    const expression::Program& program = tape_->residual_slopes;
    if (program.results.empty()) return {};
    run_slopes(
        program,
        [&](const auto& result) {
          for (std::size_t i = 0; i < coefficients_.size(); ++i)
            for (std::size_t k = 0; k < n && coefficients_[i] != 0.0; ++k)
              out[k] += std::abs(coefficients_[i] * result(i * n + k));
        },
        inputs...);
    if (!std::ranges::all_of(out, [](double each) { return std::isfinite(each); })) return {};
    return out;
  }

  const expression::Tape& programs() const { return *tape_; }

 private:
  /// 0 in lanes that are inside, and no number in the others.
  template <class R>
  static R outside_in_lanes(bool all, const R& like) {
    return lane_by_lane(
        [all](const auto& lane) {
          using T = std::remove_cvref_t<decltype(lane)>;
          return all ? poison<T>() : T(0.0);
        },
        like);
  }
  template <class R>
  R beyond_condition(std::size_t k, const R& value) const {
    return lane_by_lane(
        [&](const auto& lane) {
          using T = std::remove_cvref_t<decltype(lane)>;
          return part_.has(tape_->conditions[k], k, lane) ? T(0.0) : poison<T>();
        },
        value);
  }

  std::shared_ptr<const expression::Tape> tape_;
  CoefficientList<C> coefficients_;
  TapeConstants<C> constants_;
  DomainPart part_;
  bool empty_domain_ = false;  ///< the coefficients alone say so
};

}  // namespace stationary

/// The most there may be.
template <class C>
struct std::tuple_size<stationary::CoefficientList<C>>
    : std::integral_constant<std::size_t, stationary::expression::largest_parameter_count> {};
