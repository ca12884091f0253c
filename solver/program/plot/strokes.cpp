#include "solver/program/plot/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

bool is_finite(const PagePoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

PagePoint between(const PagePoint& a, const PagePoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The part of a line within the panel, as shares of its length (Liang and Barsky), and the sides
/// that cut it.
struct Inside {
  double from = 0.0;
  double to = 1.0;
  std::optional<PanelSide> entered;
  std::optional<PanelSide> left;
};

std::optional<Inside> inside(const PagePoint& a, const PagePoint& b, const PanelSize& panel) {
  Inside out;
  const auto cut = [&](double distance, double approach, PanelSide side) {
    // distance: of a to the side, positive within; approach: how much of it the line uses up.
    if (approach == 0.0) return distance >= 0.0;
    const double t = distance / approach;
    if (approach > 0.0) {
      if (t < out.to) out.to = t, out.left = side;
    } else if (t > out.from) {
      out.from = t, out.entered = side;
    }
    return true;
  };
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  if (!cut(a.x, -dx, PanelSide::left) || !cut(panel.width - a.x, dx, PanelSide::right) ||
      !cut(a.y, -dy, PanelSide::bottom) || !cut(panel.height - a.y, dy, PanelSide::top) ||
      out.from > out.to)
    return std::nullopt;
  return out;
}

class Pen {
 public:
  Pen(const PanelSize& panel, std::span<const Dash> dashes) : panel_(panel), dashes_(dashes) {}

  void line(const PagePoint& a, const PagePoint& b) {
    const auto part = inside(a, b, panel_);
    if (!part) {
      lift();
      return;
    }
    const PagePoint from = between(a, b, part->from);
    const PagePoint to = between(a, b, part->to);
    if (part->entered) leaves(*part->entered, from);
    if (part->left) leaves(*part->left, to);
    if (dashes_.empty()) {
      draw(from, to);
    } else {
      dash(from, to);
    }
  }

  void lift() { down_ = false; }
  DrawnCurve take() { return std::move(out_); }

 private:
  void leaves(PanelSide side, const PagePoint& at) {
    const bool level = side == PanelSide::bottom || side == PanelSide::top;
    out_.exits.push_back({side, level ? at.x : at.y});
  }

  void draw(const PagePoint& from, const PagePoint& to) {
    constexpr double touching = 1e-6;
    const bool goes_on = down_ && hypotenuse(out_.strokes.back().back().x - from.x,
                                             out_.strokes.back().back().y - from.y) < touching;
    if (!goes_on) out_.strokes.push_back({from});
    out_.strokes.back().push_back(to);
    down_ = true;
  }

  /// By x where the line is rather level, by y where it is rather steep.
  void dash(const PagePoint& from, const PagePoint& to) {
    const bool level = std::abs(to.x - from.x) >= std::abs(to.y - from.y);
    const double first = level ? from.x : from.y;
    const double last = level ? to.x : to.y;
    if (first == last) return;
    struct Piece {
      double from;
      double to;
    };
    std::vector<Piece> pieces;
    const double low = std::min(first, last);
    const double high = std::max(first, last);
    for (double period = std::floor(low / dash_period) * dash_period; period < high;
         period += dash_period) {
      for (const Dash& each : dashes_) {
        const Piece piece{std::max(low, period + each.from), std::min(high, period + each.to)};
        if (piece.from < piece.to) pieces.push_back(piece);
      }
    }
    if (last < first) std::ranges::reverse(pieces);
    for (const Piece& piece : pieces) {
      const double begin = last < first ? piece.to : piece.from;
      const double end = last < first ? piece.from : piece.to;
      draw(between(from, to, (begin - first) / (last - first)),
           between(from, to, (end - first) / (last - first)));
    }
  }

  PanelSize panel_;
  std::span<const Dash> dashes_;
  DrawnCurve out_;
  bool down_ = false;
};

}  // namespace

DrawnCurve drawn(std::span<const PagePoint> path, const PanelSize& panel,
                 std::span<const Dash> dashes) {
  Pen pen(panel, dashes);
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (is_finite(path[k - 1]) && is_finite(path[k])) {
      pen.line(path[k - 1], path[k]);
    } else {
      pen.lift();
    }
  }
  return pen.take();
}

}  // namespace stationary
