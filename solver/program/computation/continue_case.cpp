#include "solver/program/computation/continue_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/computation/row_start.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/rows/resume_table.hpp"
#include "solver/program/session/case_family.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/resume.hpp"
#include "solver/program/session/run_metadata.hpp"

namespace stationary::cli {
namespace {

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
  const ComputationPlan plan = computation_plan(input, false, PlanOf::follow);
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

Metadata describe(const Run& run, const Case& input, const Start& start, const FollowReport& report,
                  const EvaluationCounts& evaluations, const CurveTable& table) {
  const SheetRecord curve = table.record(report);
  ComputationPlan plan = computation_plan(input, true, PlanOf::follow);
  Metadata out = metadata_of(run, &input);
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
  if (const std::string gap = table.proofs().gap_text(input.continuation->parameter); !gap.empty())
    out.outcome.emplace_back("warning", gap);
  return out;
}

ExitCode end_code(const FollowReport& report) {
  if (report.interrupted) return ExitCode::interrupted;
  return given_up(report).empty() ? ExitCode::done : ExitCode::failure;
}

}  // namespace

Outcome continue_case(const Case& given, const ContinueFrom& from, TableTarget* target,
                      const Run& run) {
  require_range(given);
  const std::string row = start_row_of(given, from.row);
  std::optional<RowStart> at_row;
  try {
    if (!row.empty()) at_row = start_from_row(given, row);
  } catch (const InputError& fault) {
    if (!from.row.empty() || fault.origin().option.empty()) throw;
    throw fault_at(given.source, "continuation.start_row", fault.found(), fault.allowed(),
                   fault.remedy());  // no option has named it
  }
  const Case& input = at_row ? at_row->input : given;
  const bool to_table = target != nullptr;
  const bool with_spectrum = wants_spectrum(input, to_table);
  const bool trailing = input.continuation->parameter != "nu";
  const std::vector<Column> columns =
      chosen_columns(input,
                     equilibrium_columns({.two_polar = has_rates(input.motion),
                                          .events = true,
                                          .spectrum = with_spectrum,
                                          .certificate = input.output.certificate,
                                          .pressure = input.potential.holds_volume()}),
                     "continue", trailing);
  const std::optional<std::string> parameter =
      trailing ? std::optional(input.continuation->parameter) : std::nullopt;
  std::optional<ResumedTable> old;
  if (from.resumed) {
    old = resumed_table(input, *from.resumed, columns, parameter);
    if (!old->first && !old->last) {
      for (const auto& [row, reason] : {std::pair(&old->rows.front(), &old->first_reason),
                                        std::pair(&old->rows.back(), &old->last_reason)}) {
        if (row->event != name(EventType::stalled)) continue;
        run.complain("numerical failure: " + *reason + ": " + *from.resumed +
                     " ends there, and has nothing to go on with");
        return {ExitCode::failure, std::string()};
      }
      const std::string text = *from.resumed + " is complete: both ends are reached\n";
      return {ExitCode::done, run.summary ? text : std::string()};
    }
  }
  if (to_table) target->prepare();

  const auto begin = std::chrono::steady_clock::now();
  const Start start = [&] {
    const auto waiting = run.waiting("solving at the start");
    if (old) return resumed_start(input, *old);
    return at_row ? at_row->start : solved_start(input, run);
  }();
  if (start.found.status != SolveStatus::solved) {
    run.complain(fmt::format("at the start {} = {}: {}", input.continuation->parameter, start.p,
                             failure_text(start.outcome(), start.found.message)));
    return {exit_code(start.found.status), {}};
  }
  const AnyFamily family = family_of(input, start, with_spectrum, to_table);
  RowSink* table = nullptr;
  if (to_table) {
    std::vector<std::string> trailing_columns;
    if (parameter) trailing_columns.push_back(*parameter);
    table = &target->open(columns, trailing_columns);
  }
  CurveTable rows(input.branch_name(), table);
  rows.in_coordinates(input.coordinates);
  ask_kinds(input, start, rows);
  const double unit = parameter_unit(start.at, input.continuation->parameter);
  rows.in_units_of(unit);
  FollowOptions how = follow_options(input, unit, run);
  how.from_event = start.is_event;
  FollowReport report = old ? follow_on(family, *old, unit, how, rows)
                            : follow(family, start.found.q, start.p * unit, how, rows);
  if (!old) rows.convert(report);
  rows.complete(report.events);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!report.failure.empty()) {
    run.complain("numerical failure: " + report.failure);
    return {ExitCode::failure, {}};
  }
  if (to_table) {
    Metadata metadata =
        describe(run, input, start, report,
                 std::visit([](const auto& f) { return f->evaluations(); }, family), rows);
    metadata.seconds = seconds;
    target->commit(std::move(metadata));
  }
  if (const std::string gap = rows.proofs().gap_text(input.continuation->parameter); !gap.empty())
    run.complain(gap);
  Outcome out{end_code(report), {}};
  if (out.code == ExitCode::interrupted) {
    run.complain(fmt::format("interrupted after {} point{}{}", report.points,
                             report.points == 1 ? "" : "s",
                             to_table ? "; the table is written" : ""));
  }
  if (report.out_of_points) {
    const bool told = missing_to_resume(columns, parameter, input.branch_name()).empty() &&
                      lacking_to_resume(input, columns).empty();
    run.complain(fmt::format("stopped after {} points, continuation.max_points{}", report.points,
                             !to_table || !target->can_be_resumed() ? ""
                             : told
                                 ? "; --resume goes on where it is set higher"
                                 : "; --resume cannot go on: output.columns lacks what it needs"));
  }
  for (const std::string& reason : given_up(report)) run.complain("numerical failure: " + reason);
  if (run.summary) out.summary = summary(input, start, report, rows, seconds);
  return out;
}

}  // namespace stationary::cli
