// A potential V(q): either V_plane(alpha, xi, zeta) + V_rho(rho) ("separable", the paper's case) or
// coupled; isotropic, a function of (t, l = ln d, r = ln rho), or with directions of its own
// (anisotropic_potential.hpp). Value, gradient and Hessian in q come from one evaluation and have
// no singularity at the circle (potential_derivatives.hpp).
//
// Two layers. Templates: a model is a small aggregate of coefficients with
//   evaluate<order>(invariants, rho) -> CoupledDerivatives
// in any number type; Separable<Plane, Thickness> makes one of two. Run time: class Potential holds
// one of the models and visit() gives an isotropic one back as its own type, once per solve.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lib/body/stretch.hpp"
#include "lib/material/anisotropic_potential.hpp"
#include "lib/material/gravitating/body_model.hpp"
#include "lib/material/models/any_model.hpp"
#include "lib/material/models/isotropic_models.hpp"
#include "lib/material/models/potential_derivatives.hpp"
#include "lib/material/models/separable.hpp"

namespace stationary {

/// In q, by in_stretch(); order 0, 1, 2 as in evaluate(). first = 1: without those in alpha.
template <int order, int first = 0, class Model, class S>
auto potential_derivatives(const Model& model, const BasicStretch<S>& q) {
  return in_stretch<order, first>(model.template evaluate<order>(planar_invariants(q), q.rho), q);
}
template <int order, class C, class S>
auto potential_derivatives(const BodyModel<C>& model, const BasicStretch<S>& q) {
  return model.template derivatives<order>(q);
}

/// What `stationary models` and `stationary check` print of a model.
struct ModelDescription {
  enum class Kind {
    planar,
    thickness,
    coupled,
    fibre,  ///< beside any of them
    whole   ///< of the body beside them: its gravity, its volume
  } kind;
  std::string name;
  std::string formula;
  std::vector<std::string> parameters;
  std::vector<std::string> domain;  ///< inequalities on the parameters, all required
  bool isotropic = true;
};

/// Every built-in isotropic model, planar ones first.
const std::vector<ModelDescription>& model_descriptions();
/// The others, which make an AnisotropicPotential.
const std::vector<ModelDescription>& anisotropic_descriptions();

/// A separable potential with an expression in it, as one model.
using SeparableExpression = Separable<AnyPlane<>, AnyThickness<>>;
/// One of built-in models.
using BuiltInParts = Separable<BuiltInPlane<>, BuiltInThickness<>>;

/// Code small before fast, as a page's solver has it: a separable potential is one type, whatever it
/// is made of. The numbers are the same.
#ifdef STATIONARY_SMALL_CODE
constexpr bool few_types = true;
#else
constexpr bool few_types = false;
#endif

class Potential {
 public:
  /// Throw std::invalid_argument with the violated inequality of the model's domain.
  Potential(const PlanarPotential& plane, const ThicknessPotential& thickness);
  explicit Potential(const CoupledPotential& coupled);
  explicit Potential(const SeparableExpression& parts);
  explicit Potential(const CoupledExpression<>& coupled);
  explicit Potential(const AnisotropicPotential& anisotropic);
  /// With gravity or a held volume: g > 0 and volume > 0 where there are, J that of the body.
  explicit Potential(const BodyModel<>& body);

  /// By name; coefficients in the order of ModelDescription::parameters. Throws
  /// std::invalid_argument for an unknown name, a wrong count or a coefficient outside the domain.
  static PlanarPotential planar(std::string_view name, std::span<const double> coefficients);
  static ThicknessPotential thickness(std::string_view name, std::span<const double> coefficients);
  static CoupledPotential coupled(std::string_view name, std::span<const double> coefficients);
  /// Likewise a planar model of an anisotropic potential.
  static AnisotropicPotential::Plane oriented_plane(std::string_view name,
                                                    std::span<const double> coefficients);

  bool is_isotropic() const { return !std::holds_alternative<AnisotropicPotential>(models_); }
  bool is_separable() const {
    return is_isotropic() ? std::holds_alternative<SeparableModels>(models_) ||
                                std::holds_alternative<SeparableExpression>(models_)
                          : anisotropic().is_separable();
  }
  /// Isotropic, and made of built-in models alone.
  bool is_built_in() const {
    return std::holds_alternative<SeparableModels>(models_) ||
           std::holds_alternative<CoupledPotential>(models_);
  }
  /// Isotropic with gravity or a held volume: nothing otherwise. Counts as isotropic, though about axis 3
  /// not all of its motions need have alpha = 0 (may_shear()).
  const BodyModel<>* body_model() const { return std::get_if<BodyModel<>>(&models_); }
  /// Isotropic but for gravity of J1 != J2.
  bool has_turned_gravity() const { return body_model() != nullptr && !body_model()->isotropic(); }
  /// Such a one, no fluid, whose elastic energy may be stationary in t = xi + zeta: motions with alpha != 0
  /// may exist about axis 3, and oblique ones (sheared_balance.hpp).
  bool may_shear() const;
  /// The same as one model of a body, with gravity and a held volume where it has them. Throws
  /// std::invalid_argument where not isotropic.
  BodyModel<> as_body() const;
  /// det S, where it is held.
  std::optional<double> volume() const {
    if (!is_isotropic()) return anisotropic().body().volume;
    return body_model() == nullptr ? std::nullopt : body_model()->volume;
  }
  bool holds_volume() const { return volume().has_value(); }
  /// Gravity or a held volume.
  bool of_whole_body() const {
    return is_isotropic() ? body_model() != nullptr : anisotropic().body().any();
  }
  /// Only where not isotropic (std::bad_variant_access otherwise).
  const AnisotropicPotential& anisotropic() const {
    return std::get<AnisotropicPotential>(models_);
  }
  /// The parts; only where built in and separable (std::bad_variant_access otherwise).
  const PlanarPotential& plane() const { return std::get<SeparableModels>(models_).plane; }
  const ThicknessPotential& thickness() const {
    return std::get<SeparableModels>(models_).thickness;
  }
  /// Only where built in and not separable.
  const CoupledPotential& coupled() const { return std::get<CoupledPotential>(models_); }

  /// Calls f with the one model held, as its own type (Separable<Plane, Thickness> or a coupled
  /// one; SeparableExpression whatever its parts are). Throws std::invalid_argument where not
  /// isotropic.
  template <class F>
  decltype(auto) visit(F&& f) const {
    if (!is_isotropic()) throw std::invalid_argument("an isotropic potential");
    if constexpr (few_types) {
      return visit_parts(f);
    } else {
      if (const auto* parts = std::get_if<SeparableModels>(&models_)) {
        return std::visit(
            [&](const auto& plane, const auto& thickness) -> decltype(auto) {
              return f(Separable<std::decay_t<decltype(plane)>, std::decay_t<decltype(thickness)>>{
                  plane, thickness});
            },
            parts->plane, parts->thickness);
      }
      if (const auto* parts = std::get_if<SeparableExpression>(&models_)) return f(*parts);
      return visit_coupled(f);
    }
  }

  /// Likewise, but every separable potential of built-in parts as the same type: for what is slow
  /// beside asking at each evaluation which they are.
  template <class F>
  decltype(auto) visit_parts(F&& f) const {
    if (const auto* parts = std::get_if<SeparableModels>(&models_))
      return f(std::conditional_t<few_types, SeparableExpression, BuiltInParts>{
          {{parts->plane}}, {{parts->thickness}}});
    if (const auto* parts = std::get_if<SeparableExpression>(&models_)) return f(*parts);
    return visit_coupled(f);
  }

  /// The conditions under which its formulas are defined, and their values at q; none of built-in
  /// models, which are defined at every positive definite q.
  std::vector<ConditionValue> conditions_at(const Stretch& q) const;
  /// Whether these hold and V is a finite number.
  bool defined_at(const Stretch& q) const;
  /// Identities of its formulas that all results take for granted, for they are known at points
  /// only (formula/facts.hpp): a sentence each, mostly none.
  std::vector<std::string> assumptions() const;
  /// Whether these do not hold somewhere in a box: V_alpha, ..., V_rho of the whole formula are
  /// other numbers than those of its models. decimals: of every case within half a unit of the last
  /// place of the coefficients.
  bool assumptions_refuted(const BasicStretch<Interval>& box, bool decimals) const;
  /// Restricted to the part of its domain that q lies in: no number beyond a denominator's zero.
  Potential on_part_of(const Stretch& q) const;

  /// Value, gradient and Hessian at a positive definite q (not checked). The gradient is that of
  /// the whole formula where something is taken for granted. Where the volume is held those of what
  /// is left of V along it (held_volume.hpp).
  PotentialDerivatives<double> derivatives(const Stretch& q) const;
  double value(const Stretch& q) const;

 private:
  struct SeparableModels {
    PlanarPotential plane;
    ThicknessPotential thickness;
  };
  template <class F>
  decltype(auto) visit_coupled(F&& f) const {
    if (!is_isotropic()) throw std::invalid_argument("an isotropic potential");
    if (const auto* coupled = std::get_if<CoupledExpression<>>(&models_)) return f(*coupled);
    if (const auto* body = std::get_if<BodyModel<>>(&models_)) return f(*body);
    return std::visit([&](const auto& model) -> decltype(auto) { return f(model); },
                      std::get<CoupledPotential>(models_));
  }
  /// f(each model that is a formula).
  template <class F>
  void for_formulas(const F& f) const;
  std::variant<SeparableModels, CoupledPotential, SeparableExpression, CoupledExpression<>,
               AnisotropicPotential, BodyModel<>>
      models_;
};

}  // namespace stationary
