// Where the class of a motion (lib/stability/spectrum.hpp) may change on proven curves: slices of
// their tubes are halved until the class of every motion in them is proven, or until the q they may
// have is as narrow as rounding. Two slices of a chain share a point, so that between two of the
// intervals left the class of each sheet is one.
//
// A motion at nu is one point of each factor (axis_curves.hpp): of a body whose thickness stands
// apart, slices of both are taken together wherever they share a q. That takes in every motion, and
// pairs that are of none besides.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/tube/arc_spectrum.hpp"
#include "solver/tube/proven_curves.hpp"

namespace stationary {

/// The class of all motions of an arc, or nothing where it is not proven. Empty: not asked for.
using ClassOver = std::function<std::optional<StabilityClass>(const MotionArc&)>;

struct ClassGaps {
  /// q at which the class of some motion is not proven. Ascending, touching ones merged.
  std::vector<Interval> gaps;
  long arcs = 0;  ///< classes asked for
  bool interrupted = false;
};

/// factors: the curves of each, all of them. After most arcs what is left is a gap.
ClassGaps class_gaps(const std::vector<std::vector<std::unique_ptr<ProvenCurves>>>& factors,
                     const ClassOver& class_over, double nu_end, long most,
                     const std::atomic<bool>* stop = nullptr);

}  // namespace stationary
