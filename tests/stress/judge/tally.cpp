#include "tests/stress/judge/tally.hpp"

#include <algorithm>
#include <cstdio>

namespace stationary::stress {

void Tally::add(const Outcome& outcome) {
  ++tried;
  switch (outcome.status) {
    case SolveStatus::solved:
      ++solved;
      break;
    case SolveStatus::none_exists:
      ++none_exists;
      break;
    case SolveStatus::not_found:
      ++not_found;
      break;
    case SolveStatus::not_isolated:
      ++not_isolated;
      break;
    case SolveStatus::failed:
      ++failed;
      break;
    case SolveStatus::not_run:
    case SolveStatus::interrupted:
      break;
  }
  marginal += outcome.marginal;
  certified += outcome.certified;
  within_one_unit += outcome.status == SolveStatus::solved && outcome.units <= 1.0;
  worst_units = std::max(worst_units, outcome.units);
  worst_error_over_bound = std::max(worst_error_over_bound, outcome.error / outcome.error_bound);
  worst_mode_over_bound = std::max(worst_mode_over_bound, outcome.mode_over_bound);
  above_bound += !(outcome.error <= outcome.error_bound) || !(outcome.mode_over_bound <= 1.0);
  wrong_class += outcome.wrong_class;
  wrong_sheet += outcome.wrong_sheet;
  wrong_proof += outcome.wrong_proof;
  wrong_absence += outcome.wrong_absence;
  not_finite += outcome.not_finite;
  overlooked += outcome.overlooked;
  most_work = std::max(most_work, outcome.work);
  if (!outcome.fault.empty()) faults.push_back(outcome.fault);
}

std::string tally_header() {
  return "category,tried,solved,none_exists,not_found,not_isolated,failed,certified,marginal,"
         "within_one_unit,worst_units,worst_error_over_bound,worst_mode_over_bound,above_bound,"
         "wrong_class,wrong_sheet,wrong_proof,wrong_absence,not_finite,overlooked,most_work\n";
}

std::string tally_line(std::string_view category, const Tally& t) {
  std::string out(category);
  for (const long count : {t.tried, t.solved, t.none_exists, t.not_found, t.not_isolated, t.failed,
                           t.certified, t.marginal, t.within_one_unit})
    out += ',' + std::to_string(count);
  for (const double worst : {t.worst_units, t.worst_error_over_bound, t.worst_mode_over_bound}) {
    char text[32];
    std::snprintf(text, sizeof text, ",%.3g", worst);
    out += text;
  }
  for (const long count : {t.above_bound, t.wrong_class, t.wrong_sheet, t.wrong_proof,
                           t.wrong_absence, t.not_finite, t.overlooked, t.most_work})
    out += ',' + std::to_string(count);
  return out + '\n';
}

}  // namespace stationary::stress
