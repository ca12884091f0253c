// A plane and a thickness, each a built-in model or the same written out as a formula: one motion, one
// spectrum. And a written-out coupled one beyond its fold.
#include <gtest/gtest.h>

#include <array>

#include "solver/solve/solve.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using namespace testing;

TEST(WrittenParts, HaveTheSpectrumOfTheModels) {
  const auto plane = support::written_plane("mu*(log(lambda)^2 + log(mu_)^2) + la/2*log(d)^2",
                                            {"mu", "la"}, {1.1, 0.8});
  const auto thickness = support::written_thickness("a/rho + b/2*rho^2", {"a", "b"}, {1.0, 3.0});
  const Hencky<> own_plane{1.1, 0.8};
  const ReciprocalQuadratic<> own_thickness{1.0, 3.0};
  const Potential built_in(own_plane, own_thickness);
  const std::array mixed{
      Potential(SeparableExpression{AnyPlane<>{own_plane}, AnyThickness<>{thickness}}),
      Potential(SeparableExpression{AnyPlane<>{plane}, AnyThickness<>{own_thickness}}),
      Potential(SeparableExpression{AnyPlane<>{plane}, AnyThickness<>{thickness}})};
  const Body body(1.0, 1.7, 0.6);
  for (const Branch branch : branches) {
    for (const double nu : {0.2, 0.5}) {
      const Problem own(body, built_in, branch);
      const Equilibrium at = solve(own, nu);
      ASSERT_EQ(at.status, SolveStatus::solved);
      const Spectrum expected = stability(own, at);
      for (const Potential& V : mixed) {
        const Problem problem(body, V, branch);
        const Equilibrium other = solve(problem, nu);
        ASSERT_EQ(other.status, SolveStatus::solved) << other.message;
        EXPECT_NEAR(other.q.rho, at.q.rho, 1e-15);
        const Spectrum spectrum = stability(problem, other);
        EXPECT_EQ(spectrum.verdict, expected.verdict);
        EXPECT_EQ(spectrum.negative, expected.negative);
        ASSERT_EQ(spectrum.modes, expected.modes);
        for (std::size_t k = 0; k < static_cast<std::size_t>(spectrum.modes); ++k) {
          const Mode& one = spectrum.mode[k];
          const Mode& two = expected.mode[k];
          EXPECT_NEAR(one.lambda_re, two.lambda_re, one.lambda_error + two.lambda_error)
              << name(branch) << " " << nu << " " << k;
          EXPECT_EQ(one.krein, two.krein);
        }
      }
    }
  }
}

/// V = mu sum ln^2 + la/2 ln^2 det S: of long stretches it pulls less than what turns.
TEST(WrittenParts, HaveNoStretchesBeyondTheFold) {
  const Problem problem(Body(1.0, 1.7, 0.6),
                        Potential(support::written_coupled(
                            "mu*(log(lambda)^2 + log(mu_)^2 + log(rho)^2) + la/2*log(d*rho)^2",
                            {"mu", "la"}, {1.0, 0.5})),
                        Branch::i);
  ASSERT_EQ(solve(problem, 0.3).status, SolveStatus::solved);
  for (const Method method : {Method::automatic, Method::newton, Method::ceres}) {
    SolveOptions options;
    options.method = method;
    options.start = Stretch{0.0, 1.0, 1.2, 0.9};
    const Equilibrium answer = solve(problem, 1.5, options);
    EXPECT_NE(answer.status, SolveStatus::solved);
    EXPECT_TRUE(std::isnan(answer.q.xi) && std::isnan(answer.q.zeta) && std::isnan(answer.q.rho) &&
                std::isnan(answer.residual));
    EXPECT_FALSE(answer.unrounded);
  }
}

}  // namespace
}  // namespace stationary
