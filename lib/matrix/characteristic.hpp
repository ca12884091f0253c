// Characteristic polynomials by the recursion of U. J. J. Leverrier and D. K. Faddeev, N_0 = 1,
//
//   det(x - M) = x^n + ... + c_0:   c_{n-k} = -tr(M N_{k-1})/k,   N_k = M N_{k-1} + c_{n-k},
//
// which has the slopes of its coefficients beside it,  dc_{n-k}/dM_ij = -(N_{k-1})_ji.
//
// Over a matrix of intervals its rounding grows like |M|^n. Where they are narrow that is far more
// than what the coefficients depend on M by. Then they are taken from the middle M_0, in pairs of
// doubles with a bound of their error, and from the slopes over all of M:
//
//   c(M) in c(M_0) + dc/dM (M - M_0).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/number/dual.hpp"
#include "lib/number/enclosed_pair.hpp"
#include "lib/number/interval.hpp"

namespace stationary {

template <class T, std::size_t n>
using SquareForm = std::array<std::array<T, n>, n>;

template <class T, std::size_t n>
SquareForm<T, n> product(const SquareForm<T, n>& x, const SquareForm<T, n>& y) {
  SquareForm<T, n> out;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      out[i][j] = T(0.0);
      for (std::size_t k = 0; k < n; ++k) out[i][j] += x[i][k] * y[k][j];
    }
  }
  return out;
}

/// c_0 ... c_n = 1, and N_0 ... N_{n-1}.
template <class T, std::size_t n>
struct CharacteristicRecursion {
  std::array<T, n + 1> c;
  std::array<SquareForm<T, n>, n> N;

  /// even: a polynomial in x^2, as of every Hamiltonian M; the others are exactly 0 then.
  CharacteristicRecursion(const SquareForm<T, n>& M, bool even) {
    c.fill(T(0.0));
    c[n] = T(1.0);
    for (std::size_t i = 0; i < n; ++i) {
      N[0][i].fill(T(0.0));
      N[0][i][i] = T(1.0);
    }
    for (std::size_t k = 1; k <= n; ++k) {
      SquareForm<T, n> next = product(M, N[k - 1]);
      if (!even || k % 2 == 0) {
        T trace(0.0);
        for (std::size_t i = 0; i < n; ++i) trace += next[i][i];
        c[n - k] = -trace / static_cast<double>(k);
        for (std::size_t i = 0; i < n; ++i) next[i][i] += c[n - k];
      }
      if (k < n) N[k] = next;
    }
  }
  /// The change of c_{n-k} with dM(i, j).
  template <class Change>
  auto change(std::size_t k, const Change& dM) const {
    auto out = -(N[k - 1][0][0] * dM(0, 0));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (i + j > 0) out += -(N[k - 1][j][i] * dM(i, j));
    return out;
  }
};

template <std::size_t n>
bool is_narrow(const SquareForm<Interval, n>& M) {
  double largest = 0.0;
  double widest = 0.0;
  for (const auto& row : M) {
    for (const Interval& entry : row) {
      if (!entry.bounded()) return false;
      largest = std::max(largest, entry.magnitude());
      widest = std::max(widest, entry.width());
    }
  }
  return widest <= 0x1p-20 * largest;
}

/// c over M from its middle, by the recursion over all of M.
template <std::size_t n>
std::array<Interval, n + 1> about_middle(const SquareForm<Interval, n>& M,
                                         const CharacteristicRecursion<Interval, n>& over,
                                         bool even) {
  SquareForm<EnclosedPair, n> middle;
  SquareForm<Interval, n> aside;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      // Rounded so that that of -x is minus that of x: the middle of an even M is even.
      const double between = 0.5 * M[i][j].lo + 0.5 * M[i][j].hi;
      middle[i][j] = EnclosedPair(between);
      aside[i][j] = M[i][j] - Interval(between);
    }
  }
  const CharacteristicRecursion<EnclosedPair, n> there(middle, even);
  std::array<Interval, n + 1> out = over.c;
  for (std::size_t k = 1; k <= n; ++k) {
    if (even && k % 2 == 1) continue;
    const Interval change =
        over.change(k, [&](std::size_t i, std::size_t j) { return aside[i][j]; });
    out[n - k] = common(out[n - k], there.c[n - k].interval() + change);
  }
  return out;
}

/// Of all matrices in M; by the middle where the recursion alone has lost half the digits. even: as of
/// CharacteristicRecursion.
template <std::size_t n>
std::array<Interval, n + 1> characteristic(const SquareForm<Interval, n>& M, bool even = false) {
  const CharacteristicRecursion<Interval, n> over(M, even);
  const bool known = std::ranges::all_of(over.c, [](const Interval& c) {
    return c.lo == c.hi || c.width() <= 0x1p-26 * c.magnitude();
  });
  return known || !is_narrow(M) ? over.c : about_middle(M, over, even);
}
/// With the slopes of M's entries along some unknowns.
template <std::size_t n, std::size_t N>
std::array<Dual<Interval, N>, n + 1> characteristic(const SquareForm<Dual<Interval, N>, n>& M,
                                                    bool even = false) {
  SquareForm<Interval, n> values;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) values[i][j] = M[i][j].value;
  const CharacteristicRecursion<Interval, n> over(values, even);
  const auto c = is_narrow(values) ? about_middle(values, over, even) : over.c;
  std::array<Dual<Interval, N>, n + 1> out;
  for (std::size_t k = 0; k <= n; ++k) {
    out[n - k].value = c[n - k];
    if (k == 0 || (even && k % 2 == 1)) continue;
    for (std::size_t s = 0; s < N; ++s)
      out[n - k].slope[s] =
          over.change(k, [&](std::size_t i, std::size_t j) { return M[i][j].slope[s]; });
  }
  return out;
}

}  // namespace stationary
