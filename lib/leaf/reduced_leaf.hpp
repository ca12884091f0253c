// The eigenvalue problem of a leaf in pairs of doubles, as far as the polynomial of its Lambda:
//
//   reversible  Lambda x = -B A x        to Hessenberg form (hessenberg.hpp)
//   whole       Lambda x = (J E'')^2 x   with its structure (skew_hamiltonian.hpp)
//
// P: the kind of pair, DoubleDouble or FusedPair (fused.hpp), which give the same bits.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "lib/matrix/hessenberg.hpp"
#include "lib/matrix/skew_hamiltonian.hpp"

namespace stationary {

/// det(Lambda - h), and h; the way from vectors of h to those of what was given, of type T.
template <std::size_t n, class T>
struct ReducedLeaf {
  T similarity;
  Square<double, n> h;
  double h_size = 0.0;  ///< its largest entry
  std::array<DoubleDouble, n + 1> c;
  std::array<double, n + 1> magnitude;  ///< as of HessenbergPolynomial
  double unit = 1.0;                    ///< what was given is in this, a power of two
};
template <std::size_t n>
using ReducedProduct = ReducedLeaf<n, Similarity<n>>;
template <std::size_t n>
using ReducedSquare = ReducedLeaf<n, SymplecticSimilarity<n>>;

template <std::size_t n>
using Scales = std::array<double, n>;

namespace reduced_detail {

template <class P>
[[gnu::always_inline]] inline P pair_of(const DoubleDouble& x, double by) {
  return {x.hi * by, x.lo * by};
}

/// A power of two that makes the largest entry one of [1, 2); divides by it.
template <class P, std::size_t N>
[[gnu::always_inline]] inline double divide_by_unit(Square<P, N>& A) {
  double largest = 0.0;
  for (const auto& row : A)
    for (const P& entry : row) largest = std::fmax(largest, std::abs(double(entry.hi)));
  if (!(largest > 0.0 && largest < HUGE_VAL)) return 1.0;
  const double unit = std::scalbn(1.0, std::ilogb(largest));
  for (auto& row : A) {
    for (P& entry : row) {
      entry.hi = entry.hi / unit;
      entry.lo = entry.lo / unit;
    }
  }
  return unit;
}

template <class P, std::size_t n, class T>
[[gnu::always_inline]] inline void give(const Square<P, n>& h, const T& similarity,
                                        ReducedLeaf<n, T>& out) {
  out.similarity = similarity;
  out.h_size = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      out.h[i][j] = leading(h[i][j]);
      out.h_size = std::fmax(out.h_size, std::abs(out.h[i][j]));
    }
  }
  const HessenbergPolynomial<P, n> p(h);
  for (std::size_t k = 0; k <= n; ++k) {
    out.c[k] = {double(p.c[k].hi), double(p.c[k].lo)};
    out.magnitude[k] = p.magnitude[k];
  }
}

}  // namespace reduced_detail

/// Of -B A, x_k -> x_k/scale_k.
template <class P, std::size_t n>
void reduce_product(const Square<DoubleDouble, n>& A, const Square<DoubleDouble, n>& B,
                    const Scales<n>& scale, ReducedProduct<n>& out) {
  using reduced_detail::pair_of;
  Square<P, n> M;
  for (std::size_t i = 0; i < n; ++i) {
    M[i].fill(P(0.0));
    for (std::size_t k = 0; k < n; ++k) {
      const P b = pair_of<P>(B[i][k], -1.0);
      if (double(b.hi) == 0.0) continue;
      for (std::size_t j = 0; j < n; ++j) M[i][j] = M[i][j] + b * pair_of<P>(A[k][j], 1.0);
    }
    for (std::size_t j = 0; j < n; ++j) {
      const double by = scale[i] / scale[j];
      M[i][j] = renormalized(M[i][j]);
      M[i][j].hi = M[i][j].hi * by;
      M[i][j].lo = M[i][j].lo * by;
    }
  }
  out.unit = reduced_detail::divide_by_unit(M);
  const Hessenberg<P, n> reduced(M);
  reduced_detail::give(reduced.h, reduced.similarity, out);
}

/// Of (J E)^2, J E x_k -> x_k/scale_k; the unit is that of J E, whose head H is given too.
template <class P, std::size_t n>
void reduce_square(const Square<DoubleDouble, 2 * n>& E, const Scales<2 * n>& scale,
                   Square<double, 2 * n>& H, ReducedSquare<n>& out) {
  Square<P, 2 * n> JE;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    for (std::size_t j = 0; j < 2 * n; ++j) {
      const double by = scale[i] / scale[j] * (i < n ? 1.0 : -1.0);
      JE[i][j] = reduced_detail::pair_of<P>(E[i < n ? n + i : i - n][j], by);
    }
  }
  out.unit = reduced_detail::divide_by_unit(JE);
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < 2 * n; ++j) H[i][j] = leading(JE[i][j]);
  const SkewHamiltonian<P, n> reduced(JE);
  reduced_detail::give(reduced.hessenberg(), reduced.similarity(), out);
}

}  // namespace stationary
