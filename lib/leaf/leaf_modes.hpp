// What the eigenproblem of a leaf gives for each Lambda.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

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
};

struct LeafFacts {
  bool forced_zero;
  double uncertainty;
};

/// Energies below this of their terms' magnitudes have no sign.
constexpr double energy_doubt = 0x1p-50;

}  // namespace stationary
