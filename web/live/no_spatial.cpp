// In the place of motions about an axis in no plane, whose equations over duals of every kind would be a
// thirtieth of a page: a page shows their tables.
#include <stdexcept>

#include "solver/kind/spatial_kind.hpp"

namespace stationary {

std::unique_ptr<Kind> spatial_kind(const Body&, const Potential&, const SpatialRotation&) {
  throw std::invalid_argument("axes in no plane (plane \"123\") are solved by the program alone");
}

}  // namespace stationary
