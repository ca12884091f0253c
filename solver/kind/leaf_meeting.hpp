// Where two Lambdas of one motion meet (event_functions.hpp) whose modes are those of the leaf
// (symplectic_leaf.hpp), or of parts of it, in any number type.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "lib/stability/leaf_parts.hpp"
#include "solver/motion/event_functions.hpp"

namespace stationary {

/// Of a block of the spectrum.
template <class T>
CharacteristicValue<T> leaf_characteristic(const LeafForm<T>& whole, const LeafParts& of,
                                           Block block, const T& Lambda) {
  CharacteristicValue<T> out;
  for_each_leaf_part(of, [&](Block own, const auto& coordinates) {
    if (own != block) return;
    constexpr std::size_t n = std::tuple_size_v<std::decay_t<decltype(coordinates)>>;
    out = value_at(in_squares<n>(leaf_part(whole, of.shape().pairs(), coordinates)), Lambda);
  });
  return out;
}

/// At a motion with these numbers; V_qq along the volume where it is held.
template <class T>
std::array<T, 2> leaf_meeting(const MeetingModes& which, const LeafParts& of, const Inertia3<T>& J,
                              const BasicStretch<T>& q, const Vector3<T>& nu,
                              const Matrix4<T>& V_qq, const T& Lambda) {
  const LeafForm<T> whole = second_variation(J, q, nu, of.shape(), V_qq);
  const auto first = leaf_characteristic(whole, of, which.first, Lambda);
  return {first.value,
          which.within ? first.slope : leaf_characteristic(whole, of, which.second, Lambda).value};
}

}  // namespace stationary
