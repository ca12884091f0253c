// Searches where the thickness is what is not certain: V' = rho^2 - 2 rho + k has the roots
// 1 +- sqrt(1 - k), as close to each other as one likes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/proof/certify.hpp"
#include "solver/search/search.hpp"
#include "solver/search/two_polar_search.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

/// W of hencky; k = 1 - apart^2.
Potential with_two_thicknesses(double apart) {
  return Potential(
      SeparableExpression{AnyPlane<>{Hencky<>{1.0, 0.6}},
                          AnyThickness<>{support::written_thickness(
                              "rho^3/3 - rho^2 + k*rho", {"k"}, {(1.0 - apart) * (1.0 + apart)})}});
}

const Body round_body{1.0, 1.0, 0.7};
const TwoPolarRates<double> rates{0.3, 0.2};

SearchResult searched(double apart, bool two_polar, const SearchOptions& options = {}) {
  const Potential V = with_two_thicknesses(apart);
  return two_polar ? search_two_polar(round_body, V, rates, options)
                   : search(Problem(round_body, V, Branch::iii), 0.3, options);
}

TEST(WrittenSearch, ADoubleThicknessIsUndecidedAndNotNone) {
  for (const bool two_polar : {false, true}) {
    const SearchResult found = searched(0.0, two_polar);
    EXPECT_EQ(found.status, SearchStatus::undecided) << found.message;
    EXPECT_TRUE(found.solutions.empty());
    ASSERT_FALSE(found.undecided.empty());
    for (const StretchBox& box : found.undecided) EXPECT_TRUE(box.rho.may_be(1.0));
  }
}

/// The plane's solution is proven, the thickness is not: nor are they together.
TEST(WrittenSearch, WhatHoldsAThicknessNotProvenIsNotProven) {
  SearchOptions coarse;
  coarse.min_width = 1e-3;
  for (const double apart : {2e-6, 5e-6, 1e-5, 1.3e-5})
    for (const bool two_polar : {false, true}) {
      const SearchResult proven = searched(1e-3, two_polar);  // the plane's are the same
      ASSERT_EQ(proven.status, SearchStatus::complete) << proven.message;
      const SearchResult found = searched(apart, two_polar, coarse);
      EXPECT_EQ(found.status, SearchStatus::undecided) << found.message;
      EXPECT_TRUE(found.solutions.empty());
      // Each of them once.
      EXPECT_EQ(found.unproven.size(), proven.solutions.size()) << found.message;
      for (const Equilibrium& each : found.unproven) {
        EXPECT_LE(std::abs(std::abs(each.q.rho - 1.0) - apart), each.error_bound) << each.q.rho;
        EXPECT_TRUE(std::ranges::any_of(proven.solutions, [&](const Equilibrium& other) {
          return std::abs(each.q.xi - other.q.xi) + std::abs(each.q.zeta - other.q.zeta) < 1e-12;
        })) << each.q.xi;
      }
    }
}

/// Half a unit of k moves rho by that over 2 apart: more than rounding moves the plane's stretches.
TEST(WrittenSearch, TheBoundHoldsTheThicknessToo) {
  constexpr double apart = 1e-3;
  for (const bool two_polar : {false, true}) {
    const SearchResult found = searched(apart, two_polar);
    ASSERT_EQ(found.status, SearchStatus::complete) << found.message;
    ASSERT_FALSE(found.solutions.empty());
    for (const Equilibrium& each : found.solutions)
      EXPECT_GE(each.error_bound, 0x1p-54 / (2.0 * apart * each.q.rho)) << each.q.rho;
  }
}

/// As of the model (round_search_test.cpp): ellipses branch off the circle of W = biot-log at nu = 1.06511831249...
TEST(WrittenSearch, DecidesBesideTheEllipsesOfACircle) {
  const Potential V(SeparableExpression{
      AnyPlane<>{support::written_plane("m*(I1 - 2*t + 2) + k/2*log(d)^2", {"m", "k"}, {1.0, 4.0})},
      AnyThickness<>{ReciprocalQuadratic<>{1.0, 3.0}}});
  const Body body(1.0, 1.0, 0.6);
  for (const double distance : {1e-3, 1e-6, 1e-9}) {
    for (const double sign : {-1.0, 1.0}) {
      const SearchResult found =
          search(Problem(body, V, Branch::iii), 1.0651183124924546 * (1.0 + sign * distance));
      EXPECT_EQ(found.status, SearchStatus::complete) << distance << found.message;
      EXPECT_EQ(found.solutions.size(), sign > 0.0 ? 3U : 1U) << distance;
    }
  }
}

/// A logarithm's argument is positive there: nothing is to be said of it.
TEST(WrittenSearch, WhatIsWithinTheDomainIsProvenWithoutAReason) {
  const Potential V(
      support::written_coupled("I1 + rho^2 - log(d*rho) - k*log(9 - I1)", {"k"}, {0.2}));
  const Problem problem(round_body, V, Branch::i);
  const SearchResult found = search(problem, 0.3);
  ASSERT_FALSE(found.solutions.empty()) << found.message;
  for (const Equilibrium& each : found.solutions) {
    const Certificate proof = certify(problem, each);
    EXPECT_TRUE(proof.proven) << proof.reason;
    EXPECT_EQ(proof.reason, "");
  }
  Equilibrium beyond = found.solutions[0];
  beyond.q.xi = 3.5;
  const Certificate refused = certify(problem, beyond);
  EXPECT_FALSE(refused.proven);
  EXPECT_NE(refused.reason.find("9 - I1 > 0"), std::string::npos) << refused.reason;
}

}  // namespace
}  // namespace stationary
