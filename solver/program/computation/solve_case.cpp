#include "solver/program/computation/solve_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/answer.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"

namespace stationary::cli {
namespace {

std::string cost_text(const Answer& found) {
  std::string out = fmt::format("{:.1e} s", found.seconds);
  bool first = true;
  for (const auto& [what, count] : found.counts) {
    if (count == 0) continue;
    std::string words(what);
    for (char& c : words)
      if (c == '_') c = ' ';
    if (count == 1 && words == "spectra")
      words = "spectrum";
    else if (count == 1 && words.ends_with('s'))
      words.resize(words.size() - (words.ends_with("xes") ? 2 : 1));
    out += fmt::format("{}{} {}", std::exchange(first, false) ? ": " : ", ", count, words);
  }
  return out;
}

void add_state(Report& out, const Case& input, const TableRow& row) {
  out.row("stretch S", {{"xi    ", row[Column::xi]}, {"zeta  ", row[Column::zeta]}});
  out.row("", {{"rho   ", row[Column::rho]}, {"alpha ", row[Column::alpha]}});
  out.row("principal", {{"lambda", row[Column::lambda]}, {"mu    ", row[Column::mu]}});
  const double angle = row[Column::angle];
  if (angle == angle) {
    out.row("", {{"angle ", angle}});
  } else {
    out.line("", "no angle: lambda = mu, a circle");
  }
  const int along =
      (row[Column::nu1] != 0.0) + (row[Column::nu2] != 0.0) + (row[Column::nu3] != 0.0);
  if (along > 1) {
    out.row("axis", {{"nu1   ", row[Column::nu1]}, {"nu2   ", row[Column::nu2]}});
    out.row("", {{"nu3   ", row[Column::nu3]}});
  }
  if (has_rates(input.motion)) {
    out.row("rates", {{"omega ", row[Column::omega]}, {"theta_dot", row[Column::theta_dot]}});
    out.row("momenta", {{"s3    ", row[Column::s3]}, {"p_theta  ", row[Column::p_theta]}});
  } else {
    out.row("momenta", {{"pi1   ", row[Column::pi1]}, {"pi2   ", row[Column::pi2]}});
    out.row("", {{"pi3   ", row[Column::pi3]}});
  }
  if (const double energy = row[Column::energy]; std::isfinite(energy)) {
    out.row("energy", {{"T + V ", energy}});
  } else {
    out.line("energy", "no finite number in double precision");
  }
  if (input.potential.holds_volume()) out.row("pressure", {{"P     ", row[Column::pressure]}});
}

void add_solution(Report& out, const Case& input, const Solution& solution) {
  const TableRow& row = solution.row;
  add_state(out, input, row);
  out.gap();
  out.line("residual", fmt::format("{:.1e} of the largest term", row[Column::residual]));
  out.line("compatible to", fmt::format("{:.1e} of the largest term", row[Column::compatibility]));
  const bool proven = solution.listed == Listed::proven || solution.proven;
  out.line("error bound", fmt::format("{:.1e} relative, of S ({})", row[Column::error_bound],
                                      proven ? "proven" : "estimated"));
  if (!solution.proof.empty()) out.line("certificate", solution.proof);
  if (solution.spectrum) {
    out.gap();
    add_spectrum(out, *solution.spectrum);
  }
  out.gap();
}

std::string summary(const Case& input, const Answer& found) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  out.line("motion", motion_text(input.motion));
  out.line("found", found.message.empty() ? "solved" : found.message);
  if (!input.solve.all) out.line("connection", name(found.connection));
  out.gap();
  for (const Solution& each : found.solutions) {
    if (input.solve.all || found.solutions.size() > 1)
      out.line(fmt::format("solution {}", each.row[Column::sheet]),
               fmt::format("of {}{}", found.solutions.size(),
                           each.listed == Listed::unproven ? ", found but not proven" : ""));
    add_solution(out, input, each);
  }
  out.line("cost", cost_text(found));
  out.gap();
  const ComputationPlan plan = computation_plan(input, false, PlanOf::solve);
  add_plan(out, plan.computed);
  add_plan(out, plan.skipped);
  return out.text();
}

Metadata describe(const Run& run, const Case& input, const Answer& found) {
  ComputationPlan plan = computation_plan(input, true, PlanOf::solve);
  Metadata out = metadata_of(run, &input);
  out.seconds = found.seconds;
  out.counts = found.counts;
  out.plan = std::move(plan.computed);
  out.skipped = std::move(plan.skipped);
  out.outcome = {
      {"command", "solve"},
      {"status", std::string(found.outcome())},
      {"method", std::string(input.solve.all ? "exhaustive search" : name(input.solve.method))},
      {"connection", std::string(name(found.connection))},
      {"message", found.message}};
  if (!found.warning.empty()) out.outcome.emplace_back("warning", found.warning);
  for (const Solution& each : found.solutions)
    if (each.listed == Listed::unproven)
      out.unproven_sheets.push_back(static_cast<int>(each.row[Column::sheet]));
  if (found.solutions.size() == 1 && found.solutions[0].spectrum)
    out.outcome.emplace_back("class", name(found.solutions[0].spectrum->verdict));
  return out;
}

}  // namespace

Outcome solve_case(const Case& input, TableTarget* target, const Run& run) {
  const bool with_spectrum = wants_spectrum(input, target != nullptr);
  const std::vector<Column> columns =
      chosen_columns(input,
                     equilibrium_columns({.two_polar = has_rates(input.motion),
                                          .spectrum = with_spectrum,
                                          .certificate = input.output.certificate,
                                          .pressure = input.potential.holds_volume()}),
                     "solve", false);
  if (target != nullptr) target->prepare();
  if (input.solve.all && input.solve.start)
    run.complain("solve.start is not used: " + std::string(unused_start));

  const Answer found = [&] {
    const auto waiting = run.waiting("solving");
    return answer_of(input, run, with_spectrum,
                     run.summary ? ColumnSet::all() : ColumnSet(columns));
  }();
  Outcome out{exit_code(found.status), {}};
  if (!found.solved()) {
    run.complain(failure_text(found.outcome(), found.message));
  } else if (!found.warning.empty()) {
    run.complain(found.warning);
  }
  // That there is no equilibrium is an answer, and its table has no rows; a failure is none.
  if (target != nullptr && (found.solved() || out.code == ExitCode::no_equilibrium)) {
    RowSink& table = target->open(columns, {}, found.solutions.size());
    for (const Solution& each : found.solutions) table.write(each.row);
    target->commit(describe(run, input, found));
  }
  if (found.solved() && run.summary) out.summary = summary(input, found);
  return out;
}

}  // namespace stationary::cli
