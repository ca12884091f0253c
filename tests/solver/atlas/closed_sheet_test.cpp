// A sheet that closes upon itself between two checkpoints, so that none of them meets it: a body whose
// formula has a second well, hardly deep enough for two folds 1.2e-3 apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "tests/support/atlas_text.hpp"

namespace stationary {
namespace {

using namespace testing;

Case two_wells_case(const std::string& depth) {
  return make_case(CaseTree::parse(
      "[body]\nJ = [1.0, 1.7, 0.6]\n[motion]\nbranch = \"i\"\nnu = 0.9\n[potential]\n"
      "plane = { expression = \"c/d + 0.5*k*(t^2 - 2*d) - A*exp(-((t - t0)^2 + (d - d0)^2)/w^2)\", "
      "c = 1.0, k = 2.0, A = " +
          depth +
          ", t0 = 2.85, d0 = 2.02, w = 0.2 }\n"
          "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n",
      "two wells"));
}

AtlasOptions sparse() {
  AtlasOptions out;
  out.to = 1.02;
  out.checkpoints = 8;
  out.branches = {Branch::i};
  out.tilted = false;
  out.step.tolerance = 1e-6;
  return out;
}

/// The folds of the closed sheet.
std::vector<double> folds_of(const AtlasSheet& sheet) {
  std::vector<double> out;
  for (const AtlasRow& row : sheet.rows)
    if (row.event == EventType::fold_nu) out.push_back(row.member.nu);
  std::ranges::sort(out);
  return out;
}

TEST(ClosedSheet, IsMissedByCheckpointsAlone) {
  const Case input = two_wells_case("0.19106");
  const Atlas found = atlas(input.body, input.potential, sparse());
  EXPECT_EQ(found.sheets.size(), 1U) << text_of(found);
  expect_complete(found);
}

TEST(ClosedSheet, IsFoundBetweenCheckpoints) {
  const Case input = two_wells_case("0.19106");
  AtlasOptions how = sparse();
  how.complete = true;
  const Atlas found = atlas(input.body, input.potential, how);
  ASSERT_EQ(found.sheets.size(), 2U) << text_of(found);
  expect_complete(found);
  const AtlasSheet& closed = found.sheets[1];
  EXPECT_EQ(closed.rows.front().event, EventType::closed);
  EXPECT_EQ(closed.rows.back().event, EventType::closed);
  const std::vector<double> folds = folds_of(closed);
  ASSERT_EQ(folds.size(), 2U);
  EXPECT_LT(folds[1] - folds[0], 1.3e-3);

  // One sheet, three between the folds, one; and next to nothing is left at these.
  ASSERT_EQ(found.completeness.size(), 1U);
  const Completeness& told = found.completeness[0];
  EXPECT_LT(told.unproven_length(), 1e-9);
  ASSERT_EQ(told.intervals.size(), 5U);
  for (const std::size_t k : {0U, 2U, 4U}) {
    EXPECT_TRUE(told.intervals[k].proven) << k;
    EXPECT_EQ(told.intervals[k].sheets, k == 2 ? 3 : 1) << k;
  }
  for (const std::size_t k : {1U, 3U}) {
    const CompleteInterval& fold = told.intervals[k];
    EXPECT_FALSE(fold.proven) << k;
    const double nu = folds[k / 2];
    const double error = 1e-12 * nu;  // of the located fold
    EXPECT_LE(fold.from, nu + error);
    EXPECT_GE(fold.to, nu - error);
  }
}

/// A little shallower there is no second sheet, and a proof of that.
TEST(ClosedSheet, IsProvenAbsentWhereTheWellIsTooShallow) {
  const Case input = two_wells_case("0.19");
  AtlasOptions how = sparse();
  how.complete = true;
  const Atlas found = atlas(input.body, input.potential, how);
  EXPECT_EQ(found.sheets.size(), 1U) << text_of(found);
  ASSERT_EQ(found.completeness.size(), 1U);
  ASSERT_EQ(found.completeness[0].intervals.size(), 1U);
  EXPECT_TRUE(found.completeness[0].intervals[0].proven);
  EXPECT_EQ(found.completeness[0].intervals[0].sheets, 1);
}

}  // namespace
}  // namespace stationary
