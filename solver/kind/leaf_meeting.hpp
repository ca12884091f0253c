// Where two Lambdas of one motion meet (event_functions.hpp) whose modes are those of the leaf
// (symplectic_leaf.hpp), or of parts of it, in any number type.
#pragma once

#include <array>
#include <cstddef>

#include "lib/stability/symplectic_leaf.hpp"
#include "solver/motion/event_functions.hpp"

namespace stationary {

/// What divides the leaf of a motion that turns. Without the first two it is one part.
struct LeafParts {
  bool about_third = false;  ///< nu along axis 3: b; alpha, xi, zeta; rho
  bool straight = false;     ///< about axis 1 or 2, alpha = 0, V even: b, alpha; xi, zeta, rho
  bool coupled = true;       ///< rho is not left to itself
  bool volume_held = false;  ///< rho is no coordinate
};

/// Of a block of the spectrum.
template <class T>
CharacteristicValue<T> leaf_characteristic(const LeafForm<T>& whole, const LeafParts& of,
                                           Block block, const T& Lambda) {
  const auto part = [&](auto... coordinates) {
    constexpr std::size_t n = sizeof...(coordinates);
    const std::size_t pairs = LeafShape{true, of.volume_held}.pairs();
    const std::array<std::size_t, n> places{static_cast<std::size_t>(coordinates)...};
    return value_at(in_squares<n>(leaf_part<n>(whole, pairs, places)), Lambda);
  };
  if (of.about_third) {
    if (block == Block::odd) return part(0);
    if (block == Block::thickness) return part(4);
    return of.coupled && !of.volume_held ? part(1, 2, 3, 4) : part(1, 2, 3);
  }
  if (of.straight) {
    if (block == Block::odd) return part(0, 1);
    return of.volume_held ? part(2, 3) : part(2, 3, 4);
  }
  return of.volume_held ? part(0, 1, 2, 3) : part(0, 1, 2, 3, 4);
}

/// At a motion with these numbers; V_qq along the volume where it is held.
template <class T>
std::array<T, 2> leaf_meeting(const MeetingModes& which, const LeafParts& of, const Inertia3<T>& J,
                              const BasicStretch<T>& q, const Vector3<T>& nu,
                              const Matrix4<T>& V_qq, const T& Lambda) {
  const LeafForm<T> whole = second_variation(J, q, nu, LeafShape{true, of.volume_held}, V_qq);
  const auto first = leaf_characteristic(whole, of, which.first, Lambda);
  return {first.value,
          which.within ? first.slope : leaf_characteristic(whole, of, which.second, Lambda).value};
}

}  // namespace stationary
