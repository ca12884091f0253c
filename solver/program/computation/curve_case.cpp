#include "solver/program/computation/curve_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "solver/program/computation/event_curves.hpp"
#include "solver/program/computation/row_start.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/session/run_metadata.hpp"

namespace stationary::cli {
namespace {

/// The common columns, from nu1 on, and whether the spectrum is among them.
struct Wanted {
  std::vector<Column> columns;
  bool spectrum;
};

Wanted wanted_columns(const Case& input, bool to_table) {
  const bool spectrum = wants_spectrum(input, to_table);
  Wanted out{select_columns(equilibrium_columns({.events = true,
                                                 .spectrum = spectrum,
                                                 .pressure = input.potential.holds_volume()}),
                            input.output.columns),
             spectrum};
  std::erase_if(out.columns, [](Column c) {
    return c == Column::branch || c == Column::sheet || c == Column::point || c == Column::event ||
           c == Column::segment || c == Column::criticality || c == Column::side;
  });
  return out;
}

std::vector<CellColumn> header(const Case& input, const Wanted& wanted) {
  std::vector<CellColumn> out{{"event", CellKind::text},
                              {"curve", CellKind::count},
                              {"point", CellKind::count},
                              {"special", CellKind::text},
                              {"branch", CellKind::text}};
  for (const std::string& parameter : input.curve->parameters)
    out.push_back({parameter, CellKind::number});
  for (const Column c : wanted.columns) out.push_back({std::string(name(c)), cell_kind(c)});
  if (wanted.spectrum) {
    out.push_back({"class_before", CellKind::text});
    out.push_back({"class_after", CellKind::text});
  }
  if (input.output.certificate) out.push_back({"certified", CellKind::text});
  return out;
}

/// Rows on their way into the table, and what is counted of them.
class Rows {
 public:
  Rows(const Case& input, Wanted wanted, CellTable* table)
      : input_(input),
        wanted_(std::move(wanted)),
        set_(wanted_.columns),
        cells_(wanted_.columns),
        table_(table) {}

  void write(int curve, long point, const EventCurvePoint& at) {
    ++rows_;
    TableRow row = curve_row(input_, at, set_);
    if (input_.output.certificate) prove(at, row);
    if (table_ == nullptr) return;
    std::string line =
        fmt::format("{},{},{},{},{},{},{}", row.event, curve, point, name(at.special), row.branch,
                    row.parameter, row.second_parameter);
    if (!wanted_.columns.empty()) line += ',' + cells_.of(row);
    if (wanted_.spectrum) line += fmt::format(",{},{}", word(at.before), word(at.after));
    if (input_.output.certificate) line += fmt::format(",{}", row.certified);
    table_->write(line + '\n');
  }
  long rows() const { return rows_; }
  long proven() const { return proven_; }
  /// What is not proven though it was asked for; empty if all is.
  std::string gap_text() const {
    if (!input_.output.certificate || proven_ == rows_) return {};
    return fmt::format("{} of {} events are not proven, the first of them at {}", rows_ - proven_,
                       rows_, first_gap_);
  }

 private:
  void prove(const EventCurvePoint& at, TableRow& row) {
    const EventEnclosure proof = prove_curve_row(input_, at, row);
    proven_ += proof.proven;
    if (proof.proven || !first_gap_.empty()) return;
    const auto& keys = input_.curve->parameters;
    first_gap_ = fmt::format("{} = {:.12g}, {} = {:.12g}: {}", keys[0], row.parameter, keys[1],
                             row.second_parameter, proof.reason);
  }
  static std::string_view word(const std::optional<StabilityClass>& verdict) {
    return verdict ? name(*verdict) : std::string_view();
  }

  const Case& input_;
  Wanted wanted_;
  ColumnSet set_;
  RowCells cells_;
  CellTable* table_;
  long rows_ = 0;
  long proven_ = 0;
  std::string first_gap_;  ///< where the first one is that is not, and why
};

EventCurveRecord record_of(const Case& input, const EventCurve& curve, int number) {
  EventCurveRecord out;
  out.curve = number;
  out.points = static_cast<long>(curve.points.size());
  out.first = curve.first;
  out.last = curve.last;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const EventCurvePoint& at = curve.points[k];
    if (at.special == SpecialPoint::none) continue;
    out.special.push_back(
        {name(at.special), name(at.other), static_cast<long>(k), curve_place(input, at)});
  }
  return out;
}

std::string end_text(const Case& input, const EventCurveEnd& end, const EventCurvePoint& at) {
  const auto [first, second] = curve_place(input, at);
  return fmt::format("{} = {:.12g}, {} = {:.12g}: {}", input.curve->parameters[0], first,
                     input.curve->parameters[1], second, end.reason);
}

std::string summary(const Case& input, const EventCurves& found, const Rows& rows, double seconds) {
  constexpr std::size_t label_width = 14;
  const auto& keys = input.curve->parameters;
  Report out(label_width);
  if (!input.title.empty()) out.line("case", printable(input.title));
  out.line("event", fmt::format("{} in branch ({}), in {} and {}", name(input.curve->event),
                                input.branch_name(), keys[0], keys[1]));
  out.line("curves",
           fmt::format("{}, {} points, in {:.2g} s", found.curves.size(), rows.rows(), seconds));
  if (input.output.certificate)
    out.line("certificate", fmt::format("{} of {} events proven", rows.proven(), rows.rows()));
  if (const auto caveat = proof_caveat(input)) add_plan(out, {*caveat});
  for (std::size_t k = 0; k < found.curves.size(); ++k) {
    const EventCurve& curve = found.curves[k];
    out.gap();
    out.line(fmt::format("{}", k + 1),
             "from " + end_text(input, curve.first, curve.points.front()));
    out.line({}, "to " + end_text(input, curve.last, curve.points.back()));
    for (const EventCurvePoint& at : curve.points) {
      if (at.special == SpecialPoint::none) continue;
      const auto [first, second] = curve_place(input, at);
      out.line({},
               fmt::format("{:<20} {} = {:.15g}, {} = {:.15g}{}", name(at.special), keys[0], first,
                           keys[1], second,
                           at.other == EventType::none ? std::string()
                                                       : fmt::format(", with {}", name(at.other))));
    }
  }
  return out.text();
}

}  // namespace

Outcome curve_case(const Case& given, const std::string& row, TableTarget* target, const Run& run) {
  require_curve(given);
  std::optional<EventRow> at_row;
  if (!row.empty()) at_row = event_of_row(given, row, given.curve->event);
  const Case& input = at_row ? at_row->input : given;
  require_second_in_range(input);
  const Wanted wanted = wanted_columns(input, target != nullptr);
  if (target != nullptr) target->prepare();

  const auto begin = std::chrono::steady_clock::now();
  const EventCurves found = [&] {
    const auto waiting = run.waiting("following the curves");
    return at_row ? event_curve_of_row(input, at_row->q, wanted.spectrum, run)
                  : event_curves(input, wanted.spectrum, run);
  }();
  if (found.status != SolveStatus::solved) {
    run.complain(failure_text(outcome(found.status, found.only_in_box), found.message));
    return {exit_code(found.status), {}};
  }
  for (const std::string& each : found.failures) run.complain("no curve from " + each);
  const bool none = found.curves.empty();
  // A failure is no table.
  if (none && !found.failures.empty() && !found.interrupted) return {ExitCode::failure, {}};
  CellTable* const table = target != nullptr ? &target->open(header(input, wanted)) : nullptr;
  Rows rows(input, wanted, table);
  Metadata metadata = metadata_of(run, &input);
  ComputationPlan plan = computation_plan(input, target != nullptr, PlanOf::curve);
  metadata.plan = std::move(plan.computed);
  metadata.skipped = std::move(plan.skipped);
  for (const EventCurve& curve : found.curves) {
    const int number = static_cast<int>(metadata.event_curves.size()) + 1;
    metadata.event_curves.push_back(record_of(input, curve, number));
    long point = 0;
    for (const EventCurvePoint& at : curve.points) rows.write(number, point++, at);
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (target != nullptr) {
    metadata.seconds = seconds;
    metadata.counts = {{"curves", static_cast<long>(found.curves.size())},
                       {"without_curve", static_cast<long>(found.failures.size())}};
    if (input.output.certificate) metadata.counts.emplace_back("proven", rows.proven());
    metadata.outcome = {{"command", "curve"},
                        {"status", found.interrupted ? "interrupted" : "done"}};
    if (const std::string gap = rows.gap_text(); !gap.empty())
      metadata.outcome.emplace_back("warning", gap);
    target->commit(std::move(metadata));
  }
  Outcome out;
  if (const std::string gap = rows.gap_text(); !gap.empty()) run.complain(gap);
  if (run.summary) out.summary = summary(input, found, rows, seconds);
  if (found.interrupted) {
    run.complain("interrupted: the curves are not complete");
    out.code = ExitCode::interrupted;
  } else if (none) {
    run.complain(fmt::format("the family has no {} for {} from {} to {}", name(input.curve->event),
                             input.curve->parameters[0], input.curve->from[0], input.curve->to[0]));
    out.code = ExitCode::no_equilibrium;
  }
  return out;
}

}  // namespace stationary::cli
