// A motion at one of many values of one of its numbers: of |nu|, or of a two-polar motion's rates and
// momenta. What finds one by following a family from rest, or by a search, finds those at many values
// together: solve_tilted_each(), solve_oblique_each(), solve_two_polar_each().
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "lib/stability/spectrum.hpp"
#include "solver/motion/equilibrium.hpp"
#include "solver/motion/family_parameter.hpp"

namespace stationary {

struct AtValue {
  double value;
  /// As a solve at this value alone finds it, without its message; not_run: not looked for yet.
  Equilibrium equilibrium{};
  std::optional<Spectrum> spectrum{};  ///< where asked for, of a solved one

  bool solved() const { return equilibrium.status == SolveStatus::solved; }
};

/// Throws std::invalid_argument where a |nu| is not finite and > 0.
inline void require_rates(std::span<const AtValue> at) {
  for (const AtValue& each : at)
    if (!(each.value > 0.0 && std::isfinite(each.value)))
      throw std::invalid_argument("|nu| finite and > 0");
}

}  // namespace stationary
