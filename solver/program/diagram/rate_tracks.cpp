#include "solver/program/diagram/rate_tracks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace stationary {
namespace {

struct RowMode {
  double frequency;
  RateKind kind;
  std::size_t track;  ///< whose last point it is
};

constexpr std::size_t no_track = std::numeric_limits<std::size_t>::max();

/// In ascending order, those at zero included: others come down to them.
std::vector<RowMode> modes_of(const DiagramPoint& point) {
  std::vector<RowMode> out;
  out.reserve(point.frequency.size());
  for (std::size_t k = 0; k < point.frequency.size(); ++k) {
    if (!std::isfinite(point.frequency[k])) continue;
    out.push_back({point.frequency[k], rate_kind(point.krein[k]), no_track});
  }
  std::ranges::stable_sort(out, {}, &RowMode::frequency);
  return out;
}

using Pair = std::pair<std::size_t, std::size_t>;

/// Pairs as many as there can be of two ascending lists, in order, so that together they move least.
std::vector<Pair> nearest_pairs(const std::vector<RowMode>& from, const std::vector<RowMode>& to,
                                const std::vector<std::size_t>& a,
                                const std::vector<std::size_t>& b) {
  const bool swapped = a.size() > b.size();
  const auto& few = swapped ? b : a;
  const auto& many = swapped ? a : b;
  const auto& few_modes = swapped ? to : from;
  const auto& many_modes = swapped ? from : to;
  std::vector<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned chosen = 0; chosen < (1U << many.size()); ++chosen) {
    if (static_cast<std::size_t>(std::popcount(chosen)) != few.size()) continue;
    std::vector<std::size_t> partners;
    for (std::size_t k = 0; k < many.size(); ++k)
      if ((chosen >> k & 1U) != 0) partners.push_back(many[k]);
    double moved = 0.0;
    for (std::size_t k = 0; k < few.size(); ++k)
      moved += std::abs(few_modes[few[k]].frequency - many_modes[partners[k]].frequency);
    if (moved < least) least = moved, best = std::move(partners);
  }
  std::vector<Pair> out;
  for (std::size_t k = 0; k < best.size(); ++k)
    out.push_back(swapped ? Pair{best[k], few[k]} : Pair{few[k], best[k]});
  return out;
}

class Tracks {
 public:
  void step(std::vector<RowMode>& from, std::size_t from_row, std::vector<RowMode>& to,
            std::size_t to_row) {
    std::vector<bool> left(from.size(), true);
    std::vector<bool> free(to.size(), true);
    const auto join_those = [&](auto takes_from, auto takes_to) {
      std::vector<std::size_t> a;
      std::vector<std::size_t> b;
      for (std::size_t k = 0; k < from.size(); ++k)
        if (left[k] && takes_from(from[k])) a.push_back(k);
      for (std::size_t k = 0; k < to.size(); ++k)
        if (free[k] && takes_to(to[k])) b.push_back(k);
      for (const auto& [i, j] : nearest_pairs(from, to, a, b)) {
        left[i] = free[j] = false;
        join(from[i], from_row, to[j], to_row);
      }
    };
    const auto moves = [](const RowMode& m) { return m.frequency > 0.0; };
    const auto rests = [](const RowMode& m) { return m.frequency == 0.0; };
    for (const RateKind kind : {RateKind::positive, RateKind::negative, RateKind::undetermined}) {
      const auto is = [&](const RowMode& m) { return m.kind == kind && moves(m); };
      join_those(is, is);
    }
    join_those(moves, moves);
    join_those(moves, rests);
    join_those(rests, moves);
  }

  std::vector<RateTrack> take() { return std::move(tracks_); }

 private:
  void join(RowMode& from, std::size_t from_row, RowMode& to, std::size_t to_row) {
    const bool known = from.kind != RateKind::undetermined && from.frequency > 0.0;
    const RateKind kind = known ? from.kind : to.frequency > 0.0 ? to.kind : from.kind;
    if (from.track == no_track || tracks_[from.track].kind != kind) {
      from.track = tracks_.size();
      tracks_.push_back({kind, {{from_row, from.frequency}}});
    }
    tracks_[from.track].points.push_back({to_row, to.frequency});
    to.track = from.track;
  }

  std::vector<RateTrack> tracks_;
};

/// Whether two curves of one kind that were joined in order cross between the second and the third of
/// four rows: there they would have to bend, and do not where they are joined the other way.
bool cross(const std::array<double, 4>& parameter, std::span<const RatePoint> a,
           std::span<const RatePoint> b) {
  std::array<double, 3> step;
  for (std::size_t k = 0; k < step.size(); ++k) step[k] = parameter[k + 1] - parameter[k];
  constexpr double uneven = 5.0;  // near a fold slopes say little
  for (const double each : step)
    if (!(each * step[1] > 0.0) || std::abs(each) > uneven * std::abs(step[1])) return false;
  const auto slope = [&](std::span<const RatePoint> from, std::span<const RatePoint> to,
                         std::size_t k) { return (to[k + 1].rate - from[k].rate) / step[k]; };
  const auto bend = [&](std::span<const RatePoint> from, std::span<const RatePoint> to) {
    const double between = slope(from, to, 1);
    return std::abs(between - slope(from, from, 0)) + std::abs(between - slope(to, to, 2));
  };
  const double before = a[1].rate - b[1].rate;
  const double after = a[2].rate - b[2].rate;
  const double foreseen = before + (slope(a, a, 0) - slope(b, b, 0)) * step[1];
  const double recalled = after - (slope(a, a, 2) - slope(b, b, 2)) * step[1];
  if (!(before * after > 0.0) || foreseen * before >= 0.0 || recalled * after >= 0.0) return false;
  constexpr double clear = 0.35;
  return bend(a, b) + bend(b, a) < clear * (bend(a, a) + bend(b, b));
}

/// Exchanges what follows where two curves of one kind cross.
void cross_over(const Diagram& diagram, std::vector<RateTrack>& tracks) {
  constexpr std::size_t width = 4;
  for (std::size_t one = 0; one < tracks.size(); ++one) {
    for (std::size_t two = 0; two < one; ++two) {
      std::vector<RatePoint>& a = tracks[one].points;
      std::vector<RatePoint>& b = tracks[two].points;
      if (tracks[one].kind != tracks[two].kind) continue;
      std::size_t from_a = 0;
      std::size_t from_b = 0;
      while (from_a + width <= a.size() && from_b + width <= b.size()) {
        if (a[from_a].row != b[from_b].row) {
          ++(a[from_a].row < b[from_b].row ? from_a : from_b);
          continue;
        }
        std::array<double, width> parameter;
        for (std::size_t k = 0; k < width; ++k)
          parameter[k] = diagram.points[a[from_a + k].row].abscissa;
        if (cross(parameter, std::span(a).subspan(from_a, width),
                  std::span(b).subspan(from_b, width))) {
          const std::vector<RatePoint> rest(a.begin() + static_cast<std::ptrdiff_t>(from_a) + 2,
                                            a.end());
          a.erase(a.begin() + static_cast<std::ptrdiff_t>(from_a) + 2, a.end());
          a.insert(a.end(), b.begin() + static_cast<std::ptrdiff_t>(from_b) + 2, b.end());
          b.erase(b.begin() + static_cast<std::ptrdiff_t>(from_b) + 2, b.end());
          b.insert(b.end(), rest.begin(), rest.end());
        }
        ++from_a;
        ++from_b;
      }
    }
  }
}

/// Where it is positive, and one row beside.
void add_growth(const Diagram& diagram, std::span<const std::size_t> rows,
                std::vector<RateTrack>& out) {
  const auto growth = [&](std::size_t at) { return diagram.points[rows[at]].growth; };
  bool open = false;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    const bool seen = growth(at) > 0.0 || (at > 0 && growth(at - 1) > 0.0) ||
                      (at + 1 < rows.size() && growth(at + 1) > 0.0);
    if (!seen || !std::isfinite(growth(at))) {
      open = false;
      continue;
    }
    if (!open) out.push_back({RateKind::growth, {}});
    open = true;
    out.back().points.push_back({rows[at], growth(at)});
  }
}

}  // namespace

std::vector<RateTrack> rate_tracks(const Diagram& diagram, std::span<const std::size_t> rows) {
  Tracks tracks;
  std::vector<RateTrack> lone;
  std::vector<RowMode> before;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    std::vector<RowMode> now = modes_of(diagram.points[rows[at]]);
    if (at > 0) tracks.step(before, rows[at - 1], now, rows[at]);
    if (rows.size() == 1)
      for (const RowMode& mode : now)
        if (mode.frequency > 0.0) lone.push_back({mode.kind, {{rows[at], mode.frequency}}});
    before = std::move(now);
  }
  std::vector<RateTrack> out = tracks.take();
  cross_over(diagram, out);
  out.insert(out.end(), lone.begin(), lone.end());
  add_growth(diagram, rows, out);
  return out;
}

}  // namespace stationary
