// Labels of events along one edge of a diagram: of every event there is one, none lies on another,
// and each is as near its event as that allows.
//
// Events of one name that lie closer than half a label is wide share one. Where even so there are
// more than fit, the distance within which they share is widened.
#pragma once

#include <string>
#include <vector>

#include "solver/program/plot/diagram_lines.hpp"

namespace stationary {

struct EventLabel {
  std::string name;
  int count;      ///< events it stands for
  double anchor;  ///< the first of these events
  double place;   ///< where the label is
};

struct NamedPlace {
  std::string name;
  double place;
};

/// pitch: the least distance between labels; edge: where labels may be. The labels come in the
/// order of their places. They overlap only if there are more names than fit.
std::vector<EventLabel> event_labels(std::vector<NamedPlace> events, const AxisRange& edge,
                                     double pitch);

}  // namespace stationary
