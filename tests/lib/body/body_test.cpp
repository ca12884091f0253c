// The body refuses what is not one, and says which inequality fails.
#include "lib/body/body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace stationary {
namespace {

TEST(Body, NamesTheViolatedInequality) {
  const double infinity = std::numeric_limits<double>::infinity();
  const char* const inequalities[] = {"J1 > 0 and finite", "J2 > 0 and finite",
                                      "J3 > 0 and finite"};
  for (const double bad : {0.0, -0.0, -1.0, -infinity, infinity, std::nan("")}) {
    for (int k = 0; k < 3; ++k) {
      double J[3] = {1.0, 2.0, 3.0};
      J[k] = bad;
      try {
        const Body body(J[0], J[1], J[2]);
        ADD_FAILURE() << bad << " passes, but " << inequalities[k] << body.J1;
      } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), inequalities[k]);
      }
    }
  }
}

TEST(Body, NamesTheFirstOfSeveral) {
  try {
    const Body body(-1.0, 0.0, 0.0);
    ADD_FAILURE() << body.J1;
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "J1 > 0 and finite");
  }
}

TEST(Body, KeepsWhatItIsGiven) {
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double largest = std::numeric_limits<double>::max();
  const Body body(smallest, largest, 0.6);
  EXPECT_EQ(body.J1, smallest);
  EXPECT_EQ(body.J2, largest);
  EXPECT_EQ(body.J3, 0.6);
  EXPECT_EQ(body, Body(smallest, largest, 0.6));
  EXPECT_NE(body, Body(smallest, largest, 0.7));
}

TEST(Body, IsSymmetricExactlyWhenJ1IsJ2) {
  EXPECT_TRUE(Body(1.5, 1.5, 0.6).symmetric());
  EXPECT_FALSE(Body(1.5, std::nextafter(1.5, 2.0), 1.5).symmetric());
  EXPECT_FALSE(Body(0.6, 1.5, 1.5).symmetric());
}

}  // namespace
}  // namespace stationary
