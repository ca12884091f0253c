// Covers of bodies that gravitate or whose volume is held: between the points where sheets turn, part or
// leave the box the number of motions is that of searches, and the classical points are among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/support/covers.hpp"

namespace stationary::testing {
namespace {

struct Forces {
  std::optional<double> volume;
  double g = 0.0;
  std::optional<NeoHookean3d<>> elastic = {};
};
Potential potential_of(const Body& body, const Forces& forces) {
  BodyModel<> out;
  if (forces.elastic) out.elastic.coupled = *forces.elastic;
  out.volume = forces.volume;
  out.gravitates = forces.g > 0.0;
  out.g = forces.g;
  out.J = {body.J1, body.J2, body.J3};
  return Potential(out);
}

const NuGap* gap_at(const KindCover& cover, double nu) {
  const auto found = std::ranges::find_if(
      cover.gaps, [&](const NuGap& each) { return std::abs(each.nu.mid() - nu) < 1e-11; });
  return found == cover.gaps.end() ? nullptr : &*found;
}

const Body sphere{1.0, 1.0, 1.0};

/// With J = C = 1 and g = 4 nu^2 is Omega^2/(pi G rho). Values: docs/gravity.md.
constexpr double jacobi_bifurcation = 0.3742296747861956;
constexpr double largest_spin = 0.4493314121239139;

TEST(BodyCover, MaclaurinAndJacobi) {
  // About axis 1 they are the same, by an exchange of axes.
  for (const Branch branch : {Branch::iii, Branch::i}) {
    const double from = branch == Branch::iii ? 0.55 : 0.65;
    const double to = branch == Branch::iii ? 0.70 : 0.68;
    const Problem problem(sphere, potential_of(sphere, {1.0, 4.0}), branch);
    const KindCover cover = cover_axis(problem, from, to, {}, /*classes=*/false);
    ASSERT_EQ(cover.gaps.size(), branch == Branch::iii ? 2U : 1U);
    if (branch == Branch::iii) {
      const NuGap& parting = cover.gaps.front();
      EXPECT_TRUE(parting.mirrors);
      EXPECT_FALSE(parting.undecided);
      EXPECT_NEAR(parting.nu.mid(), std::sqrt(jacobi_bifurcation), 1e-12);
    }
    const NuGap& fold = cover.gaps.back();
    EXPECT_TRUE(fold.turns);
    EXPECT_FALSE(fold.undecided);
    EXPECT_NEAR(fold.nu.mid(), std::sqrt(largest_spin), 1e-12);
    EXPECT_LT(length_of(cover), 1e-11);
    if (branch == Branch::iii) {
      EXPECT_EQ(numbers_of(problem, cover, from, to), (std::vector{3, 2, 0}));
    }
  }
}

/// Of the ellipsoids of Jacobi those whose longest axis is at least 1.5: the same about every axis, the box being
/// that of the stretches in their places. The greater stretch of an ellipse is the first of its two.
TEST(BodyCover, OfABoxThatEllipsesLeave) {
  const Potential V = potential_of(sphere, {1.0, 4.0});
  const Interval greater(1.5, 10.0);
  const Interval smaller(0.1, 1.15);
  const Interval along(0.01, 10.0);
  const auto cover = [&](Branch branch, const std::array<Interval, 3>& box) {
    SearchOptions options;
    options.box = box;
    return cover_axis({sphere, V, branch}, 0.5, 0.6, options, /*classes=*/false);
  };
  const KindCover third = cover(Branch::iii, {greater, smaller, along});
  ASSERT_EQ(third.gaps.size(), 1U);
  EXPECT_TRUE(third.gaps[0].crosses);
  for (const KindCover& other : {cover(Branch::i, {along, greater, smaller}),
                                 cover(Branch::ii, {greater, along, smaller})}) {
    ASSERT_EQ(other.gaps.size(), 1U);
    EXPECT_TRUE(other.gaps[0].crosses);
    EXPECT_NEAR(other.gaps[0].nu.mid(), third.gaps[0].nu.mid(), 1e-12);
  }
}

TEST(BodyCover, OfHeldVolumesAgreesWithSearches) {
  const Body plate(1.0, 1.7, 0.6);
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    for (const double g : {0.0, 1.5}) {
      const Problem problem(plate, potential_of(plate, {1.3, g, NeoHookean3d<>{1.0, 2.0}}), branch);
      const double to = 0.95;
      const KindCover cover = cover_axis(problem, 0.1, to, {}, /*classes=*/false);
      EXPECT_LT(length_of(cover), 1e-9) << name(branch) << " g = " << g;
      for (const NuGap& each : cover.gaps) EXPECT_FALSE(each.undecided);
      EXPECT_GE(numbers_of(problem, cover, 0.1, to).size(), 1U);
    }
  }
}

/// rho = C/d leaves the box before xi and zeta do.
TEST(BodyCover, HeldThicknessEndsWhereTheBoxDoes) {
  const Body body(1.0, 1.0, 0.6);
  const Problem problem(body, potential_of(body, {1.0, 0.0, NeoHookean3d<>{1.0, 2.0}}),
                        Branch::iii);
  SearchOptions options;
  options.box = {Interval(0.01, 100.0), Interval(0.01, 100.0), Interval(0.5, 100.0)};
  const double to = 0.99;
  const KindCover cover = cover_axis(problem, 0.0, to, options, /*classes=*/false);
  // xi = zeta = 2^(1/2), rho = 1/2: mu (xi^2 - rho^2) = c xi^2, c = mu (1 - 1/8).
  const double end = std::sqrt(0.875);
  const NuGap* const gap = gap_at(cover, end);
  ASSERT_NE(gap, nullptr);
  EXPECT_TRUE(gap->crosses);
  EXPECT_FALSE(gap->undecided);
  EXPECT_LT(length_of(cover), 1e-9);
}

/// Gravity beside a compressible body: three stretches are left.
TEST(BodyCover, OfACompressibleBody) {
  const Body body(1.0, 1.4, 0.8);
  const Problem problem(body, potential_of(body, {{}, 1.0, NeoHookean3d<>{1.0, 2.0}}), Branch::iii);
  const double to = 0.7;
  const KindCover cover = cover_axis(problem, 0.05, to, {}, /*classes=*/false);
  EXPECT_LT(length_of(cover), 1e-9);
  EXPECT_GE(numbers_of(problem, cover, 0.05, to).size(), 1U);
}

}  // namespace
}  // namespace stationary::testing
