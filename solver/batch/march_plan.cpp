#include "solver/batch/march_plan.hpp"

#include <algorithm>
#include <cmath>

namespace stationary {
namespace {

/// Of the whole range of s^2: the first step from rest, and the longest.
constexpr double first_step = 1.0 / 96.0;
constexpr double longest_step = 1.0 / 12.0;

/// Lagrange's weights in s^2.
void set_weights(std::vector<MarchStep>& steps) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const std::size_t known = std::min<std::size_t>(k, 4);
    const double at = steps[k].s * steps[k].s;
    const auto node = [&](std::size_t i) { return steps[k - 1 - i].s * steps[k - 1 - i].s; };
    if (known == 0) steps[k].weight[0] = 1.0;  // the rest state itself
    for (std::size_t i = 0; i < known; ++i) {
      double weight = 1.0;
      for (std::size_t j = 0; j < known; ++j)
        if (j != i) weight *= (at - node(j)) / (node(i) - node(j));
      steps[k].weight[i] = weight;
    }
  }
}

}  // namespace

MarchPlan march_plan(std::span<const double> nu) {
  MarchPlan out;
  for (const double each : nu) out.s.push_back(std::abs(each));
  std::ranges::sort(out.s);
  out.s.erase(std::unique(out.s.begin(), out.s.end()), out.s.end());
  for (const double each : nu) {
    const auto at = std::ranges::lower_bound(out.s, std::abs(each));
    out.slot.push_back(static_cast<std::size_t>(at - out.s.begin()));
  }
  out.steps.push_back({});
  const double range = out.s.empty() ? 0.0 : out.s.back() * out.s.back();
  double square = 0.0;  // of the last step's s
  for (std::size_t k = 0; k < out.s.size(); ++k) {
    const double target = out.s[k] * out.s[k];
    for (;;) {
      const double step = std::clamp(square, first_step * range, longest_step * range);
      // Of squares below the smallest numbers a step is none.
      if (!(step > 0.0) || target - square <= 1.5 * step) break;
      square += step;
      out.steps.push_back({.s = std::sqrt(square)});
    }
    if (out.s[k] > 0.0) out.steps.push_back({.s = out.s[k]});
    out.steps.back().slot = static_cast<std::ptrdiff_t>(k);
    square = target;
  }
  set_weights(out.steps);
  return out;
}

}  // namespace stationary
