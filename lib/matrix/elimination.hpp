// Elimination with partial pivoting, P A = L U, of a small matrix. Eigen's inverts through a kernel of
// products that rounds by the processor's width and, on aarch64, fuses them whatever it is told; here
// every product and difference stands by itself.
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <utility>

namespace stationary {

template <int n>
class Elimination {
 public:
  using Matrix = Eigen::Matrix<double, n, n>;

  Elimination() = default;
  explicit Elimination(const Matrix& A) : lu_(A) {
    for (int i = 0; i < n; ++i) row_[static_cast<std::size_t>(i)] = i;
    for (int k = 0; k < n; ++k) {
      int pivot = k;
      for (int i = k + 1; i < n; ++i)
        if (std::abs(lu_(i, k)) > std::abs(lu_(pivot, k))) pivot = i;
      if (lu_(pivot, k) == 0.0) continue;  // singular: U has a zero on its diagonal
      if (pivot != k) {
        for (int j = 0; j < n; ++j) std::swap(lu_(k, j), lu_(pivot, j));
        std::swap(row_[static_cast<std::size_t>(k)], row_[static_cast<std::size_t>(pivot)]);
        sign_ = -sign_;
      }
      for (int i = k + 1; i < n; ++i) {
        const double l = lu_(i, k) /= lu_(k, k);
        for (int j = k + 1; j < n; ++j) lu_(i, j) -= l * lu_(k, j);
      }
    }
  }

  double determinant() const { return sign_ * lu_.diagonal().prod(); }
  /// A^-1 B. Not finite where the matrix is singular.
  template <int columns>
  Eigen::Matrix<double, n, columns> solution(const Eigen::Matrix<double, n, columns>& B) const {
    Eigen::Matrix<double, n, columns> out;
    for (int k = 0; k < n; ++k) out.row(k) = B.row(row_[static_cast<std::size_t>(k)]);
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < columns; ++j)
        for (int i = k + 1; i < n; ++i) out(i, j) -= lu_(i, k) * out(k, j);
    for (int k = n - 1; k >= 0; --k) {
      const double per_pivot = 1.0 / lu_(k, k);
      for (int j = 0; j < columns; ++j) {
        out(k, j) *= per_pivot;
        for (int i = 0; i < k; ++i) out(i, j) -= lu_(i, k) * out(k, j);
      }
    }
    return out;
  }
  Matrix inverse() const { return solution<n>(Matrix::Identity()); }

 private:
  Matrix lu_;
  std::array<int, static_cast<std::size_t>(n)> row_;
  double sign_ = 1.0;
};

/// Of four and less by Eigen's products.
template <int n>
double determinant(const Eigen::Matrix<double, n, n>& A) {
  if constexpr (n > 4) {
    return Elimination<n>(A).determinant();
  } else {
    return A.determinant();
  }
}

}  // namespace stationary
