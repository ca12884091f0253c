// Zeros of a test function inside a step at whose ends it has one certain sign: places of the step where it may
// have the other. Zeros lie between neighbouring places of certain and opposite signs.
#pragma once

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/continuation/lambda_meetings.hpp"
#include "solver/continuation/step_points.hpp"

namespace stationary {

/// A place of the step, and the test functions there.
struct Tested {
  double u;
  TestValues tests;
};

/// Adds the place between two others where a size is least, if it is < 0 there.
template <int N, class Size>
void add_least(StepPoints<N>& points, double first, double last, const Size& size,
               std::vector<Tested>& out) {
  std::uintmax_t evaluations = 25;
  const auto [u, least] = boost::math::tools::brent_find_minima(size, first, last, 20, evaluations);
  CurvePoint<N> lowest;
  if (least < 0.0 && points.evaluate(u, lowest)) out.push_back({u, lowest.tests});
}

/// Where function k comes nearest to the other sign in the step.
template <int N>
void add_least(StepPoints<N>& points, std::size_t k, std::vector<Tested>& out) {
  const double f = points.from().tests.value[k];
  const double sign = f < 0.0 ? -1.0 : 1.0;
  add_least(
      points, 0.0, 1.0, [&](double u) { return sign * points.value(k, u, f); }, out);
}

/// Where the Lambdas of one of TestValues::gaps have met, about its least size between two places where it is of
/// the same.
template <int N>
void add_meeting(StepPoints<N>& points, std::size_t gap, const Tested& a, const Tested& b,
                 std::vector<Tested>& out) {
  constexpr std::size_t k = TestValues::collision;
  const int sign = a.tests.sign(k);
  if (sign == 0) return;
  const auto size = [&](double u) {
    CurvePoint<N> point;
    const bool known = points.evaluate(u, point);
    if (known && point.tests.sign(k) == -sign) return -std::abs(point.tests.value[k]);
    const bool same = known && same_pairs(a.tests, point.tests);
    return std::abs((same ? point.tests : a.tests).gaps[gap]);
  };
  add_least(points, a.u, b.u, size, out);
}

/// Many places of the step, and between them where some Lambdas have met.
template <int N>
void add_parts(StepPoints<N>& points, std::vector<Tested>& out) {
  constexpr int parts = 32;
  std::vector<Tested> at{{0.0, points.from().tests}};
  CurvePoint<N> point;
  for (int part = 1; part < parts; ++part)
    if (const double u = double(part) / double(parts); points.evaluate(u, point))
      at.push_back({u, point.tests});
  at.push_back({1.0, points.to().tests});
  for (std::size_t place = 1; place + 1 < at.size(); ++place) {
    const Tested& before = at[place - 1];
    const Tested& here = at[place];
    const Tested& behind = at[place + 1];
    out.push_back(here);
    if (!same_pairs(before.tests, here.tests) || !same_pairs(here.tests, behind.tests)) continue;
    for (std::size_t gap = 0; gap < here.tests.gaps.size(); ++gap) {
      const double size = std::abs(here.tests.gaps[gap]);
      if (size < std::abs(before.tests.gaps[gap]) && size <= std::abs(behind.tests.gaps[gap]))
        add_meeting(points, gap, before, behind, out);
    }
  }
}

/// Adds places between one where the Lambdas stand as at the end of the step and one where some have met,
/// nearer and nearer to the meeting; the last of the first sort.
template <int N>
Tested add_before_meeting(StepPoints<N>& points, Tested apart, Tested met,
                          std::vector<Tested>& out) {
  constexpr std::size_t k = TestValues::collision;
  constexpr int halvings = 12;
  CurvePoint<N> point;
  for (int n = 0; n < halvings; ++n) {
    const double u = 0.5 * (apart.u + met.u);
    if (!points.evaluate(u, point) || point.tests.sign(k) == 0) break;
    out.push_back({u, point.tests});
    (point.tests.sign(k) == apart.tests.sign(k) ? apart : met) = out.back();
  }
  return apart;
}

/// Where negative Lambdas have met that stand in another order at b than at a (order_changed), by halving. False
/// where some such place is not seen, however near the two come: they pass each other.
template <int N>
bool add_by_order(StepPoints<N>& points, const Tested& a, const Tested& b,
                  std::vector<Tested>& out) {
  constexpr std::size_t k = TestValues::collision;
  constexpr double nearest = 0x1p-36;
  if (!order_changed(a.tests, b.tests)) return true;
  if (b.u - a.u < nearest) return false;
  for (const double share : {0.5, 0.375, 0.625}) {
    CurvePoint<N> point;
    const double u = a.u + share * (b.u - a.u);
    if (!points.evaluate(u, point)) continue;
    const Tested at{u, point.tests};
    const int sign = at.tests.sign(k);
    Tested left = at;
    Tested right = at;
    if (sign == -a.tests.sign(k)) {
      out.push_back(at);
      left = add_before_meeting(points, a, at, out);
      right = add_before_meeting(points, b, at, out);
    } else if (sign == 0 ||
               !(order_changed(a.tests, at.tests) || order_changed(at.tests, b.tests))) {
      continue;
    }
    const bool seen = add_by_order(points, a, left, out);
    return add_by_order(points, right, b, out) && seen;
  }
  return false;
}

}  // namespace stationary
