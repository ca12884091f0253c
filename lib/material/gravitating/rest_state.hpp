// The state of rest of a body with gravity or a held volume (body_model.hpp): a local minimum of
// its potential, not a critical point of any other kind. There may be none (a compressible body
// collapses beyond some g), or several.
#pragma once

#include <array>

#include "lib/material/gravitating/body_model.hpp"

namespace stationary {

/// (xi, zeta, rho) to double precision of the minimum nearest to the sphere of the held volume, or
/// to 1, in the logarithms; xi = zeta where J1 = J2. NaN where none was found among stretches in
/// [1e-3, 1e3] of that sphere's.
std::array<double, 3> rest_state(const BodyModel<>& model);

/// k of the volume's equation for this model: of the size of V's first and second derivatives in the
/// logarithms at that sphere.
double volume_stiffness(const BodyModel<>& model);

}  // namespace stationary
