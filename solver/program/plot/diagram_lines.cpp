#include "solver/program/plot/diagram_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace stationary {
namespace {

/// The class of the line between two neighbours.
std::optional<StabilityClass> class_between(const DiagramPoint& a, const DiagramPoint& b) {
  if (a.verdict == b.verdict || !b.verdict) return a.verdict;
  if (!a.verdict) return b.verdict;
  if (a.event != b.event) return a.event ? b.verdict : a.verdict;
  return a.verdict == StabilityClass::marginal ? b.verdict : a.verdict;
}

/// Keeps, of each stretch of points within one image column, the first, the last and those where a
/// value or the parameter is extreme. values: of a point, an array that begins with the parameter.
template <class Values>
std::vector<std::size_t> thinned(std::span<const std::size_t> points, const AxisRange& parameters,
                                 const Values& values) {
  const double columns_per_unit = image_columns / (parameters.high - parameters.low);
  const auto column = [&](std::size_t k) {
    return std::floor((values(points[k])[0] - parameters.low) * columns_per_unit);
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

template <class Values>
void thin(std::vector<DiagramLine>& lines, const AxisRange& parameters, const Values& values) {
  for (DiagramLine& line : lines) line.points = thinned(line.points, parameters, values);
}

/// Past the last point of a piece.
std::size_t end_of(const Diagram& diagram, std::size_t piece) {
  return piece + 1 < diagram.pieces.size() ? diagram.pieces[piece + 1] : diagram.points.size();
}

}  // namespace

std::vector<DiagramLine> stretch_lines(const Diagram& diagram, const AxisRange& parameters) {
  const std::vector<DiagramPoint>& points = diagram.points;
  std::vector<DiagramLine> lines;
  for (std::size_t piece = 0; piece < diagram.pieces.size(); ++piece) {
    const std::size_t begin = diagram.pieces[piece];
    lines.push_back({points[begin].verdict, {begin}});
    for (std::size_t k = begin + 1; k < end_of(diagram, piece); ++k) {
      const auto verdict = class_between(points[k - 1], points[k]);
      if (lines.back().points.size() == 1) lines.back().verdict = verdict;
      if (lines.back().verdict != verdict) lines.push_back({verdict, {k - 1}});
      lines.back().points.push_back(k);
    }
  }
  thin(lines, parameters, [&](std::size_t k) {
    const DiagramPoint& p = points[k];
    return std::array{p.parameter, p.stretch[0], p.stretch[1], p.stretch[2]};
  });
  return lines;
}

std::vector<DiagramLine> spectrum_lines(const Diagram& diagram, const AxisRange& parameters) {
  const std::vector<DiagramPoint>& points = diagram.points;
  std::vector<DiagramLine> lines;
  for (std::size_t piece = 0; piece < diagram.pieces.size(); ++piece) {
    DiagramLine line;
    for (std::size_t k = diagram.pieces[piece]; k < end_of(diagram, piece); ++k)
      if (points[k].has_spectrum() || !points[k].event) line.points.push_back(k);
    lines.push_back(std::move(line));
  }
  thin(lines, parameters, [&](std::size_t k) {
    const DiagramPoint& p = points[k];
    const auto& f = p.frequency;
    return std::array{p.parameter, f[0], f[1], f[2], f[3], f[4], p.growth};
  });
  return lines;
}

}  // namespace stationary
