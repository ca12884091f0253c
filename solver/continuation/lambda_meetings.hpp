// Which Lambdas met between two points of a curve, by what is certain at the two.
//
// Along a curve a Lambda of a block comes to zero, or through it, only where an event says so; else real
// Lambdas change their number by two where two meet and become complex, or the reverse. Negative ones have
// each a signature, which stays: two of opposite signatures that have changed their order have met.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <optional>

#include "solver/motion/event.hpp"

namespace stationary {

/// How many more Lambdas of a block one point has than another: real ones, negative ones, and such as may be 0.
struct CompositionChange {
  int real;
  int negative;
  int zeros;

  static CompositionChange of(std::size_t block, const TestValues& from, const TestValues& to) {
    const auto& a = from.composition[block];
    const auto& b = to.composition[block];
    return {b[0] - a[0], b[1] - a[1], to.zeros[block] - from.zeros[block]};
  }
};

/// Whether TestValues::gaps at two points are of the same Lambdas, as far as their numbers tell.
inline bool same_pairs(const TestValues& a, const TestValues& b) {
  return std::ranges::equal(
      a.composition, b.composition, {}, [](const auto& counts) { return counts[0]; },
      [](const auto& counts) { return counts[0]; });
}

/// Whether two Lambdas of a block that are negative at one end of a step are not at the other: one passes
/// zero, or comes to it, only where an event says so; two together went round it, as a complex pair. Or
/// whether four that are real at one end are complex at the other, of two meetings.
inline bool pairs_changed_sides(const TestValues& from, const TestValues& to) {
  for (std::size_t block = 0; block < from.composition.size(); ++block) {
    const auto change = CompositionChange::of(block, from, to);
    if (change.real == 0 && std::abs(change.negative) > std::max(1, std::abs(change.zeros)))
      return true;
    if (std::abs(change.real) >= 4) return true;
  }
  return false;
}

/// Of Lambdas that met between two points: negative ones or others, by what is complex at one and real at the
/// other; nothing where that does not tell.
inline std::optional<EventType> met_between(const TestValues& from, const TestValues& to) {
  int real = 0;
  int negative = 0;
  for (std::size_t block = 0; block < from.composition.size(); ++block) {
    const auto change = CompositionChange::of(block, from, to);
    real += change.real;
    negative += change.negative;
  }
  if (std::abs(real) != 2) return std::nullopt;
  if (negative == 0) return EventType::real_collision;
  if (negative == real) return EventType::hamiltonian_hopf;
  return std::nullopt;
}

/// Whether negative Lambdas of opposite signatures stand in another order at the other end of a step, in some
/// block whose real Lambdas are as many: they met. One that has come to zero was the nearest to it, and is left
/// out.
inline bool order_changed(const TestValues& from, const TestValues& to) {
  const unsigned certain = from.signed_blocks & to.signed_blocks;
  for (std::size_t block = 0; block < from.signatures.size(); ++block) {
    if (((certain >> block) & 1U) == 0) continue;
    const auto change = CompositionChange::of(block, from, to);
    if (change.real != 0 || std::abs(change.negative) > std::abs(change.zeros)) continue;
    const auto shared = std::min(from.composition[block][1], to.composition[block][1]);
    const unsigned last = (1U << shared) - 1U;
    const unsigned a = from.signatures[block] & last;
    const unsigned b = to.signatures[block] & last;
    // As many of each: else one has touched zero and has another signature since.
    if (a != b && (change.negative != 0 || std::popcount(a) == std::popcount(b))) return true;
  }
  return false;
}

}  // namespace stationary
