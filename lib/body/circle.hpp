// Which section of the figure is a circle all along a sheet: two stretches are equal, and what
// would make them differ has no part in the sheet.
//
//   xi = zeta     J1 = J2, branch (iii): the event `ellipse` breaks it
//   zeta = rho    J2 = J3, branch (i), V symmetric in the two: `ellipse-23`
//   xi = rho      J1 = J3, branch (ii), likewise: `ellipse-13`
#pragma once

#include <cmath>
#include <cstdint>

#include "lib/body/stretch.hpp"

namespace stationary {

enum class Circle : std::uint8_t { none, xi_zeta, xi_rho, zeta_rho };

/// The places of the equal stretches among (xi, zeta, rho), and of the third.
struct CirclePlaces {
  int first;
  int second;
  int other;
};
constexpr CirclePlaces places(Circle circle) {
  switch (circle) {
    case Circle::xi_rho:
      return {0, 2, 1};
    case Circle::zeta_rho:
      return {1, 2, 0};
    default:
      return {0, 1, 2};
  }
}

/// Whether the two stretches are equal; within: of their relative difference.
inline bool is_on(Circle circle, const Stretch& q, double within = 0.0) {
  if (circle == Circle::none) return false;
  const double x[3] = {q.xi, q.zeta, q.rho};
  const CirclePlaces at = places(circle);
  return std::abs(x[at.first] - x[at.second]) <= within * x[at.first];
}

}  // namespace stationary
