// Covers find every curve, tell where its number of points changes, and leave nothing undecided.
#include "solver/tube/curve_cover.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/tube/kind_cover.hpp"

namespace stationary {
namespace {

const Body plate{1.0, 1.7, 0.6};
const ReciprocalQuadratic<> thickness{1.0, 3.0};

KindCover covered(const Problem& problem, double to) { return cover_axis(problem, 0.0, to, {}); }

double undecided_length(const KindCover& cover) {
  double out = 0.0;
  for (const NuGap& each : cover.gaps) out += each.nu.hi - each.nu.lo;
  return out;
}

/// x_1^2 + x_2^2 = r^2, x_1 = (q - middle)/width: a closed curve with folds at middle +- r width.
class Closed final : public CurveEquations<2> {
 public:
  CurveLinearized<2> linearize(const CurveBox<2>& y) const override {
    CurveLinearized<2> out;
    out.g = {square(y[0]) + square(y[1]) - Interval(radius * radius),
             y[0] - (y[2] - Interval(middle)) / Interval(width)};
    out.slope[0] = {2.0 * y[0], 2.0 * y[1], Interval(0.0)};
    out.slope[1] = {Interval(1.0), Interval(0.0), Interval(-1.0) / Interval(width)};
    return out;
  }

  static constexpr double middle = 0.437;
  static constexpr double width = 0.01;
  static constexpr double radius = 0.05;
};

TEST(Cover, FindsAClosedCurve) {
  const Closed closed;
  CurveRegion<2> region;
  region.lower = {Interval(-5.0), Interval(-5.0)};
  region.upper = {Interval(5.0), Interval(5.0)};
  region.q = {0.0, 1.0};
  const CurveCover cover = cover_curves(closed, region);
  EXPECT_TRUE(cover.undecided.empty());
  ASSERT_EQ(cover.breaks.size(), 2U);
  const double fold = Closed::width * Closed::radius;
  EXPECT_NEAR(cover.breaks[0].q.mid(), Closed::middle - fold, 1e-12);
  EXPECT_NEAR(cover.breaks[1].q.mid(), Closed::middle + fold, 1e-12);
  for (const CurveBreak& each : cover.breaks) {
    EXPECT_TRUE(each.turns);
    EXPECT_FALSE(each.crosses);
    EXPECT_LT(each.q.width(), 1e-12);
  }
  EXPECT_LT(cover.boxes, 2000);
}

TEST(Cover, LeavesNothingOfADiscUndecided) {
  const Potential V(ReciprocalDeterminant<>{1.0, 2.0}, thickness);
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const KindCover cover = covered({plate, V, branch}, 1.05);
    EXPECT_TRUE(cover.gaps.empty());
    EXPECT_GT(cover.tubes, 0);
  }
}

TEST(Cover, TellsTheFoldOfHencky) {
  const Potential V(Hencky<>{1.1, 0.8}, thickness);
  const KindCover cover = covered({plate, V, Branch::i}, 1.0);
  EXPECT_LT(undecided_length(cover), 1e-9);
  ASSERT_EQ(cover.gaps.size(), 2U);
  EXPECT_TRUE(cover.gaps[0].crosses);  // zeta leaves the box at 1000
  EXPECT_TRUE(cover.gaps[1].turns);
  const double fold = std::sqrt(2.0 * 1.1 * 1.9 / (3.0 * std::numbers::e * plate.J2));
  EXPECT_TRUE(cover.gaps[1].nu.may_be(fold) || std::abs(cover.gaps[1].nu.mid() - fold) < 1e-15);
}

TEST(Cover, HasThreeSheetsApartFromRest) {
  const Potential V(BiotLog<>{1.0, 0.6}, thickness);
  const KindCover cover = covered({plate, V, Branch::iii}, 2.0);
  EXPECT_LT(undecided_length(cover), 1e-9);
  ASSERT_EQ(cover.gaps.size(), 4U);
  EXPECT_TRUE(cover.gaps[1].turns);
  EXPECT_NEAR(cover.gaps[1].nu.mid(), 1.34556, 1e-5);
  for (const NuGap& each : cover.gaps) EXPECT_FALSE(each.undecided);
}

TEST(Cover, OfAThreeDimensionalCoupling) {
  const Potential V(NeoHookean3d<>{1.0, 2.0});
  const KindCover cover = covered({plate, V, Branch::ii}, 2.0);
  ASSERT_EQ(cover.gaps.size(), 1U);
  EXPECT_TRUE(cover.gaps[0].crosses);
  EXPECT_LT(undecided_length(cover), 1e-9);
}

}  // namespace
}  // namespace stationary
