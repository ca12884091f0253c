// stationary atlas CASE: every sheet of the case's body and potential in branches (i), (ii), (iii),
// of an anisotropic body the oblique ones too, over its range of nu, connected to rest or not, and
// what is proven of there being no others.
#include "solver/atlas/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/rows/atlas_rows.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/interrupt.hpp"
#include "solver/program/session/progress.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/table_output.hpp"
#include "solver/program/tiles/search_journal.hpp"

namespace stationary::cli {
namespace {

struct AtlasCommand : ComputeOptions {
  std::optional<int> checkpoints;
  bool resume = false;
};

std::string entry_text(Entry entry, double nu) {
  switch (entry) {
    case Entry::rest:
      return "from rest";
    case Entry::search:
      return fmt::format("found at nu = {:.6g}", nu);
    case Entry::ellipse:
      return fmt::format("off the circle at nu = {:.10g}", nu);
    case Entry::shear:
      return fmt::format("off the axes at nu = {:.10g}", nu);
    case Entry::oblique:
      return fmt::format("off an axis at nu = {:.10g}", nu);
    case Entry::numerical:
      return fmt::format("found at nu = {:.6g} by Newton's method, where the search is undecided",
                         nu);
    case Entry::tilt:
      break;
  }
  return fmt::format("off a tilt at nu = {:.10g}", nu);
}

std::string sheet_text(const AtlasSheet& sheet) {
  const auto end = [](const AtlasRow& row) {
    return fmt::format("{} at nu = {:.10g}",
                       row.event == EventType::none ? "open" : name(row.event), row.member.nu);
  };
  std::string out = fmt::format("({}{}), {} rows, {}: {}, {}", kind_name(sheet),
                                sheet.report.vertical ? ", vertical" : "", sheet.rows.size(),
                                entry_text(sheet.entry, sheet.entry_nu), end(sheet.rows.front()),
                                end(sheet.rows.back()));
  if (sheet.parent)
    out += fmt::format("; leaves sheet {} at {}", sheet.parent->sheet, name(sheet.parent->event));
  if (sheet.joins)
    out += fmt::format("; joins sheet {} at {}", sheet.joins->sheet, name(sheet.joins->event));
  return out;
}

/// "16 of 16 checkpoints: ...", and those where it is not so.
void add_checkpoints(Report& out, const std::vector<Checkpoint>& all,
                     const SearchOptions& searched) {
  std::string_view label = "proven";
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const Checkpoint& c) {
      return c.branch != first->branch || c.oblique != first->oblique;
    });
    const auto complete =
        std::count_if(first, last, [](const Checkpoint& c) { return c.complete(); });
    out.line(std::exchange(label, {}),
             fmt::format(
                 "branch ({}): at {} of {} checkpoints from nu = {:.6g} to {:.6g} the sheets have "
                 "every solution with stretches in [{:g}, {:g}]",
                 kind_name(first->branch, first->oblique), complete, last - first, first->nu,
                 (last - 1)->nu, searched.min_stretch, searched.max_stretch));
    while (first != last) {
      const auto alike = [&](const Checkpoint& c) {
        return c.status == first->status && c.proven == first->proven &&
               c.on_sheets == first->on_sheets && c.beyond == first->beyond;
      };
      const auto next = std::find_if_not(first, last, alike);
      if (!first->complete()) {
        const std::string place = next - first == 1
                                      ? fmt::format("{:.6g}", first->nu)
                                      : fmt::format("{:.6g} ... {:.6g} ({} checkpoints)", first->nu,
                                                    (next - 1)->nu, next - first);
        out.line({}, fmt::format("  not shown at nu = {}: search {}, {} proven, {} of them on "
                                 "sheets, {} points of sheets not proven",
                                 place, name(first->status), first->proven, first->on_sheets,
                                 first->beyond));
      }
      first = next;
    }
  }
}

std::string summary(const Case& input, const AtlasOptions& asked, const Atlas& found,
                    const std::vector<SheetRecord>& records, const CurveProofs& proofs,
                    double seconds) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  out.line("sheets", fmt::format("{} in {:.2g} s", found.sheets.size(), seconds));
  if (input.output.certificate)
    out.line("certificate", fmt::format("{} of {} rows proven", proofs.proven, proofs.rows));
  for (std::size_t k = 0; k < found.sheets.size(); ++k) {
    const AtlasSheet& sheet = found.sheets[k];
    out.line(fmt::format("{}", sheet.number), sheet_text(sheet));
    for (const EventRecord& event : sheet.report.events) {
      out.line({}, event.status == EventStatus::unresolved
                       ? fmt::format("  {:<17} nu between {:.15g} and {:.15g}, not located",
                                     name(event.type), event.before, event.after)
                       : fmt::format("  {:<17} nu = {:.15g}", name(event.type), event.parameter));
    }
    add_segments(out, records[k].segments, "nu");
  }
  out.gap();
  if (const auto caveat = proof_caveat(input)) add_plan(out, {*caveat});
  add_checkpoints(out, found.checkpoints, asked.search);
  std::string_view label = "remarks";
  for (const Remark& each : found.remarks) {
    const std::string at = each.entry ? ", " + entry_text(*each.entry, each.nu) : std::string();
    out.line(
        std::exchange(label, {}),
        fmt::format("branch ({}){}: {}", kind_name(each.branch, each.oblique), at, each.reason));
  }
  return out.text();
}

/// All sheets in the table, if there is one, and what is told of each; how many rows are proven.
CurveProofs write_sheets(const Case& input, Atlas& found, RowSink* writer,
                         std::vector<SheetRecord>& records) {
  CurveProofs out;
  for (AtlasSheet& sheet : found.sheets) {
    CurveTable table(name(sheet.motion(0.0)), writer, sheet.number);
    if (input.output.certificate) {
      const auto kind_at = [&](double nu) {
        return kind_of(input.body, input.potential, sheet.motion(nu));
      };
      table.prove(kind_at, {});
    }
    records.push_back(write_rows(sheet, table));
    out.rows += table.proofs().rows;
    out.proven += table.proofs().proven;
  }
  return out;
}

ExitCode atlas_case(const AtlasCommand& options, const Session& session) {
  const Case input = options.read();
  const bool to_table = !options.output.empty();
  const bool with_spectrum = wants_spectrum(input, to_table);
  AtlasOptions how = atlas_options(input, options.checkpoints, with_spectrum);
  how.threads = options.threads;
  how.stop = how.search.stop = &stop_on_signals();
  const std::vector<Column> columns = chosen_columns(
      input,
      equilibrium_columns(
          {.events = true, .spectrum = with_spectrum, .certificate = input.output.certificate}),
      "atlas", false);
  const auto begin = std::chrono::steady_clock::now();
  std::optional<TableOutput> output;
  if (to_table) output.emplace(options.output, options.path);
  std::optional<SearchJournal> journal;
  if (options.resume || has_journal(options.output))
    journal.emplace(options.output, input, how, options.resume);
  if (journal) journal->keep(how);

  ProgressBar progress;
  if (progress.shown() && !options.quiet) {
    how.progress = [&progress](double fraction) {
      progress.show(fraction, "searching the checkpoints");
    };
  }
  Atlas found = atlas(input.body, make_potential(input.models), how);
  progress.clear();
  RowSink* const table = output ? &output->open(columns) : nullptr;
  std::vector<SheetRecord> records;
  const CurveProofs proofs = write_sheets(input, found, table, records);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (output) {
    Metadata metadata;
    metadata.version = STATIONARY_VERSION;
    metadata.command_line = session.command_line;
    metadata.input = &input;
    if (input.output.certificate) metadata.counts.emplace_back("proven", proofs.proven);
    metadata.seconds = seconds;
    metadata.threads = options.threads;
    metadata.atlas = &found;
    metadata.curves = records;
    if (const auto caveat = proof_caveat(input)) metadata.plan.push_back(*caveat);
    metadata.outcome = {{"command", "atlas"},
                        {"status", found.interrupted ? "interrupted" : "done"}};
    output->commit(metadata);
  }
  if (journal && !found.interrupted) journal->finish();
  if (options.shows_summary()) print(summary(input, how, found, records, proofs, seconds));
  if (found.interrupted) {
    complain(journal ? "interrupted: the atlas is not complete; --resume goes on with it"
                     : "interrupted: the atlas is not complete");
    return ExitCode::interrupted;
  }
  return ExitCode::done;
}

}  // namespace

void add_atlas(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "atlas",
                  "Find and follow every sheet over the case's range of nu, connected or not");
  const auto options = std::make_shared<AtlasCommand>();
  options->threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options->add_to(command);
  command
      .add_option("--checkpoints", options->checkpoints,
                  fmt::format("Values of nu at which every solution is found, with proof (default "
                              "{}, of an anisotropic body {})",
                              AtlasOptions{}.checkpoints, few_checkpoints))
      ->check(CLI::Range(1, 1'000'000));
  command.add_flag("--resume", options->resume,
                   "Go on with the interrupted atlas at -o FILE: no search is made twice");
  command.callback([options, &session] {
    session.action = [options, &session] { return atlas_case(*options, session); };
  });
}

}  // namespace stationary::cli
