// Where a curve leaves the range of the parameter that is asked for: the limit that a step passes,
// also by turning just beyond it, and the point of the curve there.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
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
    if (!is_fold(event.type)) continue;
    if (const auto limit = beyond(event.member.parameter))
      return RangeLimit{*limit, arc.turn_of_parameter()};
  }
  if (const auto limit = beyond(next.arc.p)) return RangeLimit{*limit, 1.0};
  return std::nullopt;
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
  const double a = distance(0.0);
  const double b = distance(limit.reach);
  double u = limit.reach;
  if ((a < 0.0) != (b < 0.0) && a != 0.0) {
    std::uintmax_t evaluations = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        distance, 0.0, limit.reach, a, b, boost::math::tools::eps_tolerance<double>(52),
        evaluations);
    u = 0.5 * (bracket.first + bracket.second);
  }
  const ArcVector<N> y = arc.at(u);
  AtLimit<N> out;
  out.corrected = curve.corrector().correct_at(
      moved<N>(from.x, ReducedVector<N>(y.template head<N>())), limit.p, arc.direction(u));
  if (out.corrected.status == CorrectorStatus::converged)
    out.arc = Arc<N>(y, from.tangent, out.corrected.point.tangent);
  return out;
}

}  // namespace stationary
