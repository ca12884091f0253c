#include "solver/batch/oriented_lanes.hpp"

#include <type_traits>
#include <variant>

namespace stationary {

std::optional<OrientedLane> oriented_lane(const Body& body, Branch branch,
                                          const AnisotropicPotential& V) {
  using Model = AnisotropicModel<double>;
  const Model& model = V.model();
  const auto* separate = std::get_if<Model::Separate>(&model.base);
  if (separate == nullptr || !separate->thickness || model.body.any()) return std::nullopt;
  OrientedLane out{.inertia = {body.J1, body.J2, body.J3}, .branch = branch};
  const bool plane = std::visit(
      [&](const auto& each) {
        if constexpr (std::is_constructible_v<PlanarPotential, decltype(each)>) {
          out.plane_model = PlanarPotential(each).index();
          out.plane = each.coefficients();
          return true;
        } else {
          return false;
        }
      },
      separate->plane);
  const bool thickness = separate->thickness->visit([&](const auto& each) {
    if constexpr (std::is_constructible_v<ThicknessPotential, decltype(each)>) {
      out.harmonic = std::is_same_v<std::remove_cvref_t<decltype(each)>, Harmonic<double>>;
      out.thickness = each.coefficients();
      return true;
    } else {
      return false;
    }
  });
  if (!plane || !thickness) return std::nullopt;
  for (const Fibre& fibre : V.fibres()) {
    const auto turned = CoefficientDuals{0, true}.direction(fibre.degrees);
    out.fibre[out.fibres] = {fibre.k,
                             model.fibres[out.fibres].along,
                             AsExtended().direction(fibre.degrees),
                             {turned.cosine.slope[0], turned.sine.slope[0]}};
    ++out.fibres;
  }
  return out;
}

}  // namespace stationary
