// What tiles cost that are handed out, and what ten thousand ranks would do:
//
//   mpirun -n 2 ranks_bench MAP ATLASES
//
// prints the microseconds of the processor for a tile that computes nothing: alone, with its journal, and of
// rank 0 that hands out to another and computes nothing itself. Then it records the costs of both cases'
// tiles and dispatches them to many ranks that are not there, whose rank 0 takes as long for a tile as was
// just measured.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <limits>
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
#include "tests/bench/ranks/ranks_simulation.hpp"

namespace {

using namespace stationary;
/// Of this process's processor, so that what others do on the machine is not in it.
double seconds_since(std::clock_t begin) {
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Bytes of a tile about as those of the two cases: an atlas's line, the cells of a map's body.
struct Size {
  std::size_t bytes;
  std::size_t tiles;
};
constexpr Size of_atlas{300, 50'000};
constexpr Size of_map{50'000, 2'000};

/// Microseconds a tile.
double empty_tiles(const cli::TiledRun& how, const Size& of) {
  cli::Run run;
  // Where there is another rank, rank 0 does nothing but hand out.
  run.threads = how.crew != nullptr && how.crew->leads() && how.crew->ranks() > 1 ? 0 : 1;
  const std::string text(of.bytes, 'x');
  constexpr int repetitions = 5;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repetitions; ++k) {
    cli::TileRunner runner({.hash = "empty",
                            .share = {0, of.tiles},
                            .unit = "tiles",
                            .compute = [&](const cli::Share&) { return std::optional(text); }},
                           how, run);
    const std::clock_t begin = std::clock();
    runner.run([](const cli::Share&, const std::string&) {});
    least = std::min(least, seconds_since(begin));
    runner.finish();
  }
  return 1e6 * least / static_cast<double>(of.tiles);
}

/// Prints them; microseconds that rank 0 takes for a tile.
struct Overhead {
  double message = 0.0;  ///< short and not kept
  double atlas = 0.0;
  double map = 0.0;
};
Overhead overhead(cli::MpiCrew& crew) {
  const bool leads = crew.leads();
  const std::string table =
      (std::filesystem::temp_directory_path() / fmt::format("empty-{}.csv", ::getpid())).string();
  if (leads)
    fmt::print("microseconds of an empty tile {:6} bytes {:6} bytes\n", of_atlas.bytes,
               of_map.bytes);
  const auto line = [&](const char* name, const cli::TiledRun& how) {
    const std::pair out{empty_tiles(how, of_atlas), empty_tiles(how, of_map)};
    if (leads) fmt::print("  {:27} {:12.2f} {:12.2f}\n", name, out.first, out.second);
    return out;
  };
  cli::TiledRun how;
  if (leads) line("alone", how);
  how.journal = table;
  if (leads) line("alone, with a journal", how);
  how.journal.reset();
  how.crew = &crew;
  const double message = line("rank 0, of another's", how).first;
  how.journal = table;
  const auto [atlas, map] = line("the same, with a journal", how);
  return {std::min(message, atlas), atlas, map};
}

std::vector<double> map_costs(const std::string& path) {
  const Case input = read_case(path, {});
  const auto cells = map_cells(input);
  std::vector<double> out;
  std::vector<TableRow> rows;
  const RowParts parts{.spectrum = true, .map = true};
  for (std::size_t k = 0; k < cells->size(); k += cells->tile()) {
    const std::clock_t begin = std::clock();
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
      const std::clock_t begin = std::clock();
      (void)atlas(at.body, make_potential(at.models, at.body),
                  atlas_options(input, std::nullopt, true));
      out.push_back(seconds_since(begin));
    }
  }
  return out;
}

/// handing_out, taking: microseconds of rank 0, of a batch and of a result.
void simulation(const std::string& name, const std::vector<double>& costs, double handing_out,
                double taking) {
  const double mean =
      std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
  fmt::print(
      "{}: {} tiles recorded, {:.3g} ms on average, {:.3g} at most; rank 0 {:.3g} us a tile\n",
      name, costs.size(), 1e3 * mean, 1e3 * *std::ranges::max_element(costs), taking);
  fmt::print("   ranks      tiles    seconds  efficiency  tiles a batch  rank 0 busy\n");
  for (const std::size_t ranks : {10U, 100U, 1000U, 10'000U}) {
    for (const std::size_t each : {10U, 100U}) {
      const bench::SimulatedRun run{ranks, ranks * each, 1e-6 * handing_out, 1e-6 * taking, 5e-6};
      const bench::SimulatedEnd end = bench::simulate(run, costs);
      fmt::print("{:8} {:10} {:10.4g} {:10.1f}% {:14.1f} {:11.1f}%\n", ranks, run.tiles,
                 end.seconds, 100.0 * end.efficiency(ranks),
                 static_cast<double>(run.tiles) / end.batches, 100.0 * end.busy);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int words = 3;
  if (argc != words) {
    fmt::print(stderr, "usage: mpirun -n 2 ranks_bench MAP ATLASES\n");
    return 2;
  }
  Overhead measured;
  {
    cli::MpiCrew crew;
    measured = overhead(crew);
    if (!crew.leads()) return 0;
  }
  simulation(argv[1], map_costs(argv[1]), measured.message, measured.map);
  simulation(argv[2], atlas_costs(argv[2]), measured.message, measured.atlas);
  return 0;
}
