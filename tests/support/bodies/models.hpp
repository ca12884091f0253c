// The built-in models as lists of types, read off the variants in lib/material/potential.hpp: a
// model added there is put through every typed suite without a line added here.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include "lib/material/models/model_coefficients.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::support {

template <class Variant>
struct TypesOf;
template <class First, class... Rest>
struct TypesOf<std::variant<First, Rest...>> {
  using type = ::testing::Types<First, Rest...>;
  using tuple = std::tuple<First, Rest...>;
  /// Each planar model with one thickness model.
  template <class Thickness>
  using with_thickness = std::tuple<Separable<First, Thickness>, Separable<Rest, Thickness>...>;
  /// Each further thickness model under one planar model.
  template <class Plane>
  using rest_under_plane = std::tuple<Separable<Plane, Rest>...>;
};

template <class Tuple>
struct AsTypes;
template <class... Models>
struct AsTypes<std::tuple<Models...>> {
  using type = ::testing::Types<Models...>;
};

using BuiltInPlanarModels = TypesOf<PlanarPotential>::type;
using BuiltInThicknessModels = TypesOf<ThicknessPotential>::type;
using BuiltInCoupledModels = TypesOf<CoupledPotential>::type;

/// Whole potentials: every planar model, every thickness model, every coupled one.
using WholeModels = AsTypes<decltype(std::tuple_cat(
    std::declval<TypesOf<PlanarPotential>::with_thickness<
        std::variant_alternative_t<0, ThicknessPotential>>>(),
    std::declval<TypesOf<ThicknessPotential>::rest_under_plane<
        std::variant_alternative_t<std::variant_size_v<PlanarPotential> - 1, PlanarPotential>>>(),
    std::declval<TypesOf<CoupledPotential>::tuple>()))>::type;

/// Test names from model names.
struct ModelName {
  template <class Model>
  static std::string GetName(int) {
    std::string out = text(static_cast<const Model*>(nullptr));
    for (char& letter : out)
      if (letter == '-') letter = '_';
    return out;
  }

 private:
  template <class Model>
  static std::string text(const Model*) {
    return std::string(Model::name);
  }
  template <class Plane, class Thickness>
  static std::string text(const Separable<Plane, Thickness>*) {
    std::string out(Plane::name);  // in steps: GCC 12 sees an overrun in the sum
    out += "_with_";
    out += Thickness::name;
    return out;
  }
};

/// A whole model with random coefficients in its domain.
template <class Model>
struct Draw {
  static Model from(Random& random) { return random.coefficients<Model>(); }
  static std::string text(const Model& model) {
    std::string out(Model::name);
    for (const double c : model.coefficients()) out += " " + std::to_string(c);
    return out;
  }
};
template <class Plane, class Thickness>
struct Draw<Separable<Plane, Thickness>> {
  static Separable<Plane, Thickness> from(Random& random) {
    const Plane plane = random.coefficients<Plane>();
    return {plane, random.coefficients<Thickness>()};
  }
  static std::string text(const Separable<Plane, Thickness>& model) {
    return Draw<Plane>::text(model.plane) + ", " + Draw<Thickness>::text(model.thickness);
  }
};
template <class Model>
Model draw(Random& random) {
  return Draw<Model>::from(random);
}
template <class Model>
std::string text_of(const Model& model) {
  return Draw<Model>::text(model);
}

/// The same model with coefficients of type T.
template <class T, class Model>
auto widen(const Model& model) {
  return with_coefficients(model, [](double c) { return T(c); });
}

/// The model as the run-time class.
template <class Model>
Potential as_potential(const Model& model) {
  return Potential(CoupledPotential(model));
}
template <class Plane, class Thickness>
Potential as_potential(const Separable<Plane, Thickness>& model) {
  return {PlanarPotential(model.plane), ThicknessPotential(model.thickness)};
}

}  // namespace stationary::support
