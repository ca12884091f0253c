// Taylor numbers against sums of the function itself: what is left after order n shrinks as h^(n+1);
// against identities; and enclosures over intervals.
#include "lib/number/taylor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/number/interval_functions.hpp"

namespace stationary {
namespace {

using Four = Taylor<double, 4>;
using Enclosed = Taylor<Interval, 4>;

/// x(s) = a + b s + c s^2.
template <class T>
Taylor<T, 4> argument(double a, double b, double c) {
  Taylor<T, 4> out = Taylor<T, 4>::along(T(a), T(b));
  out[2] = T(c);
  return out;
}

double sum(const Four& f, double s) {
  double out = f[4];
  for (int k = 3; k >= 0; --k) out = out * s + f[k];
  return out;
}

struct Function {
  const char* name;
  Four (*taylor)(const Four&);
  Enclosed (*enclosed)(const Enclosed&);

  /// Of a number f is what it is of a constant.
  double plain(double x) const { return taylor(Four(x)).value; }
};
#define STATIONARY_FUNCTION(expression)                                                           \
  Function {                                                                                      \
#expression,                                                                                  \
        [](const Four& x) -> Four { return expression; }, [](const Enclosed& x)                   \
                                                               -> Enclosed { return expression; } \
  }

const Function taylor_functions[] = {
    STATIONARY_FUNCTION(exp(x)),
    STATIONARY_FUNCTION(log(x)),
    STATIONARY_FUNCTION(sqrt(x)),
    STATIONARY_FUNCTION(sin(x)),
    STATIONARY_FUNCTION(cos(x)),
    STATIONARY_FUNCTION(tan(x)),
    STATIONARY_FUNCTION(tanh(x)),
    STATIONARY_FUNCTION(atan(x)),
    STATIONARY_FUNCTION((2.0 * x - 1.0) / (x * x + 3.0)),
    STATIONARY_FUNCTION(exp(sin(x)) / sqrt(log(x + 2.0))),
};
#undef STATIONARY_FUNCTION

TEST(Taylor, LeavesARestOfTheNextOrder) {
  for (const Function& f : taylor_functions) {
    const Four x = argument<double>(0.7, 1.3, -0.4);
    const Four at = f.taylor(x);
    const auto rest = [&](double h) { return std::abs(f.plain(sum(x, h)) - sum(at, h)); };
    const double coarse = rest(0.04);
    const double fine = rest(0.02);
    EXPECT_GT(coarse, 1e-12) << f.name;
    EXPECT_NEAR(std::log2(coarse / fine), 5.0, 0.7) << f.name;
  }
}

TEST(Taylor, EnclosesOverIntervals) {
  for (const Function& f : taylor_functions) {
    const Four at = f.taylor(argument<double>(0.7, 1.3, -0.4));
    const Enclosed held = f.enclosed(argument<Interval>(0.7, 1.3, -0.4));
    for (int k = 0; k <= 4; ++k) {
      EXPECT_NEAR(held[k].mid(), at[k], 1e-13 * (1.0 + std::abs(at[k]))) << f.name << ' ' << k;
      EXPECT_LT(held[k].width(), 1e-12) << f.name << ' ' << k;
    }
    // Of a range of arguments it holds those of each.
    Enclosed range = argument<Interval>(0.7, 1.3, -0.4);
    range.value = {0.69, 0.71};
    const Enclosed wide = f.enclosed(range);
    for (const double a : {0.69, 0.695, 0.707, 0.71}) {
      const Four inside = f.taylor(argument<double>(a, 1.3, -0.4));
      for (int k = 0; k <= 4; ++k) {
        const double slack = 1e-13 * (1.0 + std::abs(inside[k]));
        EXPECT_GE(inside[k], wide[k].lo - slack) << f.name << ' ' << k;
        EXPECT_LE(inside[k], wide[k].hi + slack) << f.name << ' ' << k;
      }
    }
  }
}

TEST(Taylor, PowersAreThoseOfALogarithm) {
  const Four x = argument<double>(1.4, 0.3, 0.2);
  const Four p = argument<double>(-2.5, 0.6, 0.1);
  const Four power = pow(x, p);
  const Four other = exp(p * log(x));
  const Four third = pow(x, Four(3.0));
  const Four cube = x * square(x);
  for (int k = 0; k <= 4; ++k) {
    EXPECT_NEAR(power[k], other[k], 1e-14) << k;
    EXPECT_NEAR(third[k], cube[k], 1e-14) << k;
  }
}

TEST(Taylor, DerivativesHaveTheirFactorials) {
  const Four f = exp(Four::along(0.0, 2.0));
  for (int k = 0; k <= 4; ++k) EXPECT_DOUBLE_EQ(f.derivative(k), std::pow(2.0, k));
  EXPECT_EQ(leading(f), 1.0);
}

}  // namespace
}  // namespace stationary
