// Where everything of a bifurcation diagram is: the ranges of the axes, the panels, the labels of
// the events. Lengths on the page are in units of which it measures 800 by 600, from its lower left
// corner.
//
//   title
//   labels of the events, along the upper panel's top edge
//   stretches against the parameter     keys
//   rates against the parameter         keys      (only where there is a spectrum)
#pragma once

#include <string_view>
#include <vector>

#include "solver/program/plot/diagram.hpp"
#include "solver/program/plot/diagram_lines.hpp"
#include "solver/program/plot/event_labels.hpp"

namespace stationary {

struct PlotPage {
  static constexpr double width = 800.0;
  static constexpr double height = 600.0;
  static constexpr double margin = 14.0;
  static constexpr double title_height = 26.0;
  static constexpr double left = 74.0;
  static constexpr double right = width - 134.0;
  static constexpr double bottom = 58.0;
  static constexpr double leader_height = 14.0;  ///< from the panel to the labels

  explicit PlotPage(const Diagram& diagram);

  /// What lies at a place between left and right.
  double parameter_at(double place) const;

  AxisRange parameters{};
  AxisRange stretches{};  ///< less stretch_base
  /// What all stretches all but share: they are drawn less it, for ticks that can be read.
  double stretch_base = 0.0;
  bool logarithmic = false;  ///< the axis of the stretches
  AxisRange rates{};
  std::vector<EventLabel> labels;
  double upper_top = height - margin - title_height;
  double upper_bottom = bottom;
  double lower_top = bottom;  ///< of the panel of the rates
};

/// The end of the asked range happens to nobody: it is neither marked nor named.
constexpr bool is_marked(std::string_view event) { return event != "limit"; }

}  // namespace stationary
