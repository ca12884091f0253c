// stationary continue CASE: the case's family followed in its parameter, both ways from the start,
// with the stability of every point and every event located.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "solver/case_keys.hpp"
#include "solver/case_parameter.hpp"
#include "solver/cli/command.hpp"
#include "solver/cli/interrupt.hpp"
#include "solver/cli/outcome.hpp"
#include "solver/cli/plan.hpp"
#include "solver/cli/progress.hpp"
#include "solver/cli/report.hpp"
#include "solver/cli/table_output.hpp"
#include "solver/cli/tilted_start.hpp"
#include "solver/curve_table.hpp"
#include "solver/equilibrium_row.hpp"
#include "solver/follow.hpp"
#include "solver/resume_table.hpp"
#include "solver/two_polar_family.hpp"

namespace stationary::cli {
namespace {

struct ContinueOptions : ComputeOptions {
  bool resume = false;
};

/// The family, and a solved member to start from.
struct Start {
  FamilyParameters at;  ///< with the parameter at p
  double p;
  Equilibrium found;
};

/// nu = 0 where the range has it and no start is given (the family through the rest state), else
/// the case's own value if it lies in the range, else the range's beginning. A tilted family has no
/// rest state: the case's own value.
double start_parameter(const Case& input) {
  const Case::Continuation& range = *input.continuation;
  const bool in_nu = range.parameter == "nu";
  if (in_nu && !input.tilted() && !input.solve.start && range.from <= 0.0 && range.to >= 0.0)
    return 0.0;
  const double own = parameter_value({input.body, input.models, input.motion}, range.parameter);
  if (own >= range.from && own <= range.to) return own;
  if (!input.solve.start && !input.tilted()) return range.from;
  throw fault_at(input.source, in_nu ? "motion.nu" : range.parameter,
                 fmt::format("found {} = {}, outside the range followed, with {}", range.parameter,
                             own, input.solve.start ? "solve.start" : "branch \"tilted\""),
                 fmt::format("a value in [{}, {}]", range.from, range.to),
                 input.solve.start ? "solve.start is a guess of the solution there"
                                   : "the family is followed from its member there");
}

FamilyParameters at_parameter(const Case& input, double p) {
  return with_parameter({input.body, input.models, input.motion}, input.continuation->parameter, p);
}

Start start_at(const Case& input, double p) { return {at_parameter(input, p), p, {}}; }

Problem problem_of(const FamilyParameters& at) {
  return {at.body, make_potential(at.models), std::get<AxisRotation>(at.motion).branch};
}

Start solved_start(const Case& input, const ComputeOptions& options) {
  Start out = start_at(input, start_parameter(input));
  const SolveOptions how{.method = input.solve.method,
                         .start = input.solve.start,
                         .threads = options.threads,
                         .stop = &stop_on_signals()};
  if (auto* tilted = std::get_if<TiltedMotion>(&out.at.motion)) {
    out.found = tilted_start(input, make_potential(out.at.models), *tilted, how);
  } else if (const auto* two_polar = std::get_if<TwoPolarMotion>(&out.at.motion)) {
    const TwoPolarEquilibrium found =
        solve_two_polar(out.at.body, make_potential(out.at.models), *two_polar, how);
    out.found.status = found.status;
    out.found.message = found.message;
    out.found.counts = found.counts;
    out.found.q = {0.0, found.x[0], found.x[1], found.x[2]};
  } else {
    const AxisRotation motion = std::get<AxisRotation>(out.at.motion);
    out.found = solve(problem_of(out.at), motion.nu, how);
    if (out.found.status == SolveStatus::not_isolated && how.start) {
      out.found.status = SolveStatus::solved;
      out.found.message = "the given start, on a vertical branch";
      out.found.connection = Connection::given_start;
      out.found.q = *how.start;
    }
  }
  return out;
}

/// Where the table goes on.
Start resumed_start(const Case& input, const ResumedTable& old) {
  const CurvePlace at = old.first ? old.first->at : old.last->at;
  Start out = start_at(input, at.p);
  out.found.status = SolveStatus::solved;
  out.found.message = "resumed from the table";
  out.found.connection = Connection::given_start;
  out.found.q = at.q;
  if (auto* tilted = std::get_if<TiltedMotion>(&out.at.motion); tilted && !tilted->plane) {
    const bool second =
        std::ranges::any_of(old.rows, [](const TableRow& row) { return row[Column::nu2] != 0.0; });
    tilted->plane = second ? TiltPlane::two_three : TiltPlane::one_three;
  }
  return out;
}

/// What is not proven though it was asked for; empty if all is.
std::string gap_text(const Case& input, const CurveProofs& proofs) {
  if (proofs.proven == proofs.rows) return {};
  return fmt::format("{} of {} rows are not proven, the first of them at {} = {:.12g}: {}",
                     proofs.rows - proofs.proven, proofs.rows, input.continuation->parameter,
                     proofs.first_gap, proofs.reason);
}

AnyFamily family_of(const Case& input, const Start& start, bool with_spectrum, bool to_table) {
  if (const auto* tilted = std::get_if<TiltedMotion>(&start.at.motion)) {
    return tilted_family(start.at.body, make_potential(start.at.models), *tilted->plane,
                         with_spectrum);
  }
  if (const auto* two_polar = std::get_if<TwoPolarMotion>(&start.at.motion)) {
    return two_polar_family(
        start.at.body, make_potential(start.at.models),
        {.motion = *two_polar,
         .parameter = family_parameter(input.continuation->parameter, input.models),
         .spectrum = with_spectrum});
  }
  const AxisRotation motion = std::get<AxisRotation>(start.at.motion);
  return axis_family(problem_of(start.at),
                     {.nu = motion.nu,
                      .parameter = family_parameter(input.continuation->parameter, input.models),
                      .spectrum = with_spectrum,
                      .errors = wants_column(input, Column::residual, to_table) ||
                                wants_column(input, Column::compatibility, to_table),
                      .energy = wants_column(input, Column::energy, to_table)});
}

FollowOptions follow_options(const Case& input, const ContinueOptions& options,
                             ProgressBar& progress) {
  const Case::Continuation& asked = *input.continuation;
  FollowOptions out;
  out.continuation.from = asked.from;
  out.continuation.to = asked.to;
  out.continuation.step.tolerance = asked.tolerance;
  out.continuation.step.first = asked.step;
  out.events = asked.event_set();
  out.max_points = static_cast<long>(asked.max_points);
  out.stop = &stop_on_signals();
  if (progress.shown() && !options.quiet) {
    out.progress = [&progress, &asked](double p, long points) {
      progress.show((p - asked.from) / (asked.to - asked.from),
                    fmt::format("{} = {:<12.6g} {} points", asked.parameter, p, points));
    };
  }
  return out;
}

std::string end_text(const Case& input, const SheetEnd& end, double p) {
  if (end.reason.empty()) return "not followed";
  return fmt::format(
      "{}at {} = {:.12g}: {}",
      end.event == EventType::none ? std::string() : fmt::format("{} ", name(end.event)),
      input.continuation->parameter, p, end.reason);
}

/// With what is proven of it.
std::string event_place(const EventRecord& event) {
  if (!event.enclosure) return fmt::format("{:.15g}", event.parameter);
  return fmt::format("{:.17g}, proven within {:.1e}", event.parameter,
                     (*event.enclosure - Interval(event.parameter)).magnitude());
}

std::string summary(const Case& input, const Start& start, const FollowReport& report,
                    const CurveTable& table, double seconds) {
  const CurveSummary& curve = table.summary();
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
  out.line("one end", end_text(input, report.backward, curve.first_parameter()));
  out.line("other end", end_text(input, report.forward, curve.last_parameter()));
  if (input.output.certificate)
    out.line("certificate",
             fmt::format("{} of {} points proven", table.proofs().proven, table.proofs().rows));
  out.gap();
  std::string_view label = "events";
  for (const EventRecord& event : report.events) {
    out.line(std::exchange(label, {}),
             fmt::format("{:<17} {} = {}", name(event.type), parameter, event_place(event)));
  }
  if (report.events.empty()) out.line(label, "none");
  if (!curve.stretches().empty()) out.gap();
  label = "stability";
  for (const CurveSummary::Stretch& each : curve.stretches()) {
    out.line(std::exchange(label, {}),
             fmt::format("{:<17} {} = {:.10g} ... {:.10g}", name(each.verdict), parameter,
                         each.from, each.to));
  }
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
  const CurveSummary& curve = table.summary();
  ComputationPlan plan = computation_plan(input, true);
  Metadata out;
  out.version = STATIONARY_VERSION;
  out.command_line = session.command_line;
  out.input = &input;
  out.counts = counts_of(start, report, evaluations, table);
  if (input.output.certificate) out.counts.emplace_back("proven", table.proofs().proven);
  out.plan = std::move(plan.computed);
  out.skipped = std::move(plan.skipped);
  out.events = report.events;
  out.outcome = {{"command", "continue"},
                 {"status", report.interrupted     ? "interrupted"
                            : report.out_of_points ? "stopped at max_points"
                                                   : "done"},
                 {"start", start.found.message},
                 {"connection", std::string(name(start.found.connection))},
                 {"first_end", end_text(input, report.backward, curve.first_parameter())},
                 {"last_end", end_text(input, report.forward, curve.last_parameter())}};
  if (report.vertical) out.outcome.emplace_back("vertical", "the sheet has this one nu");
  if (const std::string gap = gap_text(input, table.proofs()); !gap.empty())
    out.outcome.emplace_back("warning", gap);
  return out;
}

/// Refused before anything is computed.
void require_family(const Case& input) {
  if (!input.continuation) {
    throw fault_at(input.source, "continuation", "found no such key",
                   "a table with parameter, from and to", "add [continuation]");
  }
}

ExitCode end_code(const FollowReport& report) {
  if (report.interrupted) return ExitCode::interrupted;
  const bool stalled =
      report.backward.event == EventType::stalled || report.forward.event == EventType::stalled;
  return stalled ? ExitCode::failure : ExitCode::done;
}

/// The interrupted table named after -o, of this case.
ResumedTable resumed_table(const Case& input, const ContinueOptions& options,
                           const std::vector<Column>& columns,
                           const std::optional<std::string>& parameter) {
  const auto refuse = [&](const std::string& found) {
    throw InputError(Origin::of_option("--resume"), "", found,
                     "-o FILE, a table of this case that `continue` was interrupted in",
                     "its .meta.json beside it says which case it is of");
  };
  if (options.output.empty() || options.output == "-") refuse("found no file");
  const std::string metadata = metadata_path(options.output).string();
  std::ifstream file(metadata, std::ios::binary);
  if (!file) refuse("cannot read " + printable(metadata));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!is_of_case(text, input)) refuse(printable(metadata) + " is of another case");
  std::optional<CurveRecord> record = curve_record(text);
  if (!record) refuse(printable(metadata) + " does not say what rows and events the table has");
  ResumedTable out = read_resumed(options.output, columns, parameter, input.branch_name());
  if (out.rows.size() != record->rows) {
    refuse(fmt::format("{} has {} rows, {} by its metadata", printable(options.output),
                       out.rows.size(), record->rows));
  }
  out.events = std::move(record->events);
  return out;
}

/// How a table that is not gone on with there ended.
SheetEnd old_end(const TableRow& row) {
  const auto* const event = std::ranges::find(event_names, row.event);
  return {static_cast<EventType>(event - std::begin(event_names)),
          "as it was in the table resumed"};
}

/// On from the open ends of a table: new rows before it, its own, new rows after it.
FollowReport follow_on(const AnyFamily& family, const ResumedTable& old, FollowOptions options,
                       CurveTable& table) {
  FollowReport out;
  options.max_points -= static_cast<long>(old.rows.size());
  const auto add = [&](const FollowReport& part) {
    out.counts += part.counts;
    out.points += part.points;
    out.interrupted = out.interrupted || part.interrupted;
    out.out_of_points = out.out_of_points || part.out_of_points;
    options.max_points -= part.points;
    if (out.failure.empty()) out.failure = part.failure;
  };
  if (old.first) {
    HeldBack held;
    const FollowReport before = resume(family, *old.first, options, held);
    add(before);
    held.give(table);
    out.backward = before.forward;
    out.events.assign(before.events.rbegin(), before.events.rend());
  } else {
    out.backward = old_end(old.rows.front());
  }
  out.events.insert(out.events.end(), old.events.begin(), old.events.end());
  for (const TableRow& row : old.rows) table.again(row);
  out.points += static_cast<long>(old.rows.size());
  if (old.last && !out.interrupted) {
    const FollowReport after = resume(family, *old.last, options, table);
    add(after);
    out.forward = after.forward;
    out.events.insert(out.events.end(), after.events.begin(), after.events.end());
  } else if (old.last) {
    out.forward.reason = "interrupted";
  } else {
    out.forward = old_end(old.rows.back());
  }
  return out;
}

void prove_rows(const Case& input, const Start& start, CurveTable& rows) {
  if (const auto* tilted = std::get_if<TiltedMotion>(&start.at.motion)) {
    const TiltPlane plane = *tilted->plane;
    rows.prove([&input, plane](const Member& member, const Equilibrium& found, TableRow& row) {
      return prove_row(input.body, input.potential, TiltedRotation{plane, member.parameter}, found,
                       member.spectrum, row);
    });
    return;
  }
  if (input.two_polar()) {
    rows.prove([&input](const Member& member, const Equilibrium&, TableRow& row) {
      const FamilyParameters at = at_parameter(input, member.parameter);
      TwoPolarEquilibrium found;
      found.x = {member.q.xi, member.q.zeta, member.q.rho};
      found.circle = member.q.xi == member.q.zeta;
      found.rates = member.two_polar->rates;
      found.momenta = member.two_polar->momenta;
      return prove_row(at.body, make_potential(at.models), std::get<TwoPolarMotion>(at.motion),
                       found, member.spectrum, row);
    });
    return;
  }
  rows.prove([&input](double p) { return problem_of(at_parameter(input, p)); },
             family_parameter(input.continuation->parameter, input.models));
}

ExitCode continue_case(const ContinueOptions& options, const Session& session) {
  const Case input = options.read();
  require_family(input);
  const bool to_table = !options.output.empty();
  const bool with_spectrum = wants_spectrum(input, to_table);
  const bool trailing = input.continuation->parameter != "nu";
  const std::vector<Column> columns =
      chosen_columns(input,
                     equilibrium_columns({.two_polar = input.two_polar(),
                                          .events = true,
                                          .spectrum = with_spectrum,
                                          .certificate = input.output.certificate}),
                     "continue", trailing);
  const std::optional<std::string> parameter =
      trailing ? std::optional(input.continuation->parameter) : std::nullopt;
  std::optional<ResumedTable> old;
  if (options.resume) {
    old = resumed_table(input, options, columns, parameter);
    if (!old->first && !old->last) {
      if (!options.quiet) print(options.output + " is complete: both ends are reached\n");
      return ExitCode::done;
    }
  }
  std::optional<TableOutput> output;
  if (to_table) output.emplace(options.output, options.path);

  const auto begin = std::chrono::steady_clock::now();
  const Start start = old ? resumed_start(input, *old) : solved_start(input, options);
  if (start.found.status != SolveStatus::solved) {
    complain(fmt::format("at the start {} = {}: {}", input.continuation->parameter, start.p,
                         failure_text(outcome(start.found.status), start.found.message)));
    return exit_code(start.found.status);
  }
  const AnyFamily family = family_of(input, start, with_spectrum, to_table);
  ProgressBar progress;
  std::optional<TableWriter> table;
  if (output) {
    table.emplace(output->sink(), columns, parameter);
  }
  CurveTable rows(input.branch_name(), table ? &*table : nullptr);
  if (input.output.certificate) prove_rows(input, start, rows);
  const FollowOptions how = follow_options(input, options, progress);
  FollowReport report =
      old ? follow_on(family, *old, how, rows) : follow(family, start.found.q, start.p, how, rows);
  progress.clear();
  rows.add_enclosures(report.events);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!report.failure.empty()) {
    complain("numerical failure: " + report.failure);
    return ExitCode::failure;
  }
  if (output) {
    table->flush();
    Metadata metadata =
        describe(session, input, start, report,
                 std::visit([](const auto& f) { return f->evaluations(); }, family), rows);
    metadata.rows = table->rows();
    metadata.seconds = seconds;
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
  if (!output && !options.quiet) print(summary(input, start, report, rows, seconds));
  return code;
}

}  // namespace

void add_continue(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "continue",
                  "Follow the case's family in a parameter: bifurcation table, stability, events");
  const auto options = std::make_shared<ContinueOptions>();
  options->add_to(command);
  command.add_flag("--resume", options->resume,
                   "Go on with the interrupted table at -o FILE (same case, same columns)");
  command.callback([options, &session] {
    session.action = [options, &session] { return continue_case(*options, session); };
  });
}

}  // namespace stationary::cli
