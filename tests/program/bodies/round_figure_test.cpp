// Figures with a circular section through axis 3 (J2 = J3 in (i), J1 = J3 in (ii)) and where the
// circle breaks, from outside: Maclaurin's spheroids about an axis of the plane are those about
// axis 3 with other names, so every number below is known from there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

/// Of the Jacobi bifurcation: the spheroid's equal and short axes, nu (25 digits, rounded).
constexpr double wide = 1.197233858067355676666887;
constexpr double thin = 0.6976571016669558322728372;
constexpr double jacobi_nu = 0.6117431444537777853246136;

struct Placement {
  const char* branch;
  const char* event;
  const char* nu;     ///< column of the spin
  const char* other;  ///< of the stretch along the axis
  const char* first;  ///< of the two equal ones
  const char* second;
};
constexpr Placement placements[] = {{"i", "ellipse-23", "nu1", "xi", "zeta", "rho"},
                                    {"ii", "ellipse-13", "nu2", "zeta", "xi", "rho"}};

std::string round_fluid(const std::string& branch, const std::string& J = "1, 1, 1") {
  return "[body]\nJ = [" + J + "]\nvolume = 1\n[gravity]\npi_G_rho = 1\n[motion]\nbranch = \"" +
         branch + "\"\nnu = 0.3\n[continuation]\nfrom = 0.1\nto = 0.7\n";
}

std::vector<Row> continued(const TemporaryDirectory& directory, const std::string& text,
                           const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{"continue", directory.file("case.toml", text), "-o",
                                   directory / "table.csv"};
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err << text;
  return outcome.code == 0 ? rows_of(text_of(directory / "table.csv")) : std::vector<Row>();
}

std::vector<Row> events(const std::vector<Row>& rows, const std::string& name) {
  std::vector<Row> out;
  for (const Row& row : rows)
    if (row.at("event") == name) out.push_back(row);
  return out;
}

TEST(RoundFigure, BreaksWhereJacobisEllipsoidsBranchOff) {
  for (const Placement& at : placements) {
    const TemporaryDirectory directory;
    const auto rows =
        continued(directory, round_fluid(at.branch) + "[output]\ncertificate = true\n");
    const auto broken = events(rows, at.event);
    ASSERT_EQ(broken.size(), 1U) << at.branch;
    const Row& row = broken.front();
    EXPECT_NEAR(number(row.at(at.nu)), jacobi_nu, 2e-15) << at.branch;
    EXPECT_NEAR(number(row.at(at.other)), thin, 2e-15) << at.branch;
    EXPECT_NEAR(number(row.at(at.first)), wide, 2e-15) << at.branch;
    EXPECT_EQ(row.at(at.first), row.at(at.second)) << at.branch;
    EXPECT_EQ(row.at("certified"), "yes") << at.branch;
    // Beyond it one Lambda of the even block is positive, and the spheroids go on to their fold.
    const auto turn = events(rows, "fold-nu");
    ASSERT_EQ(turn.size(), 1U) << at.branch;
    const double nu = number(turn.front().at(at.nu));
    EXPECT_NEAR(nu * nu, 0.4493314121239138543595, 4e-16) << at.branch;
    bool beyond = false;
    for (const Row& each : rows) {
      EXPECT_EQ(each.at(at.first), each.at(at.second)) << at.branch;
      beyond = beyond || each.at("event") == at.event;
      if (!each.at("event").empty()) continue;
      EXPECT_EQ(each.at("negative"), beyond ? "1" : "0") << at.branch << each.at(at.nu);
      EXPECT_EQ(each.at("class"), beyond ? "unstable" : "stable") << at.branch << each.at(at.nu);
    }
    EXPECT_TRUE(events(rows, "unexplained").empty());
    EXPECT_TRUE(events(rows, "stalled").empty());
  }
}

/// The ellipsoids that branch off, in both placements, end where the circle is reached.
TEST(RoundFigure, EllipsoidsEndOnIt) {
  for (const Placement& at : placements) {
    for (const bool turned : {false, true}) {
      const TemporaryDirectory directory;
      // b/a = 0.75, about.
      const std::string axes[] = {"0.6918", turned ? "1.0412" : "1.3883",
                                  turned ? "1.3883" : "1.0412"};
      const bool first = std::string(at.branch) == "i";
      const std::string start = "[solve]\nstart = [0.0, " + (first ? axes[0] : axes[1]) + ", " +
                                (first ? axes[1] : axes[0]) + ", " + axes[2] + "]\n";
      std::string text = round_fluid(at.branch);
      text.replace(text.find("nu = 0.3"), 8, "nu = 0.6017");
      const auto rows = continued(directory, text + start);
      ASSERT_FALSE(rows.empty());
      const auto ends = events(rows, at.event);
      ASSERT_EQ(ends.size(), 1U) << at.branch << turned;
      EXPECT_TRUE(rows.front().at("event") == at.event || rows.back().at("event") == at.event);
      EXPECT_NEAR(number(ends.front().at(at.nu)), jacobi_nu, 1e-14) << at.branch;
      EXPECT_NEAR(number(ends.front().at(at.first)), wide, 1e-13) << at.branch;
    }
  }
}

/// A normal form is of the figure, whatever its axes are called.
TEST(RoundFigure, HasTheNormalFormOfTheCircleInThePlane) {
  const TemporaryDirectory directory;
  const auto plane = events(continued(directory, round_fluid("iii")), "ellipse");
  ASSERT_EQ(plane.size(), 1U);
  ASSERT_NE(plane.front().at("criticality"), "");
  for (const Placement& at : placements) {
    const auto broken = events(continued(directory, round_fluid(at.branch)), at.event);
    ASSERT_EQ(broken.size(), 1U);
    EXPECT_EQ(broken.front().at("side"), plane.front().at("side"));
    EXPECT_EQ(broken.front().at("side"), "before");
    EXPECT_NEAR(number(broken.front().at("criticality")) / number(plane.front().at("criticality")),
                1.0, 1e-10);
  }
}

/// Elastic and compressible bodies: where the closed forms and polytropes have theirs in (iii).
TEST(RoundFigure, MovesWithStiffness) {
  struct Known {
    std::string elastic;
    std::string volume;
    double nu;
  };
  const auto neo_hookean = [](const std::string& mu) {
    return "[potential]\ncoupled = { expression = \"mu/2*(I1 + rho^2 - 3)\", mu = " + mu + " }\n";
  };
  const Known known[] = {
      {neo_hookean("0.03"), "volume = 1\n", std::sqrt(0.3999283082848282457134533)},
      {"[potential]\ncoupled = { expression = \"K*(d*rho)^(-1/n)\", K = 1.3333333333333333, n = 1 "
       "}\n",
       "", 0.4716075899603202722504669}};
  for (const Known& each : known) {
    const TemporaryDirectory directory;
    const std::string nu = std::to_string(0.9 * each.nu);
    const auto rows =
        continued(directory, "[body]\nJ = [1, 1, 1]\n" + each.volume + "[gravity]\ng = 4\n" +
                                 each.elastic + "[motion]\nbranch = \"i\"\nnu = " + nu +
                                 "\n[continuation]\nfrom = " + std::to_string(0.8 * each.nu) +
                                 "\nto = " + std::to_string(1.02 * each.nu) + "\n");
    const auto broken = events(rows, "ellipse-23");
    ASSERT_EQ(broken.size(), 1U) << each.elastic;
    EXPECT_NEAR(number(broken.front().at("nu1")) / each.nu, 1.0, 1e-12) << each.elastic;
  }
}

/// Nothing is kept equal that no symmetry makes so.
TEST(RoundFigure, IsNoneOfUnequalInertias) {
  const TemporaryDirectory directory;
  const std::string elastic =
      "[potential]\ncoupled = { expression = \"mu/2*(I1 + rho^2 - 3)\", mu = 0.05 }\n";
  const std::string other =
      "[potential]\ncoupled = { expression = \"mu/2*(I1 + 1.1*rho^2 - 3)\", mu = 0.05 }\n";
  for (const auto& [J, V] : {std::pair{"1, 1, 1.02", elastic}, std::pair{"1, 1, 1", other}}) {
    std::string text = round_fluid("i", J) + V;
    const auto rows = continued(directory, text);
    EXPECT_TRUE(events(rows, "ellipse-23").empty()) << J;
    for (const Row& row : rows)
      if (number(row.at("nu1")) > 0.2) {
        EXPECT_NE(row.at("zeta"), row.at("rho")) << J;
      }
  }
}

/// Where the curve in (nu, mu) passes the closed form's.
TEST(RoundFigure, HasCurvesInTwoParameters) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      "[body]\nJ = [1, 1, 1]\nvolume = 1\n[gravity]\ng = 4\n[potential]\ncoupled = { expression = "
      "\"mu/2*(I1 + rho^2 - 3)\", mu = 0.03 }\n[motion]\nbranch = \"i\"\nnu = 0.5\n[curve]\nevent "
      "= \"ellipse-23\"\nparameters = [\"nu\", \"potential.coupled.mu\"]\nfrom = [0.3, 0.003]\nto "
      "= "
      "[1.0, 0.3]\n");
  const Outcome outcome = run_program({"curve", path, "-o", directory / "curve.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(text_of(directory / "curve.csv"));
  ASSERT_GE(rows.size(), 3U);
  bool low = false;
  for (const Row& row : rows) {
    EXPECT_EQ(row.at("event"), "ellipse-23");
    if (number(row.at("potential.coupled.mu")) != 0.003) continue;
    low = true;
    const double nu = number(row.at("nu1"));
    EXPECT_NEAR(nu * nu, 0.3767916446415322231235393, 1e-13);
  }
  EXPECT_TRUE(low);
}

/// A turn of another number than nu: at nu held, g turns where nu would, Omega^2/(pi G rho) =
/// 0.44933.
TEST(RoundFigure, TurnsInOtherNumbersAreFoldsOfAParameter) {
  const TemporaryDirectory directory;
  const auto rows = continued(
      directory,
      "[body]\nJ = [1, 1, 1]\nvolume = 1\n[gravity]\ng = 4\n[motion]\nbranch = \"iii\"\nnu = 0.6\n"
      "[continuation]\nparameter = \"gravity.g\"\nfrom = 3\nto = 5\n[output]\ncertificate = "
      "true\n");
  EXPECT_TRUE(events(rows, "fold-nu").empty());
  const auto turns = events(rows, "fold-parameter");
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(number(turns.front().at("gravity.g")), 4.0 * 0.36 / 0.4493314121239138543595, 1e-14);
  EXPECT_EQ(turns.front().at("certified"), "yes");
  EXPECT_EQ(turns.front().at("side"), "after");
}

/// What is symmetric in zeta and rho at the case's own numbers alone has no circle at others.
TEST(RoundFigure, HasNoCurveWhereTheSecondNumberBreaksItsSymmetry) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      "[body]\nJ = [1, 1, 1]\nvolume = 1\n[gravity]\ng = 4\n[potential]\ncoupled = { expression = "
      "\"mu/2*(I1 + b*rho^2 - 3)\", mu = 0.03, b = 1.0 }\n[motion]\nbranch = \"i\"\nnu = 0.5\n"
      "[curve]\nevent = \"ellipse-23\"\nparameters = [\"nu\", \"potential.coupled.b\"]\n"
      "from = [0.3, 0.9]\nto = [1.0, 1.1]\n");
  const Outcome outcome = run_program({"curve", path, "-o", directory / "curve.csv"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              testing::HasSubstr("circles of zeta and rho need a potential symmetric"));
  EXPECT_FALSE(std::filesystem::exists(directory / "curve.csv"));
}

/// An imperfection that begins at 0: zeta = rho there, and nowhere beyond.
TEST(RoundFigure, IsLeftWithACoefficientThatBreaksItsSymmetry) {
  const TemporaryDirectory directory;
  const std::string text =
      "[body]\nJ = [1.0, 1.2, 1.2]\n[potential]\ncoupled = { expression = \"mu/2*(I1 + rho^2 - 3 - "
      "2*log(d*rho)) + l/2*log(d*rho)^2 + e*(rho - 1)^2\", mu = 1.0, l = 2.0, e = 0.0 }\n[motion]\n"
      "branch = \"i\"\nnu = 0.4\n";
  const auto rows = continued(
      directory,
      text + "[continuation]\nparameter = \"potential.coupled.e\"\nfrom = 0.0\nto = 0.5\n");
  ASSERT_FALSE(rows.empty());
  const Row& last = rows.back();
  EXPECT_EQ(number(last.at("potential.coupled.e")), 0.5);
  EXPECT_LT(std::abs(number(last.at("residual"))), 1e-14);
  EXPECT_GT(number(last.at("zeta")), number(last.at("rho")) + 1e-3);
  const Outcome solved = run_program({"solve", directory.file("at.toml", text), "--set",
                                      "potential.coupled.e=0.5", "-o", directory / "at.csv"});
  ASSERT_EQ(solved.code, 0) << solved.err;
  const auto same = rows_of(text_of(directory / "at.csv"));
  for (const char* const stretch : {"xi", "zeta", "rho"})
    EXPECT_NEAR(number(same.at(0).at(stretch)), number(last.at(stretch)), 1e-13) << stretch;
}

}  // namespace
}  // namespace stationary::testing
