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

}  // namespace
}  // namespace stationary
