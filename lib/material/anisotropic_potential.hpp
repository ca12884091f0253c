// A potential that is no function of the invariants of S: fibres (material/models/fibre.hpp) beside
// an isotropic potential, an orthotropic planar model or a written-out one with or without them,
//
//   V(q) = W(t, l, r) + directed terms in q,
//
// in two layers as potential.hpp has them. AnisotropicModel<C>: all numbers of type C, coefficients
// and state alike; which isotropic model is underneath is looked up at run time, so that everything
// built on it is compiled once for a number type and not once for a model. AnisotropicPotential:
// the numbers as a user gives them, the facts, and models in any number type made of them.
//
// Any isotropic part may be written out by its user too (material/models/expression.hpp). Gravity
// and a held volume may stand beside (gravitating/body_terms.hpp); with the latter the thickness may
// be left out.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "lib/material/gravitating/body_terms.hpp"
#include "lib/material/gravitating/elastic_part.hpp"
#include "lib/material/models/anisotropic_expression.hpp"
#include "lib/material/models/any_model.hpp"
#include "lib/material/models/coefficients.hpp"
#include "lib/material/models/fibre.hpp"
#include "lib/material/models/isotropic_models.hpp"
#include "lib/material/models/orthotropic_saint_venant_kirchhoff.hpp"
#include "lib/material/models/potential_derivatives.hpp"
#include "lib/number/first_order_bound.hpp"

namespace stationary {

/// Planar models of an anisotropic potential: those of an isotropic one too.
template <class C>
using OrientedPlanarModels =
    std::variant<ReciprocalDeterminant<C>, SaintVenantKirchhoff<C>, Biot<C>, BiotLog<C>,
                 NeoHookean<C>, Hencky<C>, OrthotropicSaintVenantKirchhoff<C>, PlanarExpression<C>,
                 OrientedExpression<C>>;
template <class C>
using OrientedCoupledModels =
    std::variant<NeoHookean3d<C>, CoupledExpression<C>, OrientedExpression<C>>;

/// What does not depend on the axes and what does; gravity by its own variables.
template <class C>
struct AnisotropicDerivatives {
  CoupledDerivatives<C> isotropic;
  PotentialDerivatives<C> directed;
  struct Gravity {
    CoupledDerivatives<C> V;  ///< gravity_derivatives()
    GravitatingInertia<C> J;
  };
  std::optional<Gravity> gravity;
};

template <class C>
struct AnisotropicModel {
  struct Separate {
    OrientedPlanarModels<C> plane;
    std::optional<AnyThickness<C>> thickness;  ///< nothing: V has no part in rho
  };
  static constexpr std::size_t max_fibres = 4;

  std::variant<Separate, OrientedCoupledModels<C>> base;
  std::array<FibreTerm<C>, max_fibres> fibres{};
  std::size_t fibre_count = 0;
  BodyTerms<C> body;

  /// The part that is a written-out anisotropic one, or nullptr.
  const OrientedExpression<C>* expression() const {
    if (const auto* separate = std::get_if<Separate>(&base))
      return std::get_if<OrientedExpression<C>>(&separate->plane);
    return std::get_if<OrientedExpression<C>>(&std::get<OrientedCoupledModels<C>>(base));
  }

  /// Whether a written-out part is defined nowhere in a box.
  bool outside_box(const BasicStretch<C>& q) const {
    return any_part([&](const auto& m) -> decltype(m.outside_box(q)) { return m.outside_box(q); });
  }
  /// Whether a written-out part has decimals (TapeModel::has_decimals).
  bool has_decimals() const {
    return any_part([](const auto& m) -> decltype(m.has_decimals()) { return m.has_decimals(); });
  }
  /// Likewise TapeModel::has_conditions.
  bool has_conditions() const {
    return any_part(
        [](const auto& m) -> decltype(m.has_conditions()) { return m.has_conditions(); });
  }
  /// Whether it is so of a part that can be asked.
  template <class Question>
  bool any_part(const Question& question) const {
    const auto of = [&](const auto& model) {
      if constexpr (std::is_invocable_v<const Question&, decltype(model)>) {
        return question(model);
      } else {
        return false;
      }
    };
    if (const auto* separate = std::get_if<Separate>(&base))
      return std::visit(of, separate->plane) ||
             (separate->thickness && separate->thickness->visit(of));
    return std::visit(of, std::get<OrientedCoupledModels<C>>(base));
  }

  /// Gravity included, as if no volume were held. x: the invariants of q, which a caller may know
  /// better than by its entries.
  template <int order>
  AnisotropicDerivatives<C> evaluate(const PlanarInvariants<C>& x, const BasicStretch<C>& q) const;
};

template <class C>
template <int order>
AnisotropicDerivatives<C> AnisotropicModel<C>::evaluate(const PlanarInvariants<C>& x,
                                                        const BasicStretch<C>& q) const {
  const C none(0.0);
  AnisotropicDerivatives<C> out;
  out.isotropic = {{none, none, none, none, none, none}, none, none, none, none};
  out.directed = {none, Vector4<C>::Constant(none), Matrix4<C>::Constant(none)};
  const auto take = [&](const auto& model) {
    if constexpr (requires { model.template isotropic<order>(x, q.rho); })
      out.isotropic = model.template isotropic<order>(x, q.rho);
    if constexpr (requires { model.template add<order>(q, out.directed); }) {
      model.template add<order>(q, out.directed);
    } else if constexpr (requires { model.template evaluate<order>(x, q.rho); }) {
      out.isotropic = model.template evaluate<order>(x, q.rho);
    } else {
      out.isotropic.plane = model.template evaluate<order>(x);
    }
  };
  if (const auto* separate = std::get_if<Separate>(&base)) {
    std::visit(take, separate->plane);
    out.isotropic.w_r = out.isotropic.w_rr = none;
    if (separate->thickness) {
      const auto axial = separate->thickness->template evaluate<order>(q.rho);
      out.isotropic.plane.w = out.isotropic.plane.w + axial.v;
      out.isotropic.w_r = axial.v_r;
      out.isotropic.w_rr = axial.v_rr;
    }
    out.isotropic.w_tr = out.isotropic.w_lr = none;
  } else {
    std::visit(take, std::get<OrientedCoupledModels<C>>(base));
  }
  for (std::size_t k = 0; k < fibre_count; ++k) fibres[k].template add<order>(q, out.directed);
  if (body.gravitates)
    out.gravity = {gravity_derivatives<order>(body.g, body.J, planar_moment(body.J, q), x.d, q.rho),
                   body.J};
  return out;
}

// Compiled once, as those of its models (built_in_model.hpp).
#define STATIONARY_COMPILED_MODEL(keyword, C)                         \
  keyword AnisotropicDerivatives<C> AnisotropicModel<C>::evaluate<1>( \
      const PlanarInvariants<C>&, const BasicStretch<C>&) const;      \
  keyword AnisotropicDerivatives<C> AnisotropicModel<C>::evaluate<2>( \
      const PlanarInvariants<C>&, const BasicStretch<C>&) const;
#define STATIONARY_COMPILED_MODELS(keyword)        \
  STATIONARY_COMPILED_MODEL(keyword, double)       \
  STATIONARY_COMPILED_MODEL(keyword, DoubleDouble) \
  STATIONARY_COMPILED_MODEL(keyword, Interval)     \
  STATIONARY_COMPILED_MODEL(keyword, Conditioned)
STATIONARY_COMPILED_MODELS(extern template)

/// Of the whole V, along a held volume; order as in evaluate().
template <int order, class C>
PotentialDerivatives<C> potential_derivatives(const AnisotropicModel<C>& model, BasicStretch<C> q) {
  if (model.body.volume) q.rho = *model.body.volume / planar_invariants(q).d;
  const AnisotropicDerivatives<C> parts = model.template evaluate<order>(planar_invariants(q), q);
  PotentialDerivatives<C> out = in_stretch<order>(parts.isotropic, q);
  out.value += parts.directed.value;
  if constexpr (order >= 1) out.gradient += parts.directed.gradient;
  if constexpr (order >= 2) out.hessian += parts.directed.hessian;
  if (parts.gravity) add_gravity<order>(parts.gravity->V, parts.gravity->J, q, out);
  return model.body.volume ? along_volume<order>(out, q) : out;
}

class AnisotropicPotential {
 public:
  using Plane = OrientedPlanarModels<double>;
  using Coupled = OrientedCoupledModels<double>;
  using Model = AnisotropicModel<double>;

  /// Throw std::invalid_argument with the violated inequality: of the models' domains, k > 0 and
  /// finite degrees of each fibre, at most Model::max_fibres of them, at least one where the rest
  /// is isotropic.
  AnisotropicPotential(const Plane& plane, const AnyThickness<>& thickness,
                       std::vector<Fibre> fibres);
  AnisotropicPotential(const Plane& plane, const ThicknessPotential& thickness,
                       std::vector<Fibre> fibres)
      : AnisotropicPotential(plane, AnyThickness<>{{thickness}}, std::move(fibres)) {}
  AnisotropicPotential(const Coupled& coupled, std::vector<Fibre> fibres);
  /// Without a thickness: where a volume is held.
  AnisotropicPotential(const Plane& plane, const std::optional<AnyThickness<>>& thickness,
                       std::vector<Fibre> fibres);

  /// Of an isotropic body with gravity: what its J1 != J2 makes of it. Throws std::invalid_argument unless
  /// it gravitates and is no fluid.
  static AnisotropicPotential of_heavy(const ElasticPart<>& elastic, const BodyTerms<double>& body);

  /// With gravity (J that of the body) or a held volume. Throws std::invalid_argument unless g > 0
  /// and volume > 0 where there are, and without a thickness a volume is held.
  AnisotropicPotential with_body(BodyTerms<double> body) const;
  const BodyTerms<double>& body() const { return model_.body; }

  /// The multiplier P of det S = C (BodyModel::pressure). c_rho: the centrifugal rate of rho. Only of
  /// a held volume.
  double pressure(Stretch q, double c_rho) const;

  /// V = V_plane(alpha, xi, zeta) + V_rho(rho).
  bool is_separable() const;
  /// Whether V(-alpha, xi, zeta, rho) = V(alpha, ...) is established: the material axes 1, 2 are
  /// axes of symmetry.
  bool even_in_alpha() const;
  /// Whether V_alpha = 0 at alpha = 0, for all xi, zeta, rho, is established; without a written-out
  /// part the same as even_in_alpha().
  bool shear_free() const;
  /// Whether that is so whatever the coefficient at this place is; -1: none. Where it is,
  /// even_in_alpha() is kept too.
  bool keeps_shear_free(int place) const;
  /// Whether it is established that V_alpha != 0 somewhere at alpha = 0. Neither may be, of a
  /// written-out model.
  bool sheared() const;

  /// The conditions of a written-out part and their values at q, at the volume held.
  std::vector<ConditionValue> conditions_at(Stretch q) const;
  /// Restricted to the part of its domain that q lies in.
  AnisotropicPotential on_part_of(Stretch q) const;

  const std::vector<Fibre>& fibres() const { return fibres_; }
  /// xi = zeta at rest without fibres, and rho (separable: of the thickness at nu = 0); NaN where a
  /// written-out model has none that is known.
  double rest_stretch() const;
  double rest_thickness() const;

  /// The number of coefficients: plane (or coupled), thickness, k and degrees of each fibre, then g,
  /// J1, J2, J3 where it gravitates, and the volume where it is held.
  int coefficient_count() const;
  /// Of the whole: the place of the first coefficient of the thickness, and of the fibres.
  int thickness_place() const;
  int fibre_place() const;
  int gravity_place() const { return fibre_place() + 2 * static_cast<int>(fibres_.size()); }
  int volume_place() const { return gravity_place() + (model_.body.gravitates ? 4 : 0); }
  AnisotropicPotential with_coefficient(int place, double value) const;

  const Model& model() const { return model_; }

  /// f(each of its models but the fibres), as its own type.
  template <class F>
  void for_models(const F& f) const {
    if (const auto* separate = std::get_if<typename Model::Separate>(&model_.base)) {
      std::visit(f, separate->plane);
      if (separate->thickness) separate->thickness->visit(f);
    } else {
      std::visit(f, std::get<Coupled>(model_.base));
    }
  }

  /// The model in another number type: convert(c) of each coefficient c in their order, and
  /// convert.direction(degrees) of each angle.
  template <class Convert>
  auto model(const Convert& convert) const {
    using C = std::remove_cvref_t<decltype(convert(1.0))>;
    AnisotropicModel<C> out;
    if (const auto* separate = std::get_if<typename Model::Separate>(&model_.base)) {
      OrientedPlanarModels<C> plane = std::visit(
          [&](const auto& each) -> OrientedPlanarModels<C> {
            return with_coefficients(each, convert);
          },
          separate->plane);
      std::optional<AnyThickness<C>> thickness;
      if (separate->thickness)
        thickness = separate->thickness->visit(
            [&](const auto& each) { return AnyThickness<C>{{with_coefficients(each, convert)}}; });
      out.base = typename AnisotropicModel<C>::Separate{std::move(plane), std::move(thickness)};
    } else {
      out.base = std::visit(
          [&](const auto& each) -> OrientedCoupledModels<C> {
            return with_coefficients(each, convert);
          },
          std::get<Coupled>(model_.base));
    }
    for (const Fibre& fibre : fibres_) {
      const C k = convert(fibre.k);
      out.fibres[out.fibre_count++] = {k, convert.direction(fibre.degrees)};
    }
    out.body = converted(model_.body, convert);
    return out;
  }

 private:
  template <class Convert>
  static auto converted(const BodyTerms<double>& body, const Convert& convert) {
    BodyTerms<std::remove_cvref_t<decltype(convert(1.0))>> out;
    out.gravitates = body.gravitates;
    out.stiffness = body.stiffness;
    if (body.gravitates) {
      out.g = convert(body.g);
      out.J.J1 = convert(body.J.J1);
      out.J.J2 = convert(body.J.J2);
      out.J.J3 = convert(body.J.J3);
    }
    if (body.volume) out.volume = convert(*body.volume);
    return out;
  }

  AnisotropicPotential() = default;
  void add_fibres();
  void set_stiffness();
  /// What is left of the odd parts, in alpha, of all fibres' V; unknown: no more than rounding.
  enum class OddPart { none, unknown, some };
  OddPart fibres_odd() const;

  std::vector<Fibre> fibres_;
  Model model_;
};

/// Coefficients as they are, the angle's functions in extended precision.
struct AsExtended {
  DoubleDouble operator()(double c) const { return c; }
  Direction<DoubleDouble> direction(double degrees) const { return stationary::direction(degrees); }
};

/// As exact numbers of a Conditioned computation.
struct AsExactConditioned {
  Conditioned operator()(double c) const { return {c}; }
  Direction<Conditioned> direction(double degrees) const;
};

/// As inputs of a Conditioned computation.
struct AsConditioned {
  Conditioned operator()(double c) const { return Conditioned::input(c); }
  Direction<Conditioned> direction(double degrees) const;
};

}  // namespace stationary
