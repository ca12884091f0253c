// Frequencies and growth rates along a piece as curves. The table orders the modes of a row by
// their size; along a curve a mode keeps its Krein signature instead, so that two of opposite
// signature cross where they pass, and meet only where they collide. Those of one signature are joined
// in order, but where both would have to bend between two rows and go straight on if they cross.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "solver/program/diagram/diagram.hpp"

namespace stationary {

/// In the order in which they are drawn.
enum class RateKind : std::uint8_t { negative, undetermined, positive, growth };
constexpr std::array<RateKind, 4> rate_kinds{RateKind::negative, RateKind::undetermined,
                                             RateKind::positive, RateKind::growth};

/// Of a frequency with this Krein signature.
constexpr RateKind rate_kind(int krein) {
  return krein > 0 ? RateKind::positive : krein < 0 ? RateKind::negative : RateKind::undetermined;
}

struct RatePoint {
  std::size_t row;  ///< of Diagram::points
  double rate;
};

struct RateTrack {
  RateKind kind;
  std::vector<RatePoint> points;
};

/// Of these rows, in order. Curves come down to zero but do not run along it.
std::vector<RateTrack> rate_tracks(const Diagram& diagram, std::span<const std::size_t> rows);

}  // namespace stationary
