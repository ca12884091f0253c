// The elementary functions of extended numbers, intervals and conditioned numbers: the errors and
// enclosures their headers state, against 100 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "lib/number/interval_functions.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

/// One function in every number type, where it is tried, and its error in extended numbers there,
/// relative to scale(x, f(x)).
struct TriedInAllTypes {
  std::string name;
  Real100 (*wide)(const Real100&);
  DoubleDouble (*extended)(const DoubleDouble&);
  Interval (*interval)(const Interval&);
  Conditioned (*conditioned)(const Conditioned&);
  double largest;  ///< |x|
  double error;    ///< of 1 + |x|, or of the result
  bool relative;
};

#define TRIED(f, largest, error, relative)                          \
  TriedInAllTypes {                                                 \
#f, [](const Real100& x) { return Real100(f(x)); },               \
        [](const DoubleDouble& x) { return f(x); },                   \
        [](const Interval& x) { return f(x); },                       \
        [](const Conditioned& x) { return f(x); }, largest, error, relative \
  }

const std::vector<TriedInAllTypes>& functions_in_all_types() {
  static const std::vector<TriedInAllTypes> all{
      TRIED(exp, 300.0, 0x1p-92, true), TRIED(sin, 1e4, 0x1p-95, false),
      TRIED(cos, 1e4, 0x1p-95, false),  TRIED(tan, 1.4, 0x1p-92, true),
      TRIED(tanh, 15.0, 0x1p-92, true), TRIED(atan, 1e6, 0x1p-95, false)};
  return all;
}
#undef TRIED

/// Of all sizes, and of both signs.
double random_argument(Random& random, double largest) {
  const double size = largest * std::exp2(-random.uniform(0.0, 20.0));
  return random.sign() * size;
}

TEST(ElementaryFunctions, ExtendedErrorIsWithinWhatIsStated) {
  for (const TriedInAllTypes& f : functions_in_all_types()) {
    Random random(911);
    for (int trial = 0; trial < 150; ++trial) {
      const double x = random_argument(random, f.largest);
      const Real100 expected = f.wide(Real100(x));
      const double allowed =
          f.relative ? f.error * std::abs(nearest(expected)) : f.error * (1.0 + std::abs(x));
      const Real100 actual = exact<Real100>(f.extended(DoubleDouble(x)));
      ASSERT_TRUE(agrees(f.name + " " + at(x), expected, actual, Real100(allowed)));
    }
  }
}

TEST(ElementaryFunctions, ExtendedPower) {
  Random random(912);
  for (int trial = 0; trial < 150; ++trial) {
    const double x = std::exp(random.uniform(-5.0, 5.0));
    const double p = random.uniform(-6.0, 6.0);
    const Real100 expected = pow(Real100(x), Real100(p));
    const double growth = 1.0 + std::abs(p * std::log(x));
    const Real100 allowed = expected * Real100(0x1p-80 * growth);
    const Real100 actual = exact<Real100>(pow(DoubleDouble(x), DoubleDouble(p)));
    ASSERT_TRUE(agrees(at(x, p), expected, actual, allowed));
  }
}

TEST(ElementaryFunctions, ExtendedOutsideTheRangeIsNoNumberOrTheDoubles) {
  EXPECT_TRUE(std::isnan(double(sin(DoubleDouble(1e300)))));
  EXPECT_EQ(double(exp(DoubleDouble(800.0))), std::exp(800.0));
  EXPECT_EQ(double(exp(DoubleDouble(-800.0))), std::exp(-800.0));
  EXPECT_EQ(double(tanh(DoubleDouble(1e3))), 1.0);
  EXPECT_EQ(double(atan(DoubleDouble(1e300))), std::atan(1e300));
  EXPECT_TRUE(std::isnan(double(pow(DoubleDouble(-1.0), DoubleDouble(0.5)))));
}

TEST(ElementaryFunctions, IntervalsHoldTheValuesOfTheirPoints) {
  for (const TriedInAllTypes& f : functions_in_all_types()) {
    Random random(913);
    for (int trial = 0; trial < 150; ++trial) {
      const double lo = random_argument(random, f.largest);
      const double width = std::exp2(random.uniform(-40.0, 2.0));
      const Interval x(lo, lo + width);
      const Interval image = f.interval(x);
      for (const double part : {0.0, 1.0, random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)}) {
        const double point = std::min(x.lo + part * (x.hi - x.lo), x.hi);
        const Real100 value = f.wide(Real100(point));
        ASSERT_TRUE(Real100(image.lo) <= value && value <= Real100(image.hi))
            << f.name << " " << at(x.lo, x.hi, point, image.lo, image.hi);
      }
    }
  }
}

/// Where the function has turned between two of the points tried, the ends alone are not enough.
TEST(ElementaryFunctions, IntervalsHoldTheExtremesOfSineAndCosine) {
  for (int k = -5; k <= 5; ++k) {
    const double top = (2.0 * k + 0.5) * M_PI;
    EXPECT_EQ(sin(Interval(top - 0.1, top + 0.1)).hi, 1.0);
    EXPECT_EQ(sin(Interval(top + M_PI - 0.1, top + M_PI + 0.1)).lo, -1.0);
    EXPECT_EQ(cos(Interval(2.0 * k * M_PI - 0.1, 2.0 * k * M_PI + 0.1)).hi, 1.0);
    EXPECT_LT(sin(Interval(top + 0.1, top + 0.2)).hi, 0.996);
  }
  EXPECT_FALSE(tan(Interval(1.5, 1.6)).bounded());
  EXPECT_FALSE(pow(Interval(-0.1, 1.0), Interval(0.5)).bounded());
}

TEST(ElementaryFunctions, IntervalsOfPointsAreNarrow) {
  for (const TriedInAllTypes& f : functions_in_all_types()) {
    Random random(914);
    for (int trial = 0; trial < 100; ++trial) {
      const double x = random_argument(random, std::min(f.largest, 30.0));
      const Interval image = f.interval(Interval(x));
      const double size = f.relative ? image.magnitude() : 1.0;
      ASSERT_LE(image.width(), 0x1p-47 * (1.0 + std::abs(x)) * size) << f.name << " " << at(x);
    }
  }
}

TEST(ElementaryFunctions, IntervalsOfSineAndCosineStayWithinOne) {
  Random random(916);
  for (int trial = 0; trial < 2000; ++trial) {
    const double near = random.log_uniform(1e-12, 1e-6);
    for (const double turn : {0.0, 1.5707963267948966, 3.141592653589793, -1.5707963267948966}) {
      const Interval x(turn + near);
      for (const Interval& y : {sin(x), cos(x)}) ASSERT_TRUE(-1.0 <= y.lo && y.hi <= 1.0) << turn;
    }
  }
}

TEST(ElementaryFunctions, IntervalsOfTheSmallerAndOfTheSize) {
  const Interval x(-3.0, 2.0);
  const Interval y(-1.0, 5.0);
  EXPECT_TRUE(smaller(x, y).lo == -3.0 && smaller(x, y).hi == 2.0);
  EXPECT_TRUE(smaller(y, x).lo == -3.0 && smaller(y, x).hi == 2.0);
  EXPECT_TRUE(absolute(x).lo == 0.0 && absolute(x).hi == 3.0);
  EXPECT_TRUE(absolute(Interval(-3.0, -2.0)).lo == 2.0 && absolute(y).hi == 5.0);
  for (const Interval& z : {smaller(x, Interval::entire()), smaller(Interval::entire(), x),
                            absolute(Interval::entire())})
    EXPECT_FALSE(z.bounded());
}

TEST(ElementaryFunctions, ConditionIsTheSlopesShare) {
  for (const TriedInAllTypes& f : functions_in_all_types()) {
    Random random(915);
    for (int trial = 0; trial < 100; ++trial) {
      const double x = random_argument(random, std::min(f.largest, 30.0));
      const Conditioned value = f.conditioned(Conditioned::input(x));
      const Real100 h = Real100(x) * Real100("1e-40");
      const Real100 slope = (f.wide(Real100(x) + h) - f.wide(Real100(x) - h)) / (2 * h);
      const double share = std::abs(nearest(slope) * x);
      ASSERT_TRUE(agrees(f.name + " " + at(x), share, value.condition, 1e-12 * share + 1e-300));
    }
  }
  const Conditioned power = pow(Conditioned::input(2.0), Conditioned::input(3.0));
  EXPECT_DOUBLE_EQ(power.value, 8.0);
  EXPECT_DOUBLE_EQ(power.condition, 8.0 * (3.0 + 3.0 * std::log(2.0)));
}

TEST(ElementaryFunctions, AnExponentialThatOverflowsIsInfinite) {
  for (const double x : {710.0, 750.25, 1000.0, 1234.5, 1e5, 1e300})
    EXPECT_EQ(double(exp(DoubleDouble(x))), HUGE_VAL) << x;
}

}  // namespace
}  // namespace stationary
