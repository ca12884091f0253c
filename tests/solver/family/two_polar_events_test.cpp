// What the events of a two-polar family are: which of their equations a zero stands for, and which
// blocks of its spectrum may have collisions.
#include "solver/family/two_polar_events.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lib/body/inertia.hpp"

namespace stationary {
namespace {

/// lambda > mu, the axis of the momentum fixed in the figure.
Member ellipse() {
  Member out;
  out.body = Body(1.1, 1.1, 0.7);
  out.q = {0.0, 1.6, 0.8, 0.9};
  return out;
}

/// omega = s3/I about the axis of the figure that the motion leaves.
TEST(TwoPolarEvents, ATiltLeavesTheAxisWhoseRateItHas) {
  for (const double omega : {0.7, -0.7, 1e-3}) {
    for (const double off : {0.0, 1e-6, -1e-6}) {
      Member at = ellipse();
      const Vector3<double> m = second_moments(at.body, at.q);
      const auto leaves = [&](double inertia) {
        const double s3 = omega * (1.0 + off) * inertia;
        at.two_polar = TwoPolarState{{omega, 0.2}, {s3, 0.1}, false};
        return vanishing_at(EventType::tilt, false, at);
      };
      EXPECT_EQ(leaves(m[1] + m[2]), TwoPolarVanishing::leaves_mu) << omega << off;
      EXPECT_EQ(leaves(m[0] + m[2]), TwoPolarVanishing::leaves_lambda) << omega << off;
      EXPECT_EQ(vanishing_at(EventType::tilt, true, at), TwoPolarVanishing::leaves_circle);
    }
  }
}

/// What makes or turns an ellipse has a sign where it is more than the rounding of its terms.
TEST(TwoPolarEvents, AStiffnessBelowItsRoundingHasNoSign) {
  const KindEvents events = two_polar_events();
  const TestContext context{
      .branch = Branch::iii, .material_symmetry = true, .circle = Circle::xi_zeta};
  Member at = ellipse();
  at.q = {0.0, 1.2, 1.2, 0.9};
  at.nu = 0.5;
  at.two_polar = TwoPolarState{{0.3, 0.2}, {0.1, 0.1}, false};
  at.error_bound = 1e-15;
  at.turn_condition = 10.0;
  for (const double size : {1e-3, 1e-13, 1e-15, 0.0}) {
    at.shear_stiffness = size;
    at.turn = -size;
    TestValues out;
    out.value.fill(std::numeric_limits<double>::quiet_NaN());
    events.set(at, context, out);
    EXPECT_EQ(out.sign(TestValues::ellipse), size > 2e-14 ? 1 : 0) << size;
    EXPECT_EQ(out.sign(TestValues::turn), size > 2e-14 ? -1 : 0) << size;
  }
}

/// The modes of a circle are those of (iii), of which only the shear's may leave the real axis; of
/// an ellipse the function of collisions says nothing.
TEST(TwoPolarEvents, OnlyTheShearOfACircleMayCollide) {
  const KindEvents events = two_polar_events();
  TestContext context{.branch = Branch::iii, .material_symmetry = true};
  for (const Block block : {Block::even, Block::odd, Block::shear}) {
    context.circle = Circle::xi_zeta;
    EXPECT_EQ(events.may_collide(block, context), block == Block::shear);
    context.circle = Circle::none;
    EXPECT_FALSE(events.may_collide(block, context));
  }
}

}  // namespace
}  // namespace stationary
