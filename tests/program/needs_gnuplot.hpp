// A test that draws begins with NEEDS_GNUPLOT(): it is skipped where gnuplot is not on the path.
#pragma once

#include <cstdlib>

namespace stationary::testing {

inline bool has_gnuplot() {
  static const bool there = std::system("command -v gnuplot > /dev/null") == 0;
  return there;
}

}  // namespace stationary::testing

#define NEEDS_GNUPLOT() \
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is missing"
