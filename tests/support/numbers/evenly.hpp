// Numbers from one to another, at equal distances.
#pragma once

#include <vector>

namespace stationary::testing {

/// count >= 2 of them, both ends among them.
inline std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> out;
  for (int k = 0; k < count; ++k) out.push_back(from + (to - from) * k / (count - 1));
  return out;
}

}  // namespace stationary::testing
