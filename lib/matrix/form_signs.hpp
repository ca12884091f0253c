// Signs of a symmetric form's eigenvalues: how many are negative, and whether all are positive for
// every form within the magnitudes of its entries.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lib/matrix/hessenberg.hpp"
#include "lib/number/number.hpp"

namespace stationary {

/// Powers of two that bring the diagonal of the magnitudes to about one.
template <std::size_t n>
std::array<double, n> unit_scales(const Square<double, n>& magnitude) {
  std::array<double, n> out;
  for (std::size_t k = 0; k < n; ++k) {
    const double size = magnitude[k][k];
    out[k] = size > 0.0 && size < HUGE_VAL ? std::scalbn(1.0, -(std::ilogb(size) / 2)) : 1.0;
  }
  return out;
}

/// Signs of the pivots of P F P^T = L D L^T, D of blocks 1x1 and 2x2, the largest entry first
/// (J. R. Bunch, B. N. Parlett, SIAM J. Numer. Anal. 8 (1971) 639).
struct PivotSigns {
  int negative = 0;
  double weakest = HUGE_VAL;      ///< the least magnitude of an eigenvalue of a block
  bool last_negative = false;     ///< of the one that came last
  double before_last = HUGE_VAL;  ///< the least magnitude without the last
};

template <class S, std::size_t n>
PivotSigns pivot_signs(Square<S, n> F) {
  PivotSigns out;
  const auto count = [&](double pivot) {
    out.negative += pivot < 0.0;
    out.before_last = out.weakest;
    out.weakest = std::fmin(out.weakest, std::abs(pivot));
    out.last_negative = pivot < 0.0;
  };
  const auto exchange = [&](std::size_t i, std::size_t j) {
    if (i == j) return;
    std::swap(F[i], F[j]);
    for (auto& row : F) std::swap(row[i], row[j]);
  };
  for (std::size_t k = 0; k < n;) {
    std::size_t at = k;
    std::size_t row = k;
    std::size_t column = k;
    double aside = 0.0;
    for (std::size_t i = k; i < n; ++i) {
      if (std::abs(leading(F[i][i])) > std::abs(leading(F[at][at]))) at = i;
      for (std::size_t j = k; j < i; ++j) {
        const double size = std::abs(leading(F[i][j]));
        if (size > aside) {
          aside = size;
          row = i;
          column = j;
        }
      }
    }
    if (k + 1 == n) {
      count(leading(F[k][k]));
      break;
    }
    constexpr double growth = 0.6403882032022076;  // (1 + sqrt 17)/8
    if (std::abs(leading(F[at][at])) >= growth * aside) {
      exchange(at, k);
      const S pivot = F[k][k];
      count(leading(pivot));
      if (leading(pivot) == 0.0) break;  // so is all the rest
      for (std::size_t i = k + 1; i < n; ++i) {
        if (leading(F[i][k]) == 0.0) continue;
        const S m = renormalized(S(F[i][k] / pivot));
        for (std::size_t j = k + 1; j <= i; ++j)
          F[i][j] = F[j][i] = renormalized(S(F[i][j] - m * F[j][k]));
      }
      k += 1;
    } else {
      exchange(column, k);
      exchange(row, k + 1);
      const S a = F[k][k];
      const S b = F[k + 1][k];
      const S c = F[k + 1][k + 1];
      const S det = renormalized(S(a * c - b * b));  // < 0
      const double half = 0.5 * (leading(a) + leading(c));
      const double root = std::sqrt(half * half - leading(det));
      count(half + root);
      count(half - root);
      out.before_last = out.weakest;
      for (std::size_t i = k + 2; i < n; ++i) {
        const S x = renormalized(S((F[i][k] * c - F[i][k + 1] * b) / det));
        const S y = renormalized(S((F[i][k + 1] * a - F[i][k] * b) / det));
        for (std::size_t j = k + 2; j <= i; ++j)
          F[i][j] = F[j][i] = renormalized(S(F[i][j] - (x * F[j][k] + y * F[j][k + 1])));
      }
      k += 2;
    }
  }
  return out;
}

/// Pivots of a form given in pairs, these only where doubles leave a sign open; rows scaled first.
/// one_is_zero: its last pivot has no sign, and need have none.
template <std::size_t n>
PivotSigns pivot_signs(const Square<DoubleDouble, n>& F, const std::array<double, n>& scale,
                       bool one_is_zero) {
  constexpr double plain = 1e-11;  // of entries of order one
  Square<double, n> rough;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) rough[i][j] = leading(F[i][j]) * (scale[i] * scale[j]);
  const PivotSigns out = pivot_signs(rough);
  if ((one_is_zero ? out.before_last : out.weakest) > plain) return out;
  Square<DoubleDouble, n> scaled;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) scaled[i][j] = F[i][j] * (scale[i] * scale[j]);
  return pivot_signs(scaled);
}

/// For all inputs of relative uncertainty u: F - u diag(row sums of the magnitudes) is.
template <std::size_t n>
bool positive_definite(const Square<DoubleDouble, n>& F, const Square<double, n>& magnitude,
                       const std::array<double, n>& scale, double u) {
  Square<double, n> L;
  for (std::size_t i = 0; i < n; ++i) {
    double spread = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      spread += magnitude[i][j] * (scale[i] * scale[j]);
      L[i][j] = leading(F[i][j]) * (scale[i] * scale[j]);
    }
    constexpr double rounding = 2.0 * n * 0x1p-53;
    L[i][i] -= u * spread + rounding * std::abs(L[i][i]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (!(L[k][k] > 0.0)) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      const double m = L[i][k] / L[k][k];
      for (std::size_t j = k + 1; j <= i; ++j) L[i][j] -= m * L[j][k];
    }
  }
  return true;
}

}  // namespace stationary
