// Numbers along a curve: every value is in the range told, and that is nearer to the values than the
// ranges of the terms.
#include "lib/number/sloped.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stationary {
namespace {

/// x = a + b u.
Sloped line(double a, double b) {
  return {Interval(a) + Interval(b) * Interval(-1.0, 1.0), Interval(a), Interval(b)};
}

/// Every operation, of three lines.
template <class S>
S all_of(const S& x, const S& y, const S& z) {
  const S root = sqrt(square(x) + square(y) + S(0.25));
  S out = (x * y - z) / root + 1.5 * (x - y) * (x + z);
  out += -z / (S(2.0) + square(y));
  out -= x * x * y;
  return out;
}

TEST(Sloped, HoldsEveryValue) {
  std::mt19937_64 random(20261123);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  int narrower = 0;
  constexpr int tries = 2000;
  for (int k = 0; k < tries; ++k) {
    const double size = std::exp2(-8.0 * std::abs(any(random)));
    std::array<double, 3> a;
    std::array<double, 3> b;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = any(random);
      b[i] = size * any(random);
    }
    const std::array lines{line(a[0], b[0]), line(a[1], b[1]), line(a[2], b[2])};
    const Interval found = range(all_of(lines[0], lines[1], lines[2]));
    const Interval plain = all_of(range(lines[0]), range(lines[1]), range(lines[2]));
    for (const double u : {-1.0, -0.6, -0.01, 0.0, 0.3, 0.999, 1.0}) {
      const Interval value =
          all_of(Interval(a[0]) + b[0] * Interval(u), Interval(a[1]) + b[1] * Interval(u),
                 Interval(a[2]) + b[2] * Interval(u));
      EXPECT_FALSE(value.apart_from(found)) << k << " at u = " << u;
    }
    EXPECT_TRUE(found.within(plain)) << k;
    if (found.width() < 0.7 * plain.width()) ++narrower;
  }
  EXPECT_GT(narrower, tries / 3);
}

/// x - x and x (1 - x) about 1/2: what ranges alone never tell.
TEST(Sloped, KnowsWhatVariesAlike) {
  const Sloped x = line(0.5, 0.01);
  EXPECT_LT(range(x - x).width(), 1e-15);
  const Interval parabola = range(x * (Sloped(1.0) - x));
  EXPECT_LT(parabola.width(), 5e-4);
  EXPECT_TRUE(parabola.may_be(0.25));
  EXPECT_TRUE(parabola.may_be(0.25 - 1e-4));
}

/// Without slopes it is the interval.
TEST(Sloped, OfUnboundedSlopesIsItsRange) {
  const Sloped x(Interval(1.0, 2.0), Interval(1.5), Interval::entire());
  const Interval twice = range(x + x);
  const Interval plain = Interval(1.0, 2.0) + Interval(1.0, 2.0);
  EXPECT_EQ(twice.lo, plain.lo);
  EXPECT_EQ(twice.hi, plain.hi);
}

}  // namespace
}  // namespace stationary
