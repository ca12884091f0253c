// Directions against 50 digits, in every quarter of the turn.
#include "lib/body/direction.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using support::Random;
using support::Real50;

Real50 radians(const Real50& degrees) {
  return degrees * boost::math::constants::pi<Real50>() / 180;
}
Real50 in_50_digits(const DoubleDouble& x) { return Real50(x.hi) + Real50(x.lo); }

/// But for the last of the 50 digits: cosines of right angles are zero in the interval alone.
bool nearly_holds(const Interval& x, const Real50& exact) {
  return Real50(x.lo) <= exact + 1e-45 && exact - 1e-45 <= Real50(x.hi);
}

TEST(Direction, IsThatOf50Digits) {
  Random random(411);
  for (int trial = 0; trial < 2000; ++trial) {
    const double degrees = random.sign() * random.log_uniform(1e-6, 720.0);
    const Direction<DoubleDouble> at = direction(degrees);
    const Real50 angle = radians(degrees);
    ASSERT_LT(abs(in_50_digits(at.cosine) - cos(angle)), Real50(0x1p-96)) << degrees;
    ASSERT_LT(abs(in_50_digits(at.sine) - sin(angle)), Real50(0x1p-96)) << degrees;
  }
}

TEST(Direction, OfRightAnglesIsExact) {
  const double turns[][3] = {{0, 1, 0},    {90, 0, 1},    {180, -1, 0}, {270, 0, -1}, {360, 1, 0},
                             {-90, 0, -1}, {-180, -1, 0}, {-270, 0, 1}, {450, 0, 1}};
  for (const auto& [degrees, cosine, sine] : turns) {
    const Direction<DoubleDouble> at = direction(degrees);
    EXPECT_TRUE(at.cosine.hi == cosine && at.cosine.lo == 0.0) << degrees;
    EXPECT_TRUE(at.sine.hi == sine && at.sine.lo == 0.0) << degrees;
    const Direction<Interval> held = direction_interval(degrees, 0.0);
    EXPECT_TRUE(held.cosine.lo == cosine && held.cosine.hi == cosine) << degrees;
    EXPECT_TRUE(held.sine.lo == sine && held.sine.hi == sine) << degrees;
  }
}

TEST(Direction, IntervalHoldsEveryAngleWithinTheSpread) {
  Random random(412);
  for (int trial = 0; trial < 2000; ++trial) {
    const double degrees =
        trial % 10 == 0 ? 90.0 * random.integer(-4, 4) : random.uniform(-400.0, 400.0);
    const double spread = trial % 3 == 0 ? 0.0 : random.log_uniform(1e-18, 1e-3);
    const Direction<Interval> held = direction_interval(degrees, spread);
    for (const int side : {-1, 0, 1}) {
      const Real50 angle = radians(Real50(degrees) + side * Real50(spread));
      ASSERT_TRUE(nearly_holds(held.cosine, cos(angle))) << degrees << " " << side * spread;
      ASSERT_TRUE(nearly_holds(held.sine, sin(angle))) << degrees << " " << side * spread;
    }
    const double widest = 0x1p-3 * spread + 0x1p-50;
    ASSERT_LT(held.cosine.width(), widest) << degrees << " " << spread;
    ASSERT_LT(held.sine.width(), widest) << degrees << " " << spread;
  }
}

}  // namespace
}  // namespace stationary
