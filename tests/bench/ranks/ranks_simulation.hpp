// Many ranks without them: the dispatcher (solver/program/tiles/dispatcher.hpp) hands out tiles of recorded
// costs to ranks that only the clock of this file knows. Rank 0 does one thing after the other: hands out a
// batch, takes a result; a message is under way for `latency`.
#pragma once

#include <cstddef>
#include <vector>

namespace stationary::bench {

struct SimulatedRun {
  std::size_t ranks = 1;      ///< that compute; rank 0, which hands out, beside them
  std::size_t tiles = 1;      ///< costs are taken from the recorded ones in a fixed random order
  double handing_out = 5e-6;  ///< seconds of rank 0 a batch
  double taking = 5e-6;       ///< seconds of rank 0 a result
  double latency = 5e-6;      ///< seconds
};

struct SimulatedEnd {
  double seconds = 0.0;
  double work = 0.0;     ///< all costs together
  double batches = 0.0;  ///< how many were handed out
  double busy = 0.0;     ///< the part of the time in which rank 0 served
  /// Of the ranks that compute.
  double efficiency(std::size_t ranks) const {
    return work / (seconds * static_cast<double>(ranks));
  }
};

SimulatedEnd simulate(const SimulatedRun& of, const std::vector<double>& costs);

}  // namespace stationary::bench
