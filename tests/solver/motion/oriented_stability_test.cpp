// The rate at which a motion of an anisotropic body grows is the largest of its modes', in whatever
// parts the spectrum comes.
#include <gtest/gtest.h>

#include "solver/solve/stability.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"

namespace stationary {
namespace {

using namespace testing;

TEST(OrientedStability, GrowthIsThatOfTheFastestMode) {
  support::Random random(301);
  int growing = 0;
  int others = 0;
  for (int kind = 0; kind < 48; ++kind) {
    const OrientedBody at = random_oriented_body(random, kind);
    // About the axis of the middle inertia a stiff body's rotation grows.
    const double J[] = {at.body.J1, at.body.J2, at.body.J3};
    const Body middle_third(
        std::max({J[0], J[1], J[2]}), std::min({J[0], J[1], J[2]}),
        J[0] + J[1] + J[2] - std::max({J[0], J[1], J[2]}) - std::min({J[0], J[1], J[2]}));
    const Problem problem(middle_third, at.potential(), Branch::iii);
    const Equilibrium found = solve(problem, at.nu, without_search());
    if (found.status != SolveStatus::solved) continue;
    const Spectrum spectrum = stability(problem, found);
    double fastest = 0.0;
    for (int k = 0; k < spectrum.modes; ++k)
      fastest = std::max(fastest, spectrum.mode[static_cast<std::size_t>(k)].re);
    if (spectrum.verdict == StabilityClass::unstable ||
        spectrum.verdict == StabilityClass::oscillatory) {
      EXPECT_EQ(spectrum.growth, fastest) << at.text;
      EXPECT_GT(spectrum.growth, 0.0) << at.text;
      ++growing;
    } else {
      if (spectrum.verdict != StabilityClass::marginal) {
        EXPECT_EQ(spectrum.growth, 0.0) << at.text;
      }
      ++others;
    }
  }
  EXPECT_GT(growing, 5);
  EXPECT_GT(growing + others, 20);
}

}  // namespace
}  // namespace stationary
