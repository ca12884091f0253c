#include "tests/stress/cases/fold_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/newton/newton.hpp"
#include "tests/stress/cases/near_event.hpp"

namespace stationary::stress {
namespace {

/// Newton in double from the solution itself until it stands still; xi, zeta. Separable potentials.
ReducedVector<2> plain_newton(const HardCase& c, ReducedVector<2> x) {
  std::visit(
      [&](const auto& model) {
        const PlanarSystem<std::decay_t<decltype(model)>> system{
            model, c.problem.rates(two_product(c.nu, c.nu))};
        newton(system, x);
        newton(system, x);
      },
      c.problem.potential().plane());
  return x;
}

double plain_error(const HardCase& c, const std::array<testing::Number50, 3>& exact) {
  const ReducedVector<2> x =
      plain_newton(c, {exact[0].convert_to<double>(), exact[1].convert_to<double>()});
  double worst = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const testing::Number50 off = testing::Number50(x[static_cast<int>(k)]) / exact[k] - 1;
    worst = std::max(worst, std::abs(off.convert_to<double>()));
  }
  return worst;
}

}  // namespace

std::vector<Rung> fold_ladder(long folds) {
  constexpr int first = 2;
  constexpr int last = 14;
  std::vector<Rung> out;
  for (int k = first; k <= last; ++k) out.push_back({std::pow(10.0, -k), {}});
  Random random(21);
  for (long n = 0; n < folds; ++n) {
    const LocatedFold fold = random_fold(random);
    for (Rung& rung : out) {
      const HardCase c = beside_fold(random, fold, rung.distance);
      const Outcome outcome = judged(c);
      rung.tally.add(outcome);
      if (outcome.status != SolveStatus::solved) continue;
      rung.worst_error = std::max(rung.worst_error, outcome.error);
      rung.largest_error_bound = std::max(rung.largest_error_bound, outcome.error_bound);
      if (!c.problem.potential().is_separable()) continue;
      rung.worst_plain_error = std::max(rung.worst_plain_error, plain_error(c, outcome.exact));
    }
  }
  return out;
}

std::string ladder_table(const std::vector<Rung>& ladder) {
  std::string out =
      "distance,tried,solved,within_one_unit,above_bound,wrong_class,worst_units,worst_error,"
      "worst_error_double_residual,largest_error_bound\n";
  for (const Rung& rung : ladder) {
    const Tally& t = rung.tally;
    char text[256];
    std::snprintf(text, sizeof text, "%.0e,%ld,%ld,%ld,%ld,%ld,%.3g,%.3g,%.3g,%.3g\n",
                  rung.distance, t.tried, t.solved, t.within_one_unit, t.above_bound, t.wrong_class,
                  t.worst_units, rung.worst_error, rung.worst_plain_error,
                  rung.largest_error_bound);
    out += text;
  }
  return out;
}

}  // namespace stationary::stress
