// Square matrices of intervals: how many negative eigenvalues symmetric ones have, for every matrix in
// the intervals.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "lib/matrix/characteristic.hpp"
#include "lib/number/interval.hpp"
#include "lib/stability/enclosure_collector.hpp"

namespace stationary {

template <std::size_t n>
using IntervalForm = SquareForm<Interval, n>;

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
