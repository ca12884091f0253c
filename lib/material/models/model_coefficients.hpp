// A model with its coefficients as numbers of another type: inputs of a computation that asks what
// they do to it (conditioning), or that they are known to half a unit of their last place
// (intervals).
#pragma once

#include <utility>

#include "lib/material/models/coefficients.hpp"
#include "lib/material/models/isotropic_models.hpp"
#include "lib/material/models/separable.hpp"

namespace stationary {

/// convert(c) of each coefficient c of both parts; of one model: coefficients.hpp.
template <class Plane, class Thickness, class Convert>
auto with_coefficients(const Separable<Plane, Thickness>& model, const Convert& convert) {
  const auto plane = with_coefficients(model.plane, convert);
  const auto thickness = with_coefficients(model.thickness, convert);
  return Separable<std::remove_cv_t<decltype(plane)>, std::remove_cv_t<decltype(thickness)>>{
      plane, thickness};
}

}  // namespace stationary
