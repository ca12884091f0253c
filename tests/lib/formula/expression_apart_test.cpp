// A coupled formula that is a sum of one of the plane and one of the thickness becomes these two.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/formula/apart.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/bodies/written_potential.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace support;

const std::vector<double> values{1.3, 2.6};

std::optional<expression::PlaneAndThickness> parts_of(const std::string& text) {
  return expression::taken_apart(
      parse_expression(text, k_and_n, ExpressionSlot::coupled).expression);
}

TEST(ExpressionApart, ThePartsMakeUpTheWhole) {
  Random random(99);
  for (const char* text :
       {"k*t^2 + n*log(d) + rho^2 - n", "log(d*rho)", "k*log(d*rho) + n*(I1 + rho^2)",
        "lambda^n + mu_^n + k*(rho - 1)^2", "exp(k*log(d))*2 + 1/rho", "-(t + rho)/n",
        "n*(xi^2 + zeta^2 + 2*alpha^2 + rho^2 - 3) - k*log(d*rho^2)"}) {
    const auto parts = parts_of(text);
    ASSERT_TRUE(parts) << text;
    const CoupledExpression<> whole = written_coupled(text, k_and_n, values);
    const Separable<PlanarExpression<>, ThicknessExpression<>> sum{
        {expression::planar_tape(parts->plane), coefficient_list(values)},
        {expression::thickness_tape(parts->thickness), coefficient_list(values)}};
    for (int trial = 0; trial < 20; ++trial) {
      Stretch q{0.0, random.uniform(0.4, 2.0), random.uniform(0.4, 2.0), random.uniform(0.4, 2.0)};
      q.alpha = random.uniform(-0.3, 0.3) * std::sqrt(q.xi * q.zeta);
      const auto expected = potential_derivatives<2>(whole, q);
      const auto actual = potential_derivatives<2>(sum, q);
      const double allowed = 1e-13 * (1.0 + expected.hessian.cwiseAbs().maxCoeff());
      EXPECT_TRUE(agrees(at(text, q), expected.value, actual.value, allowed));
      for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(agrees(at(text, q), expected.gradient[i], actual.gradient[i], allowed));
        for (int j = 0; j < 4; ++j)
          EXPECT_TRUE(agrees(at(text, q), expected.hessian(i, j), actual.hessian(i, j), allowed));
      }
    }
  }
}

/// What has no two parts: one that is coupled, or a part that would be a constant.
TEST(ExpressionApart, OthersStayWhole) {
  for (const char* text :
       {"I1*rho", "log(d*rho)^2", "k*t^2 + d", "rho^2 + k", "k", "(t + rho)^2",
        // At rho = 1, or d = 1, it would be none of its domain.
        "k*I1 + rho^2 - n*log((d - 2)*rho)", "k*I1 + rho^2 - n*log(d*(rho - 2))"})
    EXPECT_FALSE(parts_of(text)) << text;
}

}  // namespace
}  // namespace stationary
