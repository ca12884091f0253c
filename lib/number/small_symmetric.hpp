// Symmetric 1x1, 2x2, 3x3 matrices and their inverses in closed form, in plain scalars: the warm
// solve spends its time here, and packet code for so small a matrix moves numbers between lanes
// more than it computes (measured on a sweep: 1.3 times slower).
//
// With the minors m_ij = a_00 a_ij - a_0i a_0j of three rows (i, j = 1, 2)
//
//   det A = (m_11 m_22 - m_12^2)/a_00,   A^-1 = cofactors/det A.
//
// Of a body that is far stiffer in volume than in shape, lambda/mu, the minors cancel to mu/lambda of
// their terms, and their product no further; a determinant by a row of cofactors cancels to
// (mu/lambda)^2. It is taken where a_00 is too small beside its row.
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
      if (8.0 * std::abs(a[0]) > std::abs(a[1]) + std::abs(a[2])) {
        const double inverse = 1.0 / a[0];
        const double m11 = a[0] * a[3] - a[1] * a[1];
        const double m12 = a[0] * a[4] - a[1] * a[2];
        const double m22 = a[0] * a[5] - a[2] * a[2];
        return (m11 * inverse) * m22 - (m12 * inverse) * m12;
      }
      return a[0] * (a[3] * a[5] - a[4] * a[4]) + a[1] * (a[2] * a[4] - a[1] * a[5]) +
             a[2] * (a[1] * a[4] - a[2] * a[3]);
    }
  }

  /// Not finite where the matrix is singular.
  SmallSymmetric inverse() const {
    const auto& a = entries;
    const double scale = 1.0 / determinant();
    if constexpr (N == 1) {
      return {{scale}};
    } else if constexpr (N == 2) {
      return {{a[2] * scale, -a[1] * scale, a[0] * scale}};
    } else {
      static_assert(N == 3);
      return {{(a[3] * a[5] - a[4] * a[4]) * scale, (a[2] * a[4] - a[1] * a[5]) * scale,
               (a[1] * a[4] - a[2] * a[3]) * scale, (a[0] * a[5] - a[2] * a[2]) * scale,
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
