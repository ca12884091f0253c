#include "lib/material/anisotropic_potential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "lib/material/model_domain.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

struct AsDouble {
  double operator()(double c) const { return c; }
  Direction<double> direction(double degrees) const {
    const auto extended = stationary::direction(degrees);
    return {double(extended.cosine), double(extended.sine)};
  }
};

constexpr auto coefficients_of = [](const auto& model) {
  return static_cast<int>(model.coefficients().size());
};

/// Counts coefficients, and changes one.
struct Replacing {
  int place;
  double value;
  int* next;

  double operator()(double c) const { return (*next)++ == place ? value : c; }
};

}  // namespace

AnisotropicPotential::AnisotropicPotential(const Plane& plane, const AnyThickness<>& thickness,
                                           std::vector<Fibre> fibres)
    : AnisotropicPotential(plane, std::optional(thickness), std::move(fibres)) {}

AnisotropicPotential::AnisotropicPotential(const Plane& plane,
                                           const std::optional<AnyThickness<>>& thickness,
                                           std::vector<Fibre> fibres)
    : fibres_(std::move(fibres)) {
  std::visit([](const auto& model) { require_domain(model); }, plane);
  if (thickness) thickness->visit([](const auto& model) { require_domain(model); });
  model_.base = Model::Separate{plane, thickness};
  if (fibres_.empty() && !std::holds_alternative<OrthotropicSaintVenantKirchhoff<>>(plane) &&
      model_.expression() == nullptr)
    throw std::invalid_argument("a fibre, or an anisotropic plane");
  add_fibres();
}

AnisotropicPotential::AnisotropicPotential(const Coupled& coupled, std::vector<Fibre> fibres)
    : fibres_(std::move(fibres)) {
  std::visit([](const auto& model) { require_domain(model); }, coupled);
  model_.base = coupled;
  if (fibres_.empty() && model_.expression() == nullptr)
    throw std::invalid_argument("a fibre, or an anisotropic potential");
  add_fibres();
}

AnisotropicPotential AnisotropicPotential::of_heavy(const ElasticPart<>& elastic,
                                                    const BodyTerms<double>& body) {
  if (!body.gravitates || elastic.is_fluid())
    throw std::invalid_argument("an elastic body with gravity");
  AnisotropicPotential out;
  if (elastic.plane) {
    const Plane plane = elastic.plane->visit([](const auto& model) -> Plane { return model; });
    out.model_.base = Model::Separate{plane, elastic.thickness};
  } else if (const auto* formula = std::get_if<CoupledExpression<>>(&elastic.coupled)) {
    out.model_.base = Coupled(*formula);
  } else {
    out.model_.base = Coupled(std::get<NeoHookean3d<>>(elastic.coupled));
  }
  return out.with_body(body);
}

void AnisotropicPotential::add_fibres() {
  if (fibres_.size() > Model::max_fibres) throw std::invalid_argument("at most 4 fibres");
  for (const Fibre& fibre : fibres_) {
    if (!(std::isfinite(fibre.k) && fibre.k > 0.0)) throw std::invalid_argument("k > 0");
    if (!std::isfinite(fibre.degrees)) throw std::invalid_argument("degrees finite");
    model_.fibres[model_.fibre_count++] = {fibre.k, AsDouble().direction(fibre.degrees)};
  }
}

AnisotropicPotential AnisotropicPotential::with_body(BodyTerms<double> body) const {
  if (body.gravitates && !(body.g > 0.0 && std::isfinite(body.g)))
    throw std::invalid_argument("g > 0");
  if (body.volume && !(*body.volume > 0.0 && std::isfinite(*body.volume)))
    throw std::invalid_argument("volume > 0");
  const auto* separate = std::get_if<Model::Separate>(&model_.base);
  if (separate != nullptr && !separate->thickness && !body.volume)
    throw std::invalid_argument("a thickness, or a held volume");
  AnisotropicPotential out = *this;
  out.model_.body = body;
  out.set_stiffness();
  return out;
}

/// From V's derivatives in logarithms where it has them, at a cube of that volume.
void AnisotropicPotential::set_stiffness() {
  BodyTerms<double>& body = model_.body;
  if (!body.volume) return;
  Model free = model_;
  free.body.volume.reset();
  const double s = cube_root(*body.volume);
  const auto V = potential_derivatives<2>(free, Stretch{0.0, s, s, s});
  const double size =
      std::max(s * s * V.hessian.cwiseAbs().maxCoeff(), s * V.gradient.cwiseAbs().maxCoeff());
  body.stiffness = size > 0.0 && std::isfinite(size) ? size : 1.0;
}

double AnisotropicPotential::pressure(Stretch q, double c_rho) const {
  const double d = planar_invariants(q).d;
  q.rho = *model_.body.volume / d;
  Model free = model_;
  free.body.volume.reset();
  return (potential_derivatives<1>(free, q).gradient[3] - c_rho * q.rho) / d;
}

bool AnisotropicPotential::is_separable() const {
  return std::holds_alternative<Model::Separate>(model_.base) && !model_.body.any();
}

// The odd part of a fibre's V is 2 k c s alpha (xi + zeta) (c^2 xi^2 + s^2 zeta^2 + alpha^2 - 1).
AnisotropicPotential::OddPart AnisotropicPotential::fibres_odd() const {
  double constant = 0.0;
  double of_cosine = 0.0;
  double size = 0.0;
  for (std::size_t k = 0; k < model_.fibre_count; ++k) {
    const auto& [c, s] = model_.fibres[k].along;
    constant += model_.fibres[k].k * (c * s);
    of_cosine += model_.fibres[k].k * (c * s) * (c * c);
    size += model_.fibres[k].k * std::abs(c * s);
  }
  if (constant == 0.0 && of_cosine == 0.0) return OddPart::none;
  const double largest = std::max(std::abs(constant), std::abs(of_cosine));
  return largest > 0x1p-48 * size ? OddPart::some : OddPart::unknown;
}

bool AnisotropicPotential::even_in_alpha() const {
  const auto* expression = model_.expression();
  return fibres_odd() == OddPart::none && (expression == nullptr || expression->even());
}

bool AnisotropicPotential::shear_free() const {
  const auto* expression = model_.expression();
  return fibres_odd() == OddPart::none && (expression == nullptr || expression->shear_free());
}

// A written-out part is shear-free at all values of its coefficients. Fibres that are for one k or
// angle, along the axes or in pairs, are not for any other but by chance.
bool AnisotropicPotential::keeps_shear_free(int place) const {
  if (!shear_free()) return false;
  if (place < fibre_place() || place >= gravity_place()) return true;
  const auto& fibre = fibres_[static_cast<std::size_t>((place - fibre_place()) / 2)];
  const bool angle = (place - fibre_place()) % 2 == 1;
  return with_coefficient(place, angle ? fibre.degrees + 17.3 : 1.37 * fibre.k).shear_free();
}

bool AnisotropicPotential::sheared() const {
  const auto* expression = model_.expression();
  if (expression == nullptr || expression->shear_free()) return fibres_odd() == OddPart::some;
  return expression->sheared() && fibres_odd() == OddPart::none;
}

std::vector<ConditionValue> AnisotropicPotential::conditions_at(Stretch q) const {
  if (model_.body.volume) q.rho = *model_.body.volume / planar_invariants(q).d;
  std::vector<ConditionValue> out;
  for_models([&](const auto& model) {
    if constexpr (requires { model.conditions_at(q); }) {
      const std::vector<ConditionValue> own = model.conditions_at(q);
      out.insert(out.end(), own.begin(), own.end());
    }
  });
  return out;
}

AnisotropicPotential AnisotropicPotential::on_part_of(Stretch q) const {
  if (model_.body.volume) q.rho = *model_.body.volume / planar_invariants(q).d;
  const auto restrict = [&](auto& models) {
    std::visit(
        [&](auto& model) {
          if constexpr (requires { model.on_part_of(q); }) model = model.on_part_of(q);
        },
        models);
  };
  AnisotropicPotential out = *this;
  if (auto* separate = std::get_if<Model::Separate>(&out.model_.base)) {
    restrict(separate->plane);
    if (separate->thickness) separate->thickness = separate->thickness->on_part_of(q);
  } else {
    restrict(std::get<Coupled>(out.model_.base));
  }
  return out;
}

double AnisotropicPotential::rest_stretch() const {
  if (model_.body.any()) return std::numeric_limits<double>::quiet_NaN();
  const auto own = [](const auto& model) {
    if constexpr (requires { model.shear_free(); }) {
      return std::numeric_limits<double>::quiet_NaN();
    } else {
      return model.rest_stretch();
    }
  };
  if (const auto* separate = std::get_if<Model::Separate>(&model_.base))
    return std::visit(own, separate->plane);
  return std::visit(own, std::get<Coupled>(model_.base));
}

double AnisotropicPotential::rest_thickness() const {
  if (model_.body.any()) return std::numeric_limits<double>::quiet_NaN();
  if (const auto* separate = std::get_if<Model::Separate>(&model_.base))
    return separate->thickness ? separate->thickness->balanced(0.0)
                               : std::numeric_limits<double>::quiet_NaN();
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.shear_free(); }) {
          return std::numeric_limits<double>::quiet_NaN();
        } else {
          return model.rest_thickness();
        }
      },
      std::get<Coupled>(model_.base));
}

int AnisotropicPotential::thickness_place() const {
  if (const auto* separate = std::get_if<Model::Separate>(&model_.base))
    return std::visit(coefficients_of, separate->plane);
  return std::visit(coefficients_of, std::get<Coupled>(model_.base));
}

int AnisotropicPotential::fibre_place() const {
  const auto* separate = std::get_if<Model::Separate>(&model_.base);
  return thickness_place() + (separate == nullptr || !separate->thickness
                                  ? 0
                                  : separate->thickness->visit(coefficients_of));
}

int AnisotropicPotential::coefficient_count() const {
  return volume_place() + (model_.body.volume ? 1 : 0);
}

AnisotropicPotential AnisotropicPotential::with_coefficient(int place, double value) const {
  AnisotropicPotential out = *this;
  int next = 0;
  const Replacing replace{place, value, &next};
  if (auto* separate = std::get_if<Model::Separate>(&out.model_.base)) {
    const auto plane =
        std::visit([&](const auto& each) -> Plane { return with_coefficients(each, replace); },
                   separate->plane);
    separate->plane = plane;
    if (separate->thickness) {
      const auto thickness = separate->thickness->visit(
          [&](const auto& each) { return AnyThickness<>{{with_coefficients(each, replace)}}; });
      separate->thickness = thickness;
    }
  } else {
    const auto coupled =
        std::visit([&](const auto& each) -> Coupled { return with_coefficients(each, replace); },
                   std::get<Coupled>(out.model_.base));
    out.model_.base = coupled;
  }
  for (std::size_t k = 0; k < out.fibres_.size(); ++k) {
    Fibre& fibre = out.fibres_[k];
    fibre.k = replace(fibre.k);
    fibre.degrees = replace(fibre.degrees);
    out.model_.fibres[k] = {fibre.k, AsDouble().direction(fibre.degrees)};
  }
  if (model_.body.any()) {
    out.model_.body = converted(model_.body, replace);
    out.set_stiffness();
  }
  return out;
}

Direction<Conditioned> AsExactConditioned::direction(double degrees) const {
  const auto at = AsDouble().direction(degrees);
  return {{at.cosine}, {at.sine}};
}

Direction<Conditioned> AsConditioned::direction(double degrees) const {
  const auto middle = AsDouble().direction(degrees);
  const double radians = std::abs(degrees) * (std::numbers::pi / 180.0);
  return {{middle.cosine, std::abs(middle.cosine) + std::abs(middle.sine) * radians},
          {middle.sine, std::abs(middle.sine) + std::abs(middle.cosine) * radians}};
}

}  // namespace stationary
