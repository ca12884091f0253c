// Cells solved per second and core, of bodies that differ in J2, each at many nu, by
//   sweep      the scalar path, body after body (sweep.hpp), with an error bound on every point
//   INSTRUCTIONS-double, INSTRUCTIONS-corrected
//              the batch (batch.hpp) on one instruction set each, with residuals in double and
//              with residuals in pairs of doubles (S rounded correctly); -bounded: with
//              error bounds
//   sweep-spectrum, INSTRUCTIONS-class, INSTRUCTIONS-spectrum
//              sweep and stability(); the batch corrected and bounded, then the class and negative
//              directions of every cell (batch_spectrum.hpp), or its modes too
// in one run, repetitions interleaved at random; output in the batch's tiles. Then the error of
// each against 50 digits (followed: the largest error bound) and the rates as ratios to the
// sweep's.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "solver/batch/sweep.hpp"
#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/solve/stability.hpp"
#include "tests/bench/bodies.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::bench {
namespace {

constexpr std::size_t lanes = 64;
constexpr int points = 1000;
constexpr double last_nu = 0.5;

struct Case {
  std::string label;
  Problem problem;
  BatchInput input;
};

Case make_case(const Problem& problem, const std::string& label) {
  std::vector<double> nu(points);
  for (std::size_t k = 0; k < nu.size(); ++k) nu[k] = last_nu * static_cast<double>(k + 1) / points;
  BatchInput input(problem, lanes, nu);
  std::vector<double> J2(lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    J2[lane] = 1.5 + 0.005 * static_cast<double>(lane);
  input.inertia[1] = J2;
  return {label, problem, input};
}

Case make_fibred_case(Branch branch, double degrees) {
  const Problem problem(
      Body(1.0, 1.7, 0.6),
      Potential(AnisotropicPotential(NeoHookean<>{1.0, 2.0}, ReciprocalQuadratic<>{1.0, 3.0},
                                     {{0.4, degrees}})),
      branch);
  return make_case(problem, "fibred/" + std::string(name(branch)));
}

double relative_error_of(const Problem& problem, double nu, const Stretch& q) {
  return testing::relative_error(q, testing::reference_solution(problem, nu, q));
}

void finish(benchmark::State& state, double error) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(lanes * points));
  state.counters["error"] = error;
}

Equilibrium equilibrium_of(Branch branch, const SweepPoint& point) {
  Equilibrium out;
  out.status = point.status;
  out.q = {0.0, point.xi, point.zeta, point.rho};
  out.nu = angular_velocity(branch, point.nu);
  out.error_bound = point.error_bound;
  return out;
}

void run_sweep(benchmark::State& state, const Case& c, bool with_spectrum) {
  std::vector<Problem> problems;
  std::vector<Equilibrium> starts;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    problems.push_back(c.input.problem(lane));
    starts.push_back(solve(problems.back(), c.input.nu.front()));
  }
  std::vector<SweepPoint> out(c.input.nu.size());
  double worst = 0.0;
  for (auto _ : state) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      Sweep(problems[lane], starts[lane]).run(c.input.nu, out);
      benchmark::DoNotOptimize(out.data());
      if (!with_spectrum) continue;
      for (const SweepPoint& point : out) {
        Spectrum spectrum =
            stability(problems[lane], equilibrium_of(problems[lane].branch(), point));
        benchmark::DoNotOptimize(&spectrum);
      }
    }
  }
  for (std::size_t k = 0; k < out.size(); k += 97) {
    const Stretch q{0.0, out[k].xi, out[k].zeta, out[k].rho};
    worst = std::max(worst, relative_error_of(problems.back(), out[k].nu, q));
  }
  finish(state, worst);
}

void run_batch(benchmark::State& state, const Case& c, const BatchOptions& options) {
  BatchResult out;
  for (auto _ : state) {
    solve_batch(c.input, options, out);
    benchmark::DoNotOptimize(&out);
  }
  double worst = 0.0;
  for (std::size_t k = 0; k < out.count(); k += 97) {
    const BatchCell cell = out.cell(lanes - 1, k);
    if (cell.status != SolveStatus::solved) {
      state.SkipWithError("a cell was not solved");
      return;
    }
    worst = std::max(worst, relative_error_of(c.input.problem(lanes - 1), c.input.nu[k],
                                              {0.0, cell.xi, cell.zeta, cell.rho}));
  }
  if (out.fallbacks() > 0) state.SkipWithError("a lane fell back to the scalar path");
  finish(state, worst);
}

void run_followed(benchmark::State& state, const Case& c) {
  BatchResult out;
  for (auto _ : state) {
    solve_batch(c.input, {}, out);
    benchmark::DoNotOptimize(&out);
  }
  double worst = 0.0;
  for (std::size_t k = 0; k < out.count(); k += 97) {
    const BatchCell cell = out.cell(lanes - 1, k);
    if (cell.status != SolveStatus::solved) {
      state.SkipWithError("a cell was not solved");
      return;
    }
    worst = std::max(worst, cell.error_bound);
  }
  finish(state, worst);
}

/// In blocks, as a map's rows are made.
void run_spectra(benchmark::State& state, const Case& c, const BatchOptions& options,
                 const SpectrumOptions& what) {
  constexpr std::size_t block = 500;
  std::vector<CellPlace> places;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t k = 0; k < c.input.nu.size(); ++k) places.push_back({lane, k});
  std::vector<CellSpectrum> spectra(block);
  BatchResult solved;
  std::size_t scalar = 0;
  for (auto _ : state) {
    solve_batch(c.input, options, solved);
    scalar = 0;
    for (std::size_t i = 0; i < places.size(); i += block)
      scalar += cell_spectra(c.input, solved, {places.data() + i, block}, what, spectra);
    benchmark::DoNotOptimize(spectra.data());
  }
  if (c.problem.potential().is_isotropic() && scalar > places.size() / 100)
    state.SkipWithError("lanes left much to the scalar path");
  finish(state, 0.0);
}

/// The usual table, then the ratios of the median rates.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.error_occurred || run.aggregate_name != "median") continue;
      const std::string& full = run.run_name.function_name;
      const auto cut = full.find('|');
      table_[full.substr(0, cut)][full.substr(cut + 1)] = {
          run.counters.at("items_per_second").value, run.counters.at("error").value};
    }
  }
  void Finalize() override {
    ConsoleReporter::Finalize();
    std::printf("\n%-28s %-28s %12s %10s %10s\n", "case", "method", "million/s", "to sweep",
                "error");
    for (const auto& [label, methods] : table_) {
      const auto base = methods.find("sweep");
      for (const auto& [method, m] : methods) {
        std::printf("%-28s %-28s %12.2f %10.2f %10.2g\n", label.c_str(), method.c_str(),
                    1e-6 * m.rate, base == methods.end() ? 0.0 : m.rate / base->second.rate,
                    m.error);
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
  const auto add = [&](const std::string& method, auto body) {
    benchmark::RegisterBenchmark((c.label + "|" + method).c_str(),
                                 [&c, body](benchmark::State& state) { body(state, c); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(7)
        ->ReportAggregatesOnly(true)
        ->MinTime(0.02);
  };
  if (!c.problem.potential().is_isotropic()) {
    add("followed", [](benchmark::State& state, const Case& of) { run_followed(state, of); });
    for (const bool modes : {false, true})
      add(modes ? "followed-spectrum" : "followed-class",
          [modes](benchmark::State& state, const Case& of) {
            run_spectra(state, of, {}, {.modes = modes});
          });
    return;
  }
  add("sweep", [](benchmark::State& state, const Case& of) { run_sweep(state, of, false); });
  add("sweep-spectrum",
      [](benchmark::State& state, const Case& of) { run_sweep(state, of, true); });
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!has_instruction_set(set)) continue;
    for (const bool extended : {false, true}) {
      for (const bool bounded : {false, true}) {
        const BatchOptions options{
            .error_bound = bounded, .extended = extended, .instructions = set};
        add(std::string(name(set)) + (extended ? "-corrected" : "-double") +
                (bounded ? "-bounded" : ""),
            [options](benchmark::State& state, const Case& of) { run_batch(state, of, options); });
      }
    }
    for (const bool modes : {false, true}) {
      const BatchOptions options{.instructions = set};
      const SpectrumOptions what{.modes = modes, .instructions = set};
      add(std::string(name(set)) + (modes ? "-spectrum" : "-class"),
          [options, what](benchmark::State& state, const Case& of) {
            run_spectra(state, of, options, what);
          });
    }
  }
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
      cases.push_back(stationary::bench::make_case(stationary::bench::problem_of(model, branch),
                                                   stationary::bench::label_of(model, branch)));
  }
  cases.push_back(stationary::bench::make_fibred_case(Branch::iii, 30.0));
  cases.push_back(stationary::bench::make_fibred_case(Branch::i, 90.0));
  for (const auto& c : cases) stationary::bench::register_case(c);
  stationary::bench::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
