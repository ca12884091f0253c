// Plane and thickness of an isotropic separable potential, whichever of them are built in.
#pragma once

#include <optional>
#include <type_traits>

#include "lib/material/potential.hpp"

namespace stationary {

/// Nothing of any other potential.
inline std::optional<SeparableExpression> separable_parts(const Potential& potential) {
  if (!potential.is_isotropic() || !potential.is_separable()) return std::nullopt;
  return potential.visit([](const auto& model) -> std::optional<SeparableExpression> {
    if constexpr (std::is_same_v<std::decay_t<decltype(model)>, SeparableExpression>) {
      return model;
    } else if constexpr (requires { model.plane; }) {
      return SeparableExpression{AnyPlane<>{{PlanarPotential(model.plane)}},
                                 AnyThickness<>{{ThicknessPotential(model.thickness)}}};
    } else {
      return std::nullopt;
    }
  });
}

}  // namespace stationary
