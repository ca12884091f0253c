// Where a curve leaves the range of the parameter that is asked for: the limit that a step passes,
// also by turning just beyond it, and the point of the curve there.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "solver/continuation/curve.hpp"
#include "solver/continuation/located_event.hpp"

namespace stationary {

struct RangeLimit {
  double p;
  double reach;  ///< of the step, to its end or its first turn beyond the range
};

/// Of a step to a point along an arc, with the events in it.
template <int N>
std::optional<RangeLimit> passed_limit(double from, double to, const CurvePoint<N>& next,
                                       const Arc<N>& arc, std::span<const Event> events) {
  const auto beyond = [&](double p) -> std::optional<double> {
    if (p > to) return to;
    if (p < from) return from;
    return std::nullopt;
  };
  for (const Event& event : events) {
    if (!turns_parameter(event)) continue;
    if (const auto limit = beyond(event.member.parameter))
      return RangeLimit{*limit, arc.turn_of_parameter()};
  }
  if (const auto limit = beyond(next.arc.p)) return RangeLimit{*limit, 1.0};
  return std::nullopt;
}

/// Where f(u) is 0 between low and high, where it has opposite signs; nothing where it has not.
template <class F>
std::optional<double> zero_between(const F& f, double low, double high) {
  const double a = f(low);
  const double b = f(high);
  if (!(a < 0.0 && b > 0.0) && !(a > 0.0 && b < 0.0)) return std::nullopt;
  std::uintmax_t evaluations = 60;
  const auto [first, last] = boost::math::tools::toms748_solve(
      f, low, high, a, b, boost::math::tools::eps_tolerance<double>(52), evaluations);
  return 0.5 * (first + last);
}

/// Where the distance, from that at `begin` on, is nearest to zero or beyond it, near `turn`.
template <class F>
double turn_near(const F& distance, double begin, double turn) {
  const double sign = distance(begin) < 0.0 ? -1.0 : 1.0;
  const double half = 0.5 * (turn - begin);
  std::uintmax_t evaluations = 60;
  return boost::math::tools::brent_find_minima([&](double u) { return sign * distance(u); },
                                               turn - half, std::min(turn + half, 1.0),
                                               std::numeric_limits<double>::digits / 2, evaluations)
      .first;
}

/// The point of the curve at the limit and, where the corrector converged, the way to it.
template <int N>
struct AtLimit {
  Corrected<N> corrected;
  Arc<N> arc;
};
template <int N>
AtLimit<N> at_limit(const Curve<N>& curve, const ArcPoint<N>& from, const Arc<N>& arc,
                    const RangeLimit& limit) {
  const double scale = curve.corrector().scale();
  const auto distance = [&](double u) { return from.p + scale * arc.at(u)[N] - limit.p; };
  // A step that begins at the limit and comes back to it turns in between.
  const double begin = from.p == limit.p ? arc.turn_of_parameter() : 0.0;
  double u = zero_between(distance, begin, limit.reach).value_or(limit.reach);
  AtLimit<N> out;
  out.corrected = curve.corrector().correct_at(
      moved<N>(from.x, ReducedVector<N>(arc.at(u).template head<N>())), limit.p, arc.direction(u));
  if (out.corrected.point.p != limit.p) {
    // Beside a turn of p the curve is followed to where its own p is the limit.
    const auto own_distance = [&](double v) { return curve.at(from, arc, v).point.p - limit.p; };
    auto own = zero_between(own_distance, begin, limit.reach);
    if (!own && limit.reach < 1.0) {
      // It turns a hair beyond the limit, and not quite where its arc does.
      u = turn_near(own_distance, begin, limit.reach);
      own = zero_between(own_distance, begin, u);
    }
    if (own) u = *own;
    out.corrected = curve.at(from, arc, u);
    // A limit some units below a turn is where the turn is, for a double.
    constexpr double units = 0x1p-50;
    ArcPoint<N>& point = out.corrected.point;
    if (!(std::abs(point.p - limit.p) <= units * std::abs(limit.p)))
      out.corrected.status = CorrectorStatus::left_curve;
    if (point.p != limit.p) point.error_bound *= 4.0;  // a root of how far p is off
    point.p = limit.p;
  }
  if (out.corrected.status == CorrectorStatus::converged)
    out.arc = Arc<N>(arc.at(u), from.tangent, out.corrected.point.tangent);
  return out;
}

}  // namespace stationary
