// Motions about an axis in no material plane (spatial_balance.hpp), as one kind.
#pragma once

#include <memory>

#include "solver/kind/kind.hpp"

namespace stationary {

std::unique_ptr<Kind> spatial_kind(const Body& body, const Potential& potential,
                                   const SpatialRotation& motion);

}  // namespace stationary
