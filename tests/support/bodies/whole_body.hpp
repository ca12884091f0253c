// Isotropic elastic bodies with gravity or a held volume.
#pragma once

#include <optional>

#include "lib/material/potential.hpp"

namespace stationary::testing {

/// An elastic body that gravitates, or whose volume is held, or both.
inline Potential whole_body(const AnyPlane<>& plane, const AnyThickness<>& thickness,
                            std::optional<double> volume, std::optional<double> g,
                            const Body& body) {
  BodyModel<> model;
  model.elastic.plane = plane;
  model.elastic.thickness = thickness;
  model.volume = volume;
  if (g) {
    model.gravitates = true;
    model.g = *g;
    model.J = {body.J1, body.J2, body.J3};
  }
  return Potential(model);
}
inline Potential held(const AnyPlane<>& plane, const AnyThickness<>& thickness) {
  return whole_body(plane, thickness, 1.0, {}, Body(1.0, 1.0, 1.0));
}

}  // namespace stationary::testing
