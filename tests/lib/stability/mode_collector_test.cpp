// What the verdict on a block is made of: signs, and the negative eigenvalues of two rows.
#include "lib/stability/mode_collector.hpp"

#include <gtest/gtest.h>

namespace stationary {
namespace {

TEST(ModeCollector, ZeroHasNoSign) {
  EXPECT_EQ(sign(0.0), 0);
  EXPECT_EQ(sign(-0.0), 0);
  EXPECT_EQ(sign(5e-324), 1);
  EXPECT_EQ(sign(-5e-324), -1);
}

TEST(ModeCollector, CountsNegativeEigenvaluesOfTwoRows) {
  EXPECT_EQ(negatives_2(1.0, 2.0, 2.0), 0);
  EXPECT_EQ(negatives_2(-1.0, -2.0, 2.0), 2);
  EXPECT_EQ(negatives_2(1.0, -2.0, -2.0), 1);
  EXPECT_EQ(negatives_2(1.0, 0.0, 0.0), 0);
  EXPECT_EQ(negatives_2(-1.0, 0.0, 0.0), 1);
  EXPECT_EQ(negatives_2(0.0, 0.0, 0.0), 0);
}

/// Certain only beyond what its inputs allow.
TEST(ModeCollector, IsCertainlyPositiveBeyondItsError) {
  EXPECT_TRUE(positive(Conditioned(1.0, 4.0), 0.2));
  EXPECT_FALSE(positive(Conditioned(1.0, 4.0), 0.25));
  EXPECT_FALSE(positive(Conditioned(-1.0, 0.0), 0.25));
}

}  // namespace
}  // namespace stationary
