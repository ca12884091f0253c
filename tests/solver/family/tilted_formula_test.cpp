// The tilted family of a formula in the principal stretches.
#include <gtest/gtest.h>

#include "solver/family/tilted_family.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

const Body body(1.0, 1.7, 0.6);

/// By the invariants its second derivatives would lose the square of the ratio of the stretches.
TEST(TiltedFamily, AFormulaOfThePrincipalStretchesKeepsItsDigitsFarFromTheCircle) {
  const std::vector<double> plane{1.0, 2.0};
  const Potential built_in(Potential::planar("hencky", plane),
                           Potential::thickness("reciprocal-quadratic", plane));
  const auto written =
      support::written_plane("c*(log(lambda)^2 + log(mu_)^2) + k/2*log(d)^2", {"c", "k"}, plane);
  const Potential formula(
      SeparableExpression{AnyPlane<>{{written}}, AnyThickness<>{{built_in.thickness()}}});
  const Potential coupled(support::written_coupled(
      "c*(log(lambda)^2 + log(mu_)^2) + k/2*log(d)^2 + c/rho + k/2*rho^2", {"c", "k"}, plane));
  for (const TiltPlane tilt : {TiltPlane::one_three, TiltPlane::two_three}) {
    const auto known = tilted_family(body, built_in, tilt, false);
    for (const Potential& each : {formula, coupled}) {
      const auto family = tilted_family(body, each, tilt, false);
      for (const double ratio : {1e-6, 1e-3, 0.5, 1e4, 1e7}) {
        const ReducedVector<2> x(0.8, 0.8 * ratio);
        const auto expected = known->linearize(x, 1.1);
        const auto at = family->linearize(x, 1.1);
        // Rows may be divided by another magnitude.
        const double factor = expected.slope[0] / at.slope[0];
        EXPECT_LE((factor * at.jacobian - expected.jacobian).norm(),
                  1e-13 * expected.jacobian.norm())
            << ratio;
        EXPECT_LE((factor * at.g - expected.g).norm(), 1e-13 * expected.g.norm()) << ratio;
      }
    }
  }
}

}  // namespace
}  // namespace stationary
