// The parts of a leaf (symplectic_leaf.hpp) that do not see each other. A part has with its momenta
// modes of its own,
//
//   det(s - J E'') = P(s^2).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "lib/leaf/symplectic_leaf.hpp"
#include "lib/matrix/characteristic.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/polynomial.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

/// What divides the leaf of a motion. Where it turns about neither, it is one part.
struct LeafParts {
  bool turns = true;
  bool about_third = false;  ///< nu along axis 3: b; alpha, xi, zeta; rho. At rest all but b
  bool straight = false;     ///< about axis 1 or 2, alpha = 0, V even: b, alpha; xi, zeta, rho
  bool coupled = true;       ///< rho is not left to itself
  bool volume_held = false;  ///< rho is no coordinate

  LeafShape shape() const { return {turns, volume_held}; }
  bool divided() const { return !turns || about_third || straight; }
};

/// visit(block, coordinates) of each part, an array of their places in the leaf's rows; an undivided
/// leaf is an even block, as its modes have it.
template <class Visit>
void for_each_leaf_part(const LeafParts& of, const Visit& visit) {
  const auto part = [&](Block block, auto... places) {
    visit(block, std::array<std::size_t, sizeof...(places)>{static_cast<std::size_t>(places)...});
  };
  if (!of.turns || of.about_third) {
    const std::size_t alpha = of.turns ? 1 : 0;
    if (of.turns) part(Block::odd, 0);
    if (of.coupled && !of.volume_held) {
      part(Block::even, alpha, alpha + 1, alpha + 2, alpha + 3);
      return;
    }
    if (!of.volume_held) part(Block::thickness, alpha + 3);
    part(Block::even, alpha, alpha + 1, alpha + 2);
  } else if (of.straight) {
    part(Block::odd, 0, 1);
    if (of.volume_held) {
      part(Block::even, 2, 3);
    } else {
      part(Block::even, 2, 3, 4);
    }
  } else if (of.volume_held) {
    part(Block::even, 0, 1, 2, 3);
  } else {
    part(Block::even, 0, 1, 2, 3, 4);
  }
}

inline double largest_of(const Interval& x) { return x.magnitude(); }
template <std::size_t N>
double largest_of(const Dual<Interval, N>& x) {
  return x.value.magnitude();
}

/// E'' of these coordinates and their momenta, both diagonals alike in size: x_k -> c_k x_k,
/// p_k -> p_k/c_k with powers of two. pairs: of the whole.
template <std::size_t n, class T>
SquareForm<T, 2 * n> leaf_part(const LeafForm<T>& whole, std::size_t pairs,
                               const std::array<std::size_t, n>& coordinates) {
  std::array<std::size_t, 2 * n> place;
  std::array<double, 2 * n> scale;
  for (std::size_t k = 0; k < n; ++k) {
    place[k] = coordinates[k];
    place[n + k] = pairs + coordinates[k];
    const double q = largest_of(whole[place[k]][place[k]]);
    const double p = largest_of(whole[place[n + k]][place[n + k]]);
    const double power = std::round(0.25 * log(p / q) / double_double_log_two.hi);
    const bool usable = std::abs(power) < 600.0;  // else one of them is zero, or not finite
    scale[k] = usable ? std::ldexp(1.0, static_cast<int>(power)) : 1.0;
    scale[n + k] = 1.0 / scale[k];
  }
  SquareForm<T, 2 * n> out;
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < 2 * n; ++j)
      out[i][j] = (scale[i] * scale[j]) * whole[place[i]][place[j]];
  return out;
}

/// P of E'' in n coordinates and their momenta.
template <std::size_t n, class T>
Polynomial<T, static_cast<int>(n)> in_squares(const SquareForm<T, 2 * n>& E) {
  SquareForm<T, 2 * n> H;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < 2 * n; ++j) {
      H[i][j] = E[n + i][j];
      H[n + i][j] = -E[i][j];
    }
  }
  const auto c = characteristic(H, /*even=*/true);
  Polynomial<T, static_cast<int>(n)> out;
  for (std::size_t k = 0; k <= n; ++k) out.c[k] = c[2 * k];
  return out;
}

}  // namespace stationary
