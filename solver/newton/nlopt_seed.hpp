// Starts for Newton by global search: NLopt's DIRECT (locally biased, deterministic) over a box of
// stretches in logarithmic coordinates, of
//
//   f(ln x) = |G(x)|^2 / magnitude(x)^2,
//
// bounded, and zero at equilibria only. Every sampled point is a candidate, not the minimum alone:
// G may vanish relatively at infinity (an escaping sheet), where no equilibrium is.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "solver/newton/reduced_system.hpp"

namespace stationary {

/// "2.7.1"; empty where this was built without: then a grid is sampled in its place (no_nlopt.cpp).
std::string version_of_nlopt();

struct SeedOptions {
  double min_stretch = 1e-3;
  double max_stretch = 1e3;
  int evaluations = 4000;
  int seeds = 48;
  double separation = 0.15;  ///< in max |ln|, between the seeds returned
  const std::atomic<bool>* stop = nullptr;
};

template <int N>
struct Seeds {
  std::vector<ReducedVector<N>> points;  ///< best first
  int evaluations = 0;
  bool interrupted = false;
};

/// objective: f above, at stretches x.
template <int N>
Seeds<N> nlopt_seeds(const std::function<double(const ReducedVector<N>&)>& objective,
                     const SeedOptions& options);

}  // namespace stationary
