// Symmetric 1x1, 2x2, 3x3 matrices and their inverses in closed form, in plain scalars: the warm
// solve spends its time here, and packet code for so small a matrix moves numbers between lanes
// more than it computes (measured on a sweep: 1.3 times slower).
//
// Of three rows one is eliminated first, with the largest diagonal entry a_pp as its pivot:
//
//   S_ij = a_ij - a_ip a_pj/a_pp   (i, j not p),    det A = a_pp det S,
//   (A^-1)_ij = (S^-1)_ij,   (A^-1)_ip = -(S^-1 u)_i,   (A^-1)_pp = 1/a_pp + u^T S^-1 u,
//   u_i = a_pi/a_pp.
//
// The cofactors of a body that is far stiffer in volume than in shape, lambda/mu, cancel to
// (mu/lambda)^2 of their terms; the entries of S to mu/lambda. Where no diagonal entry is as large
// as the others the cofactors are taken.
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
      if (const int p = pivot(); p >= 0) {
        const Eliminated out(*this, p);
        return out.pivot * out.rest.determinant();
      }
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
      if (const int p = pivot(); p >= 0) return Eliminated(*this, p).inverse();
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

 private:
  /// The row of three to eliminate first; -1 where no diagonal entry will do.
  int pivot() const requires(N == 3) {
    const auto& a = entries;
    const double d0 = std::abs(a[0]);
    const double d1 = std::abs(a[3]);
    const double d2 = std::abs(a[5]);
    const int p = d0 >= d1 ? (d0 >= d2 ? 0 : 2) : (d1 >= d2 ? 1 : 2);
    const double most = p == 0 ? d0 : p == 1 ? d1 : d2;
    const double others = std::abs(a[1]) + std::abs(a[2]) + std::abs(a[4]);
    return 8.0 * most >= others && most > 0.0 ? p : -1;
  }

  /// Row p eliminated, of rows p, q, r.
  struct Eliminated {
    int p;
    double pivot;
    double u_q;
    double u_r;
    SmallSymmetric<N - 1> rest;

    Eliminated(const SmallSymmetric& a, int row)
        : p(row),
          pivot(a(row, row)),
          u_q(a(row, q()) / pivot),
          u_r(a(row, r()) / pivot),
          rest{{a(q(), q()) - u_q * a(row, q()), a(q(), r()) - u_q * a(row, r()),
                a(r(), r()) - u_r * a(row, r())}} {}

    int q() const { return p == 0 ? 1 : 0; }
    int r() const { return p == 2 ? 1 : 2; }

    SmallSymmetric inverse() const {
      const SmallSymmetric<N - 1> s = rest.inverse();
      const double of_q = s.entries[0] * u_q + s.entries[1] * u_r;
      const double of_r = s.entries[1] * u_q + s.entries[2] * u_r;
      SmallSymmetric out;
      const auto at = [&out](int i, int j) -> double& {
        return out.entries[static_cast<std::size_t>(index(i, j))];
      };
      at(p, p) = 1.0 / pivot + u_q * of_q + u_r * of_r;
      at(p, q()) = -of_q;
      at(p, r()) = -of_r;
      at(q(), q()) = s.entries[0];
      at(q(), r()) = s.entries[1];
      at(r(), r()) = s.entries[2];
      return out;
    }
  };
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
