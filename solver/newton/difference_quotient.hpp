// Slopes of functions that are known by their values alone, each a solve to nearly all digits: by
// the symmetric quotient of six points,
//
//   f' = (45 (f_1 - f_-1) - 9 (f_2 - f_-2) + (f_3 - f_-3))/(60 h) + O(h^6),   f_k = f(x + k h),
//
// of several h, each an eighth of the one before. What a quotient is off by is seen from that of
// four points, which errs by O(h^4), from the rounding of the values, and from the next h, whose
// rounding is eight times as large: of each function the h is taken that has the least of them.
//
// The slopes of both sides, (f_1 - f_0)/h and (f_0 - f_-1)/h, differ by h f'': by an eighth at each next
// h. Where they do not (|x|, or a root as of a growth that begins there) there is no slope.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace stationary {

/// NaN of a function that was not known at all points of any h, or has none.
struct Slopes {
  std::vector<double> slope;
  std::vector<double> error;  ///< of each, estimated
};

/// at(x) gives the values of `count` functions, or nothing where they have none there. size: over
/// which they may change by much, > 0. settled: of a slope whose error is below this share of it no
/// smaller h is tried.
template <class At>
Slopes difference_quotients(const At& at, double x, double size, std::size_t count,
                            double settled = 1e-12) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr int most_steps = 6;
  Slopes best{std::vector<double>(count, nan), std::vector<double>(count, HUGE_VAL)};
  // What has no value at x has no slope.
  const std::optional<std::vector<double>> middle = at(x);
  if (!middle) return {best.slope, best.slope};
  std::vector<double> before;
  std::vector<double> before_error;
  std::vector<double> bend(count,
                           0.0);  // by how much the two sides' slopes differ, at the h before
  std::vector<bool> broken(count, false);
  double h = std::ldexp(size, -7);
  for (int step = 0; step < most_steps; ++step, h *= 0.125) {
    std::array<std::optional<std::vector<double>>, 6> f;  // at -3, -2, -1, 1, 2, 3
    constexpr double places[6] = {-3.0, -2.0, -1.0, 1.0, 2.0, 3.0};
    bool known = true;
    for (std::size_t k = 0; k < 6 && known; ++k) {
      f[k] = at(x + places[k] * h);
      known = f[k].has_value();
    }
    if (!known) continue;
    std::vector<double> slope(count, nan);
    std::vector<double> error(count, HUGE_VAL);
    bool all_settled = true;
    for (std::size_t i = 0; i < count; ++i) {
      const auto difference = [&](std::size_t k) { return (*f[k + 3])[i] - (*f[2 - k])[i]; };
      const double d1 = difference(0);
      const double d2 = difference(1);
      const double d3 = difference(2);
      slope[i] = (45.0 * d1 - 9.0 * d2 + d3) / (60.0 * h);
      // Values of some units in the last place: no less than that over h.
      error[i] =
          std::abs(slope[i] - (8.0 * d1 - d2) / (12.0 * h)) + 0x1p-50 * std::abs((*middle)[i]) / h;
      const double right = (*f[3])[i] - (*middle)[i];
      const double left = (*middle)[i] - (*f[2])[i];
      const double differ = std::abs(right - left) / h;
      constexpr double beyond_noise = 10.0;  // which is in the error
      if (differ > beyond_noise * error[i]) {
        broken[i] = bend[i] > 0.0 && differ > 0.5 * bend[i];
        bend[i] = differ;
      }
      if (!before.empty()) {
        // The coarser one, now that its rounding is seen.
        const double seen = std::max(before_error[i], std::abs(before[i] - slope[i]));
        if (seen < best.error[i]) {
          best.slope[i] = before[i];
          best.error[i] = seen;
        }
      }
      if ((*middle)[i] == (*middle)[i])
        all_settled = all_settled && best.error[i] <= settled * std::abs(best.slope[i]);
    }
    before = std::move(slope);
    before_error = std::move(error);
    if (all_settled) break;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (broken[i]) best.slope[i] = nan;
    if (!(best.slope[i] == best.slope[i])) best.error[i] = nan;
  }
  return best;
}

}  // namespace stationary
