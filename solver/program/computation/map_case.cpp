#include "solver/program/computation/map_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/map_cells.hpp"
#include "solver/program/rows/map_grid.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"
#include "solver/program/table/row_pack.hpp"
#include "solver/program/tiles/parts.hpp"

namespace stationary::cli {
namespace {

/// What a map's cells came to, and what they took.
struct MapCounts {
  std::map<std::string, long, std::less<>> statuses;
  std::map<std::string, long, std::less<>> classes;
  std::size_t rows = 0;
  long proven = 0;
  RowCounts evaluated;

  void add(const TableRow& row) {
    ++rows;
    ++at(statuses, row.status);
    if (!row.stability.empty()) ++at(classes, row.stability);
    if (!row.certified.empty() && row.certified != proof_word(false)) ++proven;
  }
  long of(CellStatus status) const {
    const auto found = statuses.find(name(status));
    return found == statuses.end() ? 0 : found->second;
  }

 private:
  static long& at(std::map<std::string, long, std::less<>>& counts, std::string_view word) {
    const auto found = counts.find(word);
    return found != counts.end() ? found->second : counts.emplace(word, 0).first->second;
  }
};

/// By the names that the metadata have.
MapCounts counts_of(const std::vector<PartTable>& parts) {
  MapCounts out;
  for (const auto& [name, count] : added_counts(parts)) {
    if (count == 0) continue;
    if (std::ranges::find(cell_status_names, name) != std::end(cell_status_names)) {
      out.statuses[name] = count;
      out.rows += static_cast<std::size_t>(count);
    } else if (std::ranges::find(stability_names, name) != std::end(stability_names)) {
      out.classes[name] = count;
    } else if (name == "proven") {
      out.proven = count;
    } else if (name == "scalar_lanes") {
      out.evaluated.scalar_lanes = count;
    } else if (name == "potentials") {
      out.evaluated.potentials = count;
    } else if (name == "spectra") {
      out.evaluated.spectra = count;
    } else if (name == "scalar_spectra") {
      out.evaluated.scalar_spectra = count;
    }
  }
  return out;
}

void require_map(const Case& input) {
  if (!input.map) {
    throw fault_at(input.source, "map", "found no such key", "a table with x, and y",
                   "add [map] with x = { parameter = \"nu\", from = 0.0, to = 1.5, count = 400 }");
  }
}

/// A map as far as it does not depend on how it is run.
struct MapWork {
  explicit MapWork(const Case& input, bool to_table)
      : parts{.two_polar = has_rates(input.motion),
              .spectrum = wants_spectrum(input, to_table),
              .certificate = input.output.certificate,
              .map = true,
              .pressure = input.potential.holds_volume()} {
    columns = chosen_columns(input, equilibrium_columns(parts), "map", true);
    const auto with = [](std::vector<Column> of, Column c) {
      if (std::ranges::find(of, c) == of.end()) {
        of.push_back(c);
        std::ranges::sort(of);
      }
      return of;
    };
    columns =
        with(columns, Column::status);  // a cell without one would say nothing where it is empty
    parameters.push_back(input.map->x.parameter);
    if (input.map->y) parameters.push_back(input.map->y->parameter);
    // Without a table the classes are counted.
    if (to_table) {
      wanted = ColumnSet(columns);
      kept = columns;
    } else {
      kept = {Column::status};
    }
    if (parts.spectrum) kept = with(kept, Column::stability);
    if (parts.certificate) kept = with(kept, Column::certified);
  }

  RowParts parts;
  std::vector<Column> columns;  ///< of the table
  std::vector<std::string> parameters;
  ColumnSet wanted;
  std::vector<Column> kept;  ///< of tiles: those of the table and what is counted
};

/// A tile: what its rows took, and they themselves (row_pack.hpp).
std::optional<std::string> tile_text(const MapCells& cells, const MapWork& work,
                                     const RowPack& pack, const Share& share,
                                     const std::atomic<bool>* stop) {
  constexpr std::size_t at_once = 512;
  std::string out(sizeof(RowCounts), '\0');
  out.reserve(out.size() + share.size() * pack.row_size());
  RowCounts counts;
  // Kept from tile to tile: fresh memory costs as much as the cells that go into it.
  thread_local std::vector<TableRow> rows;
  for (std::size_t k = share.first; k < share.last; k += at_once) {
    const std::size_t end = std::min(k + at_once, share.last);
    counts += cells.rows(k, end, work.parts, work.wanted, stop, rows);
    if (rows.size() != end - k) return std::nullopt;
    for (const TableRow& row : rows) pack.add(row, out);
  }
  std::memcpy(out.data(), &counts, sizeof counts);
  return out;
}

std::string counted(const std::map<std::string, long, std::less<>>& counts) {
  std::string out;
  for (const auto& [what, count] : counts)
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
  return out;
}

/// The case's, and what of it holds at its own numbers only.
ComputationPlan map_plan(const Case& input, bool to_table) {
  ComputationPlan out = computation_plan(input, to_table, PlanOf::map);
  if (!has_lanes(input.motion)) {
    const PlanItem alone{"cells", "each solved by itself, as `solve` does",
                         "a kind of motion that is not marched in nu"};
    out.computed.push_back(rows_together(input).value_or(alone));
  } else if (!MapGrid::takes(*input.map)) {
    out.computed.push_back({"cells", "each solved by itself, as `solve` does",
                            "nu and what it is divided by, or what is divided by it, both vary"});
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

/// Likewise of parts that several machines may have made.
std::string instructions_text(const std::vector<PartTable>& parts) {
  std::string out;
  for (const PartTable& each : parts)
    if (out.find(each.metadata.instructions) == std::string::npos)
      out += (out.empty() ? "" : ", ") + each.metadata.instructions;
  return out;
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

Metadata describe(const Run& run, const Case& input, const MapCounts& counts, std::size_t cells,
                  const std::string& instructions) {
  ComputationPlan plan = map_plan(input, true);
  Metadata out = metadata_of(run, &input);
  for (const std::string_view status : cell_status_names) {
    const auto at = counts.statuses.find(status);
    out.counts.emplace_back(status, at == counts.statuses.end() ? 0 : at->second);
  }
  for (const auto& [verdict, count] : counts.classes) out.counts.emplace_back(verdict, count);
  if (input.output.certificate) out.counts.emplace_back("proven", counts.proven);
  out.counts.emplace_back("scalar_lanes", counts.evaluated.scalar_lanes);
  out.counts.emplace_back("potentials", counts.evaluated.potentials);
  out.counts.emplace_back("spectra", counts.evaluated.spectra);
  out.counts.emplace_back("scalar_spectra", counts.evaluated.scalar_spectra);
  out.plan = std::move(plan.computed);
  out.skipped = std::move(plan.skipped);
  out.outcome = {{"command", "map"}, {"status", counts.rows < cells ? "interrupted" : "done"}};
  out.instructions = instructions;
  return out;
}

/// Of all that decides the cells.
std::string map_hash(const Case& input, const MapCells& cells) {
  return work_hash("map", input.source,
                   {fmt::format("{} {}", input.output.certificate, cells.tile())});
}

/// What the end of a whole run says, and its exit code.
ExitCode conclusion(const MapCounts& counts, bool proves, const TiledRun& tiled, const Run& run) {
  if (proves && counts.proven < counts.of(CellStatus::solved))
    run.complain(fmt::format("{} of {} solved cells are not proven",
                             counts.of(CellStatus::solved) - counts.proven,
                             counts.of(CellStatus::solved)));
  ExitCode out = ExitCode::done;
  if (const long failed = counts.of(CellStatus::failed); failed > 0) {
    run.complain(fmt::format("numerical failure in {} of {} cells", failed, counts.rows));
    out = ExitCode::failure;
  } else if (counts.of(CellStatus::solved) == 0 && counts.rows > 0) {
    run.complain(fmt::format("no stationary ellipsoid in any of {} cells: {}", counts.rows,
                             counted(counts.statuses)));
    out = ExitCode::no_equilibrium;
  }
  // What a part comes to is said of the whole.
  return tiled.part.asked ? ExitCode::done : out;
}

}  // namespace

Outcome map_case(const Case& input, TableTarget* target, const Run& run) {
  return tiled_map_case(input, {}, target, run);
}

Outcome tiled_map_case(const Case& input, const TiledRun& tiled, TableTarget* target,
                       const Run& run) {
  require_map(input);
  const bool to_table = target != nullptr;
  const MapWork work(input, to_table);
  const std::unique_ptr<MapCells> cells = map_cells(input);
  const RowPack pack(work.kept, to_table ? work.parameters.size() : 0);
  const Share share = tiled.part.share(cells->size());
  const bool serves = tiled.serves();
  TileRunner runner(
      {.hash = map_hash(input, *cells),
       .too_short = cells->marches() ? 5.0 : 0.0,
       .share = share,
       .rows_a_tile = cells->tile(),
       .unit = "cells",
       .compute = [&](const Share& rows) { return tile_text(*cells, work, pack, rows, run.stop); }},
      tiled, run);
  if (to_table && !serves) target->prepare();
  RowSink* const table =
      to_table && !serves ? &target->open(work.columns, work.parameters, share.size()) : nullptr;

  const auto begin = std::chrono::steady_clock::now();
  MapCounts counts;
  TableRow row;
  const auto take = [&](const Share&, const std::string& tile) {
    RowCounts evaluated;
    std::memcpy(&evaluated, tile.data(), sizeof evaluated);
    counts.evaluated += evaluated;
    for (std::size_t at = sizeof evaluated; at < tile.size(); at += pack.row_size()) {
      pack.read(tile.data() + at, row);
      counts.add(row);
      if (table != nullptr) table->write(row);
    }
  };
  runner.run(take);
  if (serves) return {};
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (to_table) {
    Metadata metadata = describe(run, input, counts, share.size(), instructions_text(*cells));
    metadata.seconds = seconds;
    runner.describe(metadata);
    target->commit(std::move(metadata));
  }
  runner.finish();
  const bool whole = counts.rows == share.size();
  if (!whole) run.complain(runner.interruption(counts.rows, to_table));
  Outcome out{
      whole ? conclusion(counts, input.output.certificate, tiled, run) : ExitCode::interrupted, {}};
  if (run.summary) out.summary = summary(input, counts, seconds);
  return out;
}

Outcome merged_map_case(const Case& input, const std::vector<std::string>& paths,
                        TableTarget& target, const Run& run) {
  require_map(input);
  const MapWork work(input, true);
  const std::size_t cells = input.map->cells();
  const std::vector<PartTable> parts = read_parts(paths, "map");
  const MapCounts counts = counts_of(parts);
  Metadata metadata = describe(run, input, counts, cells, instructions_text(parts));
  require_case(parts, metadata);
  require_work(parts, map_hash(input, *map_cells(input)));
  target.prepare();
  RowSink& table = target.open(work.columns, work.parameters, cells);
  const auto begin = std::chrono::steady_clock::now();
  read_rows(parts, work.columns, work.parameters, [&](const TableRow& row) { table.write(row); });
  metadata.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  metadata.merged_parts = parts.size();
  const double seconds = metadata.seconds;
  target.commit(std::move(metadata));
  Outcome out{conclusion(counts, input.output.certificate, {}, run), {}};
  if (run.summary) out.summary = summary(input, counts, seconds);
  return out;
}

}  // namespace stationary::cli
