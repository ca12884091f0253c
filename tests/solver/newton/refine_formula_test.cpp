// The last correction beside a pole of a formula, where the balance bends far more than the size of
// its terms says.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/newton/refine.hpp"
#include "solver/newton/thickness_balance.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

/// rho b/(r - rho)^2 = m rho^2 has the solution 1 - gap for r = m = 1, b = gap^2 (1 - gap).
TEST(RefineFormula, TheBoundHoldsBesideAPole) {
  for (const double gap : {0x1p-8, 0x1p-14, 0x1p-20, 0x1p-26}) {
    const double exact = 1.0 - gap;
    const auto model =
        support::written_thickness("b/(r - rho)", {"b", "r"}, {gap * gap * exact, 1.0});
    const ThicknessSystem<ThicknessExpression<>> system{model, DoubleDouble(1.0)};
    for (const double off : {1e-3 * gap, -1e-3 * gap, 1e-2 * gap, 1e-9 * gap}) {
      ReducedVector<1> x(exact * (1.0 + off));
      const Refined refined = refine(system, x);
      ASSERT_TRUE(refined.converged) << gap << " " << off;
      const double error = std::abs(x[0] / exact - 1.0);
      EXPECT_LE(error, refined.error_bound) << gap << " " << off;
      EXPECT_LE(error, 0x1p-52) << gap << " " << off;
    }
  }
}

/// A start at rounding shows no bend, and where no step more is allowed the last one is measured by
/// none: the bound is that of the inputs then.
TEST(RefineFormula, AStartNextToTheSolutionIsBoundedByItsInputs) {
  for (const double gap : {0x1p-4, 0x1p-6, 0x1p-8}) {
    const double exact = 1.0 - gap;
    const auto model =
        support::written_thickness("b/(r - rho)", {"b", "r"}, {gap * gap * exact, 1.0});
    const ThicknessSystem<ThicknessExpression<>> system{model, DoubleDouble(1.0)};
    for (const double off : {4e-16, -8e-16, 1e-12}) {
      ReducedVector<1> x(exact * (1.0 + off));
      const Refined refined = refine(system, x, 1);
      ASSERT_TRUE(refined.converged) << gap << " " << off;
      EXPECT_EQ(refined.steps, 1);
      const double error = std::abs(x[0] / exact - 1.0);
      EXPECT_LE(error, refined.error_bound) << gap << " " << off;
      EXPECT_LE(refined.error_bound, 1e-14) << gap << " " << off;
    }
  }
}

/// m(rho) = V'/rho rises up to a fold, at 1.80438 here: up to there a thickness is connected to rest.
TEST(RefineFormula, AThicknessIsFoundUpToItsFold) {
  const AnyThickness<> model{
      support::written_thickness("k/2*log(rho)^2 + 0.05*k*(rho - 1)^2", {"k"}, {1.0})};
  for (const double rho : {1.2, 1.7, 1.78, 1.79, 1.8, 1.804}) {
    const double m = (std::log(rho) / rho + 0.1 * (rho - 1.0)) / rho;
    const ThicknessBalance found = balanced_thickness(model, DoubleDouble(m));
    ASSERT_TRUE(found.refined.converged) << rho;
    EXPECT_NEAR(found.rho, rho, 1e-10) << rho;
  }
  EXPECT_FALSE(balanced_thickness(model, DoubleDouble(0.22587)).refined.converged);
  // A well much narrower than the steps.
  const AnyThickness<> well{support::written_thickness("1 - exp(-p*(rho - 1)^2)", {"p"}, {2e5})};
  const ThicknessBalance found = balanced_thickness(well, DoubleDouble(0.054));
  ASSERT_TRUE(found.refined.converged);
  EXPECT_NEAR((found.rho - 1.0) * 4e5, 0.054, 1e-6);
}

/// A place from which Newton's method leads nowhere is no place to begin at.
TEST(RefineFormula, AThicknessIsFoundFromItsOwnStartWhereTheGivenOneIsOfNoUse) {
  const AnyThickness<> model{
      support::written_thickness("a/rho + b/2*rho^2", {"a", "b"}, {1.0, 3.0})};
  const ThicknessBalance own = balanced_thickness(model, DoubleDouble(0.2));
  ASSERT_TRUE(own.refined.converged);
  EXPECT_NEAR(own.rho, std::cbrt(1.0 / 2.8), 1e-14);
  for (const double near : {own.rho, 0.9, 1e200, std::numeric_limits<double>::quiet_NaN()}) {
    const ThicknessBalance found = balanced_thickness(model, DoubleDouble(0.2), near);
    ASSERT_TRUE(found.refined.converged) << near;
    EXPECT_EQ(found.rho, own.rho) << near;
  }
}

}  // namespace
}  // namespace stationary
