// The number of steps of a way, as messages tell it.
#pragma once

#include <string>

namespace stationary {

/// "1 step", "2 steps".
inline std::string counted_steps(long count) {
  return std::to_string(count) + (count == 1 ? " step" : " steps");
}

}  // namespace stationary
