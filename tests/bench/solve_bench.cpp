// Solves per second, and the error against 50 digits, of the same sweep by
//   sweep            the reduced Newton of this library, corrected in extended precision
//   sweep-bounded    the same with an error bound on every point
//   newton-4x4       plain Newton on all of (alpha, xi, zeta, rho), Eigen's partialPivLu, analytic
//                    Jacobian, from the point before, until the step is at rounding
//   newton-4x4-para  the same from the sweep's own predictor, stopped one step earlier, where
//                    quadratic convergence has done the rest
//   tiny-solver      ceres::TinySolver on the same four equations, derivatives by Jets
//   ceres            ceres::Solve on the same
// in one run, repetitions interleaved at random. All but the plain newton-4x4 get the same
// predictor (the parabola through the last three points); each is asked for all the accuracy double
// gives. Ends with ratios to newton-4x4: a rate alone says more about the machine's neighbours than
// about the code.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "solver/batch/sweep.hpp"
#include "tests/bench/bodies.hpp"
#include "tests/bench/four_equations.hpp"
#include "tests/bench/march.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::bench {
namespace {

using Vector = Vector4<double>;

struct Case {
  std::string label;
  Problem problem;
  std::vector<double> nu;
  Equilibrium first;
};

Case make_case(std::string_view model, Branch branch) {
  const Problem problem = problem_of(model, branch);
  constexpr int points = 10000;
  constexpr double last_nu = 0.5;
  std::vector<double> nu(points);
  for (int k = 0; k < points; ++k) nu[static_cast<std::size_t>(k)] = last_nu * (k + 1) / points;
  const Equilibrium first = solve(problem, nu.front());
  return {label_of(model, branch), problem, nu, first};
}

template <template <class> class Peer>
bool run_peer(const Case& c, double tolerance, std::vector<Vector>& out,
              Start start = Start::parabola) {
  return visit(c.problem, [&]<class Model>(const Model& model) {
    Peer<Model> solve{c.problem.body(), model, tolerance};
    return march(c.problem.branch(), c.nu, c.first.q.vector(), start, solve, out);
  });
}

bool sweep(const Case& c, bool bounded, std::vector<SweepPoint>& points, std::vector<Vector>& out) {
  Sweep run(c.problem, c.first, {bounded});
  run.run(c.nu, points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].status != SolveStatus::solved) return false;
    out[k] = {0.0, points[k].xi, points[k].zeta, points[k].rho};
  }
  return true;
}

/// Worst relative error of (xi, zeta, rho) over every 97th point.
double worst_error(const Case& c, const std::vector<Vector>& x) {
  double worst = 0.0;
  for (std::size_t k = 0; k < x.size(); k += 97) {
    const Stretch q = Stretch::from(x[k]);
    worst = std::max(
        worst, testing::relative_error(q, testing::reference_solution(c.problem, c.nu[k], q)));
  }
  return worst;
}

template <class Method>
void run(benchmark::State& state, const Case& c, Method method) {
  std::vector<Vector> x(c.nu.size());
  for (auto _ : state) {
    if (!method(x)) {
      state.SkipWithError("did not converge");
      return;
    }
    benchmark::DoNotOptimize(x.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(c.nu.size()));
  state.counters["error"] = worst_error(c, x);
}

/// The usual table, then the ratios of the median rates.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.error_occurred || run.aggregate_name != "median") continue;
      const auto rate = run.counters.find("items_per_second");
      const auto error = run.counters.find("error");
      if (rate == run.counters.end() || error == run.counters.end()) continue;
      const std::string& full = run.run_name.function_name;
      const auto cut = full.find('|');
      table_[full.substr(0, cut)][full.substr(cut + 1)] = {rate->second.value, error->second.value};
    }
  }
  void Finalize() override {
    ConsoleReporter::Finalize();
    std::printf("\n%-28s %-16s %14s %12s %10s\n", "case", "method", "solves/s", "to 4x4", "error");
    for (const auto& [label, methods] : table_) {
      const auto base = methods.find("newton-4x4");
      for (const auto& [method, m] : methods) {
        std::printf("%-28s %-16s %14.0f %12.2f %10.2g\n", label.c_str(), method.c_str(), m.rate,
                    base == methods.end() ? 0.0 : m.rate / base->second.rate, m.error);
      }
    }
  }

 private:
  struct Measured {
    double rate;
    double error;
  };
  std::map<std::string, std::map<std::string, Measured>> table_;
};

void register_case(const Case& c) {
  const auto add = [&](const char* method, auto body) {
    benchmark::RegisterBenchmark((c.label + "|" + method).c_str(),
                                 [&c, body](benchmark::State& state) { run(state, c, body); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(7)
        ->ReportAggregatesOnly(true)
        ->MinTime(0.02);
  };
  add("sweep", [&c, points = std::vector<SweepPoint>(c.nu.size())](auto& x) mutable {
    return sweep(c, false, points, x);
  });
  add("sweep-bounded", [&c, points = std::vector<SweepPoint>(c.nu.size())](auto& x) mutable {
    return sweep(c, true, points, x);
  });
  add("newton-4x4", [&c](auto& x) { return run_peer<Newton4x4>(c, 1e-14, x, Start::last_point); });
  add("newton-4x4-para", [&c](auto& x) { return run_peer<Newton4x4>(c, 1e-9, x); });
  add("tiny-solver", [&c](auto& x) { return run_peer<TinySolver>(c, 1e-14, x); });
  add("ceres", [&c](auto& x) { return run_peer<CeresSolve>(c, 1e-14, x); });
}

}  // namespace
}  // namespace stationary::bench

int main(int argc, char** argv) {
  using stationary::Branch;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  static std::vector<stationary::bench::Case> cases;
  for (const std::string_view model : stationary::bench::planar_models) {
    for (const Branch branch : {Branch::i, Branch::iii})
      cases.push_back(stationary::bench::make_case(model, branch));
  }
  for (const auto& c : cases) stationary::bench::register_case(c);
  stationary::bench::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
