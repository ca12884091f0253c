// Ends of a sheet that its stretches tell: they leave the bounds followed, or a double of the
// parameter no longer tells its points apart.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "lib/body/stretch.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/hermite_arc.hpp"
#include "solver/motion/event.hpp"

namespace stationary {

/// Where one direction of a sheet ended.
struct SheetEnd {
  EventType event = EventType::none;  ///< none: it has not, was interrupted, or has all its points
  std::string reason;
};

/// The stretches that others are far from where a sheet ends: 1 and a body's own at rest.
struct StretchWindow {
  explicit StretchWindow(double unit) : least(std::min(1.0, unit)), most(std::max(1.0, unit)) {}
  double least;
  double most;
};

/// Principal stretches, the least over the window's, the largest too.
inline StretchRange stretch_range(const Stretch& q, const StretchWindow& window) {
  const auto [least, most] = stretch_range(q);
  return {least / window.least, most / window.most};
}

/// Whether the stretches run off rather than vanish, at q, the end of this arc. In their
/// logarithms: one that only grows along while another vanishes does not escape. With alpha != 0
/// the unknowns are no principal stretches, and these tell by how far each has come from it.
template <int N>
bool escapes(const Stretch& q, const Arc<N>& arc, const StretchWindow& window) {
  if (q.alpha != 0.0) {
    const auto [least, most] = stretch_range(q, window);
    return log(most) > -0.5 * log(least);
  }
  const ReducedVector<N> change = arc.chord.template head<N>();
  return change.maxCoeff() > -0.1 * change.minCoeff();
}

/// Where points are no longer resolved: the stretches run off, at an asymptote; elsewhere branches
/// meet that no event stands for.
template <int N>
SheetEnd unresolved_end(const Stretch& q, const Arc<N>& arc, const StretchWindow& window) {
  const auto [least, most] = stretch_range(q, window);
  constexpr double moderate = 8.0;
  if (most < moderate && least > 1.0 / moderate)
    return {EventType::stalled,
            "beyond this the stretches are not resolved though they are moderate: the sheet may "
            "meet another here"};
  return {escapes(q, arc, window) ? EventType::escape : EventType::collapse,
          "beyond this a double of the parameter does not resolve the stretches"};
}

/// Where a principal stretch is below min_stretch times the window's least, or above max_stretch times its most.
template <int N>
std::optional<SheetEnd> end_out_of_bounds(const Stretch& q, const Arc<N>& arc,
                                          const StretchWindow& window, double min_stretch,
                                          double max_stretch) {
  const auto [least, most] = stretch_range(q, window);
  if (most > max_stretch || least < min_stretch)
    return SheetEnd{
        most > max_stretch || escapes(q, arc, window) ? EventType::escape : EventType::collapse,
        "a stretch left the bounds followed"};
  return std::nullopt;
}

/// Whether a point's parameter p, of a bound of the coordinates there, resolves it no more, near an
/// asymptote in p: the stretches are far out and p hardly changed along the arc to it, or the bound
/// is coarse.
template <int N>
bool is_unresolved(const Stretch& q, const Arc<N>& arc, const StretchWindow& window, double scale,
                   double p, double error_bound) {
  constexpr double far = 1e3;      // of a stretch, or its inverse
  constexpr double coarse = 1e-5;  // of a bound that still holds
  const auto [least, most] = stretch_range(q, window);
  const double resolved = std::abs(arc.chord[N]) * scale / arc.length;
  return ((most > far || least < 1.0 / far) && resolved < 1e-9 * std::abs(p)) ||
         error_bound > coarse;
}

}  // namespace stationary
