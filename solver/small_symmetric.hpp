// Symmetric 1x1, 2x2, 3x3 matrices and their inverses in closed form (adjugate over determinant),
// in plain scalars: the warm solve spends its time here, and packet code for so small a matrix
// moves numbers between lanes more than it computes (measured on a sweep: 1.3 times slower).
//
// A badly conditioned inverse loses digits; the solvers iterate on an accurate residual, so that
// costs a step, not accuracy.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace stationary {

template <int N>
struct SmallSymmetric {
  /// Upper triangle by rows.
  std::array<double, N*(N + 1) / 2> entries;

  static constexpr int index(int i, int j) {
    const int row = i < j ? i : j;
    const int column = i < j ? j : i;
    return row * N - row * (row - 1) / 2 + column - row;
  }
  double operator()(int i, int j) const { return entries[static_cast<std::size_t>(index(i, j))]; }

  Eigen::Matrix<double, N, N> matrix() const {
    Eigen::Matrix<double, N, N> out;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) out(i, j) = (*this)(i, j);
    return out;
  }

  double determinant() const {
    const auto& a = entries;
    if constexpr (N == 1) {
      return a[0];
    } else if constexpr (N == 2) {
      return a[0] * a[2] - a[1] * a[1];
    } else {
      static_assert(N == 3);
      return a[0] * (a[3] * a[5] - a[4] * a[4]) + a[1] * (a[2] * a[4] - a[1] * a[5]) +
             a[2] * (a[1] * a[4] - a[2] * a[3]);
    }
  }

  /// Not finite where the matrix is singular.
  SmallSymmetric inverse() const {
    const auto& a = entries;
    if constexpr (N == 1) {
      return {{1.0 / a[0]}};
    } else if constexpr (N == 2) {
      const double scale = 1.0 / (a[0] * a[2] - a[1] * a[1]);
      return {{a[2] * scale, -a[1] * scale, a[0] * scale}};
    } else {
      static_assert(N == 3);
      const double c00 = a[3] * a[5] - a[4] * a[4];
      const double c01 = a[2] * a[4] - a[1] * a[5];
      const double c02 = a[1] * a[4] - a[2] * a[3];
      const double scale = 1.0 / (a[0] * c00 + a[1] * c01 + a[2] * c02);
      return {{c00 * scale, c01 * scale, c02 * scale, (a[0] * a[5] - a[2] * a[2]) * scale,
               (a[1] * a[2] - a[0] * a[4]) * scale, (a[0] * a[3] - a[1] * a[1]) * scale}};
    }
  }

  Eigen::Matrix<double, N, 1> operator*(const Eigen::Matrix<double, N, 1>& x) const {
    Eigen::Matrix<double, N, 1> out;
    for (int i = 0; i < N; ++i) {
      double sum = (*this)(i, 0) * x[0];
      for (int j = 1; j < N; ++j) sum += (*this)(i, j) * x[j];
      out[i] = sum;
    }
    return out;
  }

  SmallSymmetric absolute() const {
    SmallSymmetric out = *this;
    for (double& entry : out.entries) entry = std::abs(entry);
    return out;
  }
};

/// max |x_i|, NaN where any is.
template <int N>
double largest_magnitude(const Eigen::Matrix<double, N, 1>& x) {
  double out = std::abs(x[0]);
  for (int i = 1; i < N; ++i) {
    const double next = std::abs(x[i]);
    out = next > out || std::isnan(next) ? next : out;
  }
  return out;
}

}  // namespace stationary
