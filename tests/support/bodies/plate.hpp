// The body of most tests: three different inertias, thin.
#pragma once

#include "lib/body/body.hpp"
#include "lib/material/potential.hpp"

namespace stationary::testing {

inline const Body plate(1.0, 1.7, 0.6);
inline const ReciprocalQuadratic<> plate_thickness{1.0, 3.0};

}  // namespace stationary::testing
