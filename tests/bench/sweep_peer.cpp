// What python_bench.py is measured against: a million nu of cases/disc.toml by Sweep, in seconds
// of the processor, the better of two.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <vector>

#include "solver/batch/sweep.hpp"

int main() {
  using namespace stationary;
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
    const std::clock_t begin = std::clock();
    std::vector<SweepPoint> points(count);
    Sweep(disc, solve(disc, nu[0])).run(nu, points);
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (points.back().status != SolveStatus::solved) return 1;
  }
  std::printf("%.4f\n", best);
  return 0;
}
