// What a solve says it has evaluated is what it has: sums of its parts, one Jacobian to a step of
// Newton's.
#include <gtest/gtest.h>

#include "solver/solve/two_polar_equilibrium.hpp"

namespace stationary {
namespace {

const Potential separable(Hencky<>{1.0, 3.0}, ReciprocalQuadratic<>{1.0, 3.0});
const Potential coupled(NeoHookean3d<>{1.0, 2.0});

TEST(Counts, AddUp) {
  Counts sum{1, 2, 3, 4, 5, 6, 7};
  sum += Counts{10, 20, 30, 40, 50, 60, 70};
  EXPECT_EQ(sum.residuals, 11);
  EXPECT_EQ(sum.jacobians, 22);
  EXPECT_EQ(sum.extended_residuals, 33);
  EXPECT_EQ(sum.newton_steps, 44);
  EXPECT_EQ(sum.ceres_iterations, 55);
  EXPECT_EQ(sum.nlopt_evaluations, 66);
  EXPECT_EQ(sum.walk_steps, 77);
}

/// Each of Newton's steps, the last corrections too, needs its Jacobian, and nothing else does.
TEST(Counts, OfNewtonsMethodAreItsSteps) {
  SolveOptions how;
  how.method = Method::newton;
  for (const double nu : {0.1, 0.3, 0.5}) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const Equilibrium found = solve(Problem(Body(1.0, 1.7, 0.6), coupled, branch), nu, how);
      ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
      EXPECT_GE(found.counts.newton_steps, 3);
      EXPECT_EQ(found.counts.jacobians, found.counts.newton_steps);
    }
  }
}

TEST(Counts, OfATwoPolarStartAreItsSteps) {
  const Body round(1.25, 1.25, 0.6);
  const TwoPolarMotion motion = TwoPolarRates<double>{0.65, 0.0};
  SolveOptions how;
  how.start = Stretch{0.0, 2.3, 0.64, 0.69};
  const Equilibrium found = solve_two_polar(round, separable, motion, how);
  ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
  ASSERT_FALSE(found.circle);
  EXPECT_GE(found.counts.newton_steps, 2);
  EXPECT_EQ(found.counts.jacobians, found.counts.newton_steps);
}

}  // namespace
}  // namespace stationary
