// stationary solve CASE: the stationary ellipsoid of a case at its nu.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "lib/balance.hpp"
#include "solver/case_keys.hpp"
#include "solver/cli/command.hpp"
#include "solver/cli/interrupt.hpp"
#include "solver/cli/report.hpp"
#include "solver/cli/table_output.hpp"
#include "solver/equilibrium_row.hpp"

namespace stationary::cli {
namespace {

ExitCode exit_code(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return ExitCode::done;
    case SolveStatus::none_exists:
    case SolveStatus::not_found:
    case SolveStatus::not_isolated:
      return ExitCode::no_equilibrium;
    case SolveStatus::interrupted:
      return ExitCode::interrupted;
    case SolveStatus::failed:
    case SolveStatus::not_run:
      break;
  }
  return ExitCode::failure;
}

std::string_view outcome(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return "solved";
    case SolveStatus::none_exists:
      return "no stationary ellipsoid exists";
    case SolveStatus::not_found:
      return "no stationary ellipsoid was found (which does not say that none exists)";
    case SolveStatus::not_isolated:
      return "no isolated stationary ellipsoid: the solutions here form a continuum";
    case SolveStatus::interrupted:
      return "interrupted, nothing written";
    case SolveStatus::failed:
      return "numerical failure";
    case SolveStatus::not_run:
      break;
  }
  return "nothing was computed";
}

/// The columns of the table to be, refused before the computation if none is left.
std::vector<Column> columns_of(const Case& input) {
  std::vector<Column> out = select_columns(equilibrium_columns, input.output.columns);
  if (!out.empty()) return out;
  std::vector<std::string_view> names;
  for (const Column c : equilibrium_columns) names.push_back(name(c));
  throw fault_at(input.source, "output.columns", "found no column that solve computes",
                 "names of " + listed(names));
}

std::string summary(const Case& input, const Problem& problem, const Equilibrium& found,
                    const TableRow& row, double seconds) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  out.line("motion", motion_text(problem.branch(), input.motion.nu));
  out.line("found", found.message.empty() ? "solved" : found.message);
  out.line("connection", name(found.connection));
  out.gap();
  out.row("stretch S", {{"xi    ", row[Column::xi]}, {"zeta  ", row[Column::zeta]}});
  out.row("", {{"rho   ", row[Column::rho]}, {"alpha ", row[Column::alpha]}});
  out.row("principal", {{"lambda", row[Column::lambda]}, {"mu    ", row[Column::mu]}});
  const double angle = row[Column::angle];
  if (angle == angle) {
    out.row("", {{"angle ", angle}});
  } else {
    out.line("", "no angle: lambda = mu, a circle");
  }
  out.row("momenta", {{"pi1   ", row[Column::pi1]}, {"pi2   ", row[Column::pi2]}});
  out.row("", {{"pi3   ", row[Column::pi3]}});
  out.row("energy", {{"T + V ", row[Column::energy]}});
  out.gap();
  out.line("residual", fmt::format("{:.1e} of the largest term", found.residual));
  out.line("compatible to", fmt::format("{:.1e} of the largest term", found.compatibility));
  out.line("error bound", fmt::format("{:.1e} relative, of S (estimated)", found.error_bound));
  std::string cost;
  for (const auto& [what, count] : named_counts(found.counts)) {
    if (count == 0) continue;
    std::string words(what);
    for (char& c : words)
      if (c == '_') c = ' ';
    cost += fmt::format("{}{} {}", cost.empty() ? "" : ", ", count, words);
  }
  out.line("cost", fmt::format("{:.1e} s{}{}", seconds, cost.empty() ? "" : ": ", cost));
  out.gap();
  add_plan(out, problem.plan());
  add_plan(out, not_computed(input));
  return out.text();
}

Metadata describe(const Session& session, const Case& input, const Problem& problem,
                  const Equilibrium& found, double seconds) {
  Metadata out;
  out.version = STATIONARY_VERSION;
  out.command_line = session.command_line;
  out.input = &input;
  out.seconds = seconds;
  out.counts = named_counts(found.counts);
  out.plan = problem.plan();
  out.skipped = not_computed(input);
  out.outcome = {{"command", "solve"},
                 {"status", std::string(outcome(found.status))},
                 {"method", std::string(name(input.solve.method))},
                 {"connection", std::string(name(found.connection))},
                 {"message", found.message}};
  return out;
}

ExitCode solve_case(const ComputeOptions& options, const Session& session) {
  const Case input = options.read();
  const std::vector<Column> columns = columns_of(input);
  std::optional<TableOutput> output;
  if (!options.output.empty()) output.emplace(options.output, options.path);

  const Problem problem = input.problem();
  const auto begin = std::chrono::steady_clock::now();
  const Equilibrium found = solve(problem, input.motion.nu,
                                  {.method = input.solve.method,
                                   .start = input.solve.start,
                                   .threads = options.threads,
                                   .stop = &stop_on_signals()});
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  const ExitCode code = exit_code(found.status);
  const bool solved = code == ExitCode::done;
  TableRow row;
  if (solved) {
    fill_row(problem, found, row);
    row[Column::sheet] = 1;
    row[Column::point] = 0;
  } else {
    complain(fmt::format("{}{}{}", outcome(found.status), found.message.empty() ? "" : ": ",
                         found.message));
  }
  // That there is no equilibrium is an answer, and its table has no rows; a failure is none.
  if (output && (solved || code == ExitCode::no_equilibrium)) {
    TableWriter table(output->sink(), columns);
    if (solved) table.write(row);
    table.flush();
    Metadata metadata = describe(session, input, problem, found, seconds);
    metadata.rows = table.rows();
    output->commit(metadata);
  }
  if (solved && !output && !options.quiet) print(summary(input, problem, found, row, seconds));
  return code;
}

}  // namespace

void add_solve(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "solve", "Find the stationary ellipsoid of a case at its nu");
  const auto options = std::make_shared<ComputeOptions>();
  options->add_to(command);
  command.callback([options, &session] {
    session.action = [options, &session] { return solve_case(*options, session); };
  });
}

}  // namespace stationary::cli
