#include "solver/batch/oriented_lanes.hpp"

#include <variant>

namespace stationary {

std::optional<OrientedLane> oriented_lane(const Body& body, Branch branch,
                                          const OrientedModels& models) {
  using Model = AnisotropicModel<double>;
  const Model& V = models.plain;
  const auto* separate = std::get_if<Model::Separate>(&V.base);
  if (separate == nullptr || !separate->thickness || V.body.any()) return std::nullopt;
  OrientedLane out{.inertia = {body.J1, body.J2, body.J3}, .branch = branch};
  const bool plane = std::visit(
      [&](const auto& model) {
        if constexpr (std::is_constructible_v<PlanarPotential, decltype(model)>) {
          out.plane_model = PlanarPotential(model).index();
          out.plane = model.coefficients();
          return true;
        } else {
          return false;
        }
      },
      separate->plane);
  const bool thickness = separate->thickness->visit([&](const auto& model) {
    if constexpr (std::is_constructible_v<ThicknessPotential, decltype(model)>) {
      out.harmonic = std::is_same_v<std::remove_cvref_t<decltype(model)>, Harmonic<double>>;
      out.thickness = model.coefficients();
      return true;
    } else {
      return false;
    }
  });
  if (!plane || !thickness) return std::nullopt;
  for (const Fibre& fibre : models.potential.fibres()) {
    const auto turned = CoefficientDuals{0, true}.direction(fibre.degrees);
    out.fibre[out.fibres] = {fibre.k,
                             V.fibres[out.fibres].along,
                             models.extended.fibres[out.fibres].along,
                             {turned.cosine.slope[0], turned.sine.slope[0]}};
    ++out.fibres;
  }
  return out;
}

}  // namespace stationary
