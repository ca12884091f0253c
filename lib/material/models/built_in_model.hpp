// A built-in planar or thickness model whose kind is known at run time only: each evaluation asks
// which. What is slow beside that question (a proof, a search, an event) is then compiled for one
// potential and not for every pair of a planar and a thickness model.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <variant>

#include "lib/material/models/coefficients.hpp"
#include "lib/material/models/isotropic_models.hpp"

namespace stationary {

template <class Models>
struct BuiltInModel;

/// f(the model) of whichever it is.
template <class... Model>
struct BuiltInModel<std::variant<Model...>> {
  /// with_indexed_coefficients() keeps the kind.
  static constexpr bool of_any_kind = true;
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
    return visit([&](const auto& m) { return m.log_balance(arguments...); });
  }
  template <int order, class State>
  auto evaluate(const State& state) const {
    return visit([&](const auto& m) { return m.template evaluate<order>(state); });
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
