// A sheet followed in parts: stopped anywhere, and gone on with at its open ends.
#include "solver/family/follow_sheet.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

/// Hencky's model in (i) both ways from rest, past a fold and a tilt on either side.
class FollowInParts : public ::testing::Test {
 protected:
  FollowInParts() : rest_(solve(problem_, 0.0).q) { options_.continuation.step.first = 0.01; }

  Followed all() const { return followed(family_, rest_, 0.0, options_); }
  /// The rows before those there are, and after.
  void go_on(Followed& sheet) const {
    const auto place = [](const FollowedRow& row) {
      return CurvePlace{row.member.q, row.member.parameter};
    };
    auto& rows = sheet.rows;
    for (const int direction : {-1, +1}) {
      std::ranges::reverse(rows);
      if (rows.back().event != EventType::none) continue;
      OpenEnd open{place(rows.back()), std::nullopt, direction};
      if (rows.size() > 1) open.neighbour = place(rows[rows.size() - 2]);
      Kept kept;
      const FollowReport report = resume(family_, open, options_, kept);
      EXPECT_EQ(report.failure, "");
      rows.insert(rows.end(), kept.rows.begin(), kept.rows.end());
    }
  }

  Problem problem_{Body(1.0, 1.7, 0.6), testing::make_potential("hencky", {1.1, 0.8}), Branch::i};
  AnyFamily family_ = axis_family(problem_, {});
  Stretch rest_;
  FollowOptions options_ = range(-1.0, 1.0, 1e-12);
};

TEST_F(FollowInParts, StoppedAnywhereItGivesTheRowsSoFar) {
  const Followed whole = all();
  ASSERT_EQ(whole.events().size(), 4U) << whole.text();
  const long parts = static_cast<long>(whole.rows.size()) / 256;
  ASSERT_GE(parts, 6);
  for (long part = 1; part < parts; ++part) {
    std::atomic<bool> stop = false;
    FollowOptions stopped = options_;
    stopped.stop = &stop;
    stopped.progress = [&](double, long points) { stop = points >= 256 * part; };
    Followed sheet = followed(family_, rest_, 0.0, stopped);
    EXPECT_TRUE(sheet.report.interrupted);
    EXPECT_EQ(sheet.report.points, static_cast<long>(sheet.rows.size()));
    EXPECT_GE(sheet.report.points, 256 * part);
    EXPECT_EQ(sheet.rows.back().event, EventType::none);
    const bool half = sheet.rows.front().event == EventType::none;
    EXPECT_EQ(half ? sheet.report.backward.reason : sheet.report.forward.reason, "interrupted");
    if (half) {
      EXPECT_EQ(sheet.rows.back().member.parameter, 0.0) << "the start comes last";
    }
    go_on(sheet);
    EXPECT_EQ(sheet.text(), whole.text()) << part;
  }
}

TEST_F(FollowInParts, MaxPointsIsTheNumberOfRows) {
  for (const long most : {2, 3, 50, 500}) {
    FollowOptions few = options_;
    few.max_points = most;
    const Followed sheet = followed(family_, rest_, 0.0, few);
    EXPECT_FALSE(sheet.report.interrupted);
    EXPECT_EQ(sheet.report.points, static_cast<long>(sheet.rows.size()));
    EXPECT_GE(sheet.report.points, most);
    EXPECT_LE(sheet.report.points, most + static_cast<long>(sheet.events().size()));
  }
}

TEST_F(FollowInParts, APlaceOffTheCurveIsRefused) {
  Kept kept;
  const OpenEnd off{{{0.0, rest_.xi, 1.00001 * rest_.zeta, rest_.rho}, 0.0}, std::nullopt, 1};
  EXPECT_NE(resume(family_, off, options_, kept).failure, "");
  EXPECT_TRUE(kept.rows.empty());
}

/// The start is an event: it is met as from anywhere else on the sheet.
TEST(FollowFromAnEvent, WhereTheParameterIsThatOfAnExchange) {
  const auto events_from = [](double J1) {
    const Problem problem(Body(J1, 1.0, 0.6), testing::make_potential("biot-log", {1.0, 0.6}),
                          Branch::iii);
    const AnyFamily family =
        axis_family(problem, {.nu = 0.3, .parameter = {FamilyParameter::Kind::inertia, 0}});
    const Followed sheet = followed(family, solve(problem, 0.3).q, J1, range(0.5, 2.0, 1e-8));
    EXPECT_EQ(sheet.report.failure, "");
    return sheet.report.events;
  };
  const auto there = events_from(1.0);
  const auto beside = events_from(0.9);
  ASSERT_EQ(there.size(), beside.size());
  ASSERT_EQ(there.size(), 1U);
  EXPECT_EQ(there[0].type, beside[0].type);
  EXPECT_NEAR(there[0].parameter, 1.0, 1e-15);
}

TEST(FollowFromAnEvent, ATiltInNu) {
  const Problem problem(Body(1.42825, 2.69933, 2.11892),
                        testing::make_potential("biot-log", {1.15634, 0.033237},
                                                "reciprocal-quadratic", {2.21176, 1.97421}),
                        Branch::ii);
  const double nu = 0.4490786012447529;
  const Equilibrium at =
      solve(problem, nu,
            {.start = Stretch{0.0, 1.1404014591693683, 0.9981351968523923, 1.1265749255878896}});
  ASSERT_EQ(at.status, SolveStatus::solved);
  const Followed sheet =
      followed(axis_family(problem, {.spectrum = true}), at.q, nu, range(0.0, 0.6, 1e-6));
  ASSERT_EQ(sheet.report.events.size(), 1U) << sheet.text();
  EXPECT_EQ(sheet.report.events[0].type, EventType::tilt);
  EXPECT_NEAR(sheet.report.events[0].parameter, nu, 1e-14);
}

/// J1 = J2, a range that ends a hair before a tilt: which sign the inertias' difference has there is not certain,
/// and the negative direction that comes and goes with it is no event by itself.
TEST(FollowToATilt, AtTheEndOfARangeNothingIsUnexplained) {
  const Problem problem(Body(1.07785, 1.07785, 2.72593),
                        testing::make_potential("neo-hookean", {0.32088, 0.0809022},
                                                "reciprocal-quadratic", {0.424724, 3.01068}),
                        Branch::ii);
  const AnyFamily family = axis_family(
      problem, {.nu = 0.5146, .parameter = {FamilyParameter::Kind::plane, 0}, .spectrum = true});
  const auto followed_to = [&](double end) {
    return followed(family, solve(problem, 0.5146).q, 0.32088, range(0.064176, end, 1e-6));
  };
  EXPECT_TRUE(followed_to(0.3375128519882887).report.events.empty());
  const Followed on = followed_to(0.36);
  ASSERT_EQ(on.report.events.size(), 1U) << on.text();
  EXPECT_EQ(on.report.events[0].type, EventType::tilt);
  EXPECT_NEAR(on.report.events[0].parameter, 0.3375128519882887, 1e-12);
}

}  // namespace
}  // namespace stationary
