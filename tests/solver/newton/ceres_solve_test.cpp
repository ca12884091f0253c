// Ceres on the reduced systems: it reaches what it can to full precision, and what it returns is
// finite and positive whatever it met.
#include "solver/newton/ceres_solve.hpp"

#include <gtest/gtest.h>

#include "solver/newton/refine.hpp"
#include "tests/support/bodies/models.hpp"

namespace stationary {
namespace {

template <class Model>
class CeresSolveTest : public ::testing::Test {};
TYPED_TEST_SUITE(CeresSolveTest, support::BuiltInPlanarModels, support::ModelName);

/// Its parameter tolerance by default would leave errors of 1e-8.
TYPED_TEST(CeresSolveTest, ReachesASlowRotationFromRestToFullPrecision) {
  support::Random random(71);
  for (int k = 0; k < 25; ++k) {
    const auto model = random.coefficients<TypeParam>();
    const double r = model.rest_stretch();
    PlanarSystem<BuiltInPlane<>> system{{{model}}, {0.0, 0.0, 0.0}};
    const double stiffness = 1.0 / system.linearize({r, r}).jacobian.inverse().absolute()(0, 0);
    const double rate = 3e-2 * stiffness / (r * r);
    system.rates = {rate, 0.5 * rate, 0.0};
    ReducedVector<2> x(r, r);
    const CeresOutcome outcome = ceres_solve(system, x, 1);
    ASSERT_TRUE(outcome.usable) << support::text_of(model);
    const Linearized<2> at = system.linearize(x);
    EXPECT_LE(at.g.cwiseAbs().maxCoeff(), 1e-13 * at.magnitude) << support::text_of(model);
    const ReducedVector<2> left = x;
    ASSERT_TRUE(refine(system, x).converged);
    const double kappa = at.magnitude * at.jacobian.inverse().absolute().matrix().sum();
    EXPECT_LE((left.array() / x.array() - 1.0).abs().maxCoeff(), 1e-14 * (1.0 + kappa));
    EXPECT_GT(outcome.iterations, 0);
    EXPECT_GE(outcome.residuals, outcome.iterations - 1);
    EXPECT_GT(outcome.jacobians, 0);
  }
}

const BuiltInPlane<> neo_hookean{{NeoHookean<>{1.0, 0.5}}};

TEST(CeresSolve, ThreeUnknowns) {
  const CoupledSystem<NeoHookean3d<>> system{{1.0, 0.5}, {0.2, 0.1, 0.3}};
  ReducedVector<3> x(1.0, 1.0, 1.0);
  ASSERT_TRUE(ceres_solve(system, x, 1).usable);
  ReducedVector<3> refined = x;
  ASSERT_TRUE(refine(system, refined).converged);
  EXPECT_LE((x.array() / refined.array() - 1.0).abs().maxCoeff(), 1e-13);
}

TEST(CeresSolve, ThreadsDoNotChangeTheAnswer) {
  const PlanarSystem<BuiltInPlane<>> system{neo_hookean, {0.4, 0.3, 0.0}};
  ReducedVector<2> one(1.0, 1.0);
  ReducedVector<2> two(1.0, 1.0);
  ceres_solve(system, one, 1);
  ceres_solve(system, two, 2);
  EXPECT_EQ(one, two);
}

/// Where there is no equilibrium it ends somewhere finite, and refine() does not call it one.
TEST(CeresSolve, WhereNothingExistsItsWordIsNotTaken) {
  const PlanarSystem<BuiltInPlane<>> system{neo_hookean, {0.5, 1.5, 0.0}};
  ReducedVector<2> x(1.0, 1.0);
  ceres_solve(system, x, 1);
  EXPECT_TRUE(x.allFinite());
  EXPECT_GT(x.minCoeff(), 0.0);
  EXPECT_FALSE(refine(system, x).converged);
}

}  // namespace
}  // namespace stationary
