// A motion at one of many |nu|. What finds one by following a family from rest finds those at many
// |nu| on the same sheets, followed once: solve_tilted_each(), solve_oblique_each().
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "lib/stability/spectrum.hpp"
#include "solver/motion/equilibrium.hpp"

namespace stationary {

struct AtRate {
  double nu;  ///< |nu| > 0
  /// As a solve at this nu alone finds it, without its message; not_run: not looked for yet.
  Equilibrium equilibrium{};
  std::optional<Spectrum> spectrum{};  ///< where asked for, of a solved one

  bool solved() const { return equilibrium.status == SolveStatus::solved; }
};

/// Where they may lie: what is found at one |nu| depends on this, and not on which others are asked
/// for.
struct RateRange {
  double least;
  double most;
};

/// Throws std::invalid_argument where one is not finite and > 0.
inline void require_rates(std::span<const AtRate> rates) {
  for (const AtRate& each : rates)
    if (!(each.nu > 0.0 && std::isfinite(each.nu)))
      throw std::invalid_argument("|nu| finite and > 0");
}

}  // namespace stationary
