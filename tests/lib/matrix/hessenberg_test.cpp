// Small eigenvalue problems in pairs of doubles against the same in 100 digits: characteristic
// polynomials, their real factors, the shifted QR algorithm, null vectors.
#include "lib/matrix/hessenberg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "lib/number/real_factors.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/shifted_qr.hpp"

namespace stationary {
namespace {

using namespace support;
constexpr std::size_t n = 5;

struct Given {
  Square<DoubleDouble, n> pairs;
  Square<Real100, n> wide;
  Square<double, n> plain;
};

Given random_matrix(Random& random) {
  Given out;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double x = random.uniform(-1.0, 1.0) * (random.integer(0, 4) == 0 ? 0.0 : 1.0);
      out.pairs[i][j] = out.plain[i][j] = x;
      out.wide[i][j] = x;
    }
  }
  return out;
}

TEST(Hessenberg, PolynomialKeepsItsDigits) {
  Random random(811);
  for (int k = 0; k < 300; ++k) {
    const Given A = random_matrix(random);
    const HessenbergPolynomial<DoubleDouble, n> p(Hessenberg<DoubleDouble, n>(A.pairs).h);
    const HessenbergPolynomial<Real100, n> exact(Hessenberg<Real100, n>(A.wide).h);
    for (std::size_t j = 0; j <= n; ++j) {
      const Real100 off = abs(Real100(support::exact<Real100>(p.c[j]) - exact.c[j]));
      EXPECT_LE(nearest(off), 0x1p-96 * p.magnitude[j]) << k << ", coefficient " << j;
    }
  }
}

TEST(Hessenberg, NullVectorsAreThoseOfTheMatrixGiven) {
  Random random(812);
  int seen = 0;
  for (int k = 0; k < 300; ++k) {
    const Given A = random_matrix(random);
    const Hessenberg<DoubleDouble, n> similar(A.pairs);
    Square<double, n> h;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) h[i][j] = leading(similar.h[i][j]);
    const auto values = shifted_qr<DoubleDouble, n>(similar.h);
    ASSERT_TRUE(values);
    for (const auto& value : *values) {
      const std::complex<double> lambda(leading(value.re), leading(value.im));
      const NullSpace<std::complex<double>, n> space(h, lambda);
      auto x = space.right();
      auto y = space.left();
      similar.similarity.carry_right(x);
      similar.similarity.carry_left(y);
      double right = 0.0;
      double left = 0.0;
      double largest_right = 0.0;
      double largest_left = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        std::complex<double> row = -lambda * x[i];
        std::complex<double> column = -lambda * y[i];
        for (std::size_t j = 0; j < n; ++j) {
          row += A.plain[i][j] * x[j];
          column += A.plain[j][i] * y[j];
        }
        right = std::max(right, std::abs(row));
        left = std::max(left, std::abs(column));
        largest_right = std::max(largest_right, std::abs(x[i]));
        largest_left = std::max(largest_left, std::abs(y[i]));
      }
      EXPECT_LE(right, 1e-12 * largest_right) << k;
      EXPECT_LE(left, 1e-12 * largest_left) << k;
      ++seen;
    }
  }
  EXPECT_EQ(seen, 1500);
}

/// |found - exact| of each eigenvalue in 100 digits, the nearest found.
template <class Found>
double farthest(const Found& found, const std::array<ComplexOf<Real100>, n>& exact) {
  double worst = 0.0;
  for (const auto& value : exact) {
    double least = HUGE_VAL;
    for (const auto& [re, im] : found) {
      const Real100 off_re = re - value.re;
      const Real100 off_im = im - value.im;
      least = std::min(least, std::hypot(nearest(off_re), nearest(off_im)));
    }
    worst = std::max(worst, least);
  }
  return worst;
}

TEST(Hessenberg, EigenvaluesByFactorsAndByQr) {
  Random random(813);
  int converged = 0;
  for (int k = 0; k < 300; ++k) {
    const Given A = random_matrix(random);
    const Hessenberg<DoubleDouble, n> similar(A.pairs);
    const auto exact = shifted_qr<Real100, n>(Hessenberg<Real100, n>(A.wide).h);
    const auto pairs = shifted_qr<DoubleDouble, n>(similar.h);
    ASSERT_TRUE(exact && pairs);
    std::vector<std::pair<Real100, Real100>> by_qr;
    for (const auto& z : *pairs)
      by_qr.emplace_back(support::exact<Real100>(z.re), support::exact<Real100>(z.im));
    // A double root is one in 1e-15 of them.
    EXPECT_LE(farthest(by_qr, *exact), 1e-18) << k;
    const auto factors =
        real_factors<DoubleDouble, n>(HessenbergPolynomial<DoubleDouble, n>(similar.h).c);
    if (!factors.converged) continue;
    ++converged;
    std::vector<std::pair<Real100, Real100>> by_factors;
    by_factors.emplace_back(support::exact<Real100>(factors.single), 0);
    for (const auto& f : factors.quadratic) {
      const auto pair = quadratic_roots(support::exact<Real100>(f.b), support::exact<Real100>(f.c));
      if (pair.real()) {
        by_factors.emplace_back(pair.small, 0);
        by_factors.emplace_back(pair.large, 0);
      } else {
        const Real100 im = sqrt(Real100(-pair.separation));
        by_factors.emplace_back(pair.mean, im);
        by_factors.emplace_back(pair.mean, -im);
      }
    }
    EXPECT_LE(farthest(by_factors, *exact), 1e-18) << k;
  }
  EXPECT_GE(converged, 270);
}

/// (x - 1)(x + 1 - d)(x + 1 + d)(x^2 + x + 3): the two near -1 share a factor, to the last.
TEST(RealFactors, TellTwoCloseRootsApart) {
  for (const double d : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Real100 square = Real100(d) * d;
    const Real100 quadratic[3] = {1 - square, 2, 1};
    const Real100 others[4] = {-3, 2, 0, 1};  // (x - 1)(x^2 + x + 3)
    std::array<Real100, n + 1> wide{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) wide[i + j] += quadratic[i] * others[j];
    std::array<DoubleDouble, n + 1> c;
    for (std::size_t k = 0; k <= n; ++k) {
      const double hi = nearest(wide[k]);
      c[k] = {hi, nearest(Real100(wide[k] - hi))};
    }
    const auto factors = real_factors<DoubleDouble, n>(c);
    ASSERT_TRUE(factors.converged) << d;
    double best = HUGE_VAL;
    for (const auto& f : factors.quadratic) {
      const auto pair = quadratic_roots(f.b, f.c);
      best = std::min(best, std::abs(leading(pair.separation) - nearest(square)));
    }
    EXPECT_LE(best, 1e-29) << d;
  }
}

TEST(RealFactors, SayWhereThreeRootsAreOne) {
  std::array<DoubleDouble, n + 1> c{};  // (x + 1)^3 (x^2 + 4)
  const double exact[n + 1] = {4.0, 12.0, 13.0, 7.0, 3.0, 1.0};
  for (std::size_t k = 0; k <= n; ++k) c[k] = exact[k];
  EXPECT_FALSE((real_factors<DoubleDouble, n>(c).converged));
}

}  // namespace
}  // namespace stationary
