// stationary continue CASE: the case's family followed in its parameter, both ways from the start,
// with the stability of every point and every event located.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/case_family.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/progress.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/resume.hpp"
#include "solver/program/session/row_start.hpp"
#include "solver/program/session/table_output.hpp"

namespace stationary::cli {
namespace {

struct ContinueOptions : ComputeOptions {
  bool resume = false;
  std::string from;  ///< a row of a table (row_start.hpp); empty: solved for
};

/// What is not proven though it was asked for; empty if all is.
std::string gap_text(const Case& input, const CurveProofs& proofs) {
  if (proofs.proven == proofs.rows) return {};
  return fmt::format("{} of {} rows are not proven, the first of them at {} = {:.12g}: {}",
                     proofs.rows - proofs.proven, proofs.rows, input.continuation->parameter,
                     proofs.first_gap, proofs.reason);
}

/// On a bar.
void show_progress(const Case& input, double unit, ProgressBar& progress, FollowOptions& how) {
  const Case::Continuation& asked = *input.continuation;
  // Both ways from the start, and back at folds: done is what lies between the outermost points.
  how.progress = [&progress, &asked, unit, low = std::numeric_limits<double>::infinity(),
                  high = -std::numeric_limits<double>::infinity()](double in_family,
                                                                   long points) mutable {
    const double p = in_family / unit;
    low = std::min(low, p);
    high = std::max(high, p);
    progress.show((high - low) / std::abs(asked.to - asked.from),
                  fmt::format("{} = {:<12.6g} {} points", asked.parameter, p, points));
  };
}

std::string end_text(const Case& input, const EndRecord& end) {
  if (end.reason.empty()) return "not followed";
  return fmt::format(
      "{}at {} = {:.12g}: {}",
      end.event == EventType::none ? std::string() : fmt::format("{} ", name(end.event)),
      input.continuation->parameter, end.parameter, end.reason);
}

/// With what is proven of it.
std::string event_place(const EventRecord& event) {
  if (event.status == EventStatus::unresolved)
    return fmt::format(
        "between {:.15g} and {:.15g}: not located, the error bounds do not resolve it",
        event.before, event.after);
  if (!event.enclosure) return fmt::format("{:.15g}", event.parameter);
  return fmt::format("{:.17g}, proven within {:.1e}", event.parameter,
                     (*event.enclosure - Interval(event.parameter)).magnitude());
}

std::string summary(const Case& input, const Start& start, const FollowReport& report,
                    const CurveTable& table, double seconds) {
  const SheetRecord curve = table.record(report);
  constexpr std::size_t label_width = 14;
  const std::string& parameter = input.continuation->parameter;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  out.line("family", fmt::format("branch ({}) in {}, from {} to {}", input.branch_name(), parameter,
                                 input.continuation->from, input.continuation->to));
  out.line("start", fmt::format("{} = {:.12g}: {}", parameter, start.p, start.found.message));
  out.line("points", fmt::format("{} in {:.2g} s", report.points, seconds));
  if (report.vertical)
    out.line("vertical", "a branch at this one nu, followed in the eccentricity of its ellipses");
  out.line("one end", end_text(input, curve.first));
  out.line("other end", end_text(input, curve.last));
  if (input.output.certificate)
    out.line("certificate",
             fmt::format("{} of {} points proven", table.proofs().proven, table.proofs().rows));
  out.gap();
  std::string_view label = "events";
  for (const EventRecord& event : report.events) {
    out.line(std::exchange(label, {}),
             fmt::format("{:<17} {} {}{}", name(event.type), parameter,
                         event.status == EventStatus::unresolved ? "" : "= ", event_place(event)));
  }
  if (report.events.empty()) out.line(label, "none");
  if (!curve.segments.empty()) out.gap();
  add_segments(out, curve.segments, parameter);
  out.gap();
  const ComputationPlan plan = computation_plan(input, false);
  add_plan(out, plan.computed);
  add_plan(out, plan.skipped);
  return out.text();
}

/// Of the start's solve, then of the family.
std::vector<std::pair<std::string_view, long>> counts_of(const Start& start,
                                                         const FollowReport& report,
                                                         const EvaluationCounts& family,
                                                         const CurveTable& table) {
  auto out = named_counts(start.found.counts);
  out.emplace_back("continuation_steps", report.counts.steps);
  out.emplace_back("steps_taken_back", report.counts.rejected);
  out.emplace_back("points_evaluated", report.counts.members);
  out.emplace_back("continuation_jacobians", family.jacobians);
  out.emplace_back("continuation_extended_residuals", family.extended_residuals);
  out.emplace_back("sensitivities", family.sensitivities);
  out.emplace_back("potentials", family.potentials);
  out.emplace_back("second_derivatives", family.second_derivatives);
  out.emplace_back("spectra", family.spectra);
  out.emplace_back("certificates", table.proofs().rows);
  return out;
}

Metadata describe(const Session& session, const Case& input, const Start& start,
                  const FollowReport& report, const EvaluationCounts& evaluations,
                  const CurveTable& table) {
  const SheetRecord curve = table.record(report);
  ComputationPlan plan = computation_plan(input, true);
  Metadata out;
  out.version = STATIONARY_VERSION;
  out.command_line = session.command_line;
  out.input = &input;
  out.counts = counts_of(start, report, evaluations, table);
  if (input.output.certificate) out.counts.emplace_back("proven", table.proofs().proven);
  out.plan = std::move(plan.computed);
  out.skipped = std::move(plan.skipped);
  out.curves = {curve};
  out.outcome = {{"command", "continue"},
                 {"status", report.interrupted     ? "interrupted"
                            : report.out_of_points ? "stopped at max_points"
                                                   : "done"},
                 {"start", start.found.message},
                 {"connection", std::string(name(start.found.connection))},
                 {"first_end", end_text(input, curve.first)},
                 {"last_end", end_text(input, curve.last)}};
  if (report.vertical) out.outcome.emplace_back("vertical", "the sheet has this one nu");
  if (const std::string gap = gap_text(input, table.proofs()); !gap.empty())
    out.outcome.emplace_back("warning", gap);
  return out;
}

ExitCode end_code(const FollowReport& report) {
  if (report.interrupted) return ExitCode::interrupted;
  const bool stalled =
      report.backward.event == EventType::stalled || report.forward.event == EventType::stalled;
  return stalled ? ExitCode::failure : ExitCode::done;
}

ExitCode continue_case(const ContinueOptions& options, const Session& session) {
  Case input = options.read();
  require_range(input);
  const std::string row = options.from.empty() ? input.continuation->start_row : options.from;
  std::optional<Start> at_row;
  if (!row.empty()) {
    RowStart from = start_from_row(options, row);
    input = std::move(from.input);
    at_row = std::move(from.start);
  }
  const bool to_table = !options.output.empty();
  const bool with_spectrum = wants_spectrum(input, to_table);
  const bool trailing = input.continuation->parameter != "nu";
  const std::vector<Column> columns =
      chosen_columns(input,
                     equilibrium_columns({.two_polar = has_rates(input.motion),
                                          .events = true,
                                          .spectrum = with_spectrum,
                                          .certificate = input.output.certificate}),
                     "continue", trailing);
  const std::optional<std::string> parameter =
      trailing ? std::optional(input.continuation->parameter) : std::nullopt;
  std::optional<ResumedTable> old;
  if (options.resume) {
    old = resumed_table(input, options.output, columns, parameter);
    if (!old->first && !old->last) {
      if (!options.quiet) print(options.output + " is complete: both ends are reached\n");
      return ExitCode::done;
    }
  }
  std::optional<TableOutput> output;
  if (to_table) output.emplace(options.output, options.path);

  const auto begin = std::chrono::steady_clock::now();
  const Start start = [&] {
    const WaitingSign waiting("solving at the start", options.quiet);
    if (old) return resumed_start(input, *old);
    return at_row ? *at_row : solved_start(input, options.threads);
  }();
  if (start.found.status != SolveStatus::solved) {
    complain(fmt::format("at the start {} = {}: {}", input.continuation->parameter, start.p,
                         failure_text(outcome(start.found.status), start.found.message)));
    return exit_code(start.found.status);
  }
  const AnyFamily family = family_of(input, start, with_spectrum, to_table);
  ProgressBar progress;
  RowSink* table = nullptr;
  if (output) {
    std::vector<std::string> trailing_columns;
    if (parameter) trailing_columns.push_back(*parameter);
    table = &output->open(columns, trailing_columns);
  }
  CurveTable rows(input.branch_name(), table);
  if (input.output.certificate) prove_rows(input, start, rows);
  const double unit = parameter_unit(start.at, input.continuation->parameter);
  rows.in_units_of(unit);
  FollowOptions how = follow_options(input, unit);
  if (progress.shown() && !options.quiet) show_progress(input, unit, progress, how);
  FollowReport report = old ? follow_on(family, *old, unit, how, rows)
                            : follow(family, start.found.q, start.p * unit, how, rows);
  if (!old) rows.convert(report);
  progress.clear();
  rows.complete(report.events);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!report.failure.empty()) {
    complain("numerical failure: " + report.failure);
    return ExitCode::failure;
  }
  if (output) {
    Metadata metadata =
        describe(session, input, start, report,
                 std::visit([](const auto& f) { return f->evaluations(); }, family), rows);
    metadata.seconds = seconds;
    metadata.threads = options.threads;
    output->commit(metadata);
  }
  if (const std::string gap = gap_text(input, rows.proofs()); !gap.empty()) complain(gap);
  const ExitCode code = end_code(report);
  if (code == ExitCode::interrupted) {
    complain(fmt::format("interrupted after {} points{}", report.points,
                         output ? ", which are written" : ""));
  }
  if (report.out_of_points) {
    complain(fmt::format("stopped after {} points, continuation.max_points{}", report.points,
                         output ? "; --resume goes on where it is set higher" : ""));
  }
  for (const SheetEnd* end : {&report.backward, &report.forward})
    if (end->event == EventType::stalled) complain("numerical failure: " + end->reason);
  if (options.shows_summary()) print(summary(input, start, report, rows, seconds));
  return code;
}

}  // namespace

void add_continue(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "continue",
                  "Follow the case's family in a parameter: bifurcation table, stability, events");
  const auto options = std::make_shared<ContinueOptions>();
  options->add_to(command);
  command
      .add_option(
          "--from", options->from,
          "Go on from a motion of a table: TABLE:N (data row N, the first is 1), TABLE:EVENT "
          "or TABLE:EVENT:K")
      ->type_name("TABLE:ROW");
  command.add_flag("--resume", options->resume,
                   "Go on with the interrupted table at -o FILE (same case, same columns)");
  command.callback([options, &session] {
    session.action = [options, &session] { return continue_case(*options, session); };
  });
}

}  // namespace stationary::cli
