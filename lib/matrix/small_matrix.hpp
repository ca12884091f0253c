// Small square matrices without symmetry, for systems whose rows are divided by their own sizes.
#pragma once

#include <Eigen/LU>

#include "lib/matrix/elimination.hpp"

namespace stationary {

template <int N>
struct SmallMatrix {
  Eigen::Matrix<double, N, N> entries;

  double operator()(int i, int j) const { return entries(i, j); }
  const Eigen::Matrix<double, N, N>& matrix() const { return entries; }
  double determinant() const { return stationary::determinant<N>(entries); }
  /// Not finite where the matrix is singular.
  SmallMatrix inverse() const {
    if constexpr (N > 4) {
      return {Elimination<N>(entries).inverse()};
    } else {
      return {entries.inverse()};
    }
  }
  SmallMatrix absolute() const { return {entries.cwiseAbs()}; }
  Eigen::Matrix<double, N, 1> operator*(const Eigen::Matrix<double, N, 1>& x) const {
    return entries * x;
  }
};

}  // namespace stationary
