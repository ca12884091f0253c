// The last correction beside a pole of a formula, where the balance bends far more than the size of
// its terms says.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/newton/refine.hpp"
#include "tests/support/written_potential.hpp"

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

}  // namespace
}  // namespace stationary
