// Zeros of a test function inside a step at whose ends it has one certain sign: pairs of places between
// which its sign changes.
#pragma once

#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/continuation/lambda_meetings.hpp"
#include "solver/continuation/step_points.hpp"

namespace stationary {

template <int N>
struct SignChange {
  typename StepPoints<N>::Sample low;
  typename StepPoints<N>::Sample high;
};

/// A place of the step, and the test functions there.
struct Tested {
  double u;
  TestValues tests;
};

/// About the least of a size between two places, that is < 0 where the sign of function k is another.
template <int N, class Size>
void zeros_about_least(StepPoints<N>& points, std::size_t k,
                       const typename StepPoints<N>::Sample& first,
                       const typename StepPoints<N>::Sample& last, const Size& size,
                       std::vector<SignChange<N>>& out) {
  std::uintmax_t evaluations = 25;
  const auto [u, least] =
      boost::math::tools::brent_find_minima(size, first.u, last.u, 20, evaluations);
  CurvePoint<N> lowest;
  if (!(least < 0.0) || !points.evaluate(u, lowest) || lowest.tests.sign(k) == 0) return;
  const typename StepPoints<N>::Sample between{u, lowest.tests.value[k]};
  out.push_back({first, between});
  out.push_back({between, last});
}

/// Of function k by itself.
template <int N>
void zeros_about_least(StepPoints<N>& points, std::size_t k,
                       const typename StepPoints<N>::Sample& first,
                       const typename StepPoints<N>::Sample& last,
                       std::vector<SignChange<N>>& out) {
  const double sign = first.value < 0.0 ? -1.0 : 1.0;
  const auto size = [&](double u) { return sign * points.value(k, u, first.value); };
  zeros_about_least(points, k, first, last, size, out);
}

/// Meetings of the Lambdas of one of TestValues::gaps, about its least size between two places where it is of
/// the same.
template <int N>
void meetings_about_least(StepPoints<N>& points, std::size_t gap, const Tested& a, const Tested& b,
                          std::vector<SignChange<N>>& out) {
  constexpr std::size_t k = TestValues::collision;
  const auto size = [&](double u) {
    CurvePoint<N> point;
    const bool known = points.evaluate(u, point);
    if (known && point.tests.sign(k) == -a.tests.sign(k)) return -std::abs(point.tests.value[k]);
    const bool same = known && same_pairs(a.tests, point.tests);
    return std::abs((same ? point.tests : a.tests).gaps[gap]);
  };
  zeros_about_least(points, k, {a.u, a.tests.value[k]}, {b.u, b.tests.value[k]}, size, out);
}

/// Meetings, by looking at many places of the step.
template <int N>
void meetings_between_parts(StepPoints<N>& points, std::vector<SignChange<N>>& out) {
  constexpr std::size_t k = TestValues::collision;
  constexpr int parts = 32;
  std::vector<Tested> at{{0.0, points.from().tests}};
  CurvePoint<N> point;
  for (int part = 1; part < parts; ++part)
    if (const double u = double(part) / double(parts); points.evaluate(u, point))
      at.push_back({u, point.tests});
  at.push_back({1.0, points.to().tests});
  const auto value = [&](std::size_t place) { return at[place].tests.value[k]; };
  const auto changes = [&](std::size_t place) {
    return (value(place) < 0.0) != (value(place + 1) < 0.0);
  };
  for (std::size_t place = 0; place + 1 < at.size(); ++place) {
    if (changes(place)) {
      out.push_back({{at[place].u, value(place)}, {at[place + 1].u, value(place + 1)}});
      continue;
    }
    if (place == 0 || changes(place - 1)) continue;
    const Tested& before = at[place - 1];
    const Tested& here = at[place];
    const Tested& behind = at[place + 1];
    if (!same_pairs(before.tests, here.tests) || !same_pairs(here.tests, behind.tests)) continue;
    for (std::size_t gap = 0; gap < here.tests.gaps.size(); ++gap) {
      const double size = std::abs(here.tests.gaps[gap]);
      if (size < std::abs(before.tests.gaps[gap]) && size <= std::abs(behind.tests.gaps[gap]))
        meetings_about_least(points, gap, before, behind, out);
    }
  }
}

/// Meetings of negative Lambdas that stand in another order at b than at a (order_changed), by halving: in
/// a place between they are complex. False where none is seen, however near the two places come: they
/// pass each other.
template <int N>
bool meetings_by_order(StepPoints<N>& points, const Tested& a, const Tested& b,
                       std::vector<SignChange<N>>& out) {
  constexpr std::size_t k = TestValues::collision;
  constexpr double nearest = 0x1p-36;
  if (b.u - a.u < nearest) return false;
  for (const double share : {0.5, 0.375, 0.625}) {
    const double u = a.u + share * (b.u - a.u);
    CurvePoint<N> point;
    if (!points.evaluate(u, point)) continue;
    const Tested at{u, point.tests};
    const int sign = at.tests.sign(k);
    if (sign == -a.tests.sign(k)) {
      out.push_back({{a.u, a.tests.value[k]}, {u, at.tests.value[k]}});
      out.push_back({{u, at.tests.value[k]}, {b.u, b.tests.value[k]}});
      return true;
    }
    const bool before = order_changed(a.tests, at.tests);
    const bool behind = order_changed(at.tests, b.tests);
    if (sign == 0 || !(before || behind)) continue;
    const bool seen = !before || meetings_by_order(points, a, at, out);
    return (!behind || meetings_by_order(points, at, b, out)) && seen;
  }
  return false;
}

}  // namespace stationary
