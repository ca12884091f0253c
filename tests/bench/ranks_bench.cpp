// What tiles cost that are handed out, under mpirun or alone, and what ten thousand ranks would do:
//
//   mpirun -n 2 ranks_bench overhead       microseconds of an empty tile: alone, journalled, of rank 0
//                                          that hands out to another
//   ranks_bench simulation MAP ATLASES     recorded costs of both cases' tiles, dispatched to many ranks
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/commands/mpi_crew.hpp"
#include "solver/program/rows/map_cells.hpp"
#include "solver/program/tiles/tiled_run.hpp"
#include "tests/bench/ranks_simulation.hpp"

namespace {

using namespace stationary;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Microseconds a tile.
double empty_tiles(const cli::TiledRun& how, std::size_t tiles, std::size_t bytes) {
  cli::Run run;
  // Where there is another rank, rank 0 does nothing but hand out.
  run.threads = how.crew != nullptr && how.crew->leads() && how.crew->ranks() > 1 ? 0 : 1;
  const std::string text(bytes, 'x');
  cli::TileRunner runner({.hash = "empty",
                          .share = {0, tiles},
                          .unit = "tiles",
                          .compute = [&](const cli::Share&) { return std::optional(text); }},
                         how, run);
  const auto begin = Clock::now();
  runner.run([](const cli::Share&, const std::string&) {});
  const double seconds = seconds_since(begin);
  runner.finish();
  return 1e6 * seconds / static_cast<double>(tiles);
}

void overhead() {
  cli::MpiCrew crew;
  const bool leads = crew.leads();
  const std::string table =
      (std::filesystem::temp_directory_path() / fmt::format("empty-{}.csv", ::getpid())).string();
  constexpr std::pair<std::size_t, std::size_t> sizes[] = {{100, 100'000}, {10'000, 10'000}};
  if (leads) fmt::print("microseconds of an empty tile\n{:>34} bytes {:>8} bytes\n", 100, 10'000);
  const auto line = [&](const char* name, const cli::TiledRun& how) {
    if (leads) fmt::print("  {:25}", name);
    for (const auto& [bytes, tiles] : sizes) {
      const double each = empty_tiles(how, tiles, bytes);
      if (leads) fmt::print(" {:13.2f}", each);
    }
    if (leads) fmt::print("\n");
  };
  if (leads) {
    line("alone", {});
    cli::TiledRun kept;
    kept.journal = table;
    line("alone, with a journal", kept);
  }
  cli::TiledRun by_ranks;
  by_ranks.crew = &crew;
  line("rank 0, of one other rank", by_ranks);
  if (leads) by_ranks.journal = table;
  line("the same, with a journal", by_ranks);
}

std::vector<double> map_costs(const std::string& path) {
  const Case input = read_case(path, {});
  const auto cells = map_cells(input);
  std::vector<double> out;
  std::vector<TableRow> rows;
  const RowParts parts{.spectrum = true, .map = true};
  for (std::size_t k = 0; k < cells->size(); k += cells->tile()) {
    const auto begin = Clock::now();
    (void)cells->rows(k, std::min(k + cells->tile(), cells->size()), parts, ColumnSet::all(),
                      nullptr, rows);
    out.push_back(seconds_since(begin));
  }
  return out;
}

std::vector<double> atlas_costs(const std::string& path) {
  const Case input = read_case(path, {});
  std::vector<double> out;
  for (const double x : input.map.value().x.values()) {
    for (const double y : input.map->y.value().values()) {
      const FamilyParameters at = input.map->cell({input.body, input.models, input.motion}, x, y);
      const auto begin = Clock::now();
      (void)atlas(at.body, make_potential(at.models), atlas_options(input, std::nullopt, true));
      out.push_back(seconds_since(begin));
    }
  }
  return out;
}

void simulation(const std::string& name, const std::vector<double>& costs, double service) {
  const double mean =
      std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
  fmt::print("{}: {} tiles recorded, {:.3g} s on average, {:.3g} s at most\n", name, costs.size(),
             mean, *std::ranges::max_element(costs));
  fmt::print("   ranks      tiles    seconds  efficiency  tiles a batch  rank 0 busy\n");
  for (const std::size_t ranks : {10U, 100U, 1000U, 10'000U}) {
    for (const std::size_t each : {10U, 100U}) {
      const bench::SimulatedRun run{ranks, ranks * each, service, 5e-6};
      const bench::SimulatedEnd end = bench::simulate(run, costs);
      fmt::print("{:8} {:10} {:10.4g} {:10.1f}% {:13.1f} {:11.1f}%\n", ranks, run.tiles,
                 end.seconds, 100.0 * end.efficiency(ranks),
                 static_cast<double>(run.tiles) / end.batches, 100.0 * end.busy);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "overhead") {
    overhead();
  } else if (what == "simulation" && argc == 4) {
    constexpr double service = 10e-6;  // what `overhead` prints by ranks, and its journal
    simulation(argv[2], map_costs(argv[2]), service);
    simulation(argv[3], atlas_costs(argv[3]), service);
  } else {
    fmt::print(stderr, "usage: ranks_bench overhead | ranks_bench simulation MAP ATLASES\n");
    return 2;
  }
  return 0;
}
