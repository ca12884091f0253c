// A derivative is a slope: f(x + h w) - f(x) - h J w = O(h^2).
//
// Looked at over a range of h in a wide number, where rounding is far below the remainder: the
// order is read off from remainders at neighbouring h, and nothing is tuned. A wrong entry of J
// shows as order 1. A remainder that is zero to rounding (f linear) passes.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary::support {

/// f(h) = f(x + h w) as a column vector (or a number), slope = J w.
template <class F, class Slope>
::testing::AssertionResult is_slope(const std::string& x, const F& f, const Slope& slope) {
  using std::log2;
  using std::sqrt;
  constexpr int first = -20;
  constexpr int last = -40;
  constexpr int stride = 4;
  constexpr double least_order = 1.9;
  const auto size = [](const auto& v) -> Real50 {
    if constexpr (requires { v.squaredNorm(); }) {
      return sqrt(Real50(v.squaredNorm()));
    } else {
      return Real50(abs(v));
    }
  };
  const auto start = f(Real50(0));
  const Real50 scale = size(start) + size(slope);
  Real50 before = -1;
  std::ostringstream orders;
  for (int k = first; k >= last; k -= stride) {
    const Real50 h = ldexp(Real50(1), k);
    const Real50 remainder = size(Slope(f(h) - start - slope * h));
    if (!(remainder == remainder)) return ::testing::AssertionFailure() << x << ": NaN";
    if (remainder <= scale * Real50("1e-44")) return ::testing::AssertionSuccess();
    if (before > 0) {
      const double order = nearest(Real50(log2(before / remainder))) / stride;
      orders << " " << order;
      if (!(order >= least_order)) {
        return ::testing::AssertionFailure()
               << "\n  x          " << x << "\n  slope      " << slope << "\n  remainder  "
               << remainder << " at h = 2^" << k << "\n  orders    " << orders.str()
               << "\n  expected   2 or more";
      }
    }
    before = remainder;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace stationary::support
