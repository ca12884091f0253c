// The Lambda of a leaf from its characteristic polynomial in pairs of doubles, with bounds of what
// the arithmetic left: a root moves by |dp(Lambda)|/|p'(Lambda)|, one of a quadratic factor p = f g
// by |dp/g|/|f'| or, where its two meet, by the square root of |dp/g|.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lib/matrix/hessenberg.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/real_factors.hpp"

namespace stationary {

/// Lambda of n pairs. A conjugate pair stands in two neighbours, im > 0 first.
template <std::size_t n>
struct LeafRoots {
  std::array<std::complex<double>, n> lambda;
  std::array<double, n> error;  ///< of the arithmetic, without the rounding to double
  std::size_t forced = n;       ///< which one a symmetry makes zero
  bool sure = true;             ///< else the factors did not stand apart

  void set_pair(std::size_t at, const RootPair<DoubleDouble>& pair) {
    if (pair.real()) {
      lambda[at] = leading(pair.small);
      lambda[at + 1] = leading(pair.large);
    } else {
      const double im = std::sqrt(-leading(pair.separation));
      lambda[at] = {leading(pair.mean), im};
      lambda[at + 1] = {leading(pair.mean), -im};
    }
  }
};

/// c: monic, magnitude: the sums of its terms' magnitudes. The first `left_out` Lambda are zero.
template <std::size_t n, std::size_t left_out>
LeafRoots<n> leaf_roots(const std::array<DoubleDouble, n + 1>& c,
                        const std::array<double, n + 1>& magnitude) {
  constexpr std::size_t degree = n - left_out;
  constexpr double unit = 0x1p-96;  // some of pair arithmetic, for each of the terms
  LeafRoots<n> out;
  for (std::size_t k = 0; k < left_out; ++k) {
    out.lambda[k] = 0.0;
    out.error[k] = 0.0;
    out.forced = k;
  }
  if constexpr (degree > 0) {
    std::array<DoubleDouble, degree + 1> monic;
    for (std::size_t k = 0; k <= degree; ++k) monic[k] = c[k + left_out];
    const auto factors = real_factors<DoubleDouble, degree>(monic);
    out.sure = factors.converged;
    std::size_t at = left_out;
    if constexpr (degree % 2 == 1) out.lambda[at++] = leading(factors.single);
    const std::size_t pairs = at;
    std::array<double, n> half{};  // the distance from the other root of the factor
    for (const auto& f : factors.quadratic) {
      const RootPair<DoubleDouble> pair = quadratic_roots(f.b, f.c);
      out.set_pair(at, pair);
      half[at] = half[at + 1] = std::sqrt(std::abs(leading(pair.separation)));
      at += 2;
    }
    for (std::size_t k = left_out; k < n; ++k) {
      const double size = modulus(out.lambda[k]);
      double terms = magnitude[n];
      for (std::size_t j = n; j-- > left_out;) terms = terms * size + magnitude[j];
      double others = 1.0;
      for (std::size_t j = left_out; j < n; ++j) {
        const bool together = k >= pairs && j >= pairs && (k - pairs) / 2 == (j - pairs) / 2;
        if (j != k && !together) others *= one_norm(out.lambda[k] - out.lambda[j]);
      }
      const double off = unit * terms / others;
      out.error[k] = k < pairs                 ? off
                     : off < half[k] * half[k] ? off / half[k]
                                               : 2.0 * std::sqrt(off);
      out.sure = out.sure && out.error[k] < HUGE_VAL;
    }
  }
  return out;
}

}  // namespace stationary
