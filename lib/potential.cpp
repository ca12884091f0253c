#include "lib/potential.hpp"

#include <stdexcept>

#include "lib/model_domain.hpp"

namespace stationary {
namespace {

template <class Model, std::size_t... K>
Model from_coefficients(std::span<const double> values, std::index_sequence<K...>) {
  if (values.size() != sizeof...(K)) {
    throw std::invalid_argument(std::string(Model::name) + " takes " +
                                std::to_string(sizeof...(K)) + " coefficients");
  }
  const Model model{values[K]...};
  require_domain(model);
  return model;
}

/// The alternative of Variant called `name`, from its coefficients.
template <class Variant, std::size_t k = 0>
Variant by_name(std::string_view name, std::span<const double> values) {
  if constexpr (k == std::variant_size_v<Variant>) {
    throw std::invalid_argument("a built-in model, not \"" + std::string(name) + "\"");
  } else {
    using Model = std::variant_alternative_t<k, Variant>;
    if constexpr (requires { Model::name; }) {
      if (name == Model::name)
        return from_coefficients<Model>(values,
                                        std::make_index_sequence<Model::parameters.size()>{});
    }
    return by_name<Variant, k + 1>(name, values);
  }
}

template <class Model>
ModelDescription described(ModelDescription::Kind kind, bool isotropic) {
  return {kind,
          std::string(Model::name),
          std::string(Model::formula),
          {Model::parameters.begin(), Model::parameters.end()},
          {Model::domain.begin(), Model::domain.end()},
          isotropic};
}

template <class Variant, std::size_t... K>
void describe(ModelDescription::Kind kind, std::vector<ModelDescription>& out,
              std::index_sequence<K...>) {
  const auto one = [&]<class Model>(std::type_identity<Model>) {
    out.push_back(described<Model>(kind, true));
  };
  (one(std::type_identity<std::variant_alternative_t<K, Variant>>{}), ...);
}

template <class Variant>
void describe(ModelDescription::Kind kind, std::vector<ModelDescription>& out) {
  describe<Variant>(kind, out, std::make_index_sequence<std::variant_size_v<Variant>>{});
}

}  // namespace

const std::vector<ModelDescription>& model_descriptions() {
  static const std::vector<ModelDescription> all = [] {
    std::vector<ModelDescription> out;
    using Kind = ModelDescription::Kind;
    describe<PlanarPotential>(Kind::planar, out);
    describe<ThicknessPotential>(Kind::thickness, out);
    describe<CoupledPotential>(Kind::coupled, out);
    return out;
  }();
  return all;
}

const std::vector<ModelDescription>& anisotropic_descriptions() {
  using Kind = ModelDescription::Kind;
  static const std::vector<ModelDescription> all = {
      described<OrthotropicSaintVenantKirchhoff<>>(Kind::planar, false),
      {Kind::fibre,
       "fibre",
       "(k/2) (f . S^2 f - 1)^2,  f at an angle of so many degrees to axis 1",
       {"k", "degrees"},
       {"k > 0"},
       false}};
  return all;
}

Potential::Potential(const PlanarPotential& plane, const ThicknessPotential& thickness)
    : models_(SeparableModels{plane, thickness}) {
  std::visit([](const auto& model) { require_domain(model); }, plane);
  std::visit([](const auto& model) { require_domain(model); }, thickness);
}

Potential::Potential(const CoupledPotential& coupled) : models_(coupled) {
  std::visit([](const auto& model) { require_domain(model); }, coupled);
}

Potential::Potential(const SeparableExpression& parts) : models_(parts) {
  const auto require = [](const auto& part) {
    part.visit([](const auto& model) { require_domain(model); });
  };
  require(parts.plane);
  require(parts.thickness);
}

Potential::Potential(const CoupledExpression<>& coupled) : models_(coupled) {
  require_domain(coupled);
}

Potential::Potential(const AnisotropicPotential& anisotropic) : models_(anisotropic) {}

PlanarPotential Potential::planar(std::string_view name, std::span<const double> coefficients) {
  return by_name<PlanarPotential>(name, coefficients);
}

ThicknessPotential Potential::thickness(std::string_view name,
                                        std::span<const double> coefficients) {
  return by_name<ThicknessPotential>(name, coefficients);
}

CoupledPotential Potential::coupled(std::string_view name, std::span<const double> coefficients) {
  return by_name<CoupledPotential>(name, coefficients);
}

AnisotropicPotential::Plane Potential::oriented_plane(std::string_view name,
                                                      std::span<const double> coefficients) {
  return by_name<AnisotropicPotential::Plane>(name, coefficients);
}

PotentialDerivatives<double> Potential::derivatives(const Stretch& q) const {
  if (!is_isotropic()) return potential_derivatives<2>(anisotropic().model(), q);
  return visit([&](const auto& model) { return potential_derivatives<2>(model, q); });
}

double Potential::value(const Stretch& q) const {
  if (!is_isotropic()) return potential_derivatives<0>(anisotropic().model(), q).value;
  return visit([&](const auto& model) { return potential_derivatives<0>(model, q).value; });
}

}  // namespace stationary
