// Where a sheet of ellipses (J1 = J2, branch (iii)) meets the circle: K_alpha,alpha = 0 on it.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "solver/continuation/curve.hpp"

namespace stationary {

/// The circle's point inside the step of a sheet of ellipses from `from` to `to`, which lie on
/// different sides of xi = zeta. The circle's points are taken by their radius: to each belongs one
/// p, while p may turn near by. Nothing where it is not found.
template <int N>
std::optional<CurvePoint<N>> circle_within(const Curve<N>& ellipses, const CurvePoint<N>& from,
                                           const CurvePoint<N>& to, const Arc<N>& arc) {
  const double scale = ellipses.corrector().scale();
  const Curve<N> circle(ellipses.family(), scale, true);
  const double gap = std::log(from.arc.x[0] / from.arc.x[1]);
  const double u = gap / (gap - std::log(to.arc.x[0] / to.arc.x[1]));
  const ArcVector<N> y = arc.at(u);
  ReducedVector<N> x = moved<N>(from.arc.x, ReducedVector<N>(y.template head<N>()));
  x[0] = x[1] = std::sqrt(x[0] * x[1]);
  const double guess = from.arc.p + scale * y[N];
  ArcVector<N> outward = ArcVector<N>::Zero();
  outward[0] = outward[1] = std::numbers::sqrt2 / 2.0;
  constexpr double near = 0.1;
  const auto at = [&](double s) {
    const ReducedVector<N> start = moved<N>(x, s * outward.template head<N>());
    const Corrected<N> out = circle.corrector().correct(start, guess, outward, near);
    CurvePoint<N> point;  // K_alpha,alpha NaN where it is not found
    point.tests.value.fill(std::numeric_limits<double>::quiet_NaN());
    return out.status == CorrectorStatus::converged ? circle.complete(out.point) : point;
  };
  const auto stiffness = [&](double s) { return at(s).tests.value[TestValues::ellipse]; };
  for (double reach = 1e-3 * arc.length; reach <= near; reach *= 4.0) {
    const double a = stiffness(-reach);
    const double b = stiffness(reach);
    if (std::isnan(a) || std::isnan(b)) break;
    if ((a < 0.0) == (b < 0.0)) continue;
    std::uintmax_t evaluations = 80;
    const auto [low, high] = boost::math::tools::toms748_solve(
        stiffness, -reach, reach, a, b, boost::math::tools::eps_tolerance<double>(52), evaluations);
    CurvePoint<N> out = at(0.5 * (low + high));
    out.member.error_bound *= 4.0;
    if (auto known = circle.event_at(EventType::ellipse, out.member, reach))
      out.member = std::move(known->member);
    return out;
  }
  return std::nullopt;
}

}  // namespace stationary
