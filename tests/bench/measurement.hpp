// One method on one problem at one tolerance: what it costs an item and how far the items are from
// the truth, in repeats that take turns with all other methods, and in processor time: on a machine
// with other users the clock on the wall says more about the neighbours.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/body/motion.hpp"

namespace stationary::bench {

struct Entry {
  std::string what;  ///< the panel: what an item is and where it starts from
  std::string method;
  std::string model;
  Branch branch;
  std::optional<double> tolerance;
  std::size_t items;  ///< of one pass
  /// Processor seconds that many passes take.
  std::function<double(long passes)> seconds;
  /// Of the last pass: relative errors, NaN where the method says it failed.
  std::function<std::vector<double>()> errors;
};

struct Measured {
  const Entry* entry;
  double seconds;  ///< an item: median, least and most of the repeats
  double seconds_min;
  double seconds_max;
  double error_worst;  ///< of those that did not fail; NaN where all did
  double error_median;
  std::size_t failed;
};

/// Seconds of processor time this process has used.
double processor_seconds();

/// seconds of Entry for a pass of this program's.
template <class Pass>
std::function<double(long)> timed(Pass pass) {
  return [pass](long passes) mutable {
    const double from = processor_seconds();
    for (long k = 0; k < passes; ++k) pass();
    return processor_seconds() - from;
  };
}

/// Every entry `repeats` times, in another random order each time (of a fixed seed).
std::vector<Measured> measure(const std::vector<Entry>& entries, int repeats);

}  // namespace stationary::bench
