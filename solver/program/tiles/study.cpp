#include "solver/program/tiles/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/equilibrium_row.hpp"

namespace stationary::cli {

Study::Study(const StudyRun& asked)
    : source_(*asked.source), base_(*asked.base), tree_(base_), plan_(asked.plan) {
  for (const std::string& each : asked.overrides) {
    tree_.override_key(each);
    options_.push_back({each});
  }
  require_some_case();
  plan_.columns = columns();
}

/// What is wrong with the case or the options, and no row puts right, is not a row's fault.
void Study::require_some_case() const {
  const auto fault_of = [this](std::span<const Override> overrides) -> std::optional<InputError> {
    try {
      (void)make_case(base_, overrides);
      return std::nullopt;
    } catch (const InputError& fault) {
      return fault;
    }
  };
  const std::optional<InputError> own = fault_of(options_);
  if (!own) return;
  for (std::size_t row = 0; row < source_.rows(); ++row) {
    std::vector<Override> overrides = options_;
    std::ranges::move(source_.overrides(row), std::back_inserter(overrides));
    const std::optional<InputError> there = fault_of(overrides);
    if (!there || std::string_view(there->what()) != own->what()) return;
  }
  throw *own;
}

std::optional<Case> Study::alone() const {
  try {
    Case out = make_case(base_, options_);
    out.output.certificate = out.output.certificate || plan_.certify;
    return out;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<CellColumn> study_header(const std::vector<CellColumn>& source,
                                     const std::vector<CellColumn>& cells) {
  std::vector<CellColumn> out{{"study_row", CellKind::count}};
  out.insert(out.end(), source.begin(), source.end());
  out.push_back({"status", CellKind::text});
  out.push_back({"message", CellKind::text});
  out.insert(out.end(), cells.begin(), cells.end());
  return out;
}

std::vector<CellColumn> Study::header() const {
  return study_header(source_.columns(), plan_.cell_columns());
}

std::optional<std::string> Study::lines(const Share& rows, const std::atomic<bool>* stop) const {
  std::string out;
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    std::vector<Override> overrides = options_;
    std::ranges::move(source_.overrides(row), std::back_inserter(overrides));
    const auto found = study_answer(plan_, base_, overrides, stop);
    if (!found) return std::nullopt;
    for (const std::string& cells : found->cells)
      out += fmt::format("{},{},{},{},{}\n", row + 1, source_.cells(row), name(found->status),
                         csv_cell(found->message), cells);
  }
  return out;
}

std::string Study::hash() const {
  return work_hash(
      "study", tree_,
      {tree_.name(), source_.path(), source_.text(), name(plan_.task), csv_header(header()),
       fmt::format("{} {}", plan_.checkpoints.value_or(0), plan_.certify)});
}

std::vector<Column> Study::columns() const {
  if (plan_.task != StudyTask::solve) return {};
  const bool two_polar = has_rates(value_or<std::string>(tree_, "motion.branch", "")) ||
                         source_.has("motion.branch", two_polar_name);
  const std::vector<Column> all = equilibrium_columns(
      {.two_polar = two_polar,
       .spectrum = value_or(tree_, "output.spectrum", true),
       .certificate = plan_.certify || value_or(tree_, "output.certificate", false),
       .pressure = find(tree_, "body.volume") != nullptr || source_.has_column("body.volume")});
  std::vector<std::string> asked;
  if (const toml::node* names = find(tree_, "output.columns");
      names != nullptr && names->is_array())
    for (const toml::node& each : *names->as_array())
      asked.push_back(each.value<std::string>().value_or(""));
  std::vector<Column> out = select_columns(all, asked);
  if (out.empty())
    throw fault_at(tree_, "output.columns", "found no column that study computes",
                   "names of columns of solve");
  return out;
}

}  // namespace stationary::cli
