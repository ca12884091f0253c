#include "solver/batch/batch_input.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/material/models/coefficients.hpp"
#include "solver/newton/thickness_balance.hpp"

namespace stationary {
namespace {

std::vector<LaneValues> in_all_lanes(const auto& coefficients) {
  return {coefficients.begin(), coefficients.end()};
}

template <class Model>
Model at_lane(const Model& model, const std::vector<LaneValues>& values, std::size_t lane) {
  return with_indexed_coefficients(model, [&](double, std::size_t k) { return values[k][lane]; });
}

/// A potential that is not isotropic, with these coefficients.
AnisotropicPotential at_lane(const AnisotropicPotential& V, const BatchInput& values,
                             std::size_t lane) {
  std::vector<Fibre> fibres;
  for (std::size_t k = 0; k + 1 < values.fibres.size(); k += 2)
    fibres.push_back({values.fibres[k][lane], values.fibres[k + 1][lane]});
  const auto in_lane = [&]<class Models>(const Models& models) {
    return std::visit([&](const auto& each) -> Models { return at_lane(each, values.plane, lane); },
                      models);
  };
  const auto elastic = [&]() -> AnisotropicPotential {
    const auto* separate = std::get_if<AnisotropicPotential::Model::Separate>(&V.model().base);
    if (separate == nullptr)
      return {in_lane(std::get<AnisotropicPotential::Coupled>(V.model().base)), std::move(fibres)};
    std::optional<AnyThickness<>> thickness;
    if (separate->thickness) thickness = at_lane(*separate->thickness, values.thickness, lane);
    return {in_lane(separate->plane), thickness, std::move(fibres)};
  };
  BodyTerms<double> body = V.body();
  if (!body.any()) return elastic();
  if (body.gravitates) {
    body.g = values.plane[BodyModel<>::g_place][lane];
    body.J = {values.inertia[0][lane], values.inertia[1][lane], values.inertia[2][lane]};
  }
  if (body.volume) body.volume = values.plane[BodyModel<>::volume_place][lane];
  return elastic().with_body(body);
}

bool the_same_in_all(const std::vector<LaneValues>& values) {
  return std::ranges::all_of(values, [](const LaneValues& each) { return each.size() == 1; });
}

}  // namespace

BatchInput::BatchInput(const Problem& problem, std::size_t lane_count,
                       std::vector<double> nu_values)
    : branch(problem.branch()),
      potential(problem.potential()),
      lanes(lane_count),
      inertia{problem.body().J1, problem.body().J2, problem.body().J3},
      nu(std::move(nu_values)) {
  if (!potential.is_isotropic()) {
    const AnisotropicPotential& V = potential.anisotropic();
    const auto parts = [this](const auto& model) { plane = in_all_lanes(model.coefficients()); };
    if (const auto* separate =
            std::get_if<AnisotropicPotential::Model::Separate>(&V.model().base)) {
      std::visit(parts, separate->plane);
      if (separate->thickness) thickness = in_all_lanes(separate->thickness->coefficients());
    } else {
      std::visit(parts, std::get<AnisotropicPotential::Coupled>(V.model().base));
    }
    if (V.body().any()) {
      plane.resize(BodyModel<>::places, LaneValues(0.0));
      plane[BodyModel<>::g_place] = LaneValues(V.body().g);
      if (V.body().volume) plane[BodyModel<>::volume_place] = LaneValues(*V.body().volume);
    }
    for (const Fibre& fibre : V.fibres()) {
      fibres.emplace_back(fibre.k);
      fibres.emplace_back(fibre.degrees);
    }
    return;
  }
  potential.visit([this](const auto& model) {
    if constexpr (requires { model.plane; }) {
      plane = in_all_lanes(model.plane.coefficients());
      thickness = in_all_lanes(model.thickness.coefficients());
    } else {
      plane = in_all_lanes(model.coefficients());
    }
  });
}

void BatchInput::vary(const FamilyParameter& what, std::vector<double> values) {
  const auto k = static_cast<std::size_t>(what.index);
  switch (what.kind) {
    case FamilyParameter::Kind::inertia:
      inertia[k] = std::move(values);
      break;
    case FamilyParameter::Kind::plane:
      plane[k] = std::move(values);
      break;
    case FamilyParameter::Kind::thickness:
      thickness[k] = std::move(values);
      break;
    case FamilyParameter::Kind::shared:
      plane[k] = values;
      thickness[k] = std::move(values);
      break;
    case FamilyParameter::Kind::fibre:
      fibres[k] = std::move(values);
      break;
    case FamilyParameter::Kind::nu:
      break;
  }
}

Potential BatchInput::potential_at(std::size_t lane) const {
  if (!potential.is_isotropic()) return Potential(at_lane(potential.anisotropic(), *this, lane));
  return potential.visit([&](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (requires { model.plane; }) {
      const auto first = at_lane(model.plane, plane, lane);
      const auto second = at_lane(model.thickness, thickness, lane);
      if constexpr (several_thicknesses<Model>) {
        return Potential(Model{first, second});
      } else {
        return Potential(PlanarPotential(first), ThicknessPotential(second));
      }
    } else if constexpr (is_body_model<Model>) {
      Model body = at_lane(model, plane, lane);
      body.J = {inertia[0][lane], inertia[1][lane], inertia[2][lane]};
      return Potential(body);
    } else if constexpr (std::is_same_v<Model, CoupledExpression<>>) {
      return Potential(at_lane(model, plane, lane));
    } else {
      return Potential(CoupledPotential(at_lane(model, plane, lane)));
    }
  });
}

Problem BatchInput::problem(std::size_t lane) const {
  return {Body(inertia[0][lane], inertia[1][lane], inertia[2][lane]), potential_at(lane), branch};
}

void require_valid(const BatchInput& input) {
  const auto require_size = [&](const LaneValues& values) {
    if (values.size() != 1 && values.size() != input.lanes)
      throw std::invalid_argument("one value for all lanes, or one each");
  };
  const BatchInput own(Problem({1.0, 1.0, 1.0}, input.potential, input.branch), 1, {});
  if (input.plane.size() != own.plane.size() || input.thickness.size() != own.thickness.size() ||
      input.fibres.size() != own.fibres.size())
    throw std::invalid_argument("as many coefficients as the models have");
  for (const auto* values : {&input.plane, &input.thickness, &input.fibres})
    for (const LaneValues& each : *values) require_size(each);
  for (const LaneValues& each : input.inertia) require_size(each);
  require_size(input.speed);
  for (std::size_t lane = 0; lane < input.lanes; ++lane) {
    Body(input.inertia[0][lane], input.inertia[1][lane], input.inertia[2][lane]);
    if (!std::isfinite(input.speed[lane])) throw std::invalid_argument("speed finite");
  }
  if (!std::ranges::all_of(input.nu, [](double nu) { return std::isfinite(nu); }))
    throw std::invalid_argument("nu finite");
  // Making a potential checks its domain.
  const bool one = the_same_in_all(input.plane) && the_same_in_all(input.thickness) &&
                   the_same_in_all(input.fibres);
  for (std::size_t lane = 0; lane < (one ? 1 : input.lanes); ++lane) input.potential_at(lane);
}

}  // namespace stationary
