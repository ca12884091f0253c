// Plates with fibres whose families are followed.
#pragma once

#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/plate.hpp"

namespace stationary::testing {

/// Of `plate`.
inline const Potential skew_fibres = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
inline const Potential fibres_along = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 0.0);
/// One whose ellipse turns away from its axes.
inline const Body turning_plate(1.0, 1.2, 0.6);
inline const Potential fibres_across = fibred(Hencky<>{1.0, 0.6}, 0.05, 90.0);

}  // namespace stationary::testing
