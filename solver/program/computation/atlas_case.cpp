#include "solver/program/computation/atlas_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "solver/atlas/atlas.hpp"
#include "solver/atlas/least_energy.hpp"
#include "solver/program/case/case_atlas.hpp"
#include "solver/program/rows/atlas_rows.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/tiles/search_journal.hpp"
#include "solver/search/search_message.hpp"

namespace stationary::cli {
namespace {

std::string entry_text(Entry entry, double nu) {
  switch (entry) {
    case Entry::rest:
      return "from rest";
    case Entry::search:
      return fmt::format("found at nu = {:.6g}", nu);
    case Entry::ellipse:
      return fmt::format("off the circle at nu = {:.12g}", nu);
    case Entry::shear:
      return fmt::format("off the axes at nu = {:.12g}", nu);
    case Entry::oblique:
      return fmt::format("off an axis at nu = {:.12g}", nu);
    case Entry::numerical:
      return fmt::format("found at nu = {:.6g} by Newton's method, where the search is undecided",
                         nu);
    case Entry::tilt:
      break;
  }
  return fmt::format("off a tilt at nu = {:.12g}", nu);
}

std::string sheet_text(const AtlasSheet& sheet) {
  const auto end = [&](EventType event, const AtlasRow& row) {
    const std::string_view open = sheet.report.interrupted ? "interrupted" : "open";
    return fmt::format("{} at nu = {:.12g}", event == EventType::none ? open : name(event),
                       row.member.nu);
  };
  std::string out = fmt::format(
      "({}{}), {} rows, {}: {}, {}", kind_name(sheet), sheet.report.vertical ? ", vertical" : "",
      sheet.rows.size(), entry_text(sheet.entry, sheet.entry_nu),
      end(sheet.first_event(), sheet.rows.front()), end(sheet.last_event(), sheet.rows.back()));
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
    const auto last =
        std::find_if(first, all.end(), [&](const SheetKind& kind) { return kind != *first; });
    const auto complete =
        std::count_if(first, last, [](const Checkpoint& c) { return c.complete(); });
    out.line(std::exchange(label, {}),
             fmt::format(
                 "branch ({}): at {} of {} checkpoints from nu = {:.6g} to {:.6g} the sheets have "
                 "every solution with {}",
                 kind_text(*first), complete, last - first, first->nu, (last - 1)->nu,
                 range_text(searched)));
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

/// " but for ...": what is left of a range; nothing where nothing is.
std::string all_but(std::ptrdiff_t intervals, double length, double range) {
  if (intervals == 0) return {};
  return fmt::format(" but for {} interval{} of total length {:.2g}, {:.2g} of the range",
                     intervals, intervals == 1 ? "" : "s", length, length / range);
}

/// For every nu: the numbers of sheets, and where they are not told.
void add_completeness(Report& out, const std::vector<Completeness>& all) {
  std::string_view label = "complete";
  for (const Completeness& kind : all) {
    if (kind.intervals.empty()) continue;  // interrupted
    const auto unproven = std::ranges::count(kind.intervals, false, &CompleteInterval::proven);
    const double from = kind.intervals.front().from;
    const double to = kind.intervals.back().to;
    std::string text =
        fmt::format("branch ({}): complete for nu in [{:.6g}, {:.6g}]", kind_text(kind), from, to);
    text += all_but(unproven, kind.unproven_length(), to - from);
    out.line(std::exchange(label, {}),
             text + fmt::format("; {} boxes, {} tubes", kind.boxes, kind.tubes));
    for (const CompleteInterval& each : kind.joined()) {
      const std::string range = fmt::format("[{:.12g}, {:.12g}]", each.from, each.to);
      out.line({}, each.proven ? fmt::format("  {} sheet{} for nu in {}", each.sheets,
                                             each.sheets == 1 ? "" : "s", range)
                               : fmt::format("  not told in {}: {}", range, each.reason));
    }
  }
  if (!all.empty()) {
    const double left = unproven_fraction(all);
    out.line(
        {}, fmt::format("{} of the range of these branches is proven, in the box of the stretches; "
                        "two-polar motions are not covered, nor axes with three components",
                        left > 0.0 ? fmt::format("all but {:.2g}", left) : "all"));
  }
}

std::string class_counts(const ClassInterval& of) {
  std::string out;
  for (std::size_t k = 0; k < of.sheets.size(); ++k)
    if (of.sheets[k] > 0)
      out += fmt::format("{}{} {}", out.empty() ? "" : ", ", of.sheets[k], stability_names[k]);
  return out.empty() ? "no motion" : out;
}

std::string class_change(const ClassInterval& of) {
  if (of.events.empty()) return std::string(of.reason);
  std::string out;
  for (const EventType event : of.events)
    out += fmt::format("{}{}", out.empty() ? "" : ", ", name(event));
  return out;
}

/// For every nu: of how many motions each class is, and where that is not told.
void add_classes(Report& out, const std::vector<Completeness>& all) {
  std::string_view label = "classes";
  for (const Completeness& kind : all) {
    if (kind.classes.empty()) continue;
    const auto unproven = std::ranges::count(kind.classes, false, &ClassInterval::proven);
    std::string text =
        fmt::format("branch ({}): proven for nu in [{:.6g}, {:.6g}]", kind_text(kind),
                    kind.classes.front().from, kind.classes.back().to);
    text += all_but(unproven, kind.unproven_class_length(),
                    kind.classes.back().to - kind.classes.front().from);
    out.line(std::exchange(label, {}), text + fmt::format("; {} arcs", kind.class_arcs));
    for (const ClassInterval& each : kind.classes) {
      // At rest the leaf is another, and so is what a class says.
      const char* const begin = each.proven && each.from == 0.0 ? "(" : "[";
      const std::string range = fmt::format("{}{:.12g}, {:.12g}]", begin, each.from, each.to);
      out.line({}, each.proven ? fmt::format("  {} for nu in {}", class_counts(each), range)
                               : fmt::format("  not told in {}: {}", range, class_change(each)));
    }
  }
}

/// At each |pi| the motion of least energy, and where that is another.
void add_least_energy(Report& out, const std::vector<LeastEnergyPiece>& pieces,
                      const std::vector<AtlasSheet>& sheets) {
  std::string_view label = "least energy";
  for (const LeastEnergyPiece& each : pieces)
    out.line(std::exchange(label, {}),
             fmt::format("sheet {}, branch ({}), for |pi| in [{:.12g}, {:.12g}]", each.sheet,
                         kind_name(sheets[std::size_t(each.sheet) - 1]), each.from.momentum,
                         each.to.momentum));
  if (!pieces.empty())
    out.line({},
             "of the motions listed: two-polar ones, others beyond the range, and what of a sheet "
             "lies beyond its escape, are left out");
}

std::string summary(const Case& input, const AtlasOptions& asked, const Atlas& found,
                    const std::vector<SheetRecord>& records, const CurveProofs& proofs,
                    const std::vector<LeastEnergyPiece>& least, double seconds) {
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
  add_completeness(out, found.completeness);
  add_classes(out, found.completeness);
  add_least_energy(out, least, found.sheets);
  std::string_view label = "remarks";
  for (const Remark& each : found.remarks) {
    const std::string at = each.entry ? ", " + entry_text(*each.entry, each.nu) : std::string();
    out.line(std::exchange(label, {}),
             fmt::format("branch ({}){}: {}", kind_text(each), at, each.reason));
  }
  return out.text();
}

/// What was searched and followed.
std::vector<std::pair<std::string_view, long>> counts_of(const Atlas& found) {
  ContinuationCounts followed;
  for (const AtlasSheet& each : found.sheets) followed += each.report.counts;
  long boxes = 0;
  long tubes = 0;
  long arcs = 0;
  for (const Completeness& each : found.completeness) {
    boxes += each.boxes;
    tubes += each.tubes;
    arcs += each.class_arcs;
  }
  return {{"checkpoints", static_cast<long>(found.checkpoints.size())},
          {"continuation_steps", followed.steps},
          {"steps_taken_back", followed.rejected},
          {"points_evaluated", followed.members},
          {"cover_boxes", boxes},
          {"cover_tubes", tubes},
          {"class_arcs", arcs}};
}

/// metadata: of the atlas, which an HDF5 file has too.
void write_least_energy(const std::vector<LeastEnergyPiece>& least,
                        const std::vector<AtlasSheet>& sheets, Metadata metadata,
                        const std::string& path, AtomicFile& file) {
  const bool as_columns =
      is_column_file_extension(std::filesystem::path(path).extension().string());
  CellTable table(as_columns ? nullptr : &file, least_energy_columns());
  table.write(least_energy_rows(least, sheets));
  metadata.rows = table.rows();
  metadata.checksum = table.checksum().text();
  if (as_columns) table.finish(file.path().string(), metadata_json(metadata, /*of_the_run=*/false));
  file.commit();
}

}  // namespace

Outcome atlas_case(const Case& input, const AtlasRun& asked, TableTarget* target, const Run& run) {
  const bool with_spectrum = wants_spectrum(input, target != nullptr);
  AtlasOptions how = atlas_options(input, asked.checkpoints, with_spectrum);
  how.complete = how.complete || asked.complete;
  how.threads = run.threads;
  how.stop = how.search.stop = run.stop;
  if (run.progress)
    how.progress = [&run](double fraction) { run.progress(fraction, "searching the checkpoints"); };
  const std::vector<Column> columns =
      chosen_columns(input,
                     equilibrium_columns({.events = true,
                                          .spectrum = with_spectrum,
                                          .certificate = input.output.certificate,
                                          .pressure = input.potential.holds_volume()}),
                     "atlas", false);
  // First of all, so that a run refused for another one touches nothing of that.
  std::optional<SearchJournal> journal;
  if (asked.journal) journal.emplace(*asked.journal, input, how, asked.resume);
  if (target != nullptr) target->prepare();
  std::optional<AtomicFile> least_file;
  if (!asked.least_energy.empty()) {
    refuse_to_replace(asked.least_energy, asked.least_energy, input.source.name(), "the case file");
    open_output(least_file, asked.least_energy, "--least-energy");
  }
  if (journal) {
    journal->keep(how);
    for (const std::string& line : journal->remarks()) run.complain(line);
  }

  const auto begin = std::chrono::steady_clock::now();
  Atlas found = atlas(input.body, make_potential(input.models, input.body), how);
  RowSink* const table = target != nullptr ? &target->open(columns) : nullptr;
  std::vector<SheetRecord> records;
  const CurveProofs proofs = write_sheets(
      {input.body, input.potential, input.output.certificate, input.coordinates, how.stop}, found,
      table, records);
  const std::vector<LeastEnergyPiece> least = least_energy(found.sheets, how.search);
  found.interrupted = found.interrupted || (how.stop != nullptr && *how.stop);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  Metadata metadata = metadata_of(run, &input);
  metadata.counts = counts_of(found);
  if (input.output.certificate) metadata.counts.emplace_back("proven", proofs.proven);
  metadata.seconds = seconds;
  metadata.atlas = &found;
  metadata.least_energy = least;
  metadata.curves = records;
  ComputationPlan plan = computation_plan(input, target != nullptr, PlanOf::atlas);
  metadata.plan = std::move(plan.computed);
  metadata.skipped = std::move(plan.skipped);
  metadata.outcome = {{"command", "atlas"}, {"status", found.interrupted ? "interrupted" : "done"}};
  const std::string gap = proofs.gap_text("nu");
  if (!gap.empty()) metadata.outcome.emplace_back("warning", gap);
  if (least_file && !found.interrupted)
    write_least_energy(least, found.sheets, metadata, asked.least_energy, *least_file);
  if (target != nullptr) target->commit(std::move(metadata));
  if (journal && !found.interrupted) journal->finish();
  Outcome out;
  if (!gap.empty()) run.complain(gap);
  const auto cut = std::ranges::count_if(
      found.sheets, [](const AtlasSheet& sheet) { return sheet.report.out_of_points; });
  if (cut > 0)
    run.complain(
        fmt::format("{} sheet{} stopped at continuation.max_points: what is beyond may be "
                    "another sheet in this table, or in none",
                    cut, cut == 1 ? "" : "s"));
  if (run.summary) out.summary = summary(input, how, found, records, proofs, least, seconds);
  for (const AtlasSheet& sheet : found.sheets) {
    for (const std::string& reason : given_up(sheet.report)) {
      run.complain(
          fmt::format("numerical failure: sheet {} was given up: {}", sheet.number, reason));
      out.code = ExitCode::failure;
    }
  }
  if (found.interrupted) {
    run.complain(journal ? "interrupted: the atlas is not complete; --resume goes on with it"
                         : "interrupted: the atlas is not complete");
    out.code = ExitCode::interrupted;
  } else if (found.sheets.empty()) {
    run.complain(fmt::format(
        "no stationary ellipsoid was found with nu from {} to {}{}", input.continuation->from,
        input.continuation->to,
        complete_fraction(found) == 1.0 ? ": at each checkpoint none exists in the box" : ""));
    out.code = ExitCode::no_equilibrium;
  }
  return out;
}

}  // namespace stationary::cli
