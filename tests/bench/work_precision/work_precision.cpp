// Processor time against true error (50 digits) of this library and of its peers, in one run:
//   warm         equilibria of a sweep over 1,000 nu, each from the ones before
//   warm-coarse  the same over 50 nu: worse predictors
//   cold         equilibria, each from the rest state
//   spectrum     of an equilibrium
//   curve        the rest state's sheet, followed to a tolerance
//   curve-rows   the same at one tolerance: what its rows cost and keep
// Writes DIRECTORY/work_precision.csv, .meta.json, .svg and .png:
//
//   work_precision_bench --into DIRECTORY --scipy SCRIPT --auto EQUATIONS
//
// `cmake --build build/release --target work_precision` does that; with AUTO_DIR in the environment,
// or `auto` on the PATH, AUTO-07p follows the curves too.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <list>

#include "solver/program/table/atomic_file.hpp"
#include "tests/bench/bodies.hpp"
#include "tests/bench/work_precision/auto_peer.hpp"
#include "tests/bench/work_precision/curves.hpp"
#include "tests/bench/work_precision/equilibria.hpp"
#include "tests/bench/work_precision/scipy_peer.hpp"
#include "tests/bench/work_precision/spectra.hpp"
#include "tests/bench/work_precision/work_precision_figure.hpp"
#include "tests/bench/work_precision/work_precision_table.hpp"

namespace stationary::bench {
namespace {

constexpr std::string_view measured_models[] = {"reciprocal-determinant", "neo-hookean", "hencky"};
constexpr int repeats = 15;

void write(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void run(const std::filesystem::path& directory, const std::string& script,
         const std::string& equations) {
  const auto from = std::chrono::steady_clock::now();
  std::list<Equilibria> sweeps;  // lists: entries refer to their elements
  std::list<Spectra> motions;
  std::list<Curve> curves;
  std::vector<Entry> entries;
  ScipyPeer scipy(script);
  const bool has_scipy = !scipy.versions().empty();
  if (!has_scipy) std::printf("python3 with SciPy was not found: scipy-hybr is left out\n");
  const AutoPeer auto_peer(equations);
  const bool has_auto = auto_peer.missing().empty();
  if (!has_auto) std::printf("%s: its methods are left out\n", auto_peer.missing().c_str());
  for (const std::string_view model : measured_models) {
    for (const Branch branch : {Branch::i, Branch::iii}) {
      for (const auto& [what, count] : {std::pair{"warm", 1000}, {"warm-coarse", 50}}) {
        const Equilibria& of = sweeps.emplace_back(equilibria(model, branch, count));
        add_warm(of, what, entries);
        if (has_scipy) scipy.add(of, what, true, entries);
      }
      const Equilibria& of = sweeps.emplace_back(equilibria(model, branch, 20));
      add_cold(of, "cold", entries);
      if (has_scipy) scipy.add(of, "cold", false, entries);
      add_spectra(motions.emplace_back(spectra(model, branch, 20)), "spectrum", entries);
      const Curve& sheet = curves.emplace_back(curve(model, branch));
      add_curves(sheet, entries);
      if (has_auto) auto_peer.add(sheet, entries);
    }
  }
  const std::vector<Measured> results = measure(entries, repeats);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();

  std::filesystem::create_directories(directory);
  write(directory / "work_precision.csv", table_csv(results));
  write(directory / "work_precision.meta.json",
        table_metadata({repeats, seconds, results.size(), scipy.versions(), auto_peer.version(),
                        auto_peer.missing()}));
  for (const char* extension : {"svg", "png"})
    draw_work_precision(results, directory / ("work_precision." + std::string(extension)));
  std::fputs(comparison(results).c_str(), stdout);
  std::fputs(comparison_of_curves(results).c_str(), stdout);
  std::printf("%zu rows in %.0f s, written to %s\n", results.size(), seconds,
              (directory / "work_precision.csv").c_str());
}

}  // namespace
}  // namespace stationary::bench

int main(int argc, char** argv) {
  CLI::App app("Time against true error of this library and its peers");
  std::string directory;
  std::string script;
  app.add_option("--into", directory, "where the table and the figures go")->required();
  app.add_option("--scipy", script, "the script that runs SciPy")->required();
  std::string equations;
  app.add_option("--auto", equations, "the equations of the curves for AUTO-07p")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    stationary::bench::run(directory, script, equations);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "work_precision_bench: %s\n", e.what());
    return 4;
  }
  return 0;
}
