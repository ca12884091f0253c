// The step that continuation and the walk from rest share: the bordered Newton's method, the predictor, the guard, and
// how a step grows and shrinks.
#include "solver/continuation/path_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace stationary {
namespace {

using Y = ArcVector<2>;

/// The circle ln x_0 = sin s, p = 1 - cos s in a plane, ln x_1 = 0: a curve that turns in p.
struct RoundCurve {
  ReducedVector<2> log_x{0.0, 0.0};
  double p = 0.0;

  struct At {
    ReducedVector<2> g;
    Eigen::Matrix2d jacobian;
    ReducedVector<2> slope;
  };
  At linearize() const {
    const double u = log_x[0];
    At out;
    out.g = {0.5 * (u * u + (p - 1.0) * (p - 1.0) - 1.0), 2.0 * log_x[1]};
    out.jacobian << u, 0.0, 0.0, 2.0;
    out.slope = {p - 1.0, 0.0};
    return out;
  }
  void move(const Y& delta) {
    log_x += delta.head<2>();
    p += delta[2];
  }
  static Y at(double s) { return {std::sin(s), 0.0, 1.0 - std::cos(s)}; }
  static Y tangent(double s) { return {std::cos(s), 0.0, std::sin(s)}; }
};

NewtonCourse<2> correct(RoundCurve& curve, const Y& border, double max_correction) {
  return bordered_newton<2>(
      border, max_correction, [&] { return curve.linearize(); },
      [&](const Y& delta) { curve.move(delta); });
}

TEST(BorderedNewton, ComesToTheCurveInThePlaneAcrossTheBorder) {
  for (const double s : {0.1, 1.0, 1.5707963267948966, 3.0, 5.0}) {
    const Y border = RoundCurve::tangent(s);
    const Y on = RoundCurve::at(s);
    RoundCurve curve;
    curve.move(on + 0.05 * border + Y(0.0, 0.01, 0.0));
    const NewtonCourse<2> course = correct(curve, border, 0.1);
    ASSERT_EQ(course.status, CorrectorStatus::converged) << s;
    EXPECT_LE(curve.linearize().g.norm(), 1e-13);
    const Y moved = Y(curve.log_x[0], curve.log_x[1], curve.p) - on;
    EXPECT_NEAR(moved.dot(border), 0.05, 1e-14) << s;
    EXPECT_NEAR(course.first_correction, std::hypot(0.01, 0.5 * 0.05 * 0.05), 1e-4);
    // The kernel is the tangent, on the border's side.
    const Y kernel = course.last.kernel().normalized();
    EXPECT_GT(kernel.dot(border), 0.99);
    EXPECT_NEAR(kernel[0] * curve.log_x[0] + kernel[2] * (curve.p - 1.0), 0.0, 1e-6);
    EXPECT_TRUE(course.last.positive());
  }
}

TEST(BorderedNewton, SaysWhatIsWrong) {
  RoundCurve far;
  far.move({0.0, 0.2, 0.0});
  EXPECT_EQ(correct(far, RoundCurve::tangent(0.0), 0.1).status, CorrectorStatus::too_far);
  EXPECT_EQ(far.log_x[1], 0.2) << "not moved";
  // No point of the circle lies in that plane.
  RoundCurve beside;
  beside.move({1.3, 0.0, 0.9});
  const Y across_x(1.0, 0.0, 0.0);
  EXPECT_EQ(correct(beside, across_x, 1e3).status, CorrectorStatus::slow);
  RoundCurve singular;
  singular.move({0.0, 0.0, 1.0});
  EXPECT_EQ(correct(singular, across_x, 1e3).status, CorrectorStatus::not_finite);
  RoundCurve undefined;
  undefined.move({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  EXPECT_EQ(correct(undefined, across_x, 1e3).status, CorrectorStatus::not_finite);
}

TEST(PathStep, PredictsByTheTangentThenByTheCubic) {
  const double l = 0.2;
  PathStep<2> step({.first = 0.3});
  EXPECT_EQ(step.length(), 0.3);
  EXPECT_EQ(step.ahead(RoundCurve::tangent(0.0), 0.3), Y(0.3 * RoundCurve::tangent(0.0)));
  step.take(Arc<2>(RoundCurve::at(l), RoundCurve::tangent(0.0), RoundCurve::tangent(l)));
  for (const double h : {0.05, 0.1, 0.2}) {
    const Y off = RoundCurve::at(l) + step.ahead(RoundCurve::tangent(l), h) - RoundCurve::at(l + h);
    // h^2 (h + l)^2/24 of the fourth derivative, which is 1.
    const double expected = h * h * (h + l) * (h + l) / 24.0;
    EXPECT_NEAR(off.norm() / expected, 1.0, 0.1) << h;
    EXPECT_NEAR(step.shown(expected, h, [] { return 0.0; }), 1.0, 1e-12);
  }
}

TEST(PathStep, GrowsAndShrinks) {
  PathStep<2> step({.tolerance = 1e-2, .first = 0.1, .max = 1.0, .min = 0.01, .growth = 3.0});
  step.lengthen(0.0, 0.0);
  EXPECT_DOUBLE_EQ(step.length(), 0.3) << "by its growth";
  step.lengthen(0.0, 0.07);
  EXPECT_DOUBLE_EQ(step.length(), 0.6) << "by the turn of the tangent";
  step.lengthen(12.0, 0.0);
  EXPECT_NEAR(step.length(), std::pow(0.01, 0.25), 1e-12) << "by the fourth derivative";
  step.lengthen(0.0, 0.0);
  EXPECT_NEAR(step.length(), std::pow(0.01, 0.25), 1e-12) << "that of the step before counts too";
  step.lengthen(0.0, 0.0);
  EXPECT_NEAR(step.length(), 3.0 * std::pow(0.01, 0.25), 1e-12);
  step.lengthen(0.0, 0.0);
  EXPECT_EQ(step.length(), 1.0);
  EXPECT_TRUE(step.fits(0.1, 1.0));
  EXPECT_FALSE(step.fits(0.5, 1.0));
  EXPECT_TRUE(step.straight(0.2));
  EXPECT_FALSE(step.straight(0.21));
  EXPECT_FALSE(step.straight(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(step.refuse("a reason"));
  EXPECT_EQ(step.refusal(), "a reason");
  EXPECT_EQ(step.length(), 0.5);
  while (!step.too_short()) step.refuse("again");
  EXPECT_LT(step.length(), 0.01);
}

TEST(Arc, AngleIsThatOfItsSine) {
  int compared = 0;
  for (double sine = 1e-12; sine <= 1.0; sine *= 1.01, ++compared)
    EXPECT_NEAR(Arc<2>::angle_over_sine(sine) * sine, std::asin(sine), 1e-15 * std::asin(sine))
        << sine;
  EXPECT_GT(compared, 2500);
  EXPECT_EQ(Arc<2>::angle_over_sine(0.0), 1.0);
}

TEST(Arc, LengthIsThatOfACircle) {
  for (const double angle : {1e-6, 1e-3, 0.1, 0.2, 1.0}) {
    const Arc<2> arc(RoundCurve::at(0.3 + angle) - RoundCurve::at(0.3), RoundCurve::tangent(0.3),
                     RoundCurve::tangent(0.3 + angle));
    EXPECT_NEAR(arc.turned, angle, 1e-14);
    EXPECT_NEAR(arc.length, angle, 1e-14);
  }
}

}  // namespace
}  // namespace stationary
