// Where V is a plane's and a thickness' every sheet in the plane goes with each rho that is balanced: sheets
// that end alike, at the same nu, and are none of each other's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "tests/support/atlas_text.hpp"

namespace stationary {
namespace {

using namespace testing;

/// A thickness with two wells, r1 and r2, and a balance between.
Case case_of(const std::string& J, const std::string& plane, const std::string& wells,
             const std::string& more = "") {
  return make_case(CaseTree::parse(
      "[body]\nJ = " + J + "\n[motion]\nbranch = \"iii\"\nnu = 0.3\n[potential]\nplane = { " +
          plane + " }\nthickness = { expression = \"k*((rho - r1)*(rho - r2))^2 - c*rho\", " +
          wells + " }\n" + more,
      "wells"));
}

Atlas atlas_of(const Case& input, double to, int checkpoints,
               std::vector<Branch> branches = {Branch::i, Branch::ii, Branch::iii}) {
  AtlasOptions how;
  how.to = to;
  how.checkpoints = checkpoints;
  how.branches = std::move(branches);
  how.step.tolerance = 1e-6;
  return atlas(input.body, input.potential, how);
}

/// rho, where a sheet's is one, of the sheets that these are.
template <class Which>
std::multiset<double> rhos(const Atlas& found, const Which& which) {
  std::multiset<double> out;
  for (const AtlasSheet& sheet : found.sheets)
    if (which(sheet)) out.insert(sheet.rows[sheet.rows.size() / 2].member.q.rho);
  return out;
}

void expect_near(const std::multiset<double>& found, const std::vector<double>& expected,
                 double error) {
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_TRUE(std::ranges::equal(found, expected,
                                 [&](double a, double b) { return std::abs(a - b) < error; }));
}

/// Those of (iii) that come from infinity and go there, one for each root of the thickness' slope.
TEST(SeparableSheets, FromEscapeToEscapeWithEveryThickness) {
  const Atlas found = atlas_of(
      case_of("[1.046, 0.972, 0.234]", "model = \"neo-hookean\", mu = 0.0525, lambda = 2.3792",
              "k = 40.0, r1 = 0.8, r2 = 1.2, c = 0.2"),
      1.0, 48);
  const auto apart = [](const AtlasSheet& sheet) {
    return sheet.branch == Branch::iii && !sheet.plane &&
           sheet.rows.front().event == EventType::escape &&
           sheet.rows.back().event == EventType::escape;
  };
  expect_near(rhos(found, apart), {0.81798, 0.96793, 1.21410}, 1e-4);
  expect_complete(found);
}

/// One nu for all eccentricities, and three circles that they leave.
TEST(SeparableSheets, AVerticalBranchFromEveryCircle) {
  const Atlas found =
      atlas_of(case_of("[1.0, 1.0, 0.6]", "model = \"neo-hookean\", mu = 1.0, lambda = 2.0",
                       "k = 4.0, r1 = 0.8, r2 = 1.4, c = 0.0"),
               1.5, 8);
  const auto vertical = [](const AtlasSheet& sheet) { return sheet.report.vertical; };
  expect_near(rhos(found, vertical), {0.8, 1.1, 1.4}, 1e-9);
  for (const AtlasSheet& sheet : found.sheets)
    if (sheet.report.vertical) {
      EXPECT_TRUE(sheet.parent) << sheet.number;
    }
  // Tilted sheets that end on one of them are joined to it.
  int tilted = 0;
  for (const AtlasSheet& sheet : found.sheets) {
    if (!sheet.plane || sheet.rows.back().event != EventType::tilt) continue;
    EXPECT_TRUE(sheet.joins) << sheet.number;
    ++tilted;
  }
  EXPECT_EQ(tilted, 2);
}

/// Circles closer to each other than an end is to its event have one each too.
TEST(SeparableSheets, AVerticalBranchFromCirclesNearEachOther) {
  const Atlas found =
      atlas_of(case_of("[1.0, 1.0, 0.6]", "model = \"neo-hookean\", mu = 1.0, lambda = 2.0",
                       "k = 4000.0, r1 = 0.9, r2 = 0.9006, c = 0.0"),
               1.5, 2, {Branch::i, Branch::iii});
  const auto vertical = [](const AtlasSheet& sheet) { return sheet.report.vertical; };
  expect_near(rhos(found, vertical), {0.9, 0.9003, 0.9006}, 1e-6);
  // Beside all three tilts that family is found which ends at one of them: it is listed once.
  const auto tilted = [](const AtlasSheet& sheet) { return sheet.plane.has_value(); };
  EXPECT_EQ(rhos(found, tilted).size(), 1U);
}

/// Three sheets of (i), each left by an oblique one, at the same nu. The spin pulls at rho, a little.
TEST(SeparableSheets, AnObliqueSheetFromEveryThickness) {
  const Case input =
      case_of("[1.0, 1.7, 0.6]", "model = \"neo-hookean\", mu = 1.0, lambda = 2.0",
              "k = 400.0, r1 = 0.9, r2 = 1.2, c = 0.0", "fibre = { k = 0.4, degrees = 90.0 }\n");
  for (const int checkpoints : {3, 16}) {
    const Atlas found = atlas_of(input, 1.0, checkpoints, {Branch::i});
    const auto oblique = [](const AtlasSheet& sheet) { return sheet.oblique; };
    expect_near(rhos(found, oblique), {0.9, 1.05, 1.2}, 0.03);
    for (const AtlasSheet& sheet : found.sheets) {
      if (!sheet.oblique) continue;
      EXPECT_TRUE(sheet.rows.front().event == EventType::oblique ||
                  sheet.rows.back().event == EventType::oblique)
          << sheet.number;
      EXPECT_TRUE(sheet.parent) << sheet.number;
    }
  }
}

}  // namespace
}  // namespace stationary
