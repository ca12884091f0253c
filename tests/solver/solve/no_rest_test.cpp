// A potential without a minimum has no state of rest, and where a solve begins at rest it says so.
#include <gtest/gtest.h>

#include "solver/solve/solve.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

/// Convex in the stretch, and falling with it for ever.
TEST(NoRest, IsSaidOfAPotentialWithoutAMinimum) {
  const auto parsed = parse_expression("k*alpha^2 - k*log(xi*zeta)", std::vector<std::string>{"k"},
                                       ExpressionSlot::plane);
  const OrientedExpression<> plane(expression::oriented_tape(parsed.expression),
                                   coefficient_list(std::vector<double>{0.7}));
  const Potential V(AnisotropicPotential(AnisotropicPotential::Plane(plane),
                                         ThicknessPotential(ReciprocalQuadratic<>{1.0, 3.0}), {}));
  SolveOptions how;
  how.search = false;
  for (const double nu : {0.0, 0.1}) {
    for (const Method method : {Method::automatic, Method::newton}) {
      how.method = method;
      const Equilibrium found = solve(Problem(Body(1.0, 1.7, 0.6), V, Branch::iii), nu, how);
      EXPECT_NE(found.status, SolveStatus::solved) << nu;
      EXPECT_NE(found.message.find("no rest state"), std::string::npos) << found.message;
    }
  }
}

}  // namespace
}  // namespace stationary
