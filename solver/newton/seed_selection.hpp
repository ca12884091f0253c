// Of the points that a global search has sampled, those to begin Newton's method at: the lowest, some way apart.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/matrix/elementwise.hpp"
#include "solver/newton/nlopt_seed.hpp"

namespace stationary {

template <int N>
using SampledSeed = std::pair<double, ReducedVector<N>>;  ///< f, ln x

/// Stretches, best first; sorts what was sampled.
template <int N>
std::vector<ReducedVector<N>> select_seeds(std::vector<SampledSeed<N>>& sampled,
                                           const SeedOptions& options) {
  std::stable_sort(sampled.begin(), sampled.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ReducedVector<N>> kept;
  for (const auto& sample : sampled) {
    const ReducedVector<N>& point = sample.second;
    if (static_cast<int>(kept.size()) == options.seeds) break;
    const bool apart = std::all_of(kept.begin(), kept.end(), [&](const ReducedVector<N>& other) {
      return (point - other).cwiseAbs().maxCoeff() >= options.separation;
    });
    if (apart) kept.push_back(point);
  }
  for (ReducedVector<N>& each : kept) each = exponentials(each.array());
  return kept;
}

}  // namespace stationary
