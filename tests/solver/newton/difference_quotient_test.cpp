// Slopes by difference quotients against the known ones: within the error they tell, which is small
// where the function is smooth and says so where it is not.
#include "solver/newton/difference_quotient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace stationary {
namespace {

using Values = std::optional<std::vector<double>>;

TEST(DifferenceQuotients, HoldTheSlopesOfSmoothFunctions) {
  for (const double x : {0.3, 1.0, 7.5}) {
    const Slopes found = difference_quotients(
        [](double t) -> Values {
          return std::vector{std::exp(t), std::sin(3.0 * t), std::sqrt(t), 1.0 / t, 2.5};
        },
        x, x, 5);
    const double exact[] = {std::exp(x), 3.0 * std::cos(3.0 * x), 0.5 / std::sqrt(x),
                            -1.0 / (x * x), 0.0};
    for (std::size_t k = 0; k < 5; ++k) {
      const double size = std::abs(exact[k]) + 1.0;
      EXPECT_LE(std::abs(found.slope[k] - exact[k]), found.error[k] + 1e-16) << k << ' ' << x;
      EXPECT_LE(found.error[k], 1e-9 * size) << k << ' ' << x;
    }
  }
}

/// Noise of the size of rounding, by which the finest steps are useless.
TEST(DifferenceQuotients, TellOfNoise) {
  const auto noisy = [](double t) -> Values {
    return std::vector{std::exp(t) * (1.0 + 1e-9 * std::sin(1e9 * t))};
  };
  const Slopes found = difference_quotients(noisy, 1.0, 1.0, 1);
  EXPECT_LE(std::abs(found.slope[0] - std::exp(1.0)), found.error[0]);
  EXPECT_LE(found.error[0], 1e-4);
}

/// Values that are small beside their terms have the terms' rounding: that is no corner, and the error
/// holds, but where few samples happen to show none of it.
TEST(DifferenceQuotients, HoldWhereTermsCancel) {
  int beyond = 0;
  constexpr int all = 1000;
  for (int k = 0; k < all; ++k) {
    const double x = 0.5 + 0.00171 * k;
    const Slopes found = difference_quotients(
        [](double t) -> Values {
          const double large = 1e5 * std::cosh(t);
          return std::vector{(large + 0.1 * std::sin(t)) - large};
        },
        x, x, 1);
    ASSERT_FALSE(std::isnan(found.slope[0])) << x;
    beyond += std::abs(found.slope[0] - 0.1 * std::cos(x)) > found.error[0];
    EXPECT_LE(found.error[0], 1e-6) << x;
  }
  EXPECT_LE(beyond, all / 40);
}

/// One that bends within the first steps is seen at smaller ones.
TEST(DifferenceQuotients, TakeSmallerStepsBesideAPole) {
  const Slopes found = difference_quotients(
      [](double t) -> Values { return std::vector{std::sqrt(t - 0.999)}; }, 1.0, 1.0, 1);
  const double exact = 0.5 / std::sqrt(0.001);
  EXPECT_LE(std::abs(found.slope[0] - exact), found.error[0]);
  EXPECT_LE(found.error[0], 1e-8 * exact);
}

/// One that saturates within the first steps, or within all: no quotient of those is believed beyond its error.
TEST(DifferenceQuotients, HoldWhereTheFirstStepsSeeNothing) {
  for (const double within : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12}) {
    const Slopes found = difference_quotients(
        [&](double t) -> Values { return std::vector{2.0 * t + std::atan((t - 1.0) / within)}; },
        1.0, 1.0, 1);
    const double exact = 2.0 + 1.0 / within;
    if (std::isnan(found.slope[0])) {
      EXPECT_LT(within, 1e-7);
      continue;
    }
    EXPECT_LE(std::abs(found.slope[0] - exact), found.error[0]) << within;
    EXPECT_LE(found.error[0], 0.1 * exact) << within;
  }
  const Slopes jump = difference_quotients(
      [](double t) -> Values { return std::vector{t < 1.0 ? t : t + 0.5}; }, 1.0, 1.0, 1);
  EXPECT_TRUE(std::isnan(jump.slope[0]));
}

/// A corner, and roots that begin at x on one side or on both: no h says what they do there.
TEST(DifferenceQuotients, NoSlopeWhereTheSidesDiffer) {
  const Slopes found = difference_quotients(
      [](double t) -> Values {
        const double y = t - 1.0;
        return std::vector{std::abs(y) + t * t, y < 0.0 ? 3.0 * std::sqrt(-y) : 0.0,
                           std::sqrt(std::abs(y)) + t, y * std::abs(y),
                           std::exp(y) + std::sin(40 * y)};
      },
      1.0, 1.0, 5);
  for (const std::size_t k : {0U, 1U, 2U}) {
    EXPECT_TRUE(std::isnan(found.slope[k])) << k << ' ' << found.slope[k];
    EXPECT_TRUE(std::isnan(found.error[k])) << k;
  }
  // One that has a slope there, though no second one, and one that is smooth.
  EXPECT_NEAR(found.slope[3], 0.0, 1e-5);
  EXPECT_NEAR(found.slope[4], 41.0, 1e-6);
}

TEST(DifferenceQuotients, NothingIsKnownWhereTheFunctionIsNot) {
  const Slopes nowhere =
      difference_quotients([](double) -> Values { return std::nullopt; }, 1.0, 1.0, 2);
  for (const double slope : nowhere.slope) EXPECT_TRUE(std::isnan(slope));
  const Slopes partly = difference_quotients(
      [](double t) -> Values {
        return std::vector{t, std::numeric_limits<double>::quiet_NaN()};
      },
      1.0, 1.0, 2);
  EXPECT_NEAR(partly.slope[0], 1.0, 1e-12);
  EXPECT_TRUE(std::isnan(partly.slope[1]));
  EXPECT_TRUE(std::isnan(partly.error[1]));
}

}  // namespace
}  // namespace stationary
