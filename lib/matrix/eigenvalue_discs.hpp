// Where the eigenvalues of a matrix may go whose eigenvectors are known: in the basis of these it
// is diag(Lambda) + D, |D_ij| <= d_ij for all inputs within their uncertainty, and Gershgorin's
// discs hold them, each apart from the others once its own coordinate is scaled by tau:
//
//   |change of Lambda_i| <= d_ii + (sum over j != i of d_ij)/(1 + tau).
//
// Only for eigenvalues that stand apart: where discs come near each other the eigenvectors, and
// with them D, are no longer known well enough from arithmetic in double.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>

#include "lib/matrix/hessenberg.hpp"

namespace stationary {

/// Two discs together may be this much of the distance of their centers.
constexpr double discs_apart = 0x1p-10;

/// Bounds of |change of Lambda_i|; nothing where two discs are not apart, or d is not finite.
template <std::size_t n>
std::optional<std::array<double, n>> eigenvalue_discs(
    const std::array<std::complex<double>, n>& lambda, const Square<double, n>& d) {
  std::array<double, n> radius;
  for (std::size_t i = 0; i < n; ++i) {
    radius[i] = 0.0;
    for (std::size_t j = 0; j < n; ++j) radius[i] += d[i][j];
    if (!(radius[i] < HUGE_VAL)) return std::nullopt;
  }
  std::array<double, n> out;
  for (std::size_t i = 0; i < n; ++i) {
    double tau = 0x1p60;
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const double distance = modulus(lambda[i] - lambda[j]);
      if (!(radius[i] + radius[j] <= discs_apart * distance)) return std::nullopt;
      // Half the distance is each one's own.
      const double room = 0.5 * distance - radius[j];
      if (room < tau * d[j][i]) tau = room / d[j][i];
    }
    out[i] = d[i][i] + (radius[i] - d[i][i]) / (1.0 + tau);
  }
  return out;
}

}  // namespace stationary
