// The forces along the principal axes of S against slopes of the function whose gradient they are, of
// bodies with and without gravity and a held volume; over boxes against points in them.
#include "lib/balance/principal_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bodies/random_anisotropic.hpp"

namespace stationary {
namespace {

using Number = DoubleDouble;

/// The direction of an angle, turned by a small one.
struct Turned {
  Number cosine;
  Number sine;

  Turned by(double h) const {
    const Number c = 1.0 - 0.5 * square(Number(h));
    const Number s = Number(h) - h * square(Number(h)) / 6.0;
    return {cosine * c - sine * s, sine * c + cosine * s};
  }
};

struct Place {
  Number large;
  Number small;
  Number rho;
  Turned frame;
  Turned axis;

  BasicStretch<Number> stretch() const {
    const auto& [c, s] = frame;
    return {(large - small) * (s * c), large * square(c) + small * square(s),
            large * square(s) + small * square(c), rho};
  }
};

struct PrincipalSetting {
  Inertia3<Number> J;
  AnisotropicModel<Number> model;
  double nu;
  bool oblique;

  Place moved(Place at, std::size_t k, double h) const {
    if (k == 0) at.large = at.large * (1.0 + Number(h) + 0.5 * square(Number(h)));
    if (k == 1) at.small = at.small * (1.0 + Number(h) + 0.5 * square(Number(h)));
    if (k == 2) at.frame = at.frame.by(h);
    if (k == 3) at.axis = at.axis.by(h);
    return at;
  }
  /// V - q^T C q/2.
  Number function(const Place& at) const {
    BasicStretch<Number> q = at.stretch();
    if (model.body.volume) q.rho = *model.body.volume / (at.large * at.small);
    const Number nu_squared = two_product(nu, nu);
    const auto C =
        centrifugal_matrix(J, oblique ? in_plane_products(nu_squared, at.axis.cosine, at.axis.sine)
                                      : axis_products(Branch::iii, nu_squared));
    Number T(0.0);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) T += q.vector()[i] * C(i, j) * q.vector()[j];
    return potential_derivatives<0>(model, q).value - 0.5 * T;
  }
  double slope(const Place& at, std::size_t k) const {
    constexpr double h = 1e-8;
    return double(function(moved(at, k, h)) - function(moved(at, k, -h))) / (2.0 * h);
  }
};

OrientedStretch<Number> oriented(const BasicStretch<Number>& q) {
  const Number root = sqrt(q.xi * q.zeta);
  const Number tanh = q.alpha / root;
  return {q, root, tanh, sqrt(1.0 - square(tanh))};
}

Turned direction_of(double angle) {
  const double t = std::tan(0.5 * angle);
  const Number sum = 1.0 + square(Number(t));
  return {(1.0 - square(Number(t))) / sum, 2.0 * Number(t) / sum};
}

PrincipalFrame<Number> frame_of(const OrientedStretch<Number>& at) {
  const Number difference = at.q.xi - at.q.zeta;
  const Number root = sqrt(square(difference) + 4.0 * square(at.q.alpha));
  const Number large = 0.5 * (at.q.xi + at.q.zeta + root);
  return {large, at.invariants().d / large, difference / root, 2.0 * at.q.alpha / root};
}

/// With gravity and a held volume in turns.
template <class Convert>
auto with_body(const AnisotropicPotential& V, const Body& body, int kind, const Convert& convert) {
  BodyTerms<double> terms;
  terms.gravitates = (kind & 1) != 0;
  terms.g = 0.7;
  terms.J = {body.J1, body.J2, body.J3};
  if ((kind & 2) != 0) terms.volume = 1.2;
  return (terms.any() ? V.with_body(terms) : V).model(convert);
}

struct AsBoxes {
  Interval operator()(double c) const { return c; }
  Direction<Interval> direction(double degrees) const { return direction_interval(degrees, 0.0); }
};

TEST(PrincipalForces, AreSlopesOfTheFunction) {
  support::Random random(571);
  int compared = 0;
  for (int k = 0; k < 128; ++k) {
    const auto of = support::random_anisotropic(random, k);
    const Body body = random.body();
    const bool oblique = k % 3 != 0;
    const PrincipalSetting setting{{body.J1, body.J2, body.J3},
                                   with_body(of.V, body, k / 8, AsExtended()),
                                   random.uniform(0.1, 2.0),
                                   oblique};
    const Number small = random.log_uniform(0.3, 2.0);
    const Place at{small * random.log_uniform(1.01, 6.0), small, random.log_uniform(0.3, 3.0),
                   direction_of(random.uniform(-1.5, 1.5)),
                   direction_of(random.uniform(-1.5, 1.5))};
    OrientedStretch<Number> stretch = oriented(at.stretch());
    if (setting.model.body.volume) stretch = at_volume<Number>(*setting.model.body.volume, stretch);
    const PrincipalFrame<Number> frame{at.large, at.small,
                                       square(at.frame.cosine) - square(at.frame.sine),
                                       2.0 * (at.frame.cosine * at.frame.sine)};
    const AxisAngle<Number> axis{at.axis.cosine, at.axis.sine, Number(1.0)};
    const Number nu_squared = two_product(setting.nu, setting.nu);
    const auto forces = principal_forces(setting.J, setting.model, stretch, frame, nu_squared,
                                         oblique ? &axis : nullptr, Branch::iii);
    if (k % 8 == 6) {  // orthotropic: no function of the invariants
      EXPECT_FALSE(forces);
      continue;
    }
    ASSERT_TRUE(forces) << of.text;
    ++compared;
    const double scale = 1.0 + std::abs(double(setting.function(at))) +
                         std::pow(double(at.large), 4) + square(double(at.large)) / double(small);
    const double tolerance = 1e-12 * scale;
    const double along = setting.slope(at, 0);
    const double across = setting.slope(at, 1);
    EXPECT_NEAR(double(forces->along), along, tolerance) << of.text;
    EXPECT_NEAR(double(forces->across), across, tolerance) << of.text;
    EXPECT_NEAR(double(forces->sum), along + across, tolerance) << of.text;
    const double squares = double(square(at.large));
    const double turned = setting.slope(at, 2);
    ASSERT_TRUE(forces->turning);
    if (oblique) {
      const double of_axis = setting.slope(at, 3);
      EXPECT_NEAR(double(*forces->turning), -(turned + of_axis) / squares, tolerance) << of.text;
      ASSERT_TRUE(forces->compatibility);
      EXPECT_NEAR(double(*forces->compatibility * nu_squared), -2.0 * of_axis / squares, tolerance)
          << of.text;
    } else {
      EXPECT_NEAR(double(*forces->turning) * (double(square(small)) - squares), turned, tolerance)
          << of.text;
      EXPECT_FALSE(forces->compatibility);
    }
  }
  EXPECT_EQ(compared, 112);
}

/// About axes 1 and 2 the balance in theta is no condition.
TEST(PrincipalForces, OfMaterialAxesAreThoseOfTheAxis) {
  support::Random random(572);
  for (int k = 0; k < 32; ++k) {
    const auto of = support::random_anisotropic(random, k / 4);
    if (k / 4 == 6) continue;  // orthotropic
    const Body body = random.body();
    const Branch branch = k % 2 == 0 ? Branch::i : Branch::ii;
    const auto model = of.V.model(AsExtended());
    const Inertia3<Number> J{body.J1, body.J2, body.J3};
    const bool first = k % 4 < 2;  // L along axis 1
    const Number large(random.log_uniform(1.0, 3.0));
    const Number small(random.log_uniform(0.2, 1.0));
    const BasicStretch<Number> q{Number(0.0), first ? large : small, first ? small : large,
                                 Number(1.1)};
    const Number nu_squared(random.uniform(0.1, 2.0));
    const auto forces = principal_forces<Number>(
        J, model, oriented(q), {large, small, Number(first ? 1.0 : -1.0), Number(0.0)}, nu_squared,
        nullptr, branch);
    const auto rows = oriented_balance<1>(J, model, oriented(q), axis_products(branch, nu_squared));
    ASSERT_TRUE(forces);
    EXPECT_FALSE(forces->turning);
    EXPECT_NEAR(double(forces->along), double(rows.g[first ? 0 : 1]), 1e-13) << of.text;
    EXPECT_NEAR(double(forces->across), double(rows.g[first ? 1 : 0]), 1e-13) << of.text;
  }
}

TEST(PrincipalForces, OverBoxesHoldTheirPoints) {
  support::Random random(573);
  int with_circles = 0;
  for (int k = 0; k < 128; ++k) {
    const auto of = support::random_anisotropic(random, k);
    const Body body = random.body();
    const auto over = with_body(of.V, body, k / 8, AsBoxes());
    const auto exact = with_body(of.V, body, k / 8, AsExtended());
    const double width = random.log_uniform(1e-12, 0.5);
    // Some near circles.
    const double xi = random.log_uniform(0.3, 3.0);
    const std::array<double, 4> middle{xi, k % 5 == 0 ? xi : random.log_uniform(0.3, 3.0),
                                       random.log_uniform(0.4, 2.5),
                                       k % 5 == 0 ? 1.0 : random.log_uniform(0.2, 5.0)};
    const double phi = random.log_uniform(0.3, 3.0);
    const auto box = [&](double x) { return Interval(x * (1.0 - width), x * (1.0 + width)); };
    OrientedStretch<Interval> stretch =
        oriented_stretch(box(middle[0]), box(middle[1]), box(middle[2]), box(middle[3]));
    if (over.body.volume) stretch = at_volume<Interval>(*over.body.volume, stretch);
    const AxisAngle<Interval> axes = axis_angle(box(phi));
    const PrincipalFrame<Interval> frame = principal_frame(stretch);
    const Interval nu_squared = square(Interval(0.8));
    const auto forces = principal_forces(Inertia3<Interval>{body.J1, body.J2, body.J3}, over,
                                         stretch, frame, nu_squared, &axes, Branch::i);
    if (frame.large.lo <= frame.small.hi) ++with_circles;
    for (int trial = 0; trial < 8; ++trial) {
      const auto inside = [&](double x) {
        return Number(x) * (1.0 + width * random.uniform(-0.999, 0.999));
      };
      OrientedStretch<Number> q = oriented_stretch(inside(middle[0]), inside(middle[1]),
                                                   inside(middle[2]), inside(middle[3]));
      if (exact.body.volume) q = at_volume<Number>(*exact.body.volume, q);
      const PrincipalFrame<Number> own = frame_of(q);
      EXPECT_TRUE(frame.large.may_be(double(own.large))) << of.text;
      EXPECT_TRUE(frame.small.may_be(double(own.small))) << of.text;
      EXPECT_TRUE(frame.cosine.may_be(double(own.cosine))) << of.text;
      EXPECT_TRUE(frame.sine.may_be(double(own.sine))) << of.text;
      if (!forces) continue;
      const AxisAngle<Number> axis = axis_angle(inside(phi));
      const auto point = principal_forces(Inertia3<Number>{body.J1, body.J2, body.J3}, exact, q,
                                          own, two_product(0.8, 0.8), &axis, Branch::i);
      EXPECT_TRUE(forces->along.may_be(double(point->along))) << of.text;
      EXPECT_TRUE(forces->across.may_be(double(point->across))) << of.text;
      EXPECT_TRUE(forces->sum.may_be(double(point->sum))) << of.text;
      EXPECT_TRUE(forces->turning->may_be(double(*point->turning))) << of.text;
      EXPECT_TRUE(forces->compatibility->may_be(double(*point->compatibility))) << of.text;
    }
  }
  EXPECT_GE(with_circles, 8);
}

/// As narrow as the box allows: away from the circle each end is met in a corner.
TEST(PrincipalFrame, OfBoxesIsNarrow) {
  support::Random random(574);
  for (int k = 0; k < 64; ++k) {
    const bool wide = random.sign() > 0.0;  // along axis 1
    const auto box = [&](double x) { return Interval(x, 1.2 * x); };
    const Interval one = box(random.log_uniform(0.3, 1.0));
    const Interval two = box(random.log_uniform(1.3, 4.0));
    const Interval a =
        random.sign() > 0.0 ? box(random.log_uniform(1.0, 5.0)) : box(random.log_uniform(0.2, 0.8));
    const auto stretch = oriented_stretch(wide ? two : one, wide ? one : two, Interval(1.0), a);
    const PrincipalFrame<Interval> frame = principal_frame(stretch);
    std::array<double, 4> low;
    std::array<double, 4> high;
    low.fill(HUGE_VAL);
    high.fill(-HUGE_VAL);
    for (int corner = 0; corner < 8; ++corner) {
      const auto end = [&](const Interval& x, int bit) {
        return Number((corner >> bit & 1) != 0 ? x.hi : x.lo);
      };
      const PrincipalFrame<Number> own = frame_of(
          oriented_stretch(end(stretch.q.xi, 0), end(stretch.q.zeta, 1), Number(1.0), end(a, 2)));
      const std::array<double, 4> at{double(own.large), double(own.small), double(own.cosine),
                                     double(own.sine)};
      for (std::size_t i = 0; i < 4; ++i) {
        low[i] = std::min(low[i], at[i]);
        high[i] = std::max(high[i], at[i]);
      }
    }
    const std::array<Interval, 4> found{frame.large, frame.small, frame.cosine, frame.sine};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(found[i].lo, low[i], 1e-13 * std::abs(low[i]) + 1e-14) << i;
      EXPECT_NEAR(found[i].hi, high[i], 1e-13 * std::abs(high[i]) + 1e-14) << i;
    }
  }
}

}  // namespace
}  // namespace stationary
