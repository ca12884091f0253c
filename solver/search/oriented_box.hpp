// The box in which motions of a potential that need not be isotropic are sought, in the unknowns of
// oriented_system.hpp: as wide in alpha as the stretches are, and half a turn of the axis.
#pragma once

#include <cstddef>
#include <numbers>

#include "solver/motion/oriented_system.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/search/search.hpp"

namespace stationary {

template <class Layout>
Box<Layout::dimension> oriented_box(const SearchOptions& options) {
  const auto index = [](int place) { return static_cast<std::size_t>(place); };
  Box<Layout::dimension> out;
  out[0] = options.range(0);
  out[1] = options.range(1);
  if constexpr (Layout::thickness) out[index(Layout::thickness_place)] = options.range(2);
  if constexpr (Layout::alpha) {
    const double most = options.most_shear();
    out[index(Layout::alpha_place)] = {1.0 / most, most};
  }
  // Half a turn, whose ends are no material axis.
  if constexpr (Layout::axis)
    out[index(Layout::axis_place)] = {axis_coordinate(-0.25 * std::numbers::pi) * (1.0 - 1e-12),
                                      axis_coordinate(0.75 * std::numbers::pi) * (1.0 + 1e-12)};
  return out;
}

}  // namespace stationary
