#include "solver/program/computation/map_case.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/map_cells.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/report.hpp"

namespace stationary::cli {
namespace {

/// What a map's cells came to.
struct MapCounts {
  std::map<std::string_view, std::size_t> statuses;
  std::map<std::string_view, std::size_t> classes;
  std::size_t rows = 0;
  std::size_t proven = 0;

  void add(const TableRow& row) {
    ++rows;
    ++statuses[row.status];
    if (!row.stability.empty()) ++classes[row.stability];
    if (!row.certified.empty() && row.certified != proof_word(false)) ++proven;
  }
  std::size_t of(CellStatus status) const {
    const auto at = statuses.find(name(status));
    return at == statuses.end() ? 0 : at->second;
  }
};

void require_map(const Case& input) {
  if (!input.map) {
    throw fault_at(input.source, "map", "found no such key", "a table with x, and y",
                   "add [map] with x = { parameter = \"nu\", from = 0.0, to = 1.5, count = 400 }");
  }
}

/// Rows of the solved grid in their order, a window at a time computed by all threads; ends when it
/// is told to, after whole windows.
template <class Take>
RowCounts for_all_rows(const MapCells& grid, const RowParts& parts, const ColumnSet& wanted,
                       const Run& run, const Take& take) {
  // A window's rows are had all or none.
  const std::size_t block = grid.block();
  const std::size_t blocks_at_once = 8 * static_cast<std::size_t>(run.threads);
  std::vector<std::vector<TableRow>> blocks(blocks_at_once);
  std::vector<RowCounts> counts(blocks_at_once);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(run.threads));
  tbb::task_arena arena(run.threads);
  for (std::size_t begin = 0; begin < grid.size(); begin += block * blocks_at_once) {
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, blocks_at_once, [&](std::size_t k) {
        const std::size_t first = std::min(begin + k * block, grid.size());
        counts[k] +=
            grid.rows(first, std::min(first + block, grid.size()), parts, wanted, blocks[k]);
      });
    });
    if (run.stopped()) break;
    for (const std::vector<TableRow>& rows : blocks)
      for (const TableRow& row : rows) take(row);
  }
  RowCounts all;
  for (const RowCounts& each : counts) all += each;
  return all;
}

std::string counted(const std::map<std::string_view, std::size_t>& counts) {
  std::string out;
  for (const auto& [what, count] : counts)
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
  return out;
}

std::string axis_text(const MapAxis& axis) {
  return fmt::format("{} from {} to {}, {} values{}", axis.parameter, axis.from, axis.to,
                     axis.count, axis.scale == AxisScale::log ? ", logarithmic" : "");
}

/// The case's, and what of it holds at its own numbers only.
ComputationPlan map_plan(const Case& input, bool to_table) {
  ComputationPlan out = computation_plan(input, to_table);
  if (!has_lanes(input.motion)) {
    out.computed.push_back({"cells", "each solved by itself, as `solve` does",
                            "a kind of motion that is not marched in nu"});
  } else if (!input.potential.is_isotropic()) {
    out.computed.push_back(
        {"cells", "on the curve from the rest state, followed once for all nu of one body",
         "anisotropic potential. What is said above of alpha and the spectrum is so at the case's "
         "own numbers; at a cell's own V may be even in alpha or not, and nu may be 0"});
  }
  return out;
}

/// Of the march; none where every lane takes the scalar path.
std::string instructions_text(const MapCells& cells) {
  return cells.marches() ? std::string(name(best_instruction_set())) : "scalar";
}

std::string summary(const Case& input, const MapCounts& counts, double seconds) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  out.line("motion", motion_text(input.motion));
  out.line("x", axis_text(input.map->x));
  if (input.map->y) out.line("y", axis_text(*input.map->y));
  out.line("cells", fmt::format("{}: {}", counts.rows, counted(counts.statuses)));
  if (!counts.classes.empty()) out.line("classes", counted(counts.classes));
  if (input.output.certificate) out.line("certificate", fmt::format("{} proven", counts.proven));
  out.line("cost", fmt::format("{:.2g} s", seconds));
  out.gap();
  const ComputationPlan plan = map_plan(input, false);
  add_plan(out, plan.computed);
  add_plan(out, plan.skipped);
  return out.text();
}

Metadata describe(const Run& run, const Case& input, const MapCounts& counts,
                  const RowCounts& evaluated, const MapCells& cells) {
  ComputationPlan plan = map_plan(input, true);
  Metadata out;
  out.version = STATIONARY_VERSION;
  out.command_line = run.command_line;
  out.threads = run.threads;
  out.input = &input;
  for (const std::string_view status : cell_status_names) {
    const auto at = counts.statuses.find(status);
    out.counts.emplace_back(status,
                            at == counts.statuses.end() ? 0 : static_cast<long>(at->second));
  }
  for (const auto& [verdict, count] : counts.classes)
    out.counts.emplace_back(verdict, static_cast<long>(count));
  if (input.output.certificate) out.counts.emplace_back("proven", static_cast<long>(counts.proven));
  out.counts.emplace_back("scalar_lanes", static_cast<long>(cells.scalar_lanes()));
  out.counts.emplace_back("potentials", evaluated.potentials);
  out.counts.emplace_back("spectra", evaluated.spectra);
  out.counts.emplace_back("scalar_spectra", evaluated.scalar_spectra);
  out.plan = std::move(plan.computed);
  out.skipped = std::move(plan.skipped);
  if (input.solve.start || input.solve.all || input.solve.method != Method::automatic) {
    out.skipped.push_back({"start, method, all", "not used",
                           "every cell is solved on the sheet of its own rest state"});
  }
  out.outcome = {{"command", "map"},
                 {"status", counts.rows < input.map->cells() ? "interrupted" : "done"},
                 {"instructions", instructions_text(cells)}};
  return out;
}

/// What the end says, and its exit code.
ExitCode conclusion(const Case& input, const MapCounts& counts, bool written, const Run& run) {
  if (counts.rows < input.map->cells()) {
    run.complain(fmt::format("interrupted after {} of {} cells{}", counts.rows, input.map->cells(),
                             written ? ", which are written" : ""));
    return ExitCode::interrupted;
  }
  if (const std::size_t failed = counts.of(CellStatus::failed); failed > 0) {
    run.complain(fmt::format("numerical failure in {} of {} cells", failed, counts.rows));
    return ExitCode::failure;
  }
  if (counts.of(CellStatus::solved) == 0) {
    run.complain(fmt::format("no stationary ellipsoid in any of {} cells: {}", counts.rows,
                             counted(counts.statuses)));
    return ExitCode::no_equilibrium;
  }
  return ExitCode::done;
}

}  // namespace

Outcome map_case(const Case& input, TableTarget* target, const Run& run) {
  require_map(input);
  const bool to_table = target != nullptr;
  const RowParts parts{.two_polar = has_rates(input.motion),
                       .spectrum = wants_spectrum(input, to_table),
                       .certificate = input.output.certificate,
                       .map = true};
  std::vector<Column> columns = chosen_columns(input, equilibrium_columns(parts), "map", true);
  if (std::ranges::find(columns, Column::status) == columns.end()) {
    columns.push_back(Column::status);  // a cell without one would say nothing where it is empty
    std::ranges::sort(columns);
  }
  if (to_table) target->prepare();
  std::vector<std::string> parameters{input.map->x.parameter};
  if (input.map->y) parameters.push_back(input.map->y->parameter);
  RowSink* const table =
      to_table ? &target->open(columns, parameters, input.map->cells()) : nullptr;

  const auto begin = std::chrono::steady_clock::now();
  const std::unique_ptr<MapCells> grid = map_cells(input);
  BatchOptions how;
  how.threads = run.threads;
  how.stop = run.stop;
  if (run.progress) {
    how.progress = [&](double fraction) {
      run.progress(fraction, fmt::format("solving {} cells", grid->size()));
    };
  }
  grid->solve(how);
  MapCounts counts;
  // Without a table the classes are counted.
  const ColumnSet wanted = table != nullptr ? ColumnSet(columns) : ColumnSet();
  const auto take = [&](const TableRow& row) {
    counts.add(row);
    if (table != nullptr) table->write(row);
    if (run.progress && counts.rows % 4096 == 0) {
      run.progress(static_cast<double>(counts.rows) / static_cast<double>(grid->size()),
                   fmt::format("{} rows", counts.rows));
    }
  };
  const RowCounts evaluated = for_all_rows(*grid, parts, wanted, run, take);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (to_table) {
    Metadata metadata = describe(run, input, counts, evaluated, *grid);
    metadata.seconds = seconds;
    target->commit(std::move(metadata));
  }
  Outcome out{conclusion(input, counts, to_table, run), {}};
  if (run.summary && out.code != ExitCode::interrupted)
    out.summary = summary(input, counts, seconds);
  return out;
}

}  // namespace stationary::cli
