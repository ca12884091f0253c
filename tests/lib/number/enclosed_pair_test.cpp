// A pair with a bound of its error holds what 50 digits say, and keeps more than 90 bits.
#include "lib/number/enclosed_pair.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using support::Real50;

TEST(EnclosedPair, HoldsSumsOfProductsAndQuotients) {
  support::Random random(20261127);
  for (int k = 0; k < 2000; ++k) {
    EnclosedPair x(1.0);
    Real50 exact(1);
    double size = 1.0;
    for (int step = 0; step < 12; ++step) {
      const double a = random.sign() * random.log_uniform(1e-8, 1e8);
      const double b = random.sign() * random.log_uniform(1e-8, 1e8);
      const int by = random.integer(1, 10);
      x = (x * EnclosedPair(a) + -(EnclosedPair(b) * EnclosedPair(a))) / by;
      exact = (exact * a - Real50(b) * a) / by;
      size = (size + std::abs(b)) * std::abs(a) / by;
    }
    const Interval held = x.interval();
    ASSERT_TRUE(held.bounded());
    EXPECT_LE(Real50(held.lo), exact);
    EXPECT_LE(exact, Real50(held.hi));
    EXPECT_LE(held.width(), 0x1p-90 * size + 0x1p-50 * held.magnitude());
  }
}

/// What is left where the heads cancel is the tail, which an interval's own rounding does not hide.
TEST(EnclosedPair, KeepsTheTailWhereHeadsCancel) {
  for (const double tail : {0x1p-80, -0x1p-70, 0x1.8p-60}) {
    const Interval left = (EnclosedPair(1.0) + EnclosedPair(tail) + EnclosedPair(-1.0)).interval();
    EXPECT_TRUE(left.may_be(tail)) << tail;
    EXPECT_LE(left.width(), 0x1p-99) << tail;
  }
}

/// One more sum could only be wrong by what is below the last bit of a pair: the bound says so, and is
/// not zero.
TEST(EnclosedPair, SaysThatItRounds) {
  const EnclosedPair sum = EnclosedPair(1.0) + EnclosedPair(0x1p-200);
  const EnclosedPair rest = sum + EnclosedPair(-1.0);
  EXPECT_LT(rest.interval().lo, 0x1p-200);
  EXPECT_GE(rest.interval().hi, 0x1p-200);
  EXPECT_GT(rest.interval().width(), 0.0);
}

TEST(EnclosedPair, OfNoNumberNothingIsSaid) {
  const EnclosedPair huge(1e200);
  for (const EnclosedPair& x : {huge * huge, huge * huge * EnclosedPair(0.0),
                                EnclosedPair(std::numeric_limits<double>::quiet_NaN())})
    EXPECT_FALSE(x.interval().bounded());
}

}  // namespace
}  // namespace stationary
