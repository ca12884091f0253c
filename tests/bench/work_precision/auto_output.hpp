// What AUTO-07p writes: the points of its file fort.7, of eleven digits.
#pragma once

#include <string_view>
#include <vector>

namespace stationary::bench {

struct AutoPoint {
  int type;                      ///< 0: as any; 9, -9: an end; 1, 2: a branch point, a fold
  double parameter;              ///< PAR(1)
  std::vector<double> unknowns;  ///< U
};

/// The points of the last branch in the text of a fort.7. Throws std::runtime_error where a line is
/// not one of AUTO's or a number is not finite.
std::vector<AutoPoint> auto_points(std::string_view text);

}  // namespace stationary::bench
