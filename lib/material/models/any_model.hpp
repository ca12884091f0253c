// A planar or thickness model whose kind is known at run time only: a built-in one or an expression
// of the user's. Each evaluation asks which, so that a potential with an expression in it is one
// type to the solvers, whatever its other part is.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lib/material/models/built_in_model.hpp"
#include "lib/material/models/expression.hpp"
#include "lib/material/models/isotropic_models.hpp"

namespace stationary {

/// What AnyPlane and AnyThickness have in common: f(the model) of whichever it is.
template <class BuiltIn, class Expression>
struct AnyModel {
  using Kinds = AnyModel;
  static constexpr bool of_any_kind = true;
  using Coefficient = typename CoefficientOf<BuiltIn>::type;
  std::variant<BuiltIn, Expression> model;

  template <class F>
  decltype(auto) visit(F&& f) const {
    if (const auto* expression = std::get_if<Expression>(&model)) return f(*expression);
    return std::visit(f, std::get<BuiltIn>(model));
  }
  bool is_expression() const { return std::holds_alternative<Expression>(model); }
  bool has_decimals() const {
    const auto* expression = std::get_if<Expression>(&model);
    return expression != nullptr && expression->has_decimals();
  }

  bool has_conditions() const {
    const auto* expression = std::get_if<Expression>(&model);
    return expression != nullptr && expression->has_conditions();
  }

  /// Of an expression (expression.hpp).
  std::vector<ConditionValue> conditions_at(const Stretch& q) const {
    const auto* expression = std::get_if<Expression>(&model);
    return expression == nullptr ? std::vector<ConditionValue>() : expression->conditions_at(q);
  }
  bool outside_in(const auto&... box) const {
    const auto* expression = std::get_if<Expression>(&model);
    return expression != nullptr && expression->outside_in(box...);
  }
  /// Any, its expression restricted to the part of its domain that q lies in.
  template <class Any>
  Any restricted(const Stretch& q) const {
    const auto* expression = std::get_if<Expression>(&model);
    if (expression == nullptr) return Any{{model}};
    return Any{{expression->on_part_of(q)}};
  }

  /// As many as an expression may have; zeros that nothing reads follow a model's own.
  auto coefficients() const {
    return visit([](const auto& m) {
      using C = std::remove_cvref_t<decltype(m.coefficients()[0])>;
      std::array<C, expression::largest_parameter_count> out{};
      const auto& c = m.coefficients();
      std::copy(c.begin(), c.end(), out.begin());
      return out;
    });
  }

  template <class... S>
  auto log_balance(const S&... arguments) const {
    return balance_of_kind<Coefficient>(*this, arguments...);
  }
  template <int order, class State>
  auto evaluate(const State& state) const {
    return evaluate_kind<order, Coefficient>(*this, state);
  }
  template <int order, class State>
  auto forces(const State& state) const {
    const auto* expression = std::get_if<Expression>(&model);
    return expression != nullptr ? expression->template forces<order>(state)
                                 : evaluate<order>(state);
  }
};

template <class C = double>
struct AnyPlane : AnyModel<PlanarModels<C>, PlanarExpression<C>> {
  AnyPlane on_part_of(const Stretch& q) const { return this->template restricted<AnyPlane>(q); }
  double rest_stretch() const {
    return this->visit([](const auto& m) { return m.rest_stretch(); });
  }
  /// As of the expressions (expression.hpp); no built-in model gains by it.
  bool has_principal_stretches() const {
    const auto* expression = std::get_if<PlanarExpression<C>>(&this->model);
    return expression != nullptr && expression->has_principal_stretches();
  }
  /// Only where that is so.
  template <class S>
  auto residual(const S& xi, const S& zeta, const S& c_xi, const S& c_zeta) const {
    return std::get<PlanarExpression<C>>(this->model).residual(xi, zeta, c_xi, c_zeta);
  }
};

template <class C = double>
struct AnyThickness : AnyModel<ThicknessModels<C>, ThicknessExpression<C>> {
  AnyThickness on_part_of(const Stretch& q) const {
    return this->template restricted<AnyThickness>(q);
  }
  double balanced(const DoubleDouble& m) const {
    return this->visit([&](const auto& each) { return each.balanced(m); });
  }
};

// Compiled once (built_in_model.hpp), with coefficients C and a state in S.
#define STATIONARY_COMPILED_KIND(keyword, Plane, Thickness, C, S)                                  \
  keyword DerivativesAt<C, PlanarInvariants<S>> evaluate_kind<1, C>(const Plane&,                  \
                                                                    const PlanarInvariants<S>&);   \
  keyword DerivativesAt<C, PlanarInvariants<S>> evaluate_kind<2, C>(const Plane&,                  \
                                                                    const PlanarInvariants<S>&);   \
  keyword DerivativesAt<C, S> evaluate_kind<1, C>(const Thickness&, const S&);                     \
  keyword DerivativesAt<C, S> evaluate_kind<2, C>(const Thickness&, const S&);                     \
  keyword LogBalance<Product<C, S>> balance_of_kind<C>(const Plane&, const S&, const S&, const S&, \
                                                       const S&);                                  \
  keyword LogBalance<Product<C, S>> balance_of_kind<C>(const Thickness&, const S&, const S&);
#define STATIONARY_COMPILED_NUMBERS(keyword, Plane, Thickness, C) \
  STATIONARY_COMPILED_KIND(keyword, Plane<C>::Kinds, Thickness<C>::Kinds, C, C)
#define STATIONARY_COMPILED_MODEL_OF(keyword, Plane, Thickness)                               \
  STATIONARY_COMPILED_KIND(keyword, Plane<>::Kinds, Thickness<>::Kinds, double, DoubleDouble) \
  STATIONARY_COMPILED_NUMBERS(keyword, Plane, Thickness, DoubleDouble)                        \
  STATIONARY_COMPILED_NUMBERS(keyword, Plane, Thickness, Interval)                            \
  STATIONARY_COMPILED_NUMBERS(keyword, Plane, Thickness, Conditioned)
#define STATIONARY_COMPILED_KINDS(keyword)                              \
  STATIONARY_COMPILED_MODEL_OF(keyword, BuiltInPlane, BuiltInThickness) \
  STATIONARY_COMPILED_MODEL_OF(keyword, AnyPlane, AnyThickness)
STATIONARY_COMPILED_KINDS(extern template)

}  // namespace stationary
