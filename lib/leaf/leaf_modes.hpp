// What is had of each Lambda of a leaf, (J E'')^2 x = Lambda x (symplectic_leaf.hpp).
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lib/matrix/eigenvalue_discs.hpp"

namespace stationary {

template <std::size_t n>
struct LeafModes {
  std::array<std::complex<double>, n> lambda{};  ///< conjugates next to each other, im > 0 first
  std::array<double, n> error;                   ///< bounds of |change|
  std::array<int, n> energy{};  ///< sign of E'' on the mode where Lambda < 0; 0 where it has none
  std::size_t forced = n;       ///< which one a symmetry makes zero; n: none
  int negative;                 ///< negative directions of E''
  bool definite;                ///< E'' is positive, for all inputs within their uncertainty

  LeafModes() { error.fill(HUGE_VAL); }

  /// Of vectors in whose basis changes of the inputs are below d (eigenvalue_discs.hpp), rounding as
  /// much as is given. False where two Lambda are too close, or rounding is not small beside d.
  bool set_errors(const Square<double, n>& d, const std::array<double, n>& rounding) {
    const auto discs = eigenvalue_discs(lambda, d);
    if (!discs) return false;
    error = *discs;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != forced && !(rounding[i] <= 0x1p-8 * error[i])) return false;
      error[i] += rounding[i] + 0x1p-53 * one_norm(lambda[i]);
    }
    return true;
  }
};

/// What is known of a leaf beside its matrix.
struct LeafFacts {
  bool forced_zero;    ///< by a symmetry, one Lambda is exactly 0
  double uncertainty;  ///< relative, of each input of the matrix
};

/// Energies below this of their terms' magnitudes have no sign.
constexpr double energy_doubt = 0x1p-50;

/// Of an energy over its terms' magnitudes: 0 where it has no sign.
constexpr int energy_sign(double relative) {
  return relative > energy_doubt ? 1 : relative < -energy_doubt ? -1 : 0;
}
/// Of two that have one sign.
inline int energy_sign(double x, double y) {
  return energy_sign(std::abs(x) > std::abs(y) ? x : y);
}

}  // namespace stationary
