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

double distance(const PagePoint& a, const PagePoint& b) { return hypotenuse(b.x - a.x, b.y - a.y); }

double length(const Stroke& stroke) {
  double out = 0.0;
  for (std::size_t k = 1; k < stroke.size(); ++k) out += distance(stroke[k - 1], stroke[k]);
  return out;
}

/// Whether b, nearer to a than `least`, may be left out between a and c: they are nearly on a line.
bool is_needless(const PagePoint& a, const PagePoint& b, const PagePoint& c, double least,
                 double off) {
  const double across = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return distance(a, b) < least && std::abs(across) < off * distance(a, c);
}

/// Strokes without points that are nearly the same, ended where they turn back: there a mitre would
/// reach beyond. Beside others what is shorter than a pixel is left out.
class Tidying {
 public:
  explicit Tidying(const std::vector<Stroke>& strokes) {
    for (const Stroke& each : strokes) add(each);
    constexpr double seen = 1.0;
    const auto is_short = [](const Stroke& each) { return length(each) < seen; };
    if (!std::ranges::all_of(out_, is_short)) std::erase_if(out_, is_short);
  }
  std::vector<Stroke> take() { return std::move(out_); }

 private:
  void add(const Stroke& stroke) {
    constexpr double apart = 2.0;
    constexpr double least_turn = 0.5;  // what turns on less is rounding
    part_ = {stroke.front()};
    for (std::size_t k = 1; k + 1 < stroke.size(); ++k) {
      const PagePoint& last = part_.back();
      const PagePoint& here = stroke[k];
      const PagePoint& next = stroke[k + 1];
      const double way = distance(last, here);
      const bool turns_back =
          (here.x - last.x) * (next.x - here.x) + (here.y - last.y) * (next.y - here.y) < 0.0;
      if (turns_back && way >= least_turn) {
        finish(here);
        part_ = {here};
      } else if (way >= least_turn && !is_needless(last, here, next, apart, 0.1)) {
        part_.push_back(here);
      }
    }
    finish(stroke.back());
  }

  /// The flat end of a line lies across its last segment, and of a short one gnuplot rounds the
  /// direction.
  void finish(const PagePoint& end) {
    constexpr double least = 4.0;
    constexpr double off = 0.5;
    part_.push_back(end);
    while (part_.size() > 2 && is_needless(part_[0], part_[1], part_[2], least, off))
      part_.erase(part_.begin() + 1);
    while (part_.size() > 2 && is_needless(end, part_.end()[-2], part_.end()[-3], least, off))
      part_.erase(part_.end() - 2);
    out_.push_back(std::move(part_));
  }

  Stroke part_;
  std::vector<Stroke> out_;
};

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
  DrawnCurve take() {
    out_.strokes = Tidying(out_.strokes).take();
    return std::move(out_);
  }

 private:
  void leaves(PanelSide side, const PagePoint& at) {
    const bool level = side == PanelSide::bottom || side == PanelSide::top;
    out_.exits.push_back({side, level ? at.x : at.y});
  }

  void draw(const PagePoint& from, const PagePoint& to) {
    constexpr double touching = 1e-6;
    const bool goes_on = down_ && distance(out_.strokes.back().back(), from) < touching;
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
