#include "solver/program/computation/atlas_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <utility>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/computation/atlas_tables.hpp"
#include "solver/program/rows/sheet_summary.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/row_pack.hpp"
#include "solver/program/table/table_reader.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/text/written_number.hpp"
#include "solver/program/tiles/parts.hpp"
#include "solver/program/tiles/study_answer.hpp"

namespace stationary::cli {
namespace {

/// An atlas runs over nu, of all motions: neither is a number of the grid.
void require_grid(const Case& input) {
  if (!input.map)
    throw fault_at(
        input.source, "map", "found no such key", "a table with x, and y",
        "add [map] with x = { parameter = \"body.J.1\", from = 0.5, to = 2.0, count = 9 }");
  const auto of_the_body = [](std::string_view key) {
    return key.empty() || key.starts_with("body.") || key.starts_with("potential.");
  };
  for (const auto& [axis, key] : {std::pair{&input.map->x, "map.x.parameter"},
                                  {input.map->y ? &*input.map->y : nullptr, "map.y.parameter"}}) {
    if (axis == nullptr) continue;
    const ParameterParts parts = parts_of(axis->parameter);
    if (!of_the_body(parts.first) || !of_the_body(parts.second))
      throw fault_at(input.source, key, "found " + in_quotes(axis->parameter),
                     "a number of body or potential: an atlas is of every nu in [continuation]");
  }
}

/// Rows as bytes.
class PackedRows final : public RowSink {
 public:
  PackedRows(const std::vector<Column>& columns, const RowPack& pack, std::string& out)
      : RowSink(columns, 0), pack_(pack), out_(out) {}

 private:
  void put(const TableRow& row, TableChecksum& sum) override {
    add_cells(row, sum);
    pack_.add(row, out_);
  }

  const RowPack& pack_;
  std::string& out_;
};

/// A grid of atlases as far as it does not depend on how it is run.
class Grid {
 public:
  Grid(const Case& input, const std::optional<int>& checkpoints, bool with_tables)
      : input_(input),
        how_(atlas_options(input, checkpoints, input.output.spectrum)),
        with_tables_(with_tables),
        x_(input.map->x.values()),
        y_(input.map->y ? input.map->y->values() : std::vector<double>{0.0}),
        columns_(chosen_columns(input,
                                equilibrium_columns({.events = true,
                                                     .spectrum = how_.spectrum,
                                                     .certificate = input.output.certificate,
                                                     .pressure = input.potential.holds_volume()}),
                                "atlas", false)),
        pack_(columns_, 0) {}

  std::size_t cells() const { return x_.size() * y_.size(); }
  const AtlasOptions& how() const { return how_; }
  /// Of the cells' own tables.
  const std::vector<Column>& columns() const { return columns_; }
  const RowPack& pack() const { return pack_; }

  std::vector<CellColumn> header() const {
    std::vector<CellColumn> out{{input_.map->x.parameter, CellKind::number}};
    if (input_.map->y) out.push_back({input_.map->y->parameter, CellKind::number});
    out.push_back({"status", CellKind::text});
    for (const CellColumn& each : sheet_summary_columns()) out.push_back(each);
    out.push_back({"message", CellKind::text});
    return out;
  }

  /// The cell's line, and behind it the rows of its table; nothing where it was interrupted.
  std::optional<std::string> cell(std::size_t k, const std::atomic<bool>* stop) const {
    const double x = x_[k % x_.size()];
    const double y = y_[k / x_.size()];
    std::string rows;
    PackedRows sink(columns_, pack_, rows);
    std::optional<StudyAnswer> found;
    try {
      const FamilyParameters at = input_.map->cell(own_numbers(input_), x, y);
      AtlasOptions how = how_;
      how.stop = how.search.stop = stop;
      found = atlas_answer({at.body, make_potential(at.models, at.body), input_.output.certificate,
                            input_.coordinates},
                           how, with_tables_ ? &sink : nullptr);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      found = {StudyStatus::failed,
               error.what(),
               {std::string(sheet_summary_columns().size() - 1, ',')}};
      rows.clear();
    }
    if (!found) return std::nullopt;
    std::ranges::replace(found->message, '\n', ' ');
    std::string out = number_text(x) + ',';
    if (input_.map->y) out += number_text(y) + ',';
    out += fmt::format("{},{},{}\n", name(found->status), found->cells.front(),
                       csv_cell(found->message));
    return out + rows;
  }

  std::string hash() const {
    return work_hash("atlas --grid", input_.source,
                     {fmt::format("{} {} {} {} {}", how_.from, how_.to, how_.checkpoints,
                                  how_.complete, input_.output.certificate)});
  }

 private:
  const Case& input_;
  AtlasOptions how_;
  bool with_tables_;
  std::vector<double> x_;
  std::vector<double> y_;  ///< one number where the grid has no y
  std::vector<Column> columns_;
  RowPack pack_;
};

struct GridCounts {
  std::map<std::string, long, std::less<>> statuses;
  std::size_t cells = 0;
  std::string first_failed;

  void add(std::string_view status, std::string_view message) {
    ++cells;
    ++statuses[std::string(status)];
    if (status == name(StudyStatus::failed) && first_failed.empty())
      first_failed = fmt::format("row {}: {}", cells, message);
  }
  long of(StudyStatus status) const {
    const auto at = statuses.find(name(status));
    return at == statuses.end() ? 0 : at->second;
  }
};

/// Of lines of the table.
void count(const std::string& header, const std::string& lines, GridCounts& counts) {
  TableReader rows(std::make_unique<std::istringstream>(header + lines), "grid");
  const std::size_t status = rows.column("status").value();
  const std::size_t message = rows.column("message").value();
  while (rows.next()) counts.add(rows.text(status), rows.text(message));
}

std::string summary(const Case& input, const GridCounts& counts, double seconds) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  for (const auto& [label, axis] :
       {std::pair{"x", &input.map->x}, {"y", input.map->y ? &*input.map->y : nullptr}})
    if (axis != nullptr) out.line(label, axis_text(*axis));
  std::string words;
  for (const auto& [status, count] : counts.statuses)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, status);
  out.line("atlases", fmt::format("{}: {}", counts.cells, words));
  if (!counts.first_failed.empty()) out.line("first failure", counts.first_failed);
  out.line("cost", fmt::format("{:.2g} s", seconds));
  return out.text();
}

Metadata describe(const Run& run, const Case& input, const GridCounts& counts, std::size_t cells) {
  Metadata out = metadata_of(run, &input);
  for (const StudyStatus each :
       {StudyStatus::solved, StudyStatus::none, StudyStatus::not_found, StudyStatus::failed})
    out.counts.emplace_back(name(each), counts.of(each));
  ComputationPlan plan = computation_plan(input, true, PlanOf::atlas);
  out.plan = std::move(plan.computed);
  out.skipped = std::move(plan.skipped);
  out.outcome = {{"command", "atlas"}, {"status", counts.cells < cells ? "interrupted" : "done"}};
  return out;
}

/// What the end of a whole run says, and its exit code.
ExitCode conclusion(const GridCounts& counts, const TiledRun& tiled, const Run& run) {
  const long failed = counts.of(StudyStatus::failed);
  if (failed == 0 && counts.of(StudyStatus::solved) == 0 && counts.cells > 0) {
    run.complain(fmt::format("no stationary ellipsoid in any of {} atlases", counts.cells));
    return tiled.part.asked ? ExitCode::done : ExitCode::no_equilibrium;
  }
  if (failed == 0) return ExitCode::done;
  run.complain(fmt::format("{} of {} atlases failed, the first of them {}", failed, counts.cells,
                           counts.first_failed));
  const bool all = failed == static_cast<long>(counts.cells);
  // What a part comes to is said of the whole.
  return all && !tiled.part.asked ? ExitCode::failure : ExitCode::done;
}

/// Tables of cells are merged where both are named: what becomes of them, and all of them.
void require_tables(const std::string& into, const std::vector<std::string>& of_grid,
                    const std::vector<std::string>& of_cells) {
  if (of_grid.empty())
    throw InputError(Origin::of_option("--merge"), "", "found no table of a part",
                     "what --part K/N wrote after -o, and beside it the files of --tables");
  if (into.empty() && !of_cells.empty())
    throw InputError(Origin::of_option("--merge " + of_cells.front()), "",
                     "found the tables of cells, and no --tables",
                     "--tables FILE.h5, what they are to be merged in");
  if (!into.empty() && of_cells.empty())
    throw InputError(Origin::of_option("--tables " + into), "", "found no tables of cells to merge",
                     "the parts' own files of --tables, named after --merge too");
  for (const std::string& each : of_cells) refuse_to_replace(into, into, each, "a part");
}

}  // namespace

Outcome atlas_grid(const Case& input, const AtlasGridAsked& asked, const TiledRun& tiled,
                   TableTarget* target, const Run& run) {
  require_grid(input);
  const Grid grid(input, asked.checkpoints, !asked.tables.empty());
  const Share share = tiled.part.share(grid.cells());
  const bool serves = tiled.serves();
  TileRunner runner({.hash = grid.hash(),
                     .kept = asked.tables.empty() ? "" : "tables",
                     .share = share,
                     .rows_a_tile = 1,
                     .unit = "atlases",
                     .compute = [&](const Share& rows) { return grid.cell(rows.first, run.stop); }},
                    tiled, run);
  if (target != nullptr && !serves) target->prepare();
  AtlasTables tables(serves ? "" : asked.tables, input.source.name(), grid.columns());
  const std::string header = csv_header(grid.header());
  CellTable* const table = target != nullptr && !serves ? &target->open(grid.header()) : nullptr;
  const auto begin = std::chrono::steady_clock::now();
  GridCounts counts;
  runner.run([&](const Share& rows, const std::string& tile) {
    const std::size_t end = tile.find('\n') + 1;
    const std::string line = tile.substr(0, end);
    count(header, line, counts);
    if (table != nullptr) table->write(line);
    tables.add(rows.first, grid.pack(), std::string_view(tile).substr(end));
  });
  if (serves) return {};
  Metadata metadata = describe(run, input, counts, share.size());
  metadata.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double seconds = metadata.seconds;
  runner.describe(metadata);
  tables.commit(metadata);
  if (target != nullptr) target->commit(std::move(metadata));
  runner.finish();
  const bool whole = counts.cells == share.size();
  if (!whole) run.complain(runner.interruption(counts.cells, target != nullptr));
  Outcome out{whole ? conclusion(counts, tiled, run) : ExitCode::interrupted, {}};
  if (run.summary) out.summary = summary(input, counts, seconds);
  return out;
}

Outcome merged_atlas_grid(const Case& input, const AtlasGridAsked& asked,
                          const std::vector<std::string>& paths, TableTarget& target,
                          const Run& run) {
  require_grid(input);
  std::vector<std::string> of_cells;  // files of --tables among the parts
  std::vector<std::string> of_grid;
  for (const std::string& path : paths) (is_tables_file(path) ? of_cells : of_grid).push_back(path);
  require_tables(asked.tables, of_grid, of_cells);
  const std::vector<PartTable> parts = read_parts(of_grid, "atlas");
  const Grid grid(input, asked.checkpoints, false);
  require_work(parts, grid.hash());
  const auto begin = std::chrono::steady_clock::now();
  const auto [header, lines] = read_lines(parts);
  GridCounts counts;
  count(header, lines, counts);
  Metadata metadata = describe(run, input, counts, grid.cells());
  require_case(parts, metadata);
  target.prepare();
  AtlasTables tables(asked.tables, input.source.name(), grid.columns());
  if (!of_cells.empty()) merge_tables(parts, of_cells, grid.columns(), tables);
  target.open(grid.header()).write(lines);
  metadata.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double seconds = metadata.seconds;
  metadata.merged_parts = parts.size();
  tables.commit(metadata);
  target.commit(std::move(metadata));
  Outcome out{conclusion(counts, {}, run), {}};
  if (run.summary) out.summary = summary(input, counts, seconds);
  return out;
}

}  // namespace stationary::cli
