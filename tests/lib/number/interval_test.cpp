// Interval arithmetic against 50 digits: the exact result is inside, and the interval is narrow;
// what is not bounded decides nothing.
#include "lib/number/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using support::Random;
using support::Real50;

bool holds(const Interval& x, const Real50& exact) {
  return Real50(x.lo) <= exact && exact <= Real50(x.hi);
}

std::string text(const Interval& x) {
  return "[" + std::to_string(x.lo) + ", " + std::to_string(x.hi) + "]";
}

/// Half the width in units of 2^-53 of the value.
double units(const Interval& x) { return (x.hi - x.lo) / (std::abs(x.mid()) * 0x1p-52); }

/// Signs, ordinary and extreme sizes, short and long significands.
double any(Random& random) {
  const double size =
      random.integer(0, 3) == 0 ? random.log_uniform(1e-140, 1e140) : random.log_uniform(1e-3, 1e3);
  const double x = random.sign() * size;
  return random.integer(0, 3) == 0 ? std::ldexp(std::round(x * 4.0), -2) : x;
}

Interval any_interval(Random& random) {
  const double a = any(random);
  const double b = random.integer(0, 2) == 0 ? any(random) : a * random.uniform(1.0, 2.0);
  return {std::min(a, b), std::max(a, b)};
}

double inside(const Interval& x, Random& random) {
  const double at = x.lo + (x.hi - x.lo) * random.uniform(0.0, 1.0);
  return random.integer(0, 3) == 0 ? x.lo : std::min(std::max(at, x.lo), x.hi);
}

TEST(Interval, SumsOfProductsHoldTheExactResult) {
  Random random(915);
  for (int trial = 0; trial < 5000; ++trial) {
    const bool points = trial % 2 == 0;
    const Interval first = points ? Interval(any(random)) : any_interval(random);
    const double at = inside(first, random);
    IntervalSum sum(first);
    Real50 exact(at);
    Real50 size = abs(Real50(at));
    for (int k = random.integer(0, 8); k > 0; --k) {
      const Interval x = points ? Interval(any(random)) : any_interval(random);
      const Interval y = points ? Interval(any(random)) : any_interval(random);
      const Real50 product = Real50(inside(x, random)) * Real50(inside(y, random));
      sum.add_product(x, y);
      exact += product;
      size += abs(product);
      const double factor = any(random);
      sum.add_product(factor, y);
      const Real50 multiple = Real50(factor) * Real50(y.lo);
      exact += multiple;
      size += abs(multiple);
    }
    const Interval value = sum.value();
    ASSERT_TRUE(holds(value, exact)) << text(value);
    if (points) {
      EXPECT_LE(Real50(value.hi) - Real50(value.lo), size * Real50(0x1p-46) + 1e-285);
    }
  }
  IntervalSum open;
  open.add_product(Interval::entire(), Interval(0.0));
  EXPECT_FALSE(open.value().bounded());
  IntervalSum wide(Interval(1.0));
  wide.add_product(Interval(1e200), Interval(1e200));
  EXPECT_FALSE(wide.value().bounded());
}

TEST(Interval, OperationsHoldTheExactResult) {
  Random random(901);
  for (int trial = 0; trial < 20000; ++trial) {
    const Interval x = any_interval(random);
    const Interval y = any_interval(random);
    const double a = inside(x, random);
    const double b = inside(y, random);
    const Real50 p(a);
    const Real50 q(b);
    const std::string where = text(x) + " " + text(y);
    ASSERT_TRUE(holds(x + y, p + q)) << where;
    ASSERT_TRUE(holds(x - y, p - q)) << where;
    ASSERT_TRUE(holds(x * y, p * q)) << where;
    ASSERT_TRUE(holds(a * y, p * q)) << where;
    ASSERT_TRUE(holds(-x, -p)) << where;
    ASSERT_TRUE(holds(square(x), p * p)) << where;
    ASSERT_GE(square(x).lo, 0.0) << where;
    ASSERT_TRUE(b == 0.0 || holds(x / y, p / q)) << where;
    ASSERT_TRUE(holds(hull(x, y), p) && holds(hull(x, y), q)) << where;
    if (x.lo >= 0.0) {
      ASSERT_TRUE(holds(sqrt(x), sqrt(p))) << where;
    }
  }
}

/// Subnormal numbers take a processor a hundred times as long, and a balance has many zeros.
TEST(Interval, WhatIsMadeOfZeroIsNoSubnormal) {
  Random random(921);
  const Interval zero(0.0);
  const auto ordinary = [](double x) { return std::fpclassify(x) != FP_SUBNORMAL; };
  for (int trial = 0; trial < 200; ++trial) {
    const Interval x(random.log_uniform(1e-6, 1e6));
    Interval product = zero * x;
    Interval sum = zero + zero;
    for (int k = 0; k < 6; ++k) {
      for (const Interval& each : {product, sum, Interval(product * sum), square(product)}) {
        EXPECT_TRUE(ordinary(each.lo) && ordinary(each.hi)) << k << " " << text(each);
        EXPECT_TRUE(each.may_be(0.0) && each.magnitude() < 1e-240) << k << " " << text(each);
      }
      product *= x;
      sum = 0.5 * (sum * x + zero);
    }
  }
}

TEST(Interval, OfDoublesIsAFewUnitsWide) {
  Random random(902);
  for (int trial = 0; trial < 2000; ++trial) {
    const double a = random.sign() * random.log_uniform(1e-10, 1e10);
    const double b = random.sign() * random.log_uniform(1e-10, 1e10);
    const Interval x(a);
    const Interval y(b);
    EXPECT_LE(units(x + y), 3.0);
    EXPECT_LE(units(x * y), 3.0);
    EXPECT_LE(units(x / y), 3.0);
    EXPECT_LE(units(sqrt(Interval(std::abs(a)))), 3.0);
  }
}

TEST(Interval, LogarithmHoldsTheExactOne) {
  Random random(903);
  const double hard[] = {1.0 - 0x1p-53,
                         1.0 + 0x1p-52,
                         std::sqrt(0.5),
                         std::nextafter(std::sqrt(0.5), 0.0),
                         std::sqrt(2.0),
                         std::nextafter(std::sqrt(2.0), 2.0),
                         2.0,
                         0.5,
                         std::numeric_limits<double>::min(),
                         std::numeric_limits<double>::max()};
  const auto check = [](double x) {
    const Interval y = log_of_double(x);
    ASSERT_TRUE(holds(y, log(Real50(x)))) << std::to_string(x) << " " << text(y);
    ASSERT_LE(units(y), 6.0) << std::to_string(x);
  };
  for (const double x : hard) check(x);
  for (int trial = 0; trial < 20000; ++trial) {
    check(random.log_uniform(1e-300, 1e300));
    check(random.uniform(0.5, 2.0));
    check(1.0 + random.sign() * random.log_uniform(1e-15, 0.3));
  }
  EXPECT_EQ(log_of_double(1.0).lo, 0.0);
  EXPECT_EQ(log_of_double(1.0).hi, 0.0);
  const Interval wide = log(Interval(0.5, 3.0));
  EXPECT_TRUE(holds(wide, log(Real50(0.5))) && holds(wide, log(Real50(3.0))));
}

TEST(Interval, ExponentialHoldsTheExactOne) {
  Random random(904);
  const auto check = [](double x) {
    const Interval y = exp_of_double(x);
    ASSERT_TRUE(holds(y, exp(Real50(x)))) << std::to_string(x) << " " << text(y);
    ASSERT_LE(units(y), 7.0) << std::to_string(x);
  };
  for (int trial = 0; trial < 20000; ++trial) {
    check(random.uniform(-600.0, 600.0));
    check(random.uniform(-2.0, 2.0));
    check(random.sign() * random.log_uniform(1e-300, 1.0));
  }
  for (int k = -20; k <= 20; ++k) check((k + 0.5) * std::log(2.0));
  EXPECT_EQ(exp_of_double(0.0).lo, 1.0);
  EXPECT_EQ(exp_of_double(0.0).hi, 1.0);
}

TEST(Interval, WhatIsNotBoundedDecidesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Interval straddling(-1.0, 2.0);
  const Interval useless[] = {Interval(1.0) / straddling,
                              log(straddling),
                              log(Interval(0.0, 1.0)),
                              sqrt(straddling),
                              exp(Interval(0.0, 1e3)),
                              Interval(1e200) * Interval(1e200),
                              Interval(1e308) + Interval(1e308),
                              Interval(nan) + Interval(1.0),
                              Interval(nan) * straddling,
                              straddling / Interval(nan),
                              square(Interval(nan)),
                              sqrt(Interval(nan)),
                              log(Interval(nan)),
                              exp(Interval(nan)),
                              0.0 * Interval::entire(),
                              straddling * Interval::entire(),
                              Interval::entire() - Interval::entire(),
                              square(Interval::entire()),
                              poison<Interval>()};
  for (const Interval& x : useless) {
    EXPECT_FALSE(x.bounded()) << text(x);
    EXPECT_FALSE(x.positive() || x.negative()) << text(x);
    EXPECT_TRUE(x.may_be(0.0)) << text(x);
    EXPECT_FALSE(x.within(Interval::entire()) || x.inside(Interval::entire())) << text(x);
    EXPECT_FALSE(x.apart_from(Interval(7.0))) << text(x);
  }
}

TEST(Interval, Comparisons) {
  const Interval x(1.0, 2.0);
  EXPECT_TRUE(x.positive() && !x.negative() && (-x).negative());
  EXPECT_FALSE(Interval(0.0, 1.0).positive());
  EXPECT_TRUE(x.may_be(1.0) && x.may_be(2.0) && !x.may_be(0.5) && !x.may_be(2.5));
  EXPECT_TRUE(x.within(x) && !x.inside(x) && x.inside(Interval(0.5, 2.5)));
  EXPECT_TRUE(x.apart_from(Interval(2.5, 3.0)) && !x.apart_from(Interval(2.0, 3.0)));
  // Each bound counts by itself.
  for (const Interval& y : {Interval(0.5, 1.5), Interval(1.5, 2.5), Interval(0.0, 3.0)}) {
    EXPECT_FALSE(y.within(x)) << text(y);
    EXPECT_FALSE(y.inside(x)) << text(y);
    EXPECT_FALSE(y.apart_from(x) || x.apart_from(y)) << text(y);
  }
  EXPECT_FALSE(Interval(1.0, 1.5).inside(x) || Interval(1.5, 2.0).inside(x));
  EXPECT_TRUE(Interval(1.0, 1.5).within(x) && Interval(1.5, 2.0).within(x));
  EXPECT_TRUE(x.apart_from(Interval(0.0, 0.5)) && !x.apart_from(Interval(0.0, 1.0)));
  EXPECT_EQ(x.magnitude(), 2.0);
  EXPECT_EQ(x.mignitude(), 1.0);
  EXPECT_EQ(Interval(-1.0, 2.0).mignitude(), 0.0);
}

TEST(Interval, OfADecimalHoldsHalfAUnitEitherWay) {
  for (const double x : {0.1, 1.0, -1.7, 3e-300}) {
    const Interval y = Interval::decimal(x);
    EXPECT_TRUE(holds(y, Real50(x) * (Real50(1) + Real50(0x1p-53)))) << x;
    EXPECT_TRUE(holds(y, Real50(x) * (Real50(1) - Real50(0x1p-54)))) << x;
    EXPECT_LE(units(y), 2.0) << x;
  }
  EXPECT_EQ(Interval::decimal(0.0).lo, 0.0);
  EXPECT_EQ(Interval::decimal(0.0).hi, 0.0);
  // Beyond the largest double there is no bound: no interval has one alone.
  const double largest = std::numeric_limits<double>::max();
  for (const double x : {largest, -largest}) {
    EXPECT_EQ(Interval::decimal(x).lo, Interval::entire().lo);
    EXPECT_EQ(Interval::decimal(x).hi, Interval::entire().hi);
  }
}

}  // namespace
}  // namespace stationary
