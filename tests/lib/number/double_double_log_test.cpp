// The extended logarithm: its table row by row, its error bound, and the arguments it has no series
// for.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lib/number/double_double.hpp"
#include "lib/number/double_double_log_table.hpp"
#include "tests/support/numbers/double_double_operands.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

::testing::AssertionResult row_holds(const LogRow& row) {
  const Real100 expected = -log(Real100(row.reciprocal));
  const Real100 actual = Real100(row.head) + Real100(row.tail);
  return agrees<Real100>(at("r", row.reciprocal), expected, actual,
                         ldexp(Real100(1), -104) * abs(expected));
}

TEST(LogTable, CoarseRowsAreReciprocalsAndTheirLogarithms) {
  for (int i = 0; i < 128; ++i) {
    EXPECT_TRUE(row_holds(coarse_rows[i])) << i;
    // The interval of row i begins at 0.6875 with its leading seven bits counted up; every m in it
    // gives |m r - 1| < 2^-7.
    const std::uint64_t start = 0x3fe6000000000000 + (static_cast<std::uint64_t>(i) << 45);
    const double low = std::bit_cast<double>(start);
    const double high = std::bit_cast<double>(start + (std::uint64_t{1} << 45) - 1);
    for (const double m : {low, high})
      EXPECT_LT(std::abs(std::fma(m, coarse_rows[i].reciprocal, -1.0)), 0x1p-7) << i << " " << m;
  }
}

TEST(LogTable, FineRowsAreReciprocalsAndTheirLogarithms) {
  for (int j = -128; j <= 128; ++j) {
    const LogRow& row = fine_rows[j + 128];
    EXPECT_TRUE(row_holds(row)) << j;
    EXPECT_LE(std::abs(row.reciprocal * (1.0 + j * 0x1p-14) - 1.0), 0x1p-52) << j;
  }
}

::testing::AssertionResult log_holds(const DoubleDouble& x) {
  const Real100 expected = log(exact<Real100>(x));
  return agrees<Real100>(at("log of", x.hi, "+", x.lo), expected, exact<Real100>(log(x)),
                         ldexp(Real100(abs(expected)), -82));
}

TEST(DoubleDoubleLog, RandomArguments) {
  Operands operands(511);
  for (int trial = 0; trial < 3000; ++trial) ASSERT_TRUE(log_holds(abs(operands.one())));
}

TEST(DoubleDoubleLog, NearOne) {
  // Where the logarithm is small the bound is on a small number.
  Random random(512);
  for (int k = 1; k <= 105; ++k) {
    const double offset = std::ldexp(random.uniform(1.0, 2.0), -k);
    for (const double signed_offset : {offset, -offset}) {
      ASSERT_TRUE(log_holds(two_sum(1.0, signed_offset)));
      ASSERT_TRUE(log_holds(two_sum(1.0 + 0x1p-9, signed_offset)));
    }
  }
  EXPECT_EQ(log(DoubleDouble(1.0)), DoubleDouble(0.0));
}

TEST(DoubleDoubleLog, AtTheEdgesOfTheTablesIntervals) {
  for (int i = 0; i < 128; ++i) {
    const double edge = std::bit_cast<double>(0x3fe6000000000000 + (std::uint64_t(i) << 45));
    for (const double x : {edge, std::nextafter(edge, 0.0), std::nextafter(edge, 2.0)}) {
      ASSERT_TRUE(log_holds(x));
      ASSERT_TRUE(log_holds({x, x * 0x1p-54}));
      ASSERT_TRUE(log_holds({x, -x * 0x1p-54}));
      ASSERT_TRUE(log_holds(std::ldexp(x, 37)));
    }
  }
}

TEST(DoubleDoubleLog, AtTheEndsOfTheRange) {
  EXPECT_TRUE(log_holds(std::numeric_limits<double>::min()));
  EXPECT_TRUE(log_holds(0x1.0000000000001p-1022));
  const double last = std::nextafter(0x1p1022, 0.0);
  EXPECT_TRUE(log_holds(last));
  EXPECT_TRUE(log_holds({last, last * 0x1p-54}));
  // From 2^1022 on, and below the smallest normal number, it is the double's.
  for (const double x : {0x1p1022, 0x1.37p1022, 0x1.7p1022, 0x1p1023, 0x1.37p1023, 0x1.7p1023,
                         std::numeric_limits<double>::max()})
    EXPECT_EQ(log(DoubleDouble(x, x * 0x1p-54)).hi, std::log(x)) << x;
}

TEST(DoubleDoubleLog, WhereThereIsNoSeries) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(log(DoubleDouble(0.0)).hi, -infinity);
  EXPECT_EQ(log(DoubleDouble(infinity)).hi, infinity);
  EXPECT_TRUE(std::isnan(log(DoubleDouble(-1.0)).hi));
  EXPECT_TRUE(std::isnan(log(DoubleDouble(-infinity)).hi));
  EXPECT_TRUE(std::isnan(log(DoubleDouble(std::nan(""))).hi));
  // Subnormal arguments fall back to double precision.
  for (const double x : {std::numeric_limits<double>::denorm_min(), 0x1.8p-1040}) {
    const DoubleDouble logarithm = log(DoubleDouble(x));
    EXPECT_EQ(logarithm.hi, std::log(x));
  }
}

}  // namespace
}  // namespace stationary
