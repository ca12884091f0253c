#include "solver/program/diagram/diagram_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace stationary {
namespace {

/// Whether the class of an event's row says nothing of the rows beside it.
bool is_border(const DiagramPoint& p) {
  return p.event && (!p.verdict || p.verdict == StabilityClass::marginal);
}

/// The row of two neighbours whose class the line between them has; none: it changes half-way.
const DiagramPoint* decisive(const DiagramPoint& a, const DiagramPoint& b) {
  if (a.verdict == b.verdict) return &a;
  if (a.event != b.event) return a.event ? &b : &a;
  if (is_border(a)) return &b;
  return is_border(b) ? &a : nullptr;
}

/// Keeps, of each stretch of points within one image column, the first, the last and those where a
/// value or the abscissa is extreme. values: of a point, an array that begins with the abscissa.
template <class Values>
std::vector<std::size_t> thinned(std::span<const std::size_t> points, const Axis& abscissa,
                                 const Values& values) {
  const auto column = [&](std::size_t k) {
    return std::floor(abscissa.place(values(points[k])[0]) * image_columns);
  };
  std::vector<std::size_t> out;
  std::vector<std::size_t> kept;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const auto first = values(points[begin]);
    auto low = first;
    auto high = first;
    std::array<std::size_t, std::tuple_size_v<decltype(low)>> lowest;
    lowest.fill(begin);
    auto highest = lowest;
    const double here = column(begin);
    for (end = begin + 1; end < points.size() && column(end) == here; ++end) {
      const auto now = values(points[end]);
      for (std::size_t v = 0; v < now.size(); ++v) {
        // Written so that the first number replaces a value that was not computed.
        if (!(low[v] <= now[v]) && !std::isnan(now[v])) low[v] = now[v], lowest[v] = end;
        if (!(high[v] >= now[v]) && !std::isnan(now[v])) high[v] = now[v], highest[v] = end;
      }
    }
    kept.assign({begin, end - 1});
    kept.insert(kept.end(), lowest.begin(), lowest.end());
    kept.insert(kept.end(), highest.begin(), highest.end());
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    for (const std::size_t k : kept) out.push_back(points[k]);
  }
  return out;
}

}  // namespace

std::vector<DiagramLine> class_lines(const Diagram& diagram, const DiagramPiece& piece,
                                     const Axis& abscissa) {
  const std::vector<DiagramPoint>& points = diagram.points;
  std::vector<DiagramLine> lines{{points[piece.begin].verdict, {piece.begin}}};
  for (std::size_t k = piece.begin + 1; k < piece.end; ++k) {
    const DiagramPoint* const one = decisive(points[k - 1], points[k]);
    if (one == nullptr) {
      lines.back().after = k;
      lines.push_back({points[k].verdict, {k}, k - 1});
      continue;
    }
    if (lines.back().points.size() == 1 && !lines.back().before)
      lines.back().verdict = one->verdict;
    if (lines.back().verdict != one->verdict) lines.push_back({one->verdict, {k - 1}});
    lines.back().points.push_back(k);
  }
  for (DiagramLine& line : lines) {
    line.points = thinned(line.points, abscissa, [&](std::size_t k) {
      const DiagramPoint& p = points[k];
      return std::array{p.abscissa, p.ordinate[0], p.ordinate[1], p.ordinate[2]};
    });
  }
  return lines;
}

std::vector<std::size_t> spectrum_rows(const Diagram& diagram, const DiagramPiece& piece,
                                       const Axis& abscissa) {
  const std::vector<DiagramPoint>& points = diagram.points;
  std::vector<std::size_t> rows;
  for (std::size_t k = piece.begin; k < piece.end; ++k)
    if (points[k].has_spectrum()) rows.push_back(k);
  return thinned(rows, abscissa, [&](std::size_t k) {
    const DiagramPoint& p = points[k];
    const auto& f = p.frequency;
    return std::array{p.abscissa, f[0], f[1], f[2], f[3], f[4], p.growth};
  });
}

}  // namespace stationary
