// What python_bench.py is measured against: a million nu of cases/disc.toml by Sweep, in seconds.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

#include "solver/batch/sweep.hpp"

int main() {
  using namespace stationary;
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t count = 1'000'000;
  constexpr double plane[] = {1.0, 2.0};
  constexpr double thickness[] = {1.0, 3.0};
  const Problem disc(Body(1.0, 1.7, 0.6),
                     Potential(Potential::planar("reciprocal-determinant", plane),
                               Potential::thickness("reciprocal-quadratic", thickness)),
                     Branch::i);
  std::vector<double> nu(count);
  for (std::size_t k = 0; k < count; ++k)
    nu[k] = static_cast<double>(k) / static_cast<double>(count - 1);
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 2; ++run) {
    const auto begin = Clock::now();
    std::vector<SweepPoint> points(count);
    Sweep(disc, solve(disc, nu[0])).run(nu, points);
    best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
    if (points.back().status != SolveStatus::solved) return 1;
  }
  std::printf("%.4f\n", best);
  return 0;
}
