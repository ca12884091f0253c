// The coefficients of a model, whatever their number: the same model with others of another number
// type. A model is an aggregate of its coefficients, or has a function of the name below.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace stationary {

/// How many coefficients a model of this type has at most.
template <class Model>
constexpr std::size_t most_coefficients =
    std::tuple_size_v<std::remove_cvref_t<decltype(std::declval<const Model&>().coefficients())>>;

/// convert(c, k) of each coefficient c, k its place.
template <template <class> class Model, class Convert>
auto with_indexed_coefficients(const Model<double>& model, const Convert& convert) {
  const auto c = model.coefficients();
  return [&]<std::size_t... K>(std::index_sequence<K...>) {
    return Model<std::remove_cvref_t<decltype(convert(c[0], std::size_t(0)))>>{convert(c[K], K)...};
  }
  (std::make_index_sequence<most_coefficients<Model<double>>>{});
}

/// convert(c) of each coefficient c.
template <template <class> class Model, class Convert>
auto with_coefficients(const Model<double>& model, const Convert& convert) {
  return with_indexed_coefficients(model, [&](double c, std::size_t) { return convert(c); });
}

}  // namespace stationary
