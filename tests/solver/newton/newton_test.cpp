// Newton in ln x: quadratic where it converges, honest where it does not.
#include "solver/newton/newton.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/models.hpp"

namespace stationary {
namespace {

template <class Model>
class NewtonTest : public ::testing::Test {};
TYPED_TEST_SUITE(NewtonTest, support::BuiltInPlanarModels, support::ModelName);

/// A state becomes an equilibrium of slow rates near rest: solve there from rest.
TYPED_TEST(NewtonTest, ReachesASlowRotationFromRest) {
  support::Random random(61);
  for (int k = 0; k < 100; ++k) {
    const auto model = random.coefficients<TypeParam>();
    const double r = model.rest_stretch();
    PlanarSystem<TypeParam> system{model, {0.0, 0.0, 0.0}};
    const double stiffness = 1.0 / system.linearize({r, r}).jacobian.inverse().absolute()(0, 0);
    const double rate = 1e-2 * stiffness / (r * r);
    system.rates = {rate, 0.5 * rate, 0.0};
    ReducedVector<2> x(r, r);
    const NewtonResult result = newton(system, x);
    ASSERT_TRUE(result.converged) << support::text_of(model);
    EXPECT_LE(result.steps, 6);
    const Linearized<2> at = system.linearize(x);
    EXPECT_LE(at.g.cwiseAbs().maxCoeff(), 32 * 0x1p-53 * at.magnitude) << support::text_of(model);
    EXPECT_GE(x[0], r) << "the pull is outwards";
  }
}

TYPED_TEST(NewtonTest, ConvergesQuadratically) {
  support::Random random(62);
  for (int k = 0; k < 20; ++k) {
    const auto model = random.coefficients<TypeParam>();
    const double r = model.rest_stretch();
    const PlanarSystem<TypeParam> system{model, {0.0, 0.0, 0.0}};
    const auto error_after_step = [&](double error) {
      ReducedVector<2> x(r * std::exp(error), r * std::exp(-0.5 * error));
      newton(system, x, {.max_steps = 1});
      return (x.array() / r).log().abs().maxCoeff();
    };
    const double kappa = system.linearize({r, r}).magnitude *
                         system.linearize({r, r}).jacobian.inverse().absolute().matrix().sum();
    for (const double error : {1e-2, 1e-3, 1e-4})
      EXPECT_LE(error_after_step(error), 2.0 * kappa * error * error + 1e-14)
          << support::text_of(model);
  }
}

TEST(Newton, StepLimitIsNoConvergence) {
  const PlanarSystem<NeoHookean<>> system{{1.0, 0.5}, {0.3, 0.2, 0.0}};
  ReducedVector<2> x(1.0, 1.0);
  const NewtonResult result = newton(system, x, {.max_steps = 2});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.steps, 2);
  EXPECT_TRUE(newton(system, x).converged);
}

TEST(Newton, NeverMovesFartherThanItsLimitInOneStep) {
  const PlanarSystem<NeoHookean<>> system{{1.0, 0.5}, {0.3, 0.2, 0.0}};
  support::Random random(63);
  for (int k = 0; k < 200; ++k) {
    const ReducedVector<2> start(random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3));
    ReducedVector<2> x = start;
    newton(system, x, {.max_steps = 1, .max_log_step = 0.25});
    EXPECT_LE((x.array() / start.array()).log().abs().maxCoeff(), 0.25 * (1 + 1e-12));
  }
}

/// No solution to find (mu between the two rates): it must run out of steps or stop, finite.
TEST(Newton, WhereNothingExistsItSaysSo) {
  const PlanarSystem<NeoHookean<>> system{{1.0, 0.5}, {0.5, 1.5, 0.0}};
  support::Random random(64);
  for (int k = 0; k < 200; ++k) {
    ReducedVector<2> x(random.log_uniform(0.1, 10.0), random.log_uniform(0.1, 10.0));
    EXPECT_FALSE(newton(system, x).converged);
    EXPECT_TRUE(x.allFinite());
    EXPECT_GT(x.minCoeff(), 0.0);
  }
}

TEST(Newton, SingularJacobianStopsItWhereItIs) {
  const PlanarSystem<Biot<>> system{{1.0, 0.0}, {1.0, 0.0, 0.0}};
  ReducedVector<2> x(1.0, 1.0);
  ASSERT_EQ(system.linearize(x).jacobian(0, 0), 0.0);
  const NewtonResult result = newton(system, x);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.steps, 0);
  EXPECT_EQ(x, ReducedVector<2>(1.0, 1.0));
}

}  // namespace
}  // namespace stationary
