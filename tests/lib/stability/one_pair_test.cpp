// The spectrum of a leaf of one pair, E'' = [a c; c b]: Lambda = c^2 - a b.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/stability/general_spectrum.hpp"

namespace stationary {
namespace {

Spectrum spectrum_of(double a, double b, double c, double uncertainty = 0x1p-53) {
  Leaf leaf;
  leaf.pairs = 1;
  leaf.second_variation[0][0] = a;
  leaf.second_variation[1][1] = b;
  leaf.second_variation[0][1] = leaf.second_variation[1][0] = c;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      leaf.magnitude[i][j] = std::abs(leading(leaf.second_variation[i][j]));
  return general_spectrum({MaterialSymmetry::none, uncertainty}, leaf);
}

struct OnePair {
  double a, b, c;
  int negative;
  int krein;
  StabilityClass verdict;
};

TEST(OnePairLeaf, HasTheSignsOfItsForm) {
  const OnePair all[] = {{2.0, 3.0, 0.0, 0, 1, StabilityClass::stable},
                         {2.0, 3.0, 1.0, 0, 1, StabilityClass::stable},
                         {-2.0, -3.0, 1.0, 2, -1, StabilityClass::elliptic},
                         {2.0, -3.0, 0.5, 1, 0, StabilityClass::unstable},
                         {2.0, 3.0, 4.0, 1, 0, StabilityClass::unstable}};
  for (const OnePair& each : all) {
    const double lambda = each.c * each.c - each.a * each.b;
    const Spectrum out = spectrum_of(each.a, each.b, each.c);
    ASSERT_EQ(out.modes, 1);
    EXPECT_EQ(out.mode[0].lambda_re, lambda);
    EXPECT_EQ(out.verdict, each.verdict) << lambda;
    EXPECT_EQ(out.negative, each.negative) << lambda;
    EXPECT_EQ(out.mode[0].krein, each.krein) << lambda;
    EXPECT_EQ(out.growth, lambda > 0.0 ? std::sqrt(lambda) : 0.0);
  }
}

/// Every form whose entries are off by their uncertainty has its Lambda within the bound, and the
/// bound is no more than a hundredth wider than the farthest of them.
TEST(OnePairLeaf, BoundsWhatTheEntriesUncertaintyDoes) {
  constexpr double u = 1e-3;
  for (const OnePair& each :
       {OnePair{2.0, 3.0, 1.0, 0, 0, {}}, OnePair{2.0, -3.0, 4.0, 0, 0, {}}}) {
    const double error = spectrum_of(each.a, each.b, each.c, u).mode[0].lambda_error;
    const double lambda = each.c * each.c - each.a * each.b;
    double farthest = 0.0;
    for (const double s : {-u, u})
      for (const double t : {-u, u})
        for (const double r : {-u, u})
          farthest =
              std::fmax(farthest, std::abs(each.c * each.c * (1.0 + r) * (1.0 + r) -
                                           each.a * each.b * (1.0 + s) * (1.0 + t) - lambda));
    EXPECT_LE(farthest, error);
    EXPECT_LE(error, 1.01 * farthest);
  }
}

/// a > 0, det > 0, and neither for all within the uncertainty.
TEST(OnePairLeaf, IsMarginalWhereTheUncertaintyReachesZero) {
  EXPECT_EQ(spectrum_of(1.0, 1.0, 0.999, 1e-3).verdict, StabilityClass::marginal);
  EXPECT_EQ(spectrum_of(1.0, 1.0, 0.999, 1e-4).verdict, StabilityClass::stable);
}

}  // namespace
}  // namespace stationary
