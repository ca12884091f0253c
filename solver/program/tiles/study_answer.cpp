#include "solver/program/tiles/study_answer.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <new>
#include <variant>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/atlas_rows.hpp"
#include "solver/program/rows/sheet_summary.hpp"
#include "solver/program/session/answer.hpp"
#include "solver/program/session/case_family.hpp"
#include "solver/program/session/exit_status.hpp"
#include "solver/program/text/named.hpp"

namespace stationary::cli {
namespace {

std::vector<std::string> lines(const std::vector<Column>& columns,
                               const std::vector<Solution>& solutions) {
  std::vector<std::string> out;
  RowCells cells(columns);
  for (const Solution& each : solutions) out.push_back(cells.of(each.row));
  return out;
}

StudyStatus status_of(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return StudyStatus::solved;
    case SolveStatus::none_exists:
      return StudyStatus::none;
    case SolveStatus::not_found:
    case SolveStatus::not_isolated:
      return StudyStatus::not_found;
    default:
      return StudyStatus::failed;
  }
}

bool wants_spectrum(const StudyPlan& plan, const Case& input) {
  return input.output.spectrum &&
         (plan.task != StudyTask::solve || std::ranges::any_of(plan.columns, needs_spectrum));
}

std::optional<StudyAnswer> solved(const StudyPlan& plan, const Case& input, const Run& run) {
  Answer found = answer_of(input, run, wants_spectrum(plan, input), ColumnSet(plan.columns));
  if (found.status == SolveStatus::interrupted) return std::nullopt;
  const std::string& said = found.warning.empty() ? found.message : found.warning;
  return StudyAnswer{status_of(found.status), said, lines(plan.columns, found.solutions)};
}

std::optional<StudyAnswer> followed(const StudyPlan& plan, const Case& input, const Run& run) {
  require_range(input);
  if (!input.continuation->start_row.empty())
    throw fault_at(input.source, "continuation.start_row", "found a row to start from",
                   "none: a study follows each row's case from its own start");
  const Start start = solved_start(input, run);
  if (start.found.status == SolveStatus::interrupted) return std::nullopt;
  if (start.found.status != SolveStatus::solved)
    return StudyAnswer{status_of(start.found.status), start.found.message, {}};
  const AnyFamily family = family_of(input, start, wants_spectrum(plan, input), false);
  CurveTable table(input.branch_name(), nullptr);
  const double unit = parameter_unit(start.at, input.continuation->parameter);
  table.in_units_of(unit);
  FollowReport report =
      follow(family, start.found.q, start.p * unit, follow_options(input, unit, run), table);
  if (report.interrupted) return std::nullopt;
  if (!report.failure.empty()) return StudyAnswer{StudyStatus::failed, report.failure, {}};
  table.convert(report);
  table.complete(report.events);
  const SheetRecord sheet = table.record(report);
  StudyAnswer out{StudyStatus::solved, start.found.message, {sheet_summary({&sheet, 1}, {})}};
  if (report.out_of_points) out.message = "stopped at continuation.max_points";
  for (const std::string& reason : given_up(report))
    out = {StudyStatus::failed, reason, std::move(out.cells)};
  return out;
}

std::optional<StudyAnswer> charted(const StudyPlan& plan, const Case& input, const Run& run) {
  AtlasOptions how = atlas_options(input, plan.checkpoints, wants_spectrum(plan, input));
  how.stop = how.search.stop = run.stop;
  return atlas_answer({.body = input.body,
                       .potential = make_potential(input.models, input.body),
                       .coordinates = input.coordinates},
                      how, nullptr);
}

std::optional<StudyAnswer> answer(const StudyPlan& plan, const CaseTree& base,
                                  std::span<const Override> overrides, const Run& run) {
  Case input = make_case(base, overrides);
  input.output.certificate = input.output.certificate || plan.certify;
  switch (plan.task) {
    case StudyTask::solve:
      return solved(plan, input, run);
    case StudyTask::follow:
      return followed(plan, input, run);
    case StudyTask::atlas:
      break;
  }
  return charted(plan, input, run);
}

}  // namespace

std::optional<StudyTask> study_task(std::string_view name) {
  return named<StudyTask>(study_task_names, name);
}

std::vector<CellColumn> StudyPlan::cell_columns() const {
  if (task != StudyTask::solve) return sheet_summary_columns();
  std::vector<CellColumn> out;
  for (const Column c : columns) out.push_back({std::string(name(c)), cell_kind(c)});
  return out;
}

std::optional<StudyAnswer> atlas_answer(const AtlasBody& of, const AtlasOptions& how,
                                        RowSink* rows) {
  Atlas found = atlas(of.body, of.potential, how);
  if (found.interrupted) return std::nullopt;
  std::vector<SheetRecord> sheets;
  (void)write_sheets(of, found, rows, sheets);
  const double complete = complete_fraction(found);
  StudyAnswer out{StudyStatus::solved, {}, {sheet_summary(sheets, complete)}};
  // At checkpoints alone nothing is said of what lies between them.
  const bool all = how.complete && complete == 1.0 && found.remarks.empty();
  if (sheets.empty()) out.status = all ? StudyStatus::none : StudyStatus::not_found;
  if (!found.remarks.empty()) out.message = found.remarks.front().reason;
  for (const AtlasSheet& sheet : found.sheets)
    if (sheet.report.out_of_points) out.message = "stopped at continuation.max_points";
  for (const AtlasSheet& sheet : found.sheets)
    for (const std::string& reason : given_up(sheet.report))
      out = {StudyStatus::failed, reason, std::move(out.cells)};
  return out;
}

std::optional<StudyAnswer> study_answer(const StudyPlan& plan, const CaseTree& base,
                                        std::span<const Override> overrides,
                                        const std::atomic<bool>* stop) {
  Run run;
  run.stop = stop;
  std::optional<StudyAnswer> out;
  try {
    out = answer(plan, base, overrides, run);
  } catch (const InputError& error) {
    out = {StudyStatus::bad_input, error.what(), {}};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    out = {StudyStatus::failed, error.what(), {}};
  }
  if (!out) return out;
  std::ranges::replace(out->message, '\n', ' ');
  if (out->cells.empty()) out->cells.emplace_back(plan.cell_columns().size() - 1, ',');
  return out;
}

}  // namespace stationary::cli
