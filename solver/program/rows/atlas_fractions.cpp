// What the metadata say of an atlas in one number; the solver of pages has it without the rest of atlas_rows.cpp.
#include <algorithm>

#include "solver/program/rows/atlas_rows.hpp"

namespace stationary {

double unproven_fraction(const std::vector<Completeness>& completeness) {
  double open = 0.0;
  double all = 0.0;
  for (const Completeness& each : completeness) {
    if (each.intervals.empty()) continue;  // interrupted
    open += each.unproven_length();
    all += each.intervals.back().to - each.intervals.front().from;
  }
  return all > 0.0 ? open / all : 1.0;
}

double complete_fraction(const Atlas& found) {
  if (!found.completeness.empty()) return 1.0 - unproven_fraction(found.completeness);
  const auto complete = std::ranges::count_if(found.checkpoints, &Checkpoint::complete);
  return static_cast<double>(complete) / static_cast<double>(found.checkpoints.size());
}

}  // namespace stationary
