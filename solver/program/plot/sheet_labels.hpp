// Numbers of sheets beside their curves: each where the least else is, none on another.
#pragma once

#include <string>
#include <vector>

#include "solver/program/plot/strokes.hpp"

namespace stationary {

struct PictureLabel {
  std::string text;
  PagePoint at;  ///< its middle
  PanelSize size;
};

/// A sheet's curves, apart by points that are not finite.
struct SheetPath {
  std::string label;
  std::vector<PagePoint> points;
};

/// marks: what else is to be kept clear of. A sheet that is nowhere in the panel has no label, and
/// one for which no place is left that is free of labels has none either.
std::vector<PictureLabel> sheet_labels(const std::vector<SheetPath>& sheets, const PanelSize& panel,
                                       const std::vector<PagePoint>& marks);

}  // namespace stationary
