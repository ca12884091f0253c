// Roots of cubics that lie apart are rounded once; others are left to polynomial.hpp.
#include "lib/balanced/separated_roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/balanced/spin_units.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

Polynomial<DoubleDouble, 3> with_roots(double a, double b, double c) {
  const DoubleDouble x(a);
  const DoubleDouble y(b);
  const DoubleDouble z(c);
  return {{-(x * y * z), x * y + (x + y) * z, -(x + y + z), DoubleDouble(1.0)}};
}

TEST(SeparatedRoots, AreRoundedOnce) {
  support::Random random(5);
  int found = 0;
  for (int k = 0; k < 20'000; ++k) {
    std::array<double, 3> exact;
    for (double& each : exact)
      each =
          (random.uniform(0.0, 1.0) < 0.8 ? -1.0 : 1.0) * std::pow(10.0, random.uniform(-1.5, 1.5));
    std::sort(exact.begin(), exact.end());
    const SeparatedRoots roots = separated_roots(with_roots(exact[0], exact[1], exact[2]));
    if (!roots.found) continue;
    ++found;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto nearest = std::min_element(exact.begin(), exact.end(), [&](double a, double b) {
        return std::abs(a - roots.root[i]) < std::abs(b - roots.root[i]);
      });
      EXPECT_LE(std::abs(roots.root[i] - *nearest), 0x1p-53 * std::abs(*nearest));
      double slope = 1.0;
      double gap = std::numeric_limits<double>::infinity();
      for (auto other = exact.begin(); other != exact.end(); ++other) {
        if (other == nearest) continue;
        slope *= *nearest - *other;
        gap = std::min(gap, std::abs(*nearest - *other));
      }
      EXPECT_NEAR(roots.slope[i], slope, 1e-6 * std::abs(slope));
      EXPECT_NEAR(roots.gap[i], gap, 1e-6 * gap);
    }
  }
  EXPECT_GT(found, 15'000);
}

TEST(SeparatedRoots, NoneThatAreCloseOrComplex) {
  EXPECT_TRUE(separated_roots(with_roots(-1.0, -2.0, -5.0)).found);
  EXPECT_FALSE(separated_roots(with_roots(-1.0, -1.0, -5.0)).found);
  EXPECT_FALSE(separated_roots(with_roots(-1.0, -1.0 - 1e-4, -5.0)).found);
  EXPECT_FALSE(separated_roots(with_roots(-3.0, -3.0, -3.0)).found);
  EXPECT_FALSE(separated_roots(with_roots(0.0, 0.0, 0.0)).found);
  const DoubleDouble one(1.0);
  const Polynomial<DoubleDouble, 3> turned{{one, one, one, one}};  // -1, i, -i
  EXPECT_FALSE(separated_roots(turned).found);
}

/// A root far smaller than the distance of the others cannot be had to its own last place from theirs.
TEST(SeparatedRoots, OneNextToZeroIsRoundedOnceOrRefused) {
  support::Random random(6);
  int found = 0;
  int refused = 0;
  for (int k = 0; k < 2000; ++k) {
    const double small = -std::pow(10.0, random.uniform(-24.0, -6.0));
    const double one = -random.uniform(0.5, 2.0);
    const double other = one - random.uniform(0.05, 0.3);
    const SeparatedRoots roots = separated_roots(with_roots(small, one, other));
    ++(roots.found ? found : refused);
    if (!roots.found) continue;
    for (const double exact : {small, one, other}) {
      double off = std::numeric_limits<double>::infinity();
      for (const double root : roots.root) off = std::min(off, std::abs(root - exact));
      EXPECT_LE(off, 0x1p-53 * std::abs(exact)) << small << " " << one << " " << other;
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(refused, 200);
}

TEST(SpinUnits, ArePowersOfTwo) {
  for (const double x : {1.0, 1.5, 1.999, -3.7, 1e-200, 1e200, 0.1}) {
    int exponent = 0;
    EXPECT_EQ(std::frexp(reciprocal_power(x), &exponent), 0.5);
    const double unit = std::abs(x) * reciprocal_power(x);
    EXPECT_GE(unit, 1.0);
    EXPECT_LT(unit, 2.0);
  }
  const SpinUnits units(6.0, 0.3);
  EXPECT_EQ(units.inertia, 0.25);
  EXPECT_EQ(units.rate, 4.0);
  EXPECT_EQ(units.energy, 4.0);
}

}  // namespace
}  // namespace stationary
