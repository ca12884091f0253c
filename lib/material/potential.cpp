#include "lib/material/potential.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/material/elastic_energy.hpp"
#include "lib/material/gravitating/rest_state.hpp"
#include "lib/material/material_coordinates.hpp"
#include "lib/material/model_domain.hpp"

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

Potential::Potential(const BodyModel<>& body) : models_(body) {
  body.elastic.for_models([](const auto& model, std::size_t) { require_domain(model); });
  if (body.gravitates && !(body.g > 0.0 && std::isfinite(body.g)))
    throw std::invalid_argument("g > 0");
  if (body.volume && !(*body.volume > 0.0 && std::isfinite(*body.volume)))
    throw std::invalid_argument("volume > 0");
  if (!body.gravitates && !body.volume) throw std::invalid_argument("gravity or a held volume");
  if (body.elastic.is_fluid() && !body.volume)
    throw std::invalid_argument("a potential: a fluid without one needs its volume held");
  std::get<BodyModel<>>(models_).stiffness = volume_stiffness(body);
}

bool Potential::may_shear() const {
  return has_turned_gravity() && !body_model()->elastic.rises_with_trace() && !is_fluid(*this);
}

BodyModel<> Potential::as_body() const {
  if (const auto* body = body_model()) return *body;
  BodyModel<> out;
  if (const auto* parts = std::get_if<SeparableModels>(&models_)) {
    out.elastic.plane = AnyPlane<>{{parts->plane}};
    out.elastic.thickness = AnyThickness<>{{parts->thickness}};
  } else if (const auto* formulas = std::get_if<SeparableExpression>(&models_)) {
    out.elastic.plane = formulas->plane;
    out.elastic.thickness = formulas->thickness;
  } else if (const auto* formula = std::get_if<CoupledExpression<>>(&models_)) {
    out.elastic.coupled = *formula;
  } else if (const auto* coupled = std::get_if<CoupledPotential>(&models_)) {
    std::visit([&](const auto& model) { out.elastic.coupled = model; }, *coupled);
  } else {
    throw std::invalid_argument("an isotropic potential");
  }
  return out;
}

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

template <class F>
void Potential::for_formulas(const F& f) const {
  const auto one = [&](const auto& model) {
    if constexpr (requires { model.tape(); }) f(model);
  };
  if (const auto* parts = std::get_if<SeparableExpression>(&models_)) {
    parts->plane.visit(one);
    parts->thickness.visit(one);
  } else if (const auto* coupled = std::get_if<CoupledExpression<>>(&models_)) {
    one(*coupled);
  } else if (const auto* of_axes = std::get_if<AnisotropicPotential>(&models_)) {
    of_axes->for_models(one);
  } else if (const auto* body = std::get_if<BodyModel<>>(&models_)) {
    body->elastic.for_models([&](const auto& model, std::size_t) { one(model); });
  }
}

namespace {

/// Replaces what a formula that takes something for granted adds to a gradient by what the whole of
/// it does. A formula that was taken apart comes as plane and thickness, with one whole.
template <class C>
class WholeFormulas {
 public:
  explicit WholeFormulas(const BasicStretch<C>& q) : q_(q) {}

  template <class Model, class Convert>
  void replace(const Model& model, const Convert& convert, Vector4<C>& gradient) {
    const auto& whole = model.tape()->whole;
    if (whole == nullptr) return;
    const auto own = with_indexed_coefficients(model, convert);
    gradient -= model_gradient(own);
    if (whole == last_) return;
    last_ = whole;
    gradient +=
        AnisotropicExpression<C>(whole, own.coefficients()).template derivatives<1>(q_).gradient;
  }

 private:
  template <class Model>
  Vector4<C> model_gradient(const Model& model) const {
    if constexpr (requires { model.template isotropic<1>(planar_invariants(q_), q_.rho); }) {
      const auto terms = model.template isotropic<1>(planar_invariants(q_), q_.rho);
      return in_stretch<1>(terms, q_).gradient + model.template derivatives<1>(q_).gradient;
    } else if constexpr (requires { model.template derivatives<1>(q_); }) {
      return model.template derivatives<1>(q_).gradient;
    } else if constexpr (requires { model.template evaluate<1>(q_.rho); }) {
      Vector4<C> out = Vector4<C>::Constant(C(0.0));
      out[3] = model.template evaluate<1>(q_.rho).v_r / q_.rho;
      return out;
    } else {
      const C none(0.0);
      const auto x = planar_invariants(q_);
      CoupledDerivatives<C> w{{none, none, none, none, none, none}, none, none, none, none};
      if constexpr (requires { model.template evaluate<1>(x, q_.rho); }) {
        w = model.template evaluate<1>(x, q_.rho);
      } else {
        w.plane = model.template evaluate<1>(x);
      }
      return in_stretch<1>(w, q_).gradient;
    }
  }

  BasicStretch<C> q_;
  std::shared_ptr<const expression::Tape> last_;
};

}  // namespace

PotentialDerivatives<double> Potential::derivatives(const Stretch& q) const {
  PotentialDerivatives<double> out =
      is_isotropic() ? visit([&](const auto& model) { return potential_derivatives<2>(model, q); })
                     : potential_derivatives<2>(anisotropic().model(), q);
  if (holds_volume()) return out;  // the whole of a formula is not along it
  WholeFormulas<double> whole(q);
  for_formulas([&](const auto& model) {
    whole.replace(
        model, [](double c, std::size_t) { return c; }, out.gradient);
  });
  return out;
}

bool Potential::assumptions_refuted(const BasicStretch<Interval>& box, bool decimals) const {
  Vector4<Interval> excess = Vector4<Interval>::Constant(Interval(0.0));
  WholeFormulas<Interval> whole(box);
  for_formulas([&](const auto& model) {
    whole.replace(
        model,
        [decimals](double c, std::size_t) { return decimals ? Interval::decimal(c) : Interval(c); },
        excess);
  });
  for (int i = 0; i < 4; ++i)
    if (!excess[i].may_be(0.0)) return true;
  return false;
}

double Potential::value(const Stretch& q) const {
  if (!is_isotropic()) return elastic_energy(anisotropic().model(AsExtended()), q);
  return visit([&](const auto& model) { return elastic_energy(model, q); });
}

std::vector<ConditionValue> Potential::conditions_at(const Stretch& q) const {
  if (!is_isotropic()) return anisotropic().conditions_at(q);
  return visit([&](const auto& model) { return model_conditions(model, q); });
}

std::vector<std::string> Potential::assumptions() const {
  std::vector<std::string> out;
  for_formulas([&out](const auto& model) {
    for (const std::string& each : model.tape()->assumed)
      if (std::ranges::find(out, each) == out.end()) out.push_back(each);
  });
  return out;
}

bool Potential::defined_at(const Stretch& q) const {
  return std::ranges::all_of(conditions_at(q), &ConditionValue::holds) && std::isfinite(value(q));
}

Potential Potential::on_part_of(const Stretch& q) const {
  Potential out = *this;
  if (auto* parts = std::get_if<SeparableExpression>(&out.models_)) {
    *parts = stationary::on_part_of(*parts, q);
  } else if (auto* coupled = std::get_if<CoupledExpression<>>(&out.models_)) {
    *coupled = coupled->on_part_of(q);
  } else if (auto* anisotropic = std::get_if<AnisotropicPotential>(&out.models_)) {
    *anisotropic = anisotropic->on_part_of(q);
  } else if (auto* body = std::get_if<BodyModel<>>(&out.models_)) {
    *body = body->on_part_of(q);
  }
  return out;
}

}  // namespace stationary
