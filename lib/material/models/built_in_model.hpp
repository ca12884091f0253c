// A built-in planar or thickness model whose kind is known at run time only: each evaluation asks
// which. What is slow beside that question (a proof, a search, an event) is then compiled for one
// potential and not for every pair of a planar and a thickness model.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <variant>

#include "lib/body/stretch.hpp"
#include "lib/material/models/coefficients.hpp"
#include "lib/material/models/isotropic_models.hpp"
#include "lib/material/models/log_balance.hpp"
#include "lib/material/models/model_derivatives.hpp"
#include "lib/number/number.hpp"

namespace stationary {

/// What evaluate() of a planar model gives at its invariants, of a thickness model at rho; C: the
/// coefficients' type.
template <class C, class S>
PlanarDerivatives<Product<C, S>> derivatives_at(const PlanarInvariants<S>& state);
template <class C, class S>
ThicknessDerivatives<Product<C, S>> derivatives_at(const S& rho);
template <class C, class State>
using DerivativesAt = decltype(derivatives_at<C>(std::declval<const State&>()));

/// evaluate() and log_balance() of a model whose kind is asked. They are long, every solver comes by
/// them, and those that any_model.hpp lists are compiled once, in material/compiled_models.cpp: members
/// would be inline, and compiled wherever they are called.
template <int order, class C, class Model, class State>
DerivativesAt<C, State> evaluate_kind(const Model& model, const State& state) {
  return model.visit(
      [&](const auto& m) -> DerivativesAt<C, State> { return m.template evaluate<order>(state); });
}
template <class C, class Model, class S>
LogBalance<Product<C, S>> balance_of_kind(const Model& model, const S& xi, const S& zeta,
                                          const S& c_xi, const S& c_zeta) {
  return model.visit([&](const auto& m) -> LogBalance<Product<C, S>> {
    return m.log_balance(xi, zeta, c_xi, c_zeta);
  });
}
template <class C, class Model, class S>
LogBalance<Product<C, S>> balance_of_kind(const Model& model, const S& rho, const S& c_rho) {
  return model.visit(
      [&](const auto& m) -> LogBalance<Product<C, S>> { return m.log_balance(rho, c_rho); });
}

/// C of the models in a variant of them.
template <class Models>
struct CoefficientOf;
template <template <class> class First, class... Rest, class C>
struct CoefficientOf<std::variant<First<C>, Rest...>> {
  using type = C;
};

template <class Models>
struct BuiltInModel;

/// f(the model) of whichever it is.
template <class... Model>
struct BuiltInModel<std::variant<Model...>> {
  /// with_indexed_coefficients() keeps the kind.
  static constexpr bool of_any_kind = true;
  using Kinds = BuiltInModel;
  using Coefficient = typename CoefficientOf<std::variant<Model...>>::type;
  std::variant<Model...> model;

  template <class F>
  decltype(auto) visit(F&& f) const {
    return std::visit(f, model);
  }

  /// As many as any of them has; zeros that nothing reads follow a model's own.
  auto coefficients() const {
    constexpr std::size_t most = std::max({most_coefficients<Model>...});
    return visit([](const auto& m) {
      const auto& c = m.coefficients();
      std::array<std::remove_cvref_t<decltype(c[0])>, most> out{};
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
};

template <class C = double>
struct BuiltInPlane : BuiltInModel<PlanarModels<C>> {
  double rest_stretch() const {
    return this->visit([](const auto& m) { return m.rest_stretch(); });
  }
};

template <class C = double>
struct BuiltInThickness : BuiltInModel<ThicknessModels<C>> {
  double balanced(const DoubleDouble& m) const {
    return this->visit([&](const auto& each) { return each.balanced(m); });
  }
};

/// Any<C> with convert(c, k) for its coefficient c number k.
template <template <class> class Any, class Convert>
requires(Any<double>::of_any_kind) auto with_indexed_coefficients(const Any<double>& model,
                                                                  const Convert& convert) {
  using C = std::remove_cvref_t<decltype(convert(0.0, std::size_t(0)))>;
  return model.visit(
      [&](const auto& m) { return Any<C>{{with_indexed_coefficients(m, convert)}}; });
}

}  // namespace stationary
