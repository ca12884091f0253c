// Characteristic polynomials over matrices of intervals: what 50 digits have of a matrix in them is in
// them, they are not wider than the matrices ask, and their slopes are those of the coefficients.
#include "lib/matrix/characteristic.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using support::Real50;
constexpr std::size_t size = 6;

SquareForm<double, size> matrix_of(support::Random& random, double entries) {
  SquareForm<double, size> out;
  for (auto& row : out)
    for (double& entry : row) entry = random.uniform(-entries, entries);
  return out;
}

template <class T, class S>
SquareForm<T, size> as(const SquareForm<S, size>& M) {
  SquareForm<T, size> out;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) out[i][j] = T(M[i][j]);
  return out;
}

SquareForm<Interval, size> around(const SquareForm<double, size>& M, double relative) {
  SquareForm<Interval, size> out;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      const double radius = relative * std::abs(M[i][j]);
      out[i][j] = {M[i][j] - radius, M[i][j] + radius};
    }
  return out;
}

TEST(Characteristic, HoldsThatOfEveryMatrix) {
  support::Random random(20261128);
  for (int k = 0; k < 200; ++k) {
    const SquareForm<double, size> M = matrix_of(random, 10.0);
    const double relative = k % 2 == 0 ? 1e-13 : 1e-2;  // by the middle, and without it
    const auto held = characteristic(around(M, relative));
    for (int member = 0; member < 4; ++member) {
      SquareForm<Real50, size> one = as<Real50>(M);
      for (auto& row : one)
        for (Real50& entry : row) entry *= 1 + relative * random.uniform(-1.0, 1.0);
      const CharacteristicRecursion<Real50, size> exact(one, false);
      for (std::size_t i = 0; i <= size; ++i) {
        EXPECT_LE(Real50(held[i].lo), exact.c[i]) << k << " " << i;
        EXPECT_LE(exact.c[i], Real50(held[i].hi)) << k << " " << i;
      }
    }
  }
}

/// Of matrices known to 1e-15 a coefficient is known to as much of its own terms; the recursion in
/// intervals alone would know two digits less.
TEST(Characteristic, IsAsNarrowAsTheMatrix) {
  support::Random random(20261129);
  for (int k = 0; k < 50; ++k) {
    const SquareForm<double, size> M = matrix_of(random, 10.0);
    const auto box = around(M, 1e-15);
    const CharacteristicRecursion<Interval, size> alone(box, false);
    const auto held = about_middle(box, alone, false);
    const CharacteristicRecursion<double, size> near(M, false);
    for (std::size_t order = 1; order <= size; ++order) {
      double terms = 0.0;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) terms += std::abs(near.N[order - 1][j][i] * M[i][j]);
      EXPECT_LE(held[size - order].width(), 3e-15 * terms) << k << " " << order;
    }
    EXPECT_LT(held[0].width(), 1e-2 * alone.c[0].width());
  }
}

/// Where half the digits are lost the middle is asked.
TEST(Characteristic, AsksTheMiddleWhereItMust) {
  support::Random random(20261201);
  SquareForm<double, size> M = matrix_of(random, 1.0);
  for (double& entry : M[0]) entry *= 1e-12;  // and with it det M
  const auto box = around(M, 1e-15);
  const CharacteristicRecursion<Interval, size> alone(box, false);
  ASSERT_GT(alone.c[0].width(), 0x1p-26 * alone.c[0].magnitude());
  EXPECT_LT(characteristic(box)[0].width(), 1e-3 * alone.c[0].width());
}

/// Along a line of matrices.
TEST(Characteristic, HasTheSlopesOfItsCoefficients) {
  support::Random random(20261130);
  for (int k = 0; k < 50; ++k) {
    const SquareForm<double, size> M = matrix_of(random, 4.0);
    const SquareForm<double, size> along = matrix_of(random, 1.0);
    SquareForm<Dual<Interval, 1>, size> line;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) line[i][j] = {M[i][j], {Interval(along[i][j])}};
    const auto held = characteristic(line);
    const auto at = [&](const Real50& t) {
      SquareForm<Real50, size> moved = as<Real50>(M);
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) moved[i][j] += t * along[i][j];
      return CharacteristicRecursion<Real50, size>(moved, false).c;
    };
    const Real50 h("1e-16");
    const auto ahead = at(h);
    const auto behind = at(-h);
    for (std::size_t i = 0; i <= size; ++i) {
      const double slope = double((ahead[i] - behind[i]) / (2 * h));
      const Interval& found = held[i].slope[0];
      EXPECT_NEAR(found.mid(), slope, 1e-11 * (1.0 + std::abs(slope))) << k << " " << i;
      EXPECT_TRUE((found - Interval(slope)).may_be(0.0)) << k << " " << i;
    }
  }
}

/// A Hamiltonian matrix: the odd coefficients are zero, exactly, and where the others are known well
/// enough the middle is not asked.
TEST(Characteristic, OfAHamiltonianMatrixIsEven) {
  support::Random random(20261131);
  SquareForm<Interval, size> H;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Interval entry = Interval::decimal(random.uniform(-3.0, 3.0));
      const auto place = [&](std::size_t a, std::size_t b) -> Interval& {
        return H[(a + size / 2) % size][b];
      };
      place(i, j) = i >= size / 2 ? entry : -entry;
      place(j, i) = j >= size / 2 ? entry : -entry;
    }
  }
  const auto even = characteristic(H, true);
  const auto all = characteristic(H);
  const CharacteristicRecursion<Interval, size> alone(H, true);
  for (std::size_t i = 0; i <= size; ++i) {
    if (i % 2 == 1) {
      EXPECT_EQ(even[i].lo, 0.0);
      EXPECT_EQ(even[i].hi, 0.0);
      EXPECT_TRUE(all[i].may_be(0.0));
    } else {
      EXPECT_FALSE(even[i].apart_from(all[i]));
      EXPECT_EQ(even[i].lo, alone.c[i].lo);
      EXPECT_EQ(even[i].hi, alone.c[i].hi);
    }
  }
}

}  // namespace
}  // namespace stationary
