// Squares of Hamiltonian matrices, H = J E, reduced with their structure: eigenvalues and vectors.
#include "lib/matrix/skew_hamiltonian.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/shifted_qr.hpp"

namespace stationary {
namespace {

using namespace support;

/// Of a symmetric E; zeros: every so many entries are.
template <class S, std::size_t n>
Square<S, 2 * n> hamiltonian(Random random, int zeros) {
  constexpr std::size_t N = 2 * n;
  Square<S, N> E;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      E[i][j] = E[j][i] =
          S(random.uniform(-1.0, 1.0) * (i != j && random.integer(0, 5) < zeros ? 0.0 : 1.0));
  Square<S, N> H;
  for (std::size_t j = 0; j < N; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      H[i][j] = E[n + i][j];
      H[n + i][j] = -E[i][j];
    }
  }
  return H;
}

template <std::size_t n>
void expect_reduced(unsigned seed, int zeros, int& vectors) {
  constexpr std::size_t N = 2 * n;
  const Random random(seed);
  const auto H = hamiltonian<DoubleDouble, n>(random, zeros);
  const SkewHamiltonian<DoubleDouble, n> reduced(H);
  const auto& a = reduced.hessenberg();
  for (std::size_t i = 2; i < n; ++i)
    for (std::size_t j = 0; j + 1 < i; ++j) EXPECT_EQ(leading(a[i][j]), 0.0);

  // det(Lambda - A') is det(s - H).
  const HessenbergPolynomial<DoubleDouble, n> p(a);
  const HessenbergPolynomial<Real100, N> exact(
      Hessenberg<Real100, N>(hamiltonian<Real100, n>(random, zeros)).h);
  for (std::size_t k = 0; k <= n; ++k) {
    const Real100 off = abs(Real100(support::exact<Real100>(p.c[k]) - exact.c[2 * k]));
    EXPECT_LE(nearest(off), 0x1p-92 * p.magnitude[k]) << n << ", " << seed << ", " << k;
  }

  const auto values = shifted_qr<DoubleDouble, n>(a);
  ASSERT_TRUE(values);
  Square<double, n> plain;
  Square<double, N> h;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) plain[i][j] = leading(a[i][j]);
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) h[i][j] = leading(H[i][j]);
  for (const auto& value : *values) {
    const std::complex<double> lambda(leading(value.re), leading(value.im));
    const auto X =
        reduced.similarity().carry(NullSpace<std::complex<double>, n>(plain, lambda).right());
    const auto turned = [&](const auto& x) {
      std::array<std::complex<double>, N> out{};
      for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) out[i] += h[i][j] * x[j];
      return out;
    };
    const auto twice = turned(turned(X));
    double off = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      off = std::max(off, std::abs(twice[i] - lambda * X[i]));
      size = std::max(size, std::abs(X[i]));
    }
    EXPECT_LE(off, 1e-11 * size) << n << ", " << seed;
    ++vectors;
  }
}

TEST(SkewHamiltonian, HasTheEigenvaluesAndVectorsOfTheSquare) {
  int vectors = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    for (const int zeros : {0, 2, 4}) {
      expect_reduced<2>(900 + seed, zeros, vectors);
      expect_reduced<3>(900 + seed, zeros, vectors);
      expect_reduced<4>(900 + seed, zeros, vectors);
      expect_reduced<5>(900 + seed, zeros, vectors);
    }
  }
  EXPECT_EQ(vectors, 300 * (2 + 3 + 4 + 5));
}

/// Q = R = 0: F and G are zero from the start, and nothing is turned.
TEST(SkewHamiltonian, TakesZerosAsTheyAre) {
  Square<double, 6> H{};
  for (std::size_t i = 0; i < 3; ++i) {
    H[i][i] = 1.0 + static_cast<double>(i);
    H[3 + i][3 + i] = -H[i][i];
  }
  const SkewHamiltonian<double, 3> reduced(H);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(reduced.hessenberg()[i][j], i == j ? H[i][i] * H[i][i] : 0.0);
    std::array<double, 3> x{};
    x[i] = 1.0;
    std::array<double, 6> wide{};
    wide[i] = 1.0;
    EXPECT_EQ(reduced.similarity().carry(x), wide);
  }
}

}  // namespace
}  // namespace stationary
