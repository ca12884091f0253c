// What vanishes at an event, of numbers of any type.
#pragma once

#include <array>
#include <cstddef>

namespace stationary {

template <class T, std::size_t N>
using SquareArray = std::array<std::array<T, N>, N>;

/// By the first row.
template <class T, std::size_t N>
T determinant(const SquareArray<T, N>& a) {
  if constexpr (N == 1) {
    return a[0][0];
  } else {
    T sum(0.0);
    for (std::size_t j = 0; j < N; ++j) {
      SquareArray<T, N - 1> minor;
      for (std::size_t row = 1; row < N; ++row)
        for (std::size_t column = 0, to = 0; column < N; ++column)
          if (column != j) minor[row - 1][to++] = a[row][column];
      const T term = a[0][j] * determinant(minor);
      sum = j % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
  }
}

/// A matrix with a column, a row and a corner more.
template <class T, std::size_t N>
SquareArray<T, N + 1> bordered(const SquareArray<T, N>& a, const std::array<T, N>& column,
                               const std::array<T, N>& row, const T& corner) {
  SquareArray<T, N + 1> out;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) out[i][j] = a[i][j];
    out[i][N] = column[i];
    out[N][i] = row[i];
  }
  out[N][N] = corner;
  return out;
}

/// d(I nu) along the kernel of [dG/d ln x  dG/d ln nu], but for its length: zero where |pi| turns.
/// inertia_slope: dI/d ln x.
template <class T, std::size_t N>
T momentum_turn(const SquareArray<T, N>& jacobian, const std::array<T, N>& nu_slope,
                const std::array<T, N>& inertia_slope, const T& inertia) {
  return determinant(bordered(jacobian, nu_slope, inertia_slope, inertia));
}

}  // namespace stationary
