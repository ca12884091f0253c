// That no motion is outside the box: of random bodies against searches of a box as wide as those go, and of
// sheets that are known to leave it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "solver/search/search.hpp"
#include "solver/tube/kind_cover.hpp"
#include "tests/support/bodies/random_problem.hpp"

namespace stationary {
namespace {

using namespace testing;

const SearchOptions box;  // of an atlas

/// How many motions there are with all stretches in the box and between 10^-40 and 10^40.
std::array<std::size_t, 2> inside_and_all(const Problem& problem, double nu) {
  SearchOptions wide;
  wide.min_stretch = 1e-40;
  wide.max_stretch = 1e40;
  wide.max_boxes = 100'000;
  const SearchResult all = search(problem, nu, wide);
  std::size_t inside = 0;
  for (const Equilibrium& each : all.solutions) {
    const Stretch& q = each.q;
    bool is_in = true;
    for (const double x : {q.xi, q.zeta, q.rho})
      is_in = is_in && x >= box.min_stretch && x <= box.max_stretch;
    inside += is_in;
  }
  return {inside, all.solutions.size()};
}

TEST(NoneOutside, IsTrueOfRandomBodies) {
  support::Random random(77);
  int proven = 0;
  constexpr int bodies = 120;
  for (int k = 0; k < bodies; ++k) {
    // Six orders of magnitude: motions outside are not rare.
    const Posed posed = random_problem(random, 6.0);
    const double from = 0.7 * std::abs(posed.nu);
    const double to = 0.9 * std::abs(posed.nu);
    if (!none_outside(posed.problem, from, to, box)) continue;
    ++proven;
    for (const double share : {0.0, 0.37, 1.0}) {
      const auto [inside, all] = inside_and_all(posed.problem, from + share * (to - from));
      EXPECT_EQ(inside, all) << posed.text << " at " << share;
    }
  }
  EXPECT_GE(proven, bodies / 2);
}

/// zeta^4 = c k^(1/2)/(k - J2 nu^2)^(3/2) passes 1000^4 close to its escape, nu^2 = k/J2, and no other
/// motion is outside the box at any nu before.
TEST(NoneOutside, EndsWhereASheetLeavesTheBox) {
  const double c = 1.0;
  const double k = 2.0;
  const Body body(1.0, 1.7, 0.6);
  const Problem problem(body,
                        {Potential::planar("reciprocal-determinant", std::array{c, k}),
                         Potential::thickness("reciprocal-quadratic", std::array{1.0, 3.0})},
                        Branch::i);
  // About axis 1 xi feels nothing: xi^2 k = zeta^2 (k - J2 nu^2) = c/(xi zeta).
  const double softness = std::pow(c * std::sqrt(k) / 1e12, 2.0 / 3.0);
  const double leaves = std::sqrt((k - softness) / body.J2);
  EXPECT_TRUE(none_outside(problem, 0.0, leaves * (1.0 - 1e-12), box));
  EXPECT_FALSE(none_outside(problem, 0.0, leaves * (1.0 + 1e-12), box));
  EXPECT_FALSE(none_outside(problem, leaves * (1.0 + 1e-12), std::sqrt(k / body.J2), box));
  // Beyond the escape there is no motion at all, and a proof of that.
  EXPECT_TRUE(none_outside(problem, std::sqrt(k / body.J2) * (1.0 + 1e-9), 5.0, box));
}

/// Circles and ellipses are told apart there too: both leave the box of J1 = J2.
TEST(NoneOutside, OfCirclesAndEllipses) {
  const Body body(1.0, 1.0, 0.6);
  const Problem problem(body,
                        {Potential::planar("biot-log", std::array{1.0, 4.0}),
                         Potential::thickness("reciprocal-quadratic", std::array{1.0, 3.0})},
                        Branch::iii);
  EXPECT_TRUE(none_outside(problem, 0.0, 1.4, box));
  // Ellipses leave the box at 1.413520, circles at 1.413526, and escape at the root of 2.
  EXPECT_FALSE(none_outside(problem, 1.41351, 1.413523, box));
  EXPECT_FALSE(none_outside(problem, 1.413523, 1.414, box));
  EXPECT_TRUE(none_outside(problem, 1.45, 1.5, box));
}

}  // namespace
}  // namespace stationary
