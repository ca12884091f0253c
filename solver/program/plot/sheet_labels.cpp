#include "solver/program/plot/sheet_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

constexpr double text_height = 13.0;
constexpr double spacing = 5.0;  ///< of the points that stand for a curve

bool within(const PagePoint& p, const PanelSize& panel, double margin) {
  return p.x >= margin && p.x <= panel.width - margin && p.y >= margin &&
         p.y <= panel.height - margin;
}

/// Points of the curves within the panel, none far from the next.
std::vector<PagePoint> evenly(const std::vector<PagePoint>& path, const PanelSize& panel) {
  std::vector<PagePoint> out;
  const double longest = panel.width + panel.height;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const PagePoint& b = path[k];
    if (within(b, panel, 0.0)) out.push_back(b);
    if (k == 0) continue;
    const PagePoint& a = path[k - 1];
    const double length = hypotenuse(b.x - a.x, b.y - a.y);
    if (!std::isfinite(length) || length > 4.0 * longest) continue;
    const int steps = static_cast<int>(length / spacing);
    for (int step = 1; step < steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      const PagePoint p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      if (within(p, panel, 0.0)) out.push_back(p);
    }
  }
  return out;
}

/// 0 where the point is in the box.
double distance(const PictureLabel& box, const PagePoint& p) {
  return hypotenuse(std::max(0.0, std::abs(p.x - box.at.x) - 0.5 * box.size.width),
                    std::max(0.0, std::abs(p.y - box.at.y) - 0.5 * box.size.height));
}

bool overlap(const PictureLabel& a, const PictureLabel& b) {
  return std::abs(a.at.x - b.at.x) < 0.5 * (a.size.width + b.size.width) &&
         std::abs(a.at.y - b.at.y) < 0.5 * (a.size.height + b.size.height);
}

}  // namespace

std::vector<PictureLabel> sheet_labels(const std::vector<SheetPath>& sheets, const PanelSize& panel,
                                       const std::vector<PagePoint>& marks) {
  std::vector<std::vector<PagePoint>> curves;
  for (const SheetPath& sheet : sheets) curves.push_back(evenly(sheet.points, panel));
  std::vector<PictureLabel> out;
  for (std::size_t own = 0; own < sheets.size(); ++own) {
    const double width = 4.0 + 7.0 * static_cast<double>(sheets[own].label.size());
    PictureLabel best;
    double most = -std::numeric_limits<double>::infinity();
    const std::size_t stride = std::max<std::size_t>(1, curves[own].size() / 150);
    for (std::size_t k = 0; k < curves[own].size(); k += stride) {
      for (const double side : {10.0, -10.0}) {
        const PictureLabel label{
            sheets[own].label, {curves[own][k].x, curves[own][k].y + side}, {width, text_height}};
        if (!within(label.at, panel, 0.5 * text_height)) continue;
        if (std::ranges::any_of(out, [&](const PictureLabel& l) { return overlap(l, label); }))
          continue;
        // Clear of its own curves a little, of the others as far as may be.
        constexpr double enough = 24.0;
        double clear = enough;
        for (std::size_t other = 0; other < curves.size(); ++other) {
          const double weight = other == own ? 4.0 : 1.0;
          for (const PagePoint& p : curves[other])
            clear = std::min(clear, weight * distance(label, p));
        }
        for (const PagePoint& p : marks) clear = std::min(clear, distance(label, p));
        if (clear > most) most = clear, best = label;
      }
    }
    if (most >= 0.0) out.push_back(best);
  }
  return out;
}

}  // namespace stationary
