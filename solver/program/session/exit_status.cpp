#include "solver/program/session/exit_status.hpp"

#include "solver/program/case/case_schema.hpp"

namespace stationary::cli {

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

std::string_view outcome(SolveStatus status, bool only_in_box) {
  const bool none = status == SolveStatus::none_exists;
  return none && only_in_box ? "no stationary ellipsoid in the box searched" : outcome(status);
}

std::string failure_text(std::string_view outcome, const std::string& message) {
  std::string out(outcome);
  if (!message.empty()) out += ": " + message;
  return out;
}

std::vector<std::string> given_up(const FollowReport& report) {
  std::vector<std::string> out;
  for (const SheetEnd* end : {&report.backward, &report.forward})
    if (end->event == EventType::stalled) out.push_back(end->reason);
  return out;
}

std::vector<Column> chosen_columns(const Case& input, const std::vector<Column>& computed,
                                   std::string_view command, bool trailing) {
  std::vector<Column> out = select_columns(computed, input.output.columns);
  if (!out.empty() || trailing) return out;
  const auto has = [&](Column c) { return std::ranges::find(computed, c) != computed.end(); };
  const bool has_spectrum = std::ranges::any_of(computed, needs_spectrum);
  std::vector<std::string_view> names;
  for (std::size_t k = 0; k < column_count; ++k) {
    const auto c = static_cast<Column>(k);
    // The spectrum is left out for want of a column that is named.
    const bool if_named = !has_spectrum && input.output.spectrum && needs_spectrum(c) &&
                          (!is_certificate(c) || has(Column::certified)) &&
                          (c != Column::segment || has(Column::event));
    if (has(c) || if_named) names.push_back(name(c));
  }
  throw fault_at(input.source, "output.columns",
                 "found no column that " + std::string(command) + " computes",
                 "names of " + listed(names));
}

}  // namespace stationary::cli
