// Affine forms against 50 digits: whatever the coordinates are, the exact number lies in the form
// and in its range; what two forms have in common cancels.
#include "lib/number/affine_form.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using support::Random;
using support::Real50;
using Form = AffineForm<3>;

struct EpsilonPoint {
  std::array<double, 3> epsilon;
};

bool form_holds(const Form& form, const EpsilonPoint& at, const Real50& exact) {
  Real50 linear(form.center);
  for (std::size_t j = 0; j < 3; ++j) linear += Real50(form.slope[j]) * Real50(at.epsilon[j]);
  return abs(exact - linear) <= Real50(form.radius) && Real50(form.range.lo) <= exact &&
         exact <= Real50(form.range.hi);
}

/// A box of coordinates and a point of it.
struct Box {
  std::array<Interval, 3> side;
  std::array<Form, 3> form;
  EpsilonPoint point;
  std::array<Real50, 3> value;
};

Box random_box(Random& random, double lowest, double highest) {
  Box out;
  for (std::size_t j = 0; j < 3; ++j) {
    const double middle = random.uniform(lowest, highest);
    const double half = random.log_uniform(1e-12, 4.0);
    out.side[j] = Interval(middle - half, middle + half);
    out.form[j] = Form::coordinate(static_cast<int>(j), out.side[j]);
    // The ends of the form reach the box's, so a point is one of its own coordinates.
    const double epsilon = random.uniform(-1.0, 1.0);
    out.point.epsilon[j] = epsilon;
    out.value[j] = Real50(out.form[j].center) + Real50(out.form[j].slope[j]) * Real50(epsilon);
    if (out.value[j] < Real50(out.side[j].lo) || out.value[j] > Real50(out.side[j].hi)) {
      out.point.epsilon[j] = 0.0;
      out.value[j] = Real50(out.form[j].center);
    }
  }
  return out;
}

TEST(AffineForm, HoldsWhatItStandsFor) {
  Random random(411);
  for (int trial = 0; trial < 20000; ++trial) {
    const Box box = random_box(random, -6.0, 6.0);
    const auto& [x, y, z] = box.form;
    const auto& [a, b, c] = box.value;
    const Interval k(random.uniform(-3.0, 0.0), random.uniform(0.0, 3.0));
    const Real50 in_k = Real50(k.lo) + Real50(random.uniform(0.0, 1.0)) * Real50(k.hi - k.lo);
    const std::string where = "trial " + std::to_string(trial);
    ASSERT_TRUE(form_holds(x + y, box.point, a + b)) << where;
    ASSERT_TRUE(form_holds(x + k, box.point, a + in_k)) << where;
    ASSERT_TRUE(form_holds(k * x, box.point, in_k * a)) << where;
    ASSERT_TRUE(form_holds(x * y, box.point, a * b)) << where;
    ASSERT_TRUE(form_holds(x * x, box.point, a * a)) << where;
    const Form sum = Interval(0.3) * x + Interval(-1.7) * y + z * z;
    const Real50 exact_sum = Real50(0.3) * a + Real50(-1.7) * b + c * c;
    ASSERT_TRUE(form_holds(sum, box.point, exact_sum)) << where;
    ASSERT_TRUE(form_holds(exp(x), box.point, exp(a))) << where;
    ASSERT_TRUE(form_holds(exp(x + Interval(-1.0) * y), box.point, exp(a - b))) << where;
    const Form size = exp(x) + exp(y);
    ASSERT_TRUE(form_holds(log(size), box.point, log(exp(a) + exp(b)))) << where;
  }
}

TEST(AffineForm, ExponentialsFarBelowAndAbove) {
  const Form x = Form::coordinate(0, Interval(-2000.0, 3.0));
  const Form low = exp(x);
  EXPECT_TRUE(low.bounded());
  EXPECT_EQ(low.range.lo, 0.0);
  EXPECT_LT(low.range.hi, 20.1);
  for (const double epsilon : {-1.0, -0.5, 0.0, 0.5, 0.999, 1.0}) {
    const Real50 at = Real50(x.center) + Real50(x.slope[0]) * Real50(epsilon);
    if (at > Real50(3.0)) continue;
    EXPECT_TRUE(form_holds(low, {{epsilon, 0.0, 0.0}}, exp(at))) << epsilon;
  }
  EXPECT_FALSE(exp(Form::coordinate(0, Interval(0.0, 800.0))).bounded());
  EXPECT_FALSE(log(Form::coordinate(0, Interval(0.0, 1.0))).bounded());
}

TEST(AffineForm, WhatIsCommonCancels) {
  const Form x = Form::coordinate(0, Interval(1.0, 3.0));
  const Form y = Form::coordinate(1, Interval(1.0, 3.0));
  const Form difference = (x + y) + Interval(-1.0) * x;
  EXPECT_LT(difference.range.hi - difference.range.lo, 2.0001);
  const Form nothing = x * y + Interval(-1.0) * (y * x);
  EXPECT_LT(nothing.range.magnitude(), 4.1);  // x y itself ranges over 8
}

}  // namespace
}  // namespace stationary
