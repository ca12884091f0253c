// Slopes of functions that are known by their values alone, each a solve to nearly all digits: by
// the symmetric quotient of six points,
//
//   f' = (45 (f_1 - f_-1) - 9 (f_2 - f_-2) + (f_3 - f_-3))/(60 h) + O(h^6),   f_k = f(x + k h),
//
// of several h, each an eighth of the one before. What a quotient is off by is seen from that of
// four points, which errs by O(h^4), from the noise of the values, and from the next h, whose
// noise is eight times as large: of each function the h is taken that has the least of them. Where a function changes within
// less than h, what is seen of it is a jump, the values of either side being far nearer to each other than to the other
// side's: no such h is taken, and smaller ones are tried. The noise of
// values that are small beside their terms is not of their own last place: it is what is left in the fifth and
// sixth differences of the seven points, of a smooth function O(h^5).
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
#include <span>
#include <utility>
#include <vector>

namespace stationary {

/// NaN of a function that was not known at all points of any h, or has none.
struct Slopes {
  std::vector<double> slope;
  std::vector<double> error;  ///< of each, estimated
};

namespace detail {

/// The quotients of one function by h descending.
class Quotients {
 public:
  /// Values at x - 3 h ... x + 3 h.
  void add(const std::array<double, 7>& v, double h) {
    const double d1 = v[4] - v[2];
    const double d2 = v[5] - v[1];
    const double d3 = v[6] - v[0];
    Step step;
    step.h = h;
    step.slope = (45.0 * d1 - 9.0 * d2 + d3) / (60.0 * h);
    step.cut = std::abs(step.slope - (8.0 * d1 - d2) / (12.0 * h));
    step.bend = std::abs((v[4] - v[3]) - (v[3] - v[2]));
    // Of noise of size s fifth differences are about 16 s, the sixth 30 s.
    const auto fifth = [&](std::size_t k) {
      return v[k + 5] - 5.0 * v[k + 4] + 10.0 * v[k + 3] - 10.0 * v[k + 2] + 5.0 * v[k + 1] - v[k];
    };
    const double seen = std::max({std::abs(fifth(0)) / 16.0, std::abs(fifth(1)) / 16.0,
                                  std::abs(fifth(1) - fifth(0)) / 30.0});
    constexpr double safety = 4.0;  // few samples
    step.noise = std::max(safety * seen, 0x1p-50 * std::abs(v[3]));
    const double jump = std::abs((v[4] + v[5] + v[6]) - (v[0] + v[1] + v[2])) / 3.0;
    const auto [least_left, most_left] = std::minmax({v[0], v[1], v[2]});
    const auto [least_right, most_right] = std::minmax({v[4], v[5], v[6]});
    const double scatter = std::max(most_left - least_left, most_right - least_right);
    constexpr double far = 8.0;  // along a line it is twice the scatter
    step.jumps = jump > far * scatter && jump > 0x1p-44 * std::abs(v[3]);
    steps_.push_back(step);
  }

  /// A slope and what it is off by, of all but the last h: NaN and infinite of none.
  std::pair<double, double> best() const {
    std::pair<double, double> out{std::numeric_limits<double>::quiet_NaN(), HUGE_VAL};
    for (std::size_t k = 0; k + 1 < steps_.size(); ++k) {
      const Step& step = steps_[k];
      if (step.jumps || steps_[k + 1].jumps) continue;
      const double seen =
          std::max(step.cut + noise_from(k) / step.h, std::abs(step.slope - steps_[k + 1].slope));
      if (seen < out.second) out = {step.slope, seen};
    }
    return out;
  }

  /// Whether the function is not yet seen to be smooth at two h: it is not known there, or jumps from one side to the
  /// other.
  bool is_open() const {
    if (steps_.size() < 2) return true;
    const auto last = std::span(steps_).last(std::min<std::size_t>(steps_.size(), 3));
    return std::ranges::any_of(last, &Step::jumps);
  }

  /// Whether f_1 - 2 f_0 + f_-1 falls as h, an eighth at the next, and not as h^2, where it is more than
  /// the noise of two later h at least.
  bool bends_as_a_corner() const {
    constexpr double beyond = 4.0;
    bool out = false;
    double last = 0.0;
    for (std::size_t k = 0; k + 3 < steps_.size(); ++k) {
      const double bend = steps_[k].bend;
      if (!(bend > beyond * noise_from(k + 2))) continue;
      out = last > 0.0 && bend > 0.5 * 0.125 * last;
      last = bend;
    }
    return out;
  }

 private:
  struct Step {
    double h;
    double slope;
    double cut;   ///< by what the quotient of four points differs
    double bend;  ///< of the values of both sides from a line
    double noise;
    bool jumps;
  };
  /// Seen at this h or a later one, where less of the function is in it.
  double noise_from(std::size_t k) const {
    double out = 0.0;
    for (; k < steps_.size(); ++k) out = std::max(out, steps_[k].noise);
    return out;
  }
  std::vector<Step> steps_;
};

}  // namespace detail

/// at(x) gives the values of `count` functions, or nothing where they have none there. size: over
/// which they may change by much, > 0. settled: of a slope whose error is below this share of it no
/// smaller h is tried.
template <class At>
Slopes difference_quotients(const At& at, double x, double size, std::size_t count,
                            double settled = 1e-12) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t steps = 6;
  constexpr std::size_t most_steps = 9;  // of what is open then
  Slopes out{std::vector<double>(count, nan), std::vector<double>(count, nan)};
  // What has no value at x has no slope.
  const std::optional<std::vector<double>> middle = at(x);
  if (!middle) return out;
  std::vector<detail::Quotients> of(count);
  double h = std::ldexp(size, -7);
  for (std::size_t step = 0; step < most_steps; ++step, h *= 0.125) {
    if (step >= steps &&
        std::ranges::none_of(of, [](const detail::Quotients& each) { return each.is_open(); }))
      break;
    std::array<std::optional<std::vector<double>>, 6> f;  // at -3, -2, -1, 1, 2, 3
    constexpr double places[6] = {-3.0, -2.0, -1.0, 1.0, 2.0, 3.0};
    bool known = true;
    for (std::size_t k = 0; k < 6 && known; ++k) {
      f[k] = at(x + places[k] * h);
      known = f[k].has_value();
    }
    if (!known) continue;
    bool all_settled = true;
    for (std::size_t i = 0; i < count; ++i) {
      of[i].add(
          {(*f[0])[i], (*f[1])[i], (*f[2])[i], (*middle)[i], (*f[3])[i], (*f[4])[i], (*f[5])[i]},
          h);
      const auto [slope, error] = of[i].best();
      if ((*middle)[i] == (*middle)[i])
        all_settled = all_settled && error <= settled * std::abs(slope);
    }
    if (all_settled) break;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto [slope, error] = of[i].best();
    if (of[i].bends_as_a_corner() || !(slope == slope)) continue;
    constexpr double safety = 2.0;
    out.slope[i] = slope;
    out.error[i] = safety * error;
  }
  return out;
}

}  // namespace stationary
