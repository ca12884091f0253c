// Where a sheet of ellipses meets the circle that its family may be (body/circle.hpp).
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "lib/number/elementary.hpp"
#include "solver/continuation/curve.hpp"

namespace stationary {

/// The circle's point inside the step of a sheet of ellipses from `from` to `to`, which lie on
/// different sides of it. The circle's points are taken by their radius: to each belongs one
/// p, while p may turn near by; or by p, where that enters no balance of the circle. Nothing where
/// it is not found.
template <int N>
std::optional<CurvePoint<N>> circle_within(const Curve<N>& ellipses, const CurvePoint<N>& from,
                                           const CurvePoint<N>& to, const Arc<N>& arc) {
  const double scale = ellipses.corrector().scale();
  const Circle section = ellipses.family().circle();
  const auto [first, second, other] = places(section);
  const Curve<N> circle(ellipses.family(), scale, section);
  const double gap = log(from.arc.x[first] / from.arc.x[second]);
  const double u = gap / (gap - log(to.arc.x[first] / to.arc.x[second]));
  const ArcVector<N> y = arc.at(u);
  ReducedVector<N> x = moved<N>(from.arc.x, ReducedVector<N>(y.template head<N>()));
  x[first] = x[second] = std::sqrt(x[first] * x[second]);
  const double guess = from.arc.p + scale * y[N];
  constexpr double near = 0.1;
  const auto found_along = [&](const ArcVector<N>& along) -> std::optional<CurvePoint<N>> {
    const auto at = [&](double s) {
      const ReducedVector<N> start = moved<N>(x, ReducedVector<N>(s * along.template head<N>()));
      const Corrected<N> out =
          circle.corrector().correct(start, guess + scale * s * along[N], along, near);
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
          stiffness, -reach, reach, a, b, boost::math::tools::eps_tolerance<double>(52),
          evaluations);
      CurvePoint<N> out = at(0.5 * (low + high));
      if (std::isnan(out.tests.value[TestValues::ellipse])) return std::nullopt;
      out.member.error_bound *= 4.0;
      if (auto known = circle.event_at(ellipse_event(section), out.member, reach))
        out.member = std::move(known->member);
      return out;
    }
    return std::nullopt;
  };
  ArcVector<N> outward = ArcVector<N>::Zero();
  outward[first] = outward[second] = std::numbers::sqrt2 / 2.0;
  if (auto out = found_along(outward)) return out;
  return found_along(ArcVector<N>::Unit(N));
}

}  // namespace stationary
