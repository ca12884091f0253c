// Cost of proofs: a certificate with its spectrum, and an exhaustive search of [1e-3, 1e3] in every
// stretch, for each model; and a whole atlas, tilted families and spectra included.
#include <benchmark/benchmark.h>

#include <string>

#include "solver/atlas/atlas.hpp"
#include "solver/proof/certify.hpp"
#include "solver/search/search.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

const double coefficients[] = {1.0, 2.0};
const double axial[] = {1.0, 3.0};

Problem problem_of(const ModelDescription& model, Branch branch) {
  const Body body(1.0, 1.7, 0.6);
  if (model.kind == ModelDescription::Kind::coupled)
    return {body, Potential(Potential::coupled(model.name, coefficients)), branch};
  return {body,
          Potential(Potential::planar(model.name, coefficients),
                    Potential::thickness("reciprocal-quadratic", axial)),
          branch};
}

constexpr double nu = 0.4;

void certificate(benchmark::State& state, const ModelDescription& model, Branch branch) {
  const Problem problem = problem_of(model, branch);
  const Equilibrium at = solve(problem, nu);
  Certificate proof;
  for (auto _ : state) {
    proof = certify(problem, at);
    benchmark::DoNotOptimize(proof);
  }
  state.counters["bound"] = proof.error_bound;
  if (!proof.proven) state.SkipWithError("not proven");
}

void spectrum(benchmark::State& state, const ModelDescription& model, Branch branch) {
  const Problem problem = problem_of(model, branch);
  const Equilibrium at = solve(problem, nu);
  const Certificate proof = certify(problem, at);
  const Spectrum modes = stability(problem, at);
  for (auto _ : state) benchmark::DoNotOptimize(enclose_spectrum(problem, at, proof, modes));
}

void everything(benchmark::State& state, const ModelDescription& model, Branch branch) {
  const Problem problem = problem_of(model, branch);
  SearchResult found;
  for (auto _ : state) {
    found = search(problem, nu);
    benchmark::DoNotOptimize(found);
  }
  state.counters["boxes"] = static_cast<double>(found.boxes);
  state.counters["solutions"] = static_cast<double>(found.solutions.size());
  if (found.status != SearchStatus::complete) state.SkipWithError("undecided");
}

/// nu up to 1.1, 256 checkpoints, tolerance 1e-10.
void whole_atlas(benchmark::State& state) {
  const Potential potential(Potential::planar("neo-hookean", coefficients),
                            Potential::thickness("reciprocal-quadratic", axial));
  AtlasOptions options;
  options.to = 1.1;
  options.threads = static_cast<int>(state.range(0));
  std::size_t rows = 0;
  for (auto _ : state) {
    rows = 0;
    for (const AtlasSheet& sheet : atlas(Body(1.0, 1.7, 0.6), potential, options).sheets)
      rows += sheet.rows.size();
  }
  state.counters["rows"] = static_cast<double>(rows);
}

}  // namespace
}  // namespace stationary

int main(int argc, char** argv) {
  using namespace stationary;
  for (const ModelDescription& model : model_descriptions()) {
    if (model.kind == ModelDescription::Kind::thickness) continue;
    for (const Branch branch : {Branch::i, Branch::iii}) {
      const std::string name =
          std::string(model.name) + " (" + std::string(stationary::name(branch)) + ")";
      benchmark::RegisterBenchmark((name + " certificate").c_str(), certificate, model, branch)
          ->Unit(benchmark::kMicrosecond);
      benchmark::RegisterBenchmark((name + " spectrum").c_str(), spectrum, model, branch)
          ->Unit(benchmark::kMicrosecond);
      benchmark::RegisterBenchmark((name + " search").c_str(), everything, model, branch)
          ->Unit(benchmark::kMicrosecond);
    }
  }
  benchmark::RegisterBenchmark("neo-hookean atlas, threads", whole_atlas)
      ->Arg(1)
      ->Arg(2)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
