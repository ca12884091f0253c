// Covers find every curve, tell where its number of points changes, and leave nothing undecided.
#include "solver/tube/curve_cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "solver/tube/axis_curves.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/covers.hpp"

namespace stationary::testing {
namespace {

KindCover covered(const Problem& problem, double to) {
  return cover_axis(problem, 0.0, to, {}, /*classes=*/false);
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

TEST(Cover, LooksForBreaksNoLongerWhenToldToStop) {
  const Closed closed;
  CurveRegion<2> region;
  region.lower = {Interval(-5.0), Interval(-5.0)};
  region.upper = {Interval(5.0), Interval(5.0)};
  region.q = {0.0, 1.0};
  TubeSet<2> tubes(closed, region);
  ASSERT_TRUE(tubes.follow({0.0, Closed::radius, Closed::middle}));
  std::atomic<bool> stop{false};
  EXPECT_EQ(curve_breaks(closed, region, tubes, &stop).size(), 2U);
  stop = true;
  EXPECT_TRUE(curve_breaks(closed, region, tubes, &stop).empty());
}

TEST(Cover, LeavesNothingOfADiscUndecided) {
  const Potential V(ReciprocalDeterminant<>{1.0, 2.0}, plate_thickness);
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const KindCover cover = covered({plate, V, branch}, 1.05);
    EXPECT_TRUE(cover.gaps.empty());
    EXPECT_GT(cover.tubes, 0);
  }
}

TEST(Cover, TellsTheFoldOfHencky) {
  const Potential V(Hencky<>{1.1, 0.8}, plate_thickness);
  const KindCover cover = covered({plate, V, Branch::i}, 1.0);
  EXPECT_LT(length_of(cover), 1e-9);
  ASSERT_EQ(cover.gaps.size(), 2U);
  EXPECT_TRUE(cover.gaps[0].crosses);  // zeta leaves the box at 1000
  EXPECT_TRUE(cover.gaps[1].turns);
  const double fold = std::sqrt(2.0 * 1.1 * 1.9 / (3.0 * std::numbers::e * plate.J2));
  EXPECT_TRUE(cover.gaps[1].nu.may_be(fold) || std::abs(cover.gaps[1].nu.mid() - fold) < 1e-15);
}

TEST(Cover, HasThreeSheetsApartFromRest) {
  const Potential V(BiotLog<>{1.0, 0.6}, plate_thickness);
  const KindCover cover = covered({plate, V, Branch::iii}, 2.0);
  EXPECT_LT(length_of(cover), 1e-9);
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
  EXPECT_LT(length_of(cover), 1e-9);
}

const Body round_body{1.0, 1.0, 0.6};

/// W_t = c t and W_l = -c d at t = 2 r, d = r^2:  2 mu - c = mu/r,  2 lambda ln r = mu r.
TEST(Cover, EllipsesPartFromCirclesWhereTheClosedFormSays) {
  const double to = 3.0;
  const Problem problem(round_body, Potential(BiotLog<>{1.0, 4.0}, plate_thickness), Branch::iii);
  const KindCover cover = covered(problem, to);
  EXPECT_LT(length_of(cover), 1e-9);
  EXPECT_LT(cover.boxes, 20'000);
  std::vector<double> parting;
  for (double r : {1.155, 26.1}) {
    for (int k = 0; k < 50; ++k) r -= (8.0 * std::log(r) - r) / (8.0 / r - 1.0);
    parting.push_back(std::sqrt(2.0 - 1.0 / r));
  }
  std::size_t met = 0;
  for (const NuGap& each : cover.gaps) {
    EXPECT_FALSE(each.undecided);
    if (!each.mirrors) continue;
    ASSERT_LT(met, parting.size());
    EXPECT_NEAR(each.nu.mid(), parting[met++], 1e-12);
    EXPECT_LT(each.nu.width(), 1e-12);
  }
  EXPECT_EQ(met, parting.size());
  EXPECT_GE(numbers_of(problem, cover, 0.0, to).size(), 4U);
}

TEST(Cover, OfRoundBodiesAgreesWithSearches) {
  const Potential potentials[] = {
      Potential(ReciprocalDeterminant<>{1.0, 2.0}, plate_thickness),
      Potential(Hencky<>{1.1, 0.8}, plate_thickness),
      Potential(SaintVenantKirchhoff<>{1.0, 0.5}, plate_thickness),
      Potential(NeoHookean<>{1.0, 2.0}, plate_thickness),
      Potential(NeoHookean3d<>{1.0, 2.0}),
  };
  int intervals = 0;
  for (const Potential& V : potentials) {
    const double to = 1.3;
    const Problem problem(round_body, V, Branch::iii);
    const KindCover cover = covered(problem, to);
    EXPECT_LT(length_of(cover), 1e-9);
    intervals += static_cast<int>(numbers_of(problem, cover, 0.0, to).size());
  }
  EXPECT_GE(intervals, 7);
}

/// Of neo-hookean bodies all ellipses are at nu^2 = mu/J: a vertical branch.
TEST(Cover, HasAVerticalBranchInOneGap) {
  const auto at_one = [](const KindCover& cover) {
    return std::ranges::find_if(cover.gaps, [](const NuGap& each) { return each.nu.may_be(1.0); });
  };
  const KindCover cover =
      covered({round_body, Potential(NeoHookean<>{1.0, 2.0}, plate_thickness), Branch::iii}, 1.3);
  const auto vertical = at_one(cover);
  ASSERT_NE(vertical, cover.gaps.end());
  EXPECT_TRUE(vertical->mirrors);
  EXPECT_LT(vertical->nu.width(), 1e-9);
  // Where the volume is coupled mu = J nu^2 leaves rho = 0 alone: no ellipse is in the box.
  const KindCover coupled =
      covered({round_body, Potential(NeoHookean3d<>{1.0, 2.0}), Branch::iii}, 1.3);
  EXPECT_EQ(at_one(coupled), coupled.gaps.end());
}

/// x_2 (x_1^2 - w^2) = 0, q = 1/2 + x_1 + 0.3 x_2: a line and two that cross it at q = 1/2 -+ w.
class Crossings final : public CurveEquations<2> {
 public:
  CurveLinearized<2> linearize(const CurveBox<2>& y) const override {
    CurveLinearized<2> out;
    const Interval apart = square(y[0]) - square(Interval(w));
    out.g = {y[1] * apart, y[0] + 0.3 * y[1] + Interval(0.5) - y[2]};
    out.slope[0] = {2.0 * (y[0] * y[1]), apart, Interval(0.0)};
    out.slope[1] = {Interval(1.0), Interval(0.3), Interval(-1.0)};
    return out;
  }

  static constexpr double w = 0.2;
};

/// What is left undecided is the two crossings, and not what lies between them.
TEST(Cover, LeavesNoMoreUndecidedThanEachCrossing) {
  const Crossings crossings;
  CurveRegion<2> region;
  region.lower = {Interval(-0.45), Interval(-0.45)};
  region.upper = {Interval(0.45), Interval(0.45)};
  region.q = {0.0, 1.0};
  CoverOptions options;
  options.min_width = 0x1p-20;
  const CurveCover cover = cover_curves(crossings, region, options);
  int first = 0;
  int second = 0;
  for (const Interval& each : cover.undecided) {
    EXPECT_LT(each.width(), 1e-2);
    first += each.may_be(0.5 - Crossings::w) ? 1 : 0;
    second += each.may_be(0.5 + Crossings::w) ? 1 : 0;
  }
  EXPECT_EQ(first, 1);
  EXPECT_EQ(second, 1);
}

/// x_2 (x_2 - 1) = 0. On x_2 = 0 a curve turns at q = 1/2, on x_2 = 1 another passes the side x_1 =
/// 0.4 at a q that differs by less than is told apart.
class TurnAndSide final : public CurveEquations<2> {
 public:
  CurveLinearized<2> linearize(const CurveBox<2>& y) const override {
    CurveLinearized<2> out;
    const Interval turns = Interval(0.5) + square(y[0]);
    const Interval passes = Interval(0.5 + 5e-13) + y[0] - Interval(side);
    const Interval rest = Interval(1.0) - y[1];
    out.g = {y[1] * (y[1] - Interval(1.0)), rest * turns + y[1] * passes - y[2]};
    out.slope[0] = {Interval(0.0), 2.0 * y[1] - Interval(1.0), Interval(0.0)};
    out.slope[1] = {2.0 * (rest * y[0]) + y[1], passes - turns, Interval(-1.0)};
    return out;
  }

  static constexpr double side = 0.4;
};

TEST(Cover, OneBreakIsAllThatHappensThere) {
  const TurnAndSide both;
  CurveRegion<2> region;
  region.lower = {Interval(-TurnAndSide::side), Interval(-5.0)};
  region.upper = {Interval(TurnAndSide::side), Interval(5.0)};
  region.q = {0.0, 1.0};
  TubeSet<2> tubes(both, region);
  ASSERT_TRUE(tubes.follow({0.0, 0.0, 0.5}));
  ASSERT_TRUE(tubes.follow({0.3, 1.0, 0.4}));
  const std::vector<CurveBreak> breaks = curve_breaks(both, region, tubes);
  const auto at = [&](double q) {
    return std::ranges::find_if(
        breaks, [q](const CurveBreak& each) { return std::abs(each.q.mid() - q) < 1e-11; });
  };
  ASSERT_NE(at(0.5), breaks.end());
  EXPECT_TRUE(at(0.5)->turns);
  EXPECT_TRUE(at(0.5)->crosses);
  const auto beyond = at(0.5 + TurnAndSide::side * TurnAndSide::side);
  ASSERT_NE(beyond, breaks.end());
  EXPECT_FALSE(beyond->turns);
  EXPECT_TRUE(beyond->crosses);
}

/// Of a round body whose stretches are wanted in ranges with nothing in common there is no circle; ellipses
/// either way, where the ranges differ.
TEST(Cover, HasNoCirclesWhereTheRangesHaveNothingInCommon) {
  const Problem problem(round_body, Potential(BiotLog<>{1.0, 4.0}, plate_thickness), Branch::iii);
  const auto sets = [&](const Interval& xi, const Interval& zeta) {
    SearchOptions options;
    options.box = {xi, zeta, Interval(0.5, 2.0)};
    std::size_t out = 0;
    for (const CurveFactor& factor : axis_curves(problem, 0.0, 1.0, options))
      out += factor.sets.size();
    return out;
  };
  // The thickness, circles, and ellipses with xi > zeta; where the ranges differ with xi < zeta too.
  EXPECT_EQ(sets({0.5, 2.0}, {0.5, 2.0}), 3U);
  EXPECT_EQ(sets({1.5, 3.0}, {0.5, 2.0}), 4U);
  EXPECT_EQ(sets({2.0, 3.0}, {0.5, 1.0}), 2U);
  EXPECT_EQ(sets({0.5, 1.0}, {2.0, 3.0}), 2U);
}

}  // namespace
}  // namespace stationary::testing
