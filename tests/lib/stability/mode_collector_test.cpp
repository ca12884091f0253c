// What the verdict on a block is made of: signs, and the negative eigenvalues of two rows.
#include "lib/stability/mode_collector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stationary {
namespace {

TEST(ModeCollector, ZeroHasNoSign) {
  EXPECT_EQ(sign(0.0), 0);
  EXPECT_EQ(sign(-0.0), 0);
  EXPECT_EQ(sign(5e-324), 1);
  EXPECT_EQ(sign(-5e-324), -1);
}

TEST(ModeCollector, CountsNegativeEigenvaluesOfTwoRows) {
  EXPECT_EQ(negatives_2(1.0, 2.0, 2.0), 0);
  EXPECT_EQ(negatives_2(-1.0, -2.0, 2.0), 2);
  EXPECT_EQ(negatives_2(1.0, -2.0, -2.0), 1);
  EXPECT_EQ(negatives_2(1.0, 0.0, 0.0), 0);
  EXPECT_EQ(negatives_2(-1.0, 0.0, 0.0), 1);
  EXPECT_EQ(negatives_2(0.0, 0.0, 0.0), 0);
}

/// Certain only beyond what its inputs allow.
/// What grows beside a mode that is open is told of in a marginal row too.
TEST(ModeCollector, AGrowthBesideAnOpenModeIsNoZero) {
  ModeCollector out;
  out.add_complex(0.5, 2.0, 1e-12);
  out.add_real(-1e-13, 1e-12, 1);
  const Spectrum spectrum = out.finish();
  EXPECT_EQ(spectrum.verdict, StabilityClass::marginal);
  EXPECT_EQ(spectrum.growth, spectrum.mode[1].re);
  EXPECT_GT(spectrum.growth, 0.3);
  // What may be none is none there.
  ModeCollector open;
  open.add_real(1e-13, 1e-12, 1);
  open.add_complex(-4.0, 1e-13, 1e-12);
  EXPECT_EQ(open.finish().verdict, StabilityClass::marginal);
  EXPECT_GT(open.finish().mode[0].re, 0.0);
  EXPECT_EQ(open.finish().growth, 0.0);
}

TEST(ModeCollector, IsCertainlyPositiveBeyondItsError) {
  EXPECT_TRUE(positive(Conditioned(1.0, 4.0), 0.2));
  EXPECT_FALSE(positive(Conditioned(1.0, 4.0), 0.25));
  EXPECT_FALSE(positive(Conditioned(-1.0, 0.0), 0.25));
}

/// Lambda^2 + 2 Lambda + 1 + h, h within u: sqrt(h + u) - sqrt(h) where the pair nearly meets, more than half u/sqrt(h).
TEST(ModeCollector, ErrorsOfComplexPairsBoundTheirChange) {
  for (const double u : {1e-14, 1e-12, 1e-8}) {
    for (const double ratio : {1.02, 1.2, 2.0, 10.0, 1e4}) {
      const double h = ratio * u;
      Polynomial<Conditioned, 2> p;
      p.c = {Conditioned(1.0 + h, 1.0), Conditioned(2.0), Conditioned(1.0)};
      const double exact = (1.0 + h) - 1.0;  // as the double has it
      const double error = UncertainPolynomial<2>(p, u).pair_error(-1.0, std::sqrt(exact));
      EXPECT_GE(error, std::sqrt(exact) - std::sqrt(std::max(exact - u, 0.0))) << u << " " << ratio;
      EXPECT_GE(error, std::sqrt(exact + u) - std::sqrt(exact)) << u << " " << ratio;
      EXPECT_LE(error, 4.0 * std::sqrt(u)) << u << " " << ratio;
    }
  }
}

}  // namespace
}  // namespace stationary
