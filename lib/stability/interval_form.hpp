// Square matrices of intervals: what their characteristic polynomials are, and how many negative
// eigenvalues symmetric ones have, each for every matrix in the intervals.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "lib/number/interval.hpp"
#include "lib/stability/enclosure_collector.hpp"

namespace stationary {

template <std::size_t n>
using IntervalForm = std::array<std::array<Interval, n>, n>;

template <std::size_t n>
IntervalForm<n> product(const IntervalForm<n>& x, const IntervalForm<n>& y) {
  IntervalForm<n> out;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) out[i][j] += x[i][k] * y[k][j];
  return out;
}

/// Coefficients c_0 ... c_n = 1 of det(x - M) by the recursion of U. J. J. Leverrier and D. K.
/// Faddeev, N_0 = 1:  c_{n-k} = -tr(M N_{k-1})/k,  N_k = M N_{k-1} + c_{n-k}.
/// even: a polynomial in x^2, as of every Hamiltonian M; the others are exactly 0 then.
template <std::size_t n>
std::array<Interval, n + 1> characteristic(const IntervalForm<n>& M, bool even = false) {
  std::array<Interval, n + 1> out;
  out[n] = 1.0;
  IntervalForm<n> N;
  for (std::size_t i = 0; i < n; ++i) N[i][i] = 1.0;
  for (std::size_t k = 1; k <= n; ++k) {
    N = product<n>(M, N);
    if (even && k % 2 == 1) continue;
    Interval trace;
    for (std::size_t i = 0; i < n; ++i) trace += N[i][i];
    out[n - k] = -trace / static_cast<double>(k);
    for (std::size_t i = 0; i < n; ++i) N[i][i] += out[n - k];
  }
  return out;
}

/// Negative eigenvalues of a symmetric F of rank `rank`, by Sylvester's law, the largest pivot
/// first; nothing where a pivot has no sign.
template <std::size_t n>
std::optional<int> negative_directions(IntervalForm<n> F, std::size_t rank = n) {
  std::array<std::size_t, n> order;
  for (std::size_t k = 0; k < n; ++k) order[k] = k;
  int count = 0;
  for (std::size_t a = 0; a < rank; ++a) {
    std::iter_swap(
        order.begin() + a,
        std::max_element(order.begin() + a, order.end(), [&](std::size_t i, std::size_t j) {
          return F[i][i].mignitude() < F[j][j].mignitude();
        }));
    const std::size_t k = order[a];
    const int sign = proven_sign(F[k][k]);
    if (sign == unknown) return std::nullopt;
    count += sign < 0;
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = a + 1; c < n; ++c)
        F[order[b]][order[c]] -= F[order[b]][k] * F[k][order[c]] / F[k][k];
  }
  return count;
}

}  // namespace stationary
