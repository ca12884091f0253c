// Sheets of stiff bodies followed to their ends, every row's stretches held against 50 digits at
// the row's own numbers, an event's at the event: its bound must hold, and its bracket the event.
#pragma once

#include <string>
#include <vector>

namespace stationary::stress {

struct FollowedRows {
  long sheets = 0;
  long rows = 0;    ///< held against 50 digits, those of events not counted
  long events = 0;  ///< likewise
  long ends = 0;    ///< sheets that collapse or escape
  double worst_error_over_bound = 0.0;
  double widest_bound = 0.0;
  std::vector<std::string> faults;
};

/// Random bodies, lambda/mu up to 1e10.
FollowedRows followed_rows(long sheets);

}  // namespace stationary::stress
