// How many threads are worth beginning: as many as are asked for, and no more than this process has
// processors, of which its mask or mpirun may leave it fewer than the machine has. TBB and Ceres write
// warnings of theirs on standard error where they are asked for more.
#pragma once

#include <tbb/info.h>

#include <algorithm>

namespace stationary {

/// At least 1.
inline int available_threads(int asked) {
  return std::max(1, std::min(asked, tbb::info::default_concurrency()));
}

}  // namespace stationary
