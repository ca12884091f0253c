// The lines of a diagram: each connected piece cut where the class changes, neighbours sharing the
// point at the border, and thinned to what an image can show.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/program/diagram/axis.hpp"
#include "solver/program/diagram/diagram.hpp"

namespace stationary {

/// Points of Diagram::points joined by one line.
struct DiagramLine {
  std::optional<StabilityClass> verdict;
  std::vector<std::size_t> points;
  /// The rows of other classes beside it: it begins half-way from the one, and ends half-way to the
  /// other.
  std::optional<std::size_t> before = std::nullopt;
  std::optional<std::size_t> after = std::nullopt;
};

/// Columns of the image: within each, first, last and extreme values are kept.
constexpr double image_columns = 1600.0;

/// Of a piece, cut where the class changes: between two rows in the middle. A located event belongs to
/// both its sides, whatever its own class: on the border that is marginal.
std::vector<DiagramLine> class_lines(const Diagram& diagram, const DiagramPiece& piece,
                                     const Axis& abscissa);

/// The rows of a piece at which there is a spectrum: an event's without one are passed over.
std::vector<std::size_t> spectrum_rows(const Diagram& diagram, const DiagramPiece& piece,
                                       const Axis& abscissa);

}  // namespace stationary
