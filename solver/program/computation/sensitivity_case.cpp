#include "solver/program/computation/sensitivity_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/rows/sensitivity.hpp"
#include "solver/program/session/answer.hpp"
#include "solver/program/session/case_family.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"
#include "solver/program/text/written_number.hpp"

namespace stationary::cli {
namespace {

/// The slopes of one motion or event.
struct Moved {
  std::string of;  ///< "motion" or the event's name
  int sheet;
  double at;                   ///< the parameter of an event
  std::vector<double> values;  ///< of what has slopes
  std::vector<NumberSlopes> slopes;
  std::vector<double> combined;  ///< empty: no number has an uncertainty
};

/// What is computed, and how it came out.
struct Answered {
  ExitCode code = ExitCode::done;
  std::string status = "done";
  std::vector<Moved> moved;
  std::vector<std::string> without;  ///< events of which nothing is known
  std::vector<std::pair<std::string_view, long>> counts;
  double seconds = 0.0;
};

/// Which numbers, and what has slopes.
struct Asked {
  const Case& input;
  std::vector<std::string> numbers;
  std::vector<double> uncertainty;  ///< of each; 0: none is told
  std::vector<Column> columns;

  bool has_uncertainty() const {
    return std::ranges::any_of(uncertainty, [](double u) { return u > 0.0; });
  }
  /// "of", then each column's slope.
  std::vector<CellColumn> header(bool events) const {
    std::vector<CellColumn> out{{"of", CellKind::text},      {"sheet", CellKind::count},
                                {"at", CellKind::number},    {"number", CellKind::text},
                                {"value", CellKind::number}, {"uncertainty", CellKind::number}};
    if (events) out.push_back({"d_event", CellKind::number});
    for (const Column c : columns) out.push_back({"d_" + std::string(name(c)), CellKind::number});
    out.push_back({"error", CellKind::number});
    return out;
  }
};

Asked asked_of(const Case& input, bool events) {
  Asked out{input, {}, {}, {}};
  const ParameterParts followed =
      events ? parts_of(input.continuation->parameter) : ParameterParts();
  for (const std::string& number : case_parameters(input.motion, input.models)) {
    if (number == followed.first) continue;  // a ratio moves with its second
    const auto known =
        std::ranges::find(input.output.uncertainty, number, &std::pair<std::string, double>::first);
    out.numbers.push_back(number);
    out.uncertainty.push_back(known == input.output.uncertainty.end() ? 0.0 : known->second);
  }
  out.columns = chosen_columns(
      input,
      sloped_columns(equilibrium_columns({.two_polar = has_rates(input.motion),
                                          .spectrum = input.output.spectrum && !events,
                                          .pressure = input.potential.holds_volume()})),
      "sensitivity", events);
  return out;
}

void combine(const Asked& asked, Moved& moved) {
  if (asked.has_uncertainty())
    moved.combined = combined_uncertainty(moved.slopes, asked.uncertainty);
}

/// Of each motion that `solve` finds.
Answered of_motions(const Asked& asked, const Run& run) {
  const Case& input = asked.input;
  const Answer found = answer_of(input, run, input.output.spectrum, ColumnSet::all());
  Answered out{exit_code(found.status), std::string(found.outcome()), {}, {}, found.counts, 0.0};
  if (run.stopped()) return out;
  if (!found.solved()) {
    run.complain(failure_text(found.outcome(), found.message));
    return out;
  }
  for (const Solution& each : found.solutions) {
    Moved moved{"motion",
                static_cast<int>(each.row[Column::sheet]),
                std::numeric_limits<double>::quiet_NaN(),
                {},
                {},
                {}};
    for (const Column c : asked.columns) moved.values.push_back(each.row[c]);
    moved.slopes = motion_slopes({input.body, input.models, each.motion}, each.row, asked.numbers,
                                 asked.columns, run.stop);
    combine(asked, moved);
    out.moved.push_back(std::move(moved));
  }
  return out;
}

/// Keeps the events of a followed sheet.
class EventMembers final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override {
    if (event != EventType::none && event != EventType::limit) events.emplace_back(member, event);
  }
  std::vector<std::pair<Member, EventType>> events;
};

Answered of_events(const Asked& asked, const Run& run) {
  const Case& input = asked.input;
  if (!input.continuation->start_row.empty())
    throw fault_at(input.source, "continuation.start_row", "found a row to start from",
                   "none: sensitivity follows the case from its own start");
  Answered out;
  const Start start = solved_start(input, run);
  if (run.stopped()) return out;
  if (start.found.status != SolveStatus::solved) {
    out.code = exit_code(start.found.status);
    out.status = start.outcome();
    run.complain(failure_text(out.status, start.found.message));
    return out;
  }
  const std::string& parameter = input.continuation->parameter;
  const double unit = parameter_unit(start.at, parameter);
  EventMembers sink;
  const FollowReport report = follow(family_of(input, start, true, true), start.found.q,
                                     start.p * unit, follow_options(input, unit, run), sink);
  if (run.stopped()) return out;
  if (!report.failure.empty()) {
    run.complain("numerical failure: " + report.failure);
    out.code = ExitCode::failure;
    out.status = "numerical failure";
    return out;
  }
  out.counts.emplace_back("continuation_steps", report.counts.steps);
  if (report.out_of_points)
    run.complain("stopped at continuation.max_points: events beyond are not among these");
  for (const std::string& reason : given_up(report)) {
    run.complain("numerical failure: " + reason + "; events beyond are not among these");
    out.code = ExitCode::failure;
    out.status = "stalled";
  }
  for (const auto& [member, event] : sink.events) {
    Moved moved{std::string(name(event)), 1, member.parameter / unit, {}, {}, {}};
    TableRow row;
    fill_row(input.branch_name(), member, ColumnSet(asked.columns), row);
    moved.values.push_back(moved.at);
    for (const Column c : asked.columns) moved.values.push_back(row[c]);
    moved.slopes =
        event_slopes(start.at, parameter, member, event, asked.numbers, asked.columns, run.stop);
    const bool known = std::ranges::any_of(moved.slopes, [](const NumberSlopes& by) {
      return by.of.slope.front() == by.of.slope.front();
    });
    if (known) {
      combine(asked, moved);
      out.moved.push_back(std::move(moved));
    } else {
      out.without.push_back(fmt::format("{} at {} = {:.15g}", moved.of, parameter, moved.at));
    }
  }
  return out;
}

std::string cell(double x) { return x == x ? number_text(x) : std::string(); }

void write(const Asked& asked, const Answered& found, CellTable& table) {
  for (const Moved& each : found.moved) {
    const std::string begin = fmt::format("{},{},{},", each.of, each.sheet, cell(each.at));
    std::string lines;
    for (std::size_t k = 0; k < each.slopes.size(); ++k) {
      const NumberSlopes& by = each.slopes[k];
      const double u = asked.uncertainty[k];
      lines += begin + fmt::format("{},{},{}", csv_cell(by.number), cell(by.value),
                                   u > 0.0 ? cell(u) : std::string());
      double error = std::numeric_limits<double>::quiet_NaN();
      for (std::size_t i = 0; i < by.of.slope.size(); ++i) {
        lines += ',' + cell(by.of.slope[i]);
        error = std::fmax(error, by.of.error[i]);
      }
      lines += ',' + cell(error) + '\n';
    }
    if (!each.combined.empty()) {
      lines += begin + "combined,,";
      for (const double u : each.combined) lines += ',' + cell(u);
      lines += ",\n";
    }
    table.write(lines);
  }
}

std::string summary(const Asked& asked, bool events, const Answered& found) {
  std::vector<std::string> names;
  if (events) names.push_back(asked.input.continuation->parameter);
  for (const Column c : asked.columns) names.emplace_back(name(c));
  std::size_t width = 14;
  for (const std::string& number : asked.numbers) width = std::max(width, number.size() + 2);
  Report out(width);
  if (!asked.input.title.empty()) out.line("case", printable(asked.input.title));
  for (const Moved& each : found.moved) {
    out.gap();
    out.line(each.of, each.of == "motion" ? fmt::format("sheet {}", each.sheet)
                                          : fmt::format("{} = {:.15g}", names.front(), each.at));
    for (std::size_t i = 0; i < each.combined.size(); ++i) {
      if (!(each.combined[i] == each.combined[i]) || !(each.values[i] == each.values[i])) continue;
      if (each.combined[i] == 0.0) continue;
      out.line(names[i], fmt::format("{:.10g} +- {:.2g}", each.values[i], each.combined[i]));
    }
    if (!each.combined.empty()) continue;
    constexpr std::size_t shown = 3;
    const auto told = [&](const std::string& quantity) {
      return events ? quantity == names.front()
                    : quantity == "xi" || quantity == "zeta" || quantity == "rho";
    };
    for (const NumberSlopes& by : each.slopes) {
      std::string line;
      std::size_t count = 0;
      for (std::size_t i = 0; i < names.size() && count < shown; ++i) {
        if (!told(names[i])) continue;
        const double slope = by.of.slope[i];
        line += fmt::format("{}d {} = {:<14}", count++ == 0 ? "" : "  ", names[i],
                            slope == slope ? fmt::format("{:.8g}", slope) : "not known");
      }
      out.line(by.number, line);
    }
  }
  if (!found.without.empty()) out.gap();
  for (const std::string& each : found.without)
    out.line("not known", each + ": it has no equations of its own");
  if (found.moved.empty() && found.without.empty()) out.line("events", "none");
  return out.text();
}

}  // namespace

Outcome sensitivity_case(const Case& input, bool events, TableTarget* target, const Run& run) {
  if (events) require_range(input);
  if (!input.coordinates.are_own())
    throw fault_at(input.source, "body.J", "found a fluid whose J are not equal",
                   "equal J, or a body that resists shear",
                   "its S is told in other coordinates than it is computed in");
  const Asked asked = asked_of(input, events);
  if (target != nullptr) target->prepare();
  const auto begin = std::chrono::steady_clock::now();
  Answered found = events ? of_events(asked, run) : of_motions(asked, run);
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (run.stopped()) {
    run.complain("interrupted");
    return {ExitCode::interrupted, {}};
  }
  if (found.code != ExitCode::done) return {found.code, {}};
  if (target != nullptr) {
    write(asked, found, target->open(asked.header(events)));
    Case unproven = input;
    unproven.output.certificate = false;
    ComputationPlan plan =
        computation_plan(unproven, true, events ? PlanOf::follow : PlanOf::solve);
    Metadata out = metadata_of(run, &input);
    out.plan = std::move(plan.computed);
    out.skipped = std::move(plan.skipped);
    if (input.output.certificate)
      out.skipped.push_back({"output.certificate", "not used", "slopes are estimated, not proven"});
    out.seconds = found.seconds;
    out.counts = found.counts;
    out.outcome = {{"command", "sensitivity"}, {"status", found.status}};
    target->commit(std::move(out));
  }
  return {ExitCode::done, run.summary ? summary(asked, events, found) : std::string()};
}

}  // namespace stationary::cli
