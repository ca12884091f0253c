// A x = b of a small square matrix whose rows are divided by their largest entries first, each equation having a
// size of its own; columns may be of any size. Eliminated with complete pivoting.
#pragma once

#include <Eigen/LU>
#include <array>
#include <cstddef>

namespace stationary {

/// N = 2 ... 6. NaN where A is singular, or not finite.
template <int N>
class ScaledRows {
 public:
  using Numbers = std::array<double, static_cast<std::size_t>(N)>;

  void eliminate(const std::array<Numbers, static_cast<std::size_t>(N)>& columns);

  /// x, in the same units as A's columns.
  Numbers solve(const Numbers& b) const;
  /// |A^-1| b, b >= 0: what x may be off by where b is off by so much; scaled(i, b) of each row is what it takes.
  Numbers largest(const Numbers& scaled_b) const;
  /// b, divided as row i is.
  double scaled(std::size_t i, double b) const { return b * scale_[static_cast<Eigen::Index>(i)]; }

 private:
  Eigen::Matrix<double, N, 1> scale_;
  Eigen::FullPivLU<Eigen::Matrix<double, N, N>> lu_;
  bool regular_ = false;
};

}  // namespace stationary
