// What a pen does within a panel: a curve's path on the page cut off at the panel's edges, and into
// dashes. The dashes are laid by the place on the page, not by the way along the curve, and all
// patterns leave the same gap free: of curves that lie on one another the gaps do too, whatever their
// classes and wherever they begin, so that no two dashed curves make up a solid one.
#pragma once

#include <span>
#include <vector>

namespace stationary {

/// In the page's units, from the panel's lower left corner.
struct PagePoint {
  double x;
  double y;
};
using Stroke = std::vector<PagePoint>;

struct PanelSize {
  double width;
  double height;
};

/// Drawn from `from` up to `to`, of each period.
struct Dash {
  double from;
  double to;
};
constexpr double dash_period = 20.0;
constexpr double dash_gap_begins = 13.0;  ///< no dash lies beyond

enum class PanelSide { bottom, top, left, right };

/// Where a curve leaves the panel, or comes back into it.
struct CurveExit {
  PanelSide side;
  double place;  ///< along that side
};

struct DrawnCurve {
  std::vector<Stroke> strokes;
  std::vector<CurveExit> exits;
};

/// dashes: none for a solid line. The path is broken at points that are not finite. Of points that are
/// nearly the same one is kept; a stroke ends where the path turns back.
DrawnCurve drawn(std::span<const PagePoint> path, const PanelSize& panel,
                 std::span<const Dash> dashes);

}  // namespace stationary
