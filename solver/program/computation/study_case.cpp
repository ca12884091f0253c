#include "solver/program/computation/study_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "solver/program/rows/sheet_summary.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"
#include "solver/program/table/table_reader.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/tiles/parts.hpp"

namespace stationary::cli {
namespace {

/// What the rows of a study came to.
struct StudyCounts {
  std::map<std::string, long, std::less<>> statuses;
  std::size_t rows = 0;   ///< of the table run over
  std::string first_bad;  ///< message of the first that failed

  long of(StudyStatus status) const {
    const auto at = statuses.find(name(status));
    return at == statuses.end() ? 0 : at->second;
  }
  long without_answer() const { return of(StudyStatus::failed) + of(StudyStatus::bad_input); }
};

/// Of a study's own table, which parts may have another one than.
std::size_t study_column(const TableReader& rows, std::string_view column) {
  if (const auto at = rows.column(column)) return *at;
  throw InputError(Origin::of_option("--merge"), "", "found no column " + in_quotes(column),
                   "tables as a study wrote them");
}

/// Reads the rows' own lines, so that those of a journal and of parts count as well.
void count(const std::string& header, const std::string& lines, StudyCounts& counts) {
  if (lines.empty()) return;
  TableReader rows(std::make_unique<std::istringstream>(header + lines), "study");
  const std::size_t number = study_column(rows, "study_row");
  const std::size_t status = study_column(rows, "status");
  std::string last;
  while (rows.next()) {
    if (last == rows.text(number)) continue;  // another solution of the same row
    last = rows.text(number);
    ++counts.rows;
    const std::string word(rows.text(status));
    ++counts.statuses[word];
    const bool bad = word == name(StudyStatus::failed) || word == name(StudyStatus::bad_input);
    if (bad && counts.first_bad.empty())
      counts.first_bad = fmt::format("row {}: {}", last, rows.text(status + 1));
  }
}

std::string counted(const StudyCounts& counts) {
  std::string out;
  for (const std::string_view each : study_status_names)
    if (const auto at = counts.statuses.find(each); at != counts.statuses.end())
      out += fmt::format("{}{} {}", out.empty() ? "" : ", ", at->second, each);
  return out;
}

std::string summary(const CaseTree& tree, const StudyRecord& study, const StudyCounts& counts,
                    double seconds) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  out.line("case", printable(tree.name()));
  out.line("over", fmt::format("{}: {} rows", printable(study.over), study.rows));
  out.line("do", study.task);
  out.line("rows", fmt::format("{}: {}", counts.rows, counted(counts)));
  if (!counts.first_bad.empty()) out.line("first failure", counts.first_bad);
  out.line("cost", fmt::format("{:.2g} s", seconds));
  return out.text();
}

/// rows: how many were to be done.
Metadata describe(const Run& run, const CaseTree& tree, const std::optional<Case>& alone,
                  StudyRecord study, const StudyCounts& counts, std::size_t rows) {
  Metadata out = metadata_of(run, alone ? &*alone : nullptr);
  out.source = &tree;
  out.study = std::move(study);
  for (const std::string_view each : study_status_names) {
    const auto at = counts.statuses.find(each);
    out.counts.emplace_back(each, at == counts.statuses.end() ? 0 : at->second);
  }
  out.outcome = {{"command", "study"}, {"status", counts.rows < rows ? "interrupted" : "done"}};
  return out;
}

/// What the end of a whole run says, and its exit code.
ExitCode conclusion(const StudyCounts& counts, const TiledRun& tiled, const Run& run) {
  const long bad = counts.without_answer();
  if (bad == 0) return ExitCode::done;
  run.complain(fmt::format("{} of {} rows failed, the first of them {}", bad, counts.rows,
                           counts.first_bad));
  const bool all = bad == static_cast<long>(counts.rows);
  // What a part comes to is said of the whole.
  return all && !tiled.part.asked ? ExitCode::failure : ExitCode::done;
}

/// The columns of a study's own table.
std::vector<CellColumn> columns_of(const std::string& header, const std::string& lines) {
  TableReader rows(std::make_unique<std::istringstream>(header + lines), "study");
  const std::vector<std::string>& names = rows.columns();
  const std::size_t status = study_column(rows, "status");
  std::vector<CellColumn> source;
  for (std::size_t k = 1; k < status; ++k) source.push_back({names[k], CellKind::number});
  while (rows.next())
    for (std::size_t k = 1; k < status; ++k)
      if (!rows.text(k).empty() && !is_number(rows.text(k))) source[k - 1].kind = CellKind::text;
  std::vector<CellColumn> cells;
  const std::vector<CellColumn> summaries = sheet_summary_columns();
  for (std::size_t k = status + 2; k < names.size(); ++k) {
    const auto summary = std::ranges::find(summaries, names[k], &CellColumn::name);
    if (summary != summaries.end()) {
      cells.push_back(*summary);
    } else if (const auto column = find_column(names[k])) {
      cells.push_back({names[k], cell_kind(*column)});
    }
  }
  return study_header(source, cells);
}

}  // namespace

Outcome study_case(const StudyRun& asked, TableTarget* target, const Run& run) {
  const Study study(asked);
  const TiledRun& tiled = asked.tiled;
  const Share share = tiled.part.share(study.source().rows());
  const bool serves = tiled.serves();
  TileRunner runner({.hash = study.hash(),
                     .share = share,
                     .rows_a_tile = study.rows_a_tile(),
                     .unit = "rows",
                     .compute = [&](const Share& rows) { return study.lines(rows, run.stop); }},
                    tiled, run);
  CellTable* table = nullptr;
  if (target != nullptr && !serves) {
    target->prepare();
    table = &target->open(study.header());
  }
  const std::string header = csv_header(study.header());
  const auto begin = std::chrono::steady_clock::now();
  StudyCounts counts;
  runner.run([&](const Share&, const std::string& lines) {
    count(header, lines, counts);
    if (table != nullptr) table->write(lines);
  });
  if (serves) return {};
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const StudyRecord record{study.source().path(), std::string(name(study.plan().task)),
                           study.source().rows()};
  if (target != nullptr) {
    const std::optional<Case> alone = study.alone();
    Metadata metadata = describe(run, study.tree(), alone, record, counts, share.size());
    metadata.seconds = seconds;
    runner.describe(metadata);
    target->commit(std::move(metadata));
  }
  runner.finish();
  const bool whole = counts.rows == share.size();
  if (!whole) run.complain(runner.interruption(counts.rows, target != nullptr));
  Outcome out{whole ? conclusion(counts, tiled, run) : ExitCode::interrupted, {}};
  if (run.summary) out.summary = summary(study.tree(), record, counts, seconds);
  return out;
}

Outcome merged_study_case(const StudyRun& asked, std::optional<StudyTask> task,
                          const std::vector<std::string>& paths, TableTarget& target,
                          const Run& run) {
  const std::vector<PartTable> parts = read_parts(paths, "study");
  if (asked.source != nullptr) require_work(parts, Study(asked).hash());
  const StudyRecord record = parts.front().metadata.study.value();
  if (task && name(*task) != record.task)
    throw InputError(Origin::of_option("--do " + std::string(name(*task))), "",
                     "found parts made with --do " + record.task, "what the parts were made with");
  CaseTree tree = *asked.base;
  std::vector<Override> overrides;
  for (const std::string& each : asked.overrides) {
    tree.override_key(each);
    overrides.push_back({each});
  }
  std::optional<Case> alone;
  try {
    alone = make_case(*asked.base, overrides);
    alone->output.certificate =
        alone->output.certificate || asked.plan.certify || parts.front().metadata.certificate;
  } catch (const InputError&) {
    // It is one only with a row's values.
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto [header, lines] = read_lines(parts);
  StudyCounts counts;
  count(header, lines, counts);
  Metadata metadata = describe(run, tree, alone, record, counts, record.rows);
  require_case(parts, metadata);
  target.prepare();
  target.open(columns_of(header, lines)).write(lines);
  metadata.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double seconds = metadata.seconds;
  metadata.merged_parts = parts.size();
  target.commit(std::move(metadata));
  Outcome out{conclusion(counts, {}, run), {}};
  if (run.summary) out.summary = summary(tree, record, counts, seconds);
  return out;
}

}  // namespace stationary::cli
