// Eigenvalue problems of small matrices that are not symmetric, by elimination:
//
//   T^-1 A T = H,  H zero below its subdiagonal,  T = P0 L0 P1 L1 ...: row swaps, then shears with
//                  entries of magnitude 1 at most;
//   det(x - H)     by the recurrence over the leading blocks of H;
//   null vectors   of H - lambda from one LU factorization of it, carried back by T.
//
// In pairs of doubles the characteristic polynomial keeps its digits where the coefficients by
// traces of powers do not. A division less than by rotations, a third of their operations; growth
// is no concern at this size, and the caller's error bound sees the magnitude of what was computed.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>

#include "lib/number/elementary.hpp"
#include "lib/number/number.hpp"
#include "lib/number/polynomial.hpp"

namespace stationary {

template <class S, std::size_t n>
using Square = std::array<std::array<S, n>, n>;

/// |re| + |im| of a complex number, for comparisons.
inline double one_norm(double x) { return std::abs(x); }
inline double one_norm(const std::complex<double>& z) {
  return std::abs(z.real()) + std::abs(z.imag());
}
inline double inverse(double x) { return 1.0 / x; }
inline std::complex<double> inverse(const std::complex<double>& z) {
  return std::conj(z) / std::norm(z);
}

/// T.
template <std::size_t n>
struct Similarity {
  std::array<std::size_t, n> swapped{};  ///< row k + 1 with this one
  Square<double, n> multiplier{};        ///< [i][k]: of row k + 1 in row i

  /// T x, of a right eigenvector of H.
  template <class T>
  void carry_right(std::array<T, n>& x) const {
    for (std::size_t k = n - 2; n > 2 && k-- > 0;) {
      for (std::size_t i = k + 2; i < n; ++i) x[i] += multiplier[i][k] * x[k + 1];
      std::swap(x[k + 1], x[swapped[k]]);
    }
  }
  /// T^-T y, of a left one.
  template <class T>
  void carry_left(std::array<T, n>& y) const {
    for (std::size_t k = n - 2; n > 2 && k-- > 0;) {
      for (std::size_t i = k + 2; i < n; ++i) y[k + 1] -= multiplier[i][k] * y[i];
      std::swap(y[k + 1], y[swapped[k]]);
    }
  }
};

/// A row and column at a time; S is a pair of doubles, or any real number.
template <class S, std::size_t n>
struct Hessenberg {
  Square<S, n> h;
  Similarity<n> similarity;

  explicit Hessenberg(const Square<S, n>& A) : h(A) {
    auto& [swapped, multiplier] = similarity;
    for (std::size_t k = 0; k + 2 < n; ++k) {
      const std::size_t top = k + 1;
      std::size_t pivot = top;
      for (std::size_t i = top + 1; i < n; ++i)
        if (std::abs(leading(h[i][k])) > std::abs(leading(h[pivot][k]))) pivot = i;
      swapped[k] = pivot;
      if (pivot != top) {
        std::swap(h[pivot], h[top]);
        for (std::size_t i = 0; i < n; ++i) std::swap(h[i][pivot], h[i][top]);
      }
      for (std::size_t i = top + 1; i < n; ++i) {
        if (leading(h[i][k]) == 0.0) {
          multiplier[i][k] = 0.0;
          continue;
        }
        const S m = renormalized(S(h[i][k] / h[top][k]));
        multiplier[i][k] = leading(m);
        h[i][k] = S(0.0);
        for (std::size_t j = top; j < n; ++j) h[i][j] = renormalized(S(h[i][j] - m * h[top][j]));
        for (std::size_t j = 0; j < n; ++j) h[j][top] = renormalized(S(h[j][top] + m * h[j][i]));
      }
    }
  }
};

/// det(x - H), monic, of a Hessenberg matrix; `magnitude`: the sums of its terms' magnitudes.
template <class S, std::size_t n>
struct HessenbergPolynomial {
  std::array<S, n + 1> c;
  std::array<double, n + 1> magnitude;

  explicit HessenbergPolynomial(const Square<S, n>& h) {
    // Of the leading k x k block, k = 0 ... n.
    std::array<std::array<S, n + 1>, n + 1> p;
    std::array<std::array<double, n + 1>, n + 1> m;
    p[0][0] = S(1.0);
    m[0][0] = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      auto& next = p[k + 1];
      auto& size = m[k + 1];
      const double diagonal = std::abs(leading(h[k][k]));
      next[k + 1] = S(1.0);
      size[k + 1] = 1.0;
      for (std::size_t j = k + 1; j-- > 0;) {
        const S lower = -(h[k][k] * p[k][j]);
        next[j] = j > 0 ? renormalized(S(p[k][j - 1] + lower)) : renormalized(lower);
        size[j] = (j > 0 ? m[k][j - 1] : 0.0) + diagonal * m[k][j];
      }
      S below(1.0);  // the product of the subdiagonal entries passed
      for (std::size_t i = k; i-- > 0;) {
        below = renormalized(S(below * h[i + 1][i]));
        if (leading(below) == 0.0) break;
        if (leading(h[i][k]) == 0.0) continue;
        const S factor = renormalized(S(h[i][k] * below));
        const double weight = std::abs(leading(factor));
        for (std::size_t j = 0; j <= i; ++j) {
          next[j] = renormalized(S(next[j] - factor * p[i][j]));
          size[j] += weight * m[i][j];
        }
      }
    }
    c = p[n];
    magnitude = m[n];
  }
};

/// H - lambda in factors, lambda an eigenvalue to working precision, and its null vectors; the
/// largest component of each is of order one.
template <class T, std::size_t n>
class NullSpace {
 public:
  NullSpace(const Square<double, n>& h, const T& lambda) {
    double size = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i > 0 ? i - 1 : 0; j < n; ++j) {
        u_[i][j] = h[i][j];
        size = std::fmax(size, std::abs(h[i][j]));
      }
      u_[i][i] -= lambda;
    }
    const double least =
        std::fmax(0x1p-53 * std::fmax(size, one_norm(lambda)), std::numeric_limits<double>::min());
    for (std::size_t k = 0; k < n; ++k) {
      if (k + 1 < n) {
        swapped_[k] = one_norm(u_[k + 1][k]) > one_norm(u_[k][k]);
        if (swapped_[k])
          for (std::size_t j = k; j < n; ++j) std::swap(u_[k][j], u_[k + 1][j]);
      }
      if (one_norm(u_[k][k]) < least) u_[k][k] = least;
      pivot_[k] = inverse(u_[k][k]);
      if (k + 1 < n) {
        m_[k] = product(u_[k + 1][k], pivot_[k]);
        for (std::size_t j = k + 1; j < n; ++j) u_[k + 1][j] -= product(m_[k], u_[k][j]);
      }
    }
  }

  std::array<T, n> right() const {
    std::array<T, n> x;
    x.fill(T(1.0));
    solve_upper(x);
    normalize(x);
    // Once more, from where it is.
    for (std::size_t k = 0; k + 1 < n; ++k) {
      if (swapped_[k]) std::swap(x[k], x[k + 1]);
      x[k + 1] -= product(m_[k], x[k]);
    }
    solve_upper(x);
    normalize(x);
    return x;
  }

  std::array<T, n> left() const {
    std::array<T, n> x;
    x.fill(T(1.0));
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = 0; j < k; ++j) x[k] -= product(u_[j][k], x[j]);
        x[k] = product(x[k], pivot_[k]);
      }
      for (std::size_t k = n - 1; k-- > 0;) {
        x[k] -= product(m_[k], x[k + 1]);
        if (swapped_[k]) std::swap(x[k], x[k + 1]);
      }
      normalize(x);
    }
    return x;
  }

 private:
  static void normalize(std::array<T, n>& x) {
    double largest = 0.0;
    for (const T& each : x) largest = std::fmax(largest, one_norm(each));
    const double scale = 1.0 / largest;
    for (T& each : x) each *= scale;
  }

  void solve_upper(std::array<T, n>& x) const {
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) x[k] -= product(u_[k][j], x[j]);
      x[k] = product(x[k], pivot_[k]);
    }
  }

  Square<T, n> u_;
  std::array<T, n> m_;
  std::array<bool, n> swapped_;
  std::array<T, n> pivot_;  ///< inverses
};

}  // namespace stationary
