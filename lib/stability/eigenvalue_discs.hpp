// Where the eigenvalues of a matrix may go whose eigenvectors are known: in the basis of these it
// is diag(Lambda) + D, |D_ij| <= d_ij for all inputs within their uncertainty, and Gershgorin's
// discs hold them, each apart from the others once its own coordinate is scaled:
//
//   Lambda_i + D_ii + sum over j of D_ij D_ji/(distance)...  <=  d_ii + (sum over j of d_ij)/tau.
//
// Discs that touch are one region for all eigenvalues in them. Not a first-order estimate: near a
// collision the region is as wide as the square root that Lambda follows there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lib/number/hessenberg.hpp"

namespace stationary {

/// Bounds of |change of Lambda_i|; infinite where d is not finite.
template <std::size_t n>
std::array<double, n> eigenvalue_discs(const std::array<std::complex<double>, n>& lambda,
                                       const Square<double, n>& d) {
  if constexpr (n == 1) return {d[0][0]};
  std::array<double, n> radius;
  Square<double, n> apart;
  for (std::size_t i = 0; i < n; ++i) {
    radius[i] = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      radius[i] += d[i][j];
      apart[i][j] = j < i ? apart[j][i]
                    : lambda[i].imag() == lambda[j].imag()
                        ? std::abs(lambda[i].real() - lambda[j].real())
                        : std::abs(lambda[i] - lambda[j]);
    }
  }
  std::array<double, n> out = radius;
  for (std::size_t i = 0; i < n; ++i) {
    // Half the distance to each of the others is its own.
    double tau = 0x1p60;
    bool alone = true;
    for (std::size_t j = 0; j < n && alone; ++j) {
      if (j == i) continue;
      const double room = 0.5 * apart[i][j] - radius[j];
      alone = room > 0.0 && radius[i] < 0.5 * apart[i][j];
      if (room < tau * d[j][i]) tau = room / d[j][i];
    }
    if (alone) {
      out[i] = d[i][i] + (radius[i] - d[i][i]) / (1.0 + tau);
      continue;
    }
    // All of the region its disc belongs to.
    std::array<bool, n> member{};
    member[i] = true;
    for (std::size_t pass = 0; pass < n; ++pass)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < n; ++k)
          if (member[k] && !(apart[j][k] > radius[j] + radius[k])) member[j] = true;
    for (std::size_t j = 0; j < n; ++j) {
      if (!member[j]) continue;
      const double reach = apart[i][j] + radius[j];
      out[i] = std::isnan(reach) ? HUGE_VAL : std::fmax(out[i], reach);
    }
  }
  return out;
}

}  // namespace stationary
