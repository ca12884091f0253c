// Steady rotations about an axis that is not a material one.
#pragma once

#include <optional>

#include "lib/balance/balance.hpp"
#include "lib/body/motion.hpp"

namespace stationary {

struct TiltedRotation {
  TiltPlane plane;
  double nu;  ///< |nu| > 0
};

struct ObliqueRotation {
  double nu;  ///< |nu| > 0
  /// The branch, (i) or (ii), whose axis the family's is at rest, or which it leaves at an event.
  std::optional<Branch> near = std::nullopt;
};

}  // namespace stationary
