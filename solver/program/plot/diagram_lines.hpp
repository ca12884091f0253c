// The lines of a diagram: each connected piece cut where the class changes, neighbours sharing the
// point at the border, and thinned to what an image can show.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/program/plot/diagram.hpp"

namespace stationary {

/// Points of Diagram::points joined by one line; a single one is a dot.
struct DiagramLine {
  std::optional<StabilityClass> verdict;
  std::vector<std::size_t> points;
};

struct AxisRange {
  double low;
  double high;
};

/// Columns of the image: within each, first, last and extreme values are kept.
constexpr double image_columns = 1600.0;

/// Cut at sheets and classes. A located event belongs to both its sides, whatever its own class: on
/// the border that is marginal.
std::vector<DiagramLine> stretch_lines(const Diagram& diagram, const AxisRange& parameters);

/// Cut at sheets only. Event rows without a spectrum are passed over.
std::vector<DiagramLine> spectrum_lines(const Diagram& diagram, const AxisRange& parameters);

}  // namespace stationary
