// Every error bound double_double.hpp states, held against 100-digit arithmetic over random and
// adversarial operands: near 1, near cancellation, tiny, huge.
#include "lib/number/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/numbers/double_double_operands.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int double_double_trials = 4000;

Real100 wide(const DoubleDouble& x) { return exact<Real100>(x); }

/// Results are not renormalized, but a tail stays within a few units in the head's last place
/// (where the heads did not cancel).
bool nearly_normalized(const DoubleDouble& x) {
  return std::abs(x.lo) <= 4 * 0x1p-52 * std::abs(x.hi);
}

TEST(DoubleDouble, TwoSumIsExact) {
  Operands operands(501);
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const auto [x, y] = operands.pair();
    const DoubleDouble s = two_sum(x.hi, y.hi);
    ASSERT_EQ(s.hi, x.hi + y.hi);
    ASSERT_EQ(wide(s), Real100(x.hi) + Real100(y.hi)) << at(x.hi, y.hi);
    const bool ordered = std::abs(x.hi) >= std::abs(y.hi);
    const DoubleDouble quick = ordered ? quick_two_sum(x.hi, y.hi) : quick_two_sum(y.hi, x.hi);
    ASSERT_EQ(quick, s) << at(x.hi, y.hi);
  }
  EXPECT_EQ(quick_two_sum(0.0, 3.0), DoubleDouble(3.0));
}

TEST(DoubleDouble, TwoProductIsExact) {
  Operands operands(502);
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const auto [x, y] = operands.pair();
    const DoubleDouble p = two_product(x.hi, y.hi);
    ASSERT_EQ(p.hi, x.hi * y.hi);
    ASSERT_EQ(wide(p), Real100(x.hi) * Real100(y.hi)) << at(x.hi, y.hi);
  }
}

TEST(DoubleDouble, SumAndDifference) {
  Operands operands(503);
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const auto [x, y] = operands.pair();
    const Real100 allowed = ldexp(Real100(abs(wide(x)) + abs(wide(y))), -104);
    const std::string where = at(x.hi, x.lo, y.hi, y.lo);
    ASSERT_TRUE(agrees<Real100>(where, wide(x) + wide(y), wide(x + y), allowed));
    ASSERT_TRUE(agrees<Real100>(where, wide(x) - wide(y), wide(x - y), allowed));
    ASSERT_TRUE(agrees<Real100>(where, wide(x) + y.hi, wide(x + y.hi), allowed));
    ASSERT_TRUE(agrees<Real100>(where, x.hi - wide(y), wide(x.hi - y), allowed));
    ASSERT_TRUE(agrees<Real100>(where, wide(x) - y.hi, wide(x - y.hi), allowed));
    // The rounded value is the sum of the parts.
    ASSERT_TRUE(agrees(where, nearest(wide(x + y)), static_cast<double>(x + y), 0.0));
    DoubleDouble z = x;
    z += y;
    ASSERT_EQ(z, x + y);
    z = x;
    z -= y;
    ASSERT_EQ(z, x - y);
  }
}

TEST(DoubleDouble, ProductAndQuotient) {
  Operands operands(504);
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const auto [x, y] = operands.pair();
    const std::string where = at(x.hi, x.lo, y.hi, y.lo);
    const auto relative = [&](const Real100& expected, const DoubleDouble& actual) {
      return agrees<Real100>(where, expected, wide(actual), ldexp(Real100(abs(expected)), -101));
    };
    ASSERT_TRUE(relative(wide(x) * wide(y), x * y));
    ASSERT_TRUE(relative(wide(x) * y.hi, x * y.hi));
    ASSERT_TRUE(relative(x.hi * wide(y), x.hi * y));
    ASSERT_TRUE(relative(wide(x) / wide(y), x / y));
    ASSERT_TRUE(relative(wide(x) / y.hi, x / y.hi));
    ASSERT_TRUE(relative(x.hi / wide(y), x.hi / y));
    ASSERT_TRUE(nearly_normalized(x * y) && nearly_normalized(x / y)) << where;
    DoubleDouble z = x;
    z *= y;
    ASSERT_EQ(z, x * y);
    z = x;
    z /= y;
    ASSERT_EQ(z, x / y);
  }
}

TEST(DoubleDouble, SquareRoot) {
  Operands operands(505);
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const DoubleDouble x = abs(operands.one());
    const Real100 expected = sqrt(wide(x));
    ASSERT_TRUE(agrees<Real100>(at(x.hi, x.lo), expected, wide(sqrt(x)), ldexp(expected, -101)));
  }
  EXPECT_EQ(sqrt(DoubleDouble(0.0)).hi, 0.0);
  EXPECT_EQ(sqrt(DoubleDouble(2.25)), DoubleDouble(1.5));
  EXPECT_TRUE(std::isnan(sqrt(DoubleDouble(-1.0)).hi));
}

TEST(DoubleDouble, OrderAndSign) {
  Operands operands(506);
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const auto [x, y] = operands.pair();
    ASSERT_EQ(x < y, wide(x) < wide(y)) << at(x.hi, x.lo, y.hi, y.lo);
    ASSERT_EQ(x > y, wide(x) > wide(y)) << at(x.hi, x.lo, y.hi, y.lo);
    ASSERT_EQ(x == y, wide(x) == wide(y)) << at(x.hi, x.lo, y.hi, y.lo);
    ASSERT_EQ(wide(abs(x)), abs(wide(x)));
    ASSERT_EQ(wide(-x), -wide(x));
    ASSERT_EQ(static_cast<double>(x), x.hi);
  }
}

TEST(DoubleDouble, LosesNothingAtTheEndsOfItsRange) {
  // Far enough inside the doubles' range that no tail underflows and no split overflows.
  for (const double a : {0x1.fffffffffffffp899, 0x1.0000000000001p899, 0x1.fffffffffffffp-900}) {
    const DoubleDouble x(a, std::ldexp(a, -54));
    const Real100 expected = wide(x);
    EXPECT_TRUE(agrees<Real100>(at(a), expected * expected / expected,
                                wide((x * DoubleDouble(0.75)) / DoubleDouble(0.75)),
                                ldexp(Real100(abs(expected)), -100)));
    EXPECT_TRUE(agrees<Real100>(at(a), 1 / expected, wide(1.0 / x),
                                ldexp(Real100(abs(1 / expected)), -101)));
    EXPECT_TRUE(agrees<Real100>(at(a), sqrt(expected), wide(sqrt(x)),
                                ldexp(Real100(sqrt(expected)), -101)));
  }
}

TEST(DoubleDouble, RenormalizedIsTheSameNumberInOrder) {
  Operands operands(507);
  int cancelled = 0;
  for (int trial = 0; trial < double_double_trials; ++trial) {
    const auto [x, y] = operands.pair();
    const DoubleDouble sum = x + y;
    const DoubleDouble r = renormalized(sum);
    ASSERT_EQ(wide(r), wide(sum));
    ASSERT_EQ(r.hi, r.hi + r.lo);
    if (std::abs(sum.lo) > 0x1p-52 * std::abs(sum.hi)) ++cancelled;
    // A difference that cancelled its heads still has its square root.
    if (r.hi > 0.0) {
      const Real100 root = sqrt(wide(sum));
      ASSERT_TRUE(agrees<Real100>(at(sum.hi, sum.lo), root, wide(sqrt(sum)), ldexp(root, -101)));
    }
  }
  EXPECT_GT(cancelled, 100);
}

TEST(DoubleDouble, NaNIsOrderedWithNothing) {
  const DoubleDouble nan = std::numeric_limits<DoubleDouble>::quiet_NaN();
  EXPECT_TRUE(std::isnan(nan.hi));
  EXPECT_FALSE(nan == nan);
  EXPECT_FALSE(nan < DoubleDouble(1.0) || nan > DoubleDouble(1.0));
  EXPECT_TRUE(std::isnan((nan + 1.0).hi) && std::isnan((nan * 2.0).hi));
}

}  // namespace
}  // namespace stationary
