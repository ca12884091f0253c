// What a family leaves to be solved, and the rates it hands out.
#include "solver/motion/problem.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/bodies/whole_body.hpp"

namespace stationary {
namespace {

using ::testing::HasSubstr;
using testing::make_potential;
using testing::plate;
using testing::whole_body;

TEST(Problem, ThicknessRuleFollowsPotentialAndBranch) {
  const Potential separable = make_potential("biot", {1.0, 0.5});
  const Potential coupled = make_potential("neo-hookean-3d", {1.0, 0.5});
  EXPECT_EQ(Problem(plate, separable, Branch::i).thickness_rule(), ThicknessRule::closed_form);
  EXPECT_EQ(Problem(plate, separable, Branch::ii).thickness_rule(), ThicknessRule::closed_form);
  EXPECT_EQ(Problem(plate, separable, Branch::iii).thickness_rule(), ThicknessRule::constant);
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    EXPECT_EQ(Problem(plate, separable, branch).unknowns(), 2);
    EXPECT_EQ(Problem(plate, coupled, branch).unknowns(), 3);
    EXPECT_EQ(Problem(plate, coupled, branch).thickness_rule(), ThicknessRule::coupled);
  }
}

TEST(Problem, KeepsWhatItWasGiven) {
  const Problem problem(plate, make_potential("biot", {1.0, 0.5}), Branch::ii);
  EXPECT_EQ(problem.body(), plate);
  EXPECT_EQ(problem.branch(), Branch::ii);
  EXPECT_TRUE(problem.potential().is_separable());
}

TEST(Problem, RatesAreTheDiagonalOfC) {
  support::Random random(51);
  for (int k = 0; k < 100; ++k) {
    const testing::Posed posed = testing::random_problem(random, 4.0);
    const Vector3<double> nu = angular_velocity(posed.problem.branch(), posed.nu);
    const Matrix4<double> C = centrifugal_matrix(posed.problem.body(), nu);
    const auto rates = posed.problem.rates(posed.nu * posed.nu);
    EXPECT_EQ(rates.xi, C(1, 1)) << posed.text;
    EXPECT_EQ(rates.zeta, C(2, 2)) << posed.text;
    EXPECT_EQ(rates.rho, C(3, 3)) << posed.text;
    const auto wide = posed.problem.rates(two_product(posed.nu, posed.nu));
    EXPECT_NEAR(double(wide.xi), rates.xi, 0x1p-51 * rates.xi);
    EXPECT_NEAR(double(wide.rho), rates.rho, 0x1p-51 * rates.rho);
  }
}

TEST(Problem, NoPullAlongTheSpin) {
  const Potential potential = make_potential("biot", {1.0, 0.5});
  EXPECT_EQ(Problem(plate, potential, Branch::i).rates(2.0).xi, 0.0);
  EXPECT_EQ(Problem(plate, potential, Branch::ii).rates(2.0).zeta, 0.0);
  EXPECT_EQ(Problem(plate, potential, Branch::iii).rates(2.0).rho, 0.0);
}

TEST(Problem, PlanNamesEveryQuantityAndWhy) {
  for (const Body& body : {plate, Body(1.0, 1.0, 0.6)}) {
    for (const char* model : {"biot", "neo-hookean-3d"}) {
      for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
        const Problem problem(body, make_potential(model, {1.0, 0.5}), branch);
        std::vector<std::string> quantities;
        for (const PlanItem& item : problem.plan()) {
          quantities.push_back(item.quantity);
          EXPECT_FALSE(item.how.empty());
          EXPECT_FALSE(item.why.empty());
        }
        EXPECT_THAT(quantities, ::testing::ElementsAre("alpha", "rho", "xi, zeta"));
      }
    }
  }
}

TEST(Problem, PlanGivesTheRightReason) {
  const Potential separable = make_potential("biot", {1.0, 0.5});
  const auto why = [&](const Body& body, Branch branch) {
    return Problem(body, separable, branch).plan().front().why;
  };
  EXPECT_THAT(why(plate, Branch::i), HasSubstr("compatibility"));
  EXPECT_THAT(why(Body(1.0, 1.0, 0.6), Branch::i), HasSubstr("compatibility"));
  EXPECT_THAT(why(plate, Branch::iii), HasSubstr("J1 != J2"));
  EXPECT_THAT(why(Body(1.0, 1.0, 0.6), Branch::iii), HasSubstr("theta = 0"));
  EXPECT_THAT(Problem(plate, separable, Branch::iii).plan()[1].how, HasSubstr("once for all nu"));
  EXPECT_THAT(
      Problem(plate, make_potential("neo-hookean-3d", {1.0, 0.5}), Branch::iii).plan()[2].how,
      HasSubstr("3 equations"));
}

TEST(Problem, PlanNamesTheForcesThatAreThere) {
  const AnyPlane<> plane{Hencky<>{1.0, 0.6}};
  const AnyThickness<> thickness{ReciprocalQuadratic<>{0.8, 1.3}};
  const auto why = [](const Potential& potential) {
    return Problem(plate, potential, Branch::i).plan().back().why;
  };
  EXPECT_EQ(why(Potential(Hencky<>{1.0, 0.6}, ReciprocalQuadratic<>{0.8, 1.3})),
            "balance of elastic and centrifugal force");
  EXPECT_EQ(why(whole_body(plane, thickness, 1.0, {}, plate)),
            "balance of elastic, centrifugal force and pressure");
  EXPECT_EQ(why(whole_body(plane, thickness, {}, 0.7, plate)),
            "balance of elastic, centrifugal force and gravity");
  EXPECT_EQ(why(whole_body(plane, thickness, 1.0, 0.7, plate)),
            "balance of elastic, centrifugal force, gravity and pressure");
  BodyModel<> fluid;
  fluid.volume = 1.0;
  fluid.gravitates = true;
  fluid.g = 0.7;
  fluid.J = {plate.J1, plate.J2, plate.J3};
  EXPECT_EQ(why(Potential(fluid)), "balance of centrifugal force, gravity and pressure");
}

}  // namespace
}  // namespace stationary
