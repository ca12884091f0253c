#include "solver/program/computation/study_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/table/table_reader.hpp"
#include "solver/program/tiles/journal.hpp"
#include "solver/program/tiles/tile_loop.hpp"

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

/// A study as far as it does not depend on how it is run.
class Study {
 public:
  explicit Study(const StudyRun& asked)
      : source_(*asked.source), base_(*asked.base), tree_(base_), plan_(asked.plan) {
    for (const std::string& each : asked.overrides) {
      tree_.override_key(each);
      options_.push_back({each});
    }
    plan_.columns = columns();
    // Solves are short, and a record of the journal for each would not be.
    rows_a_tile_ = plan_.task == StudyTask::solve ? 16 : 1;
  }

  const StudySource& source() const { return source_; }
  const StudyPlan& plan() const { return plan_; }
  const CaseTree& tree() const { return tree_; }
  /// The case by itself, where it is one without a row's values.
  std::optional<Case> alone() const {
    try {
      return make_case(base_, options_);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  std::vector<CellColumn> header() const {
    std::vector<CellColumn> out{{"study_row", CellKind::count}};
    for (const CellColumn& each : source_.columns()) out.push_back(each);
    out.push_back({"status", CellKind::text});
    out.push_back({"message", CellKind::text});
    for (const CellColumn& each : plan_.cell_columns()) out.push_back(each);
    return out;
  }

  std::size_t tiles() const { return (source_.rows() + rows_a_tile_ - 1) / rows_a_tile_; }
  /// Its rows' lines; nothing where it was interrupted.
  std::optional<std::string> tile(std::size_t k, const std::atomic<bool>* stop) const {
    std::string out;
    const std::size_t end = std::min(source_.rows(), (k + 1) * rows_a_tile_);
    for (std::size_t row = k * rows_a_tile_; row < end; ++row) {
      std::vector<Override> overrides = options_;
      std::ranges::move(source_.overrides(row), std::back_inserter(overrides));
      const auto found = study_answer(plan_, base_, overrides, stop);
      if (!found) return std::nullopt;
      for (const std::string& cells : found->cells)
        out += fmt::format("{},{},{},{},{}\n", row + 1, source_.cells(row), name(found->status),
                           csv_cell(found->message), cells);
    }
    return out;
  }

  /// Of all that decides the tiles.
  std::string hash() const {
    std::ostringstream tree;
    tree << tree_.root();
    return hash_of(
        {"study", STATIONARY_VERSION, tree_.name(), tree.str(), source_.path(), source_.text(),
         name(plan_.task), csv_header(header()),
         fmt::format("{} {} {}", plan_.checkpoints.value_or(0), plan_.certify, rows_a_tile_)});
  }

 private:
  /// Of solve's rows: those the case asks for, of any kind of motion that a row may have.
  std::vector<Column> columns() const {
    if (plan_.task != StudyTask::solve) return {};
    const bool two_polar = value_or<std::string>(tree_, "motion.branch", "") == two_polar_name ||
                           source_.has("motion.branch", two_polar_name);
    const std::vector<Column> all = equilibrium_columns(
        {.two_polar = two_polar,
         .spectrum = value_or(tree_, "output.spectrum", true),
         .certificate = plan_.certify || value_or(tree_, "output.certificate", false)});
    std::vector<std::string> asked;
    if (const toml::node* names = find(tree_, "output.columns");
        names != nullptr && names->is_array())
      for (const toml::node& each : *names->as_array())
        asked.push_back(each.value<std::string>().value_or(""));
    std::vector<Column> out = select_columns(all, asked);
    if (out.empty())
      throw fault_at(tree_, "output.columns", "found no column that study computes",
                     "names of columns of solve");
    return out;
  }

  const StudySource& source_;
  const CaseTree& base_;
  std::vector<Override> options_;  ///< of --set
  CaseTree tree_;                  ///< with these
  StudyPlan plan_;
  std::size_t rows_a_tile_ = 1;
};

/// Reads the tiles' own lines, so that those of a journal count as well.
void count(const Study& study, const std::string& lines, StudyCounts& counts) {
  if (lines.empty()) return;
  TableReader rows(std::make_unique<std::istringstream>(csv_header(study.header()) + lines),
                   "study");
  const std::size_t number = rows.column("study_row").value();
  const std::size_t status = study.source().columns().size() + 1;
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

std::string summary(const Study& study, const StudyCounts& counts, double seconds) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  out.line("case", printable(study.tree().name()));
  out.line("over",
           fmt::format("{}: {} rows", printable(study.source().path()), study.source().rows()));
  out.line("do", name(study.plan().task));
  out.line("rows", fmt::format("{}: {}", counts.rows, counted(counts)));
  if (!counts.first_bad.empty()) out.line("first failure", counts.first_bad);
  out.line("cost", fmt::format("{:.2g} s", seconds));
  return out.text();
}

Metadata describe(const Run& run, const Study& study, const StudyCounts& counts,
                  const std::optional<Case>& alone) {
  Metadata out;
  out.version = STATIONARY_VERSION;
  out.command_line = run.command_line;
  out.threads = run.threads;
  if (alone) out.input = &*alone;
  out.source = &study.tree();
  out.study = StudyRecord{study.source().path(), std::string(name(study.plan().task)),
                          study.source().rows()};
  for (const std::string_view each : study_status_names) {
    const auto at = counts.statuses.find(each);
    out.counts.emplace_back(each, at == counts.statuses.end() ? 0 : at->second);
  }
  out.outcome = {{"command", "study"},
                 {"status", counts.rows < study.source().rows() ? "interrupted" : "done"}};
  return out;
}

/// What the end says, and its exit code.
ExitCode conclusion(const Study& study, const StudyCounts& counts, bool resumable, const Run& run) {
  const std::size_t all = study.source().rows();
  if (counts.rows < all) {
    run.complain(fmt::format("interrupted after {} of {} rows{}", counts.rows, all,
                             resumable ? ", which are written; --resume goes on with them" : ""));
    return ExitCode::interrupted;
  }
  const long bad = counts.without_answer();
  if (bad == 0) return ExitCode::done;
  run.complain(
      fmt::format("{} of {} rows failed, the first of them {}", bad, all, counts.first_bad));
  return bad == static_cast<long>(all) ? ExitCode::failure : ExitCode::done;
}

}  // namespace

Outcome study_case(const StudyRun& asked, TableTarget* target, const Run& run) {
  const Study study(asked);
  if (target != nullptr) target->prepare();
  std::optional<Journal> journal;
  if (asked.journal) journal.emplace(*asked.journal, study.hash(), asked.resume);
  CellTable* const table = target != nullptr ? &target->open(study.header()) : nullptr;

  const auto begin = std::chrono::steady_clock::now();
  StudyCounts counts;
  std::size_t finished = journal ? journal->known() : 0;
  TileLoop loop;
  loop.tiles = study.tiles();
  loop.threads = run.threads;
  loop.stop = run.stop;
  if (journal) loop.known = [&](std::size_t k) { return journal->known(k); };
  loop.compute = [&](std::size_t k) { return study.tile(k, run.stop); };
  loop.done = [&](std::size_t k, const std::string& lines) {
    if (journal) journal->add(k, lines);
    if (run.progress)
      run.progress(static_cast<double>(++finished) / static_cast<double>(loop.tiles),
                   fmt::format("{} rows", study.source().rows()));
  };
  loop.take = [&](std::size_t, const std::string& lines) {
    count(study, lines, counts);
    if (table != nullptr)
      table->write(lines, static_cast<std::size_t>(std::ranges::count(lines, '\n')));
  };
  const bool whole = cli::run(loop);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (target != nullptr) {
    const std::optional<Case> alone = study.alone();
    Metadata metadata = describe(run, study, counts, alone);
    metadata.seconds = seconds;
    target->commit(std::move(metadata));
  }
  if (journal && whole) journal->finish();
  Outcome out;
  out.code = conclusion(study, counts, journal.has_value(), run);
  if (run.summary && out.code != ExitCode::interrupted)
    out.summary = summary(study, counts, seconds);
  return out;
}

}  // namespace stationary::cli
