// Motions with alpha != 0 of an isotropic body that its gravity shears, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Not;

/// With gravity and J1 != J2 motions of an isotropic body with alpha != 0, where W_t = 0: xi + zeta = 1.8.
class ShearedByGravity : public ::testing::Test {
 protected:
  static std::string text(const std::string& motion) {
    return "[body]\nJ = [1.0, 1.7, 0.6]\nvolume = 0.72\n[gravity]\ng = 2.0\n[potential]\n"
           "plane = { model = \"biot\", mu = 0.5, lambda = 4.0 }\n"
           "thickness = { model = \"harmonic\", k = 1.0, rest = 1.9103134285 }\n"
           "[motion]\n" +
           motion + "[continuation]\nfrom = 0.0\nto = 0.7\n";
  }
  Outcome run(const std::string& motion, std::vector<std::string> words) const {
    words.insert(words.begin() + 1, directory_.file("case.toml", text(motion)));
    return run_program(words);
  }
  static std::vector<double> events(const Outcome& outcome, const std::string& event,
                                    const std::string& column) {
    std::vector<double> out;
    for (const Row& row : rows_of(outcome.out))
      if (row.at("event") == event) out.push_back(number(row.at(column)));
    return out;
  }
  const std::string third_ = "branch = \"iii\"\nnu = 0.536491\n";
  TemporaryDirectory directory_;
};

/// At rest no axis is one of a spin, and a start with alpha != 0 leads to the rest state all the same.
TEST_F(ShearedByGravity, AtRestAStartMayBeSheared) {
  const std::string rest = "branch = \"iii\"\nnu = 0.0\n";
  const Outcome plain = run(rest, {"solve", "-o", "-", "--set", "solve.start=[0.0, 1, 0.8, 0.9]"});
  const Outcome sheared =
      run(rest, {"solve", "-o", "-", "--set", "solve.start=[0.1, 1, 0.8, 0.9]"});
  ASSERT_EQ(plain.code, 0) << plain.err;
  ASSERT_EQ(sheared.code, 0) << sheared.err;
  EXPECT_NEAR(number(rows_of(plain.out).at(0).at("xi")),
              number(rows_of(sheared.out).at(0).at("xi")), 1e-14);
}

TEST_F(ShearedByGravity, IsAmongAllAboutAxisThree) {
  const Outcome all = run(third_, {"solve", "-o", "-", "--set", "solve.all=true", "--set",
                                   "solve.box=[0.5,2]", "--set", "output.certificate=true"});
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(run(third_, {"solve", "--set", "solve.all=true", "--set", "solve.box=[0.5,2]"}).out,
              HasSubstr("proven to be all"));
  int sheared = 0;
  for (const Row& row : rows_of(all.out)) {
    if (number(row.at("alpha")) == 0.0) continue;
    ++sheared;
    // By a derivation of its own, in 100 digits.
    EXPECT_NEAR(number(row.at("alpha")), 0.2598084312841751, 1e-14);
    EXPECT_NEAR(number(row.at("xi")), 1.0499976858015287, 1e-14);
    EXPECT_NEAR(number(row.at("zeta")), 0.7500023141984713, 1e-14);
    EXPECT_NEAR(number(row.at("rho")), 0.9999996204336969, 1e-14);
  }
  EXPECT_EQ(sheared, 1);
  // With J1 = J2 the angle of S is a matter of choice.
  const Outcome check = run(third_, {"check"});
  EXPECT_THAT(check.out, HasSubstr("isotropic but for gravity"));
  EXPECT_THAT(run(third_, {"check", "--set", "potential.plane.model=neo-hookean"}).out,
              HasSubstr("isotropic but for gravity"));
  EXPECT_THAT(run(third_, {"check", "--set", "body.J=[1.0,1.0,0.6]"}).out,
              Not(HasSubstr("but for gravity")));
}

/// From `shear` of one sheet of (iii) to `shear` of another, each at the same nu to the last digits, and S
/// turned by a right angle in between.
TEST_F(ShearedByGravity, JoinsTwoSheetsOfTheThirdBranch) {
  const Outcome bent =
      run(third_, {"continue", "-o", "-", "--set", "solve.start=[0.26,1.05,0.75,1.0]", "--set",
                   "output.certificate=true"});
  ASSERT_EQ(bent.code, 0) << bent.err;
  const std::vector<Row> rows = rows_of(bent.out);
  ASSERT_GE(rows.size(), 100U);
  const std::vector<double> ends = events(bent, "shear", "nu3");
  ASSERT_EQ(ends.size(), 2U);
  for (const Row& row : rows)
    EXPECT_NEAR(number(row.at("xi")) + number(row.at("zeta")), 1.8, 1e-14);
  EXPECT_NEAR(number(rows.front().at("lambda")), number(rows.front().at("zeta")), 1e-15);
  EXPECT_NEAR(number(rows.back().at("lambda")), number(rows.back().at("xi")), 1e-15);
  const std::vector<double> straight =
      events(run("branch = \"iii\"\nnu = 0.0\n", {"continue", "-o", "-"}), "shear", "nu3");
  ASSERT_EQ(straight.size(), 1U);
  EXPECT_NEAR(straight[0], ends[1], 1e-14);
  // And it begins on the side that it is on.
  EXPECT_EQ(rows.front().at("side"), "after");
  EXPECT_EQ(rows.back().at("side"), "before");
  EXPECT_NE(number(rows.front().at("criticality")), 0.0);
  const std::vector<double> other =
      events(run(third_, {"continue", "-o", "-", "--set", "solve.start=[0,0.936,0.8598,0.8947]"}),
             "shear", "nu3");
  EXPECT_THAT(other, Contains(DoubleNear(ends[0], 1e-14)));
}

TEST_F(ShearedByGravity, JoinsTheBranchesOfTheOtherAxesObliquely) {
  const std::string motion = "branch = \"oblique\"\nnu = 0.48\n";
  const Outcome bent = run(motion, {"continue", "-o", "-"});
  ASSERT_EQ(bent.code, 0) << bent.err;
  std::vector<double> ends = events(bent, "oblique", "nu1");
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[1], 0.0);
  ends[1] = events(bent, "oblique", "nu2")[1];
  EXPECT_EQ(rows_of(bent.out).front().at("side"), "after");
  EXPECT_EQ(rows_of(bent.out).back().at("side"), "before");
  for (const auto& [branch, column, at] :
       {std::tuple{"i", "nu1", ends[0]}, std::tuple{"ii", "nu2", std::abs(ends[1])}}) {
    const std::string from = directory_ / (std::string(branch) + ".csv");
    const std::string text = std::string("branch = \"") + branch + "\"\nnu = 0.0\n";
    const Outcome straight = run(text, {"continue", "-o", "-"});
    const std::vector<double> events_there = events(straight, "oblique", column);
    ASSERT_EQ(events_there.size(), 1U) << branch;
    EXPECT_NEAR(events_there[0], at, 1e-14) << branch;
    // And the family can be entered there.
    ASSERT_EQ(run(text, {"continue", "-o", from}).code, 0);
    const Outcome entered = run(motion, {"continue", "-o", "-", "--from", from + ":oblique"});
    ASSERT_EQ(entered.code, 0) << entered.err;
    EXPECT_EQ(events(entered, "oblique", "nu1").size(), 2U) << branch;
  }
}

TEST_F(ShearedByGravity, IsRefusedWhereItCannotBe) {
  const std::string start = "solve.start=[0.26,1.05,0.75,1.0]";
  const Outcome in_J = run(
      third_, {"continue", "-o", "-", "--set", start, "--set", "continuation.parameter=body.J.1",
               "--set", "continuation.from=1.6", "--set", "continuation.to=1.8"});
  EXPECT_EQ(in_J.code, 2);
  EXPECT_THAT(in_J.err, HasSubstr("followed in nu alone"));
  const std::string oblique = "branch = \"oblique\"\nnu = 0.48\n";
  const Outcome axis = run(oblique + "axis = \"1\"\n", {"solve"});
  EXPECT_EQ(axis.code, 2);
  EXPECT_THAT(axis.err, HasSubstr("axis"));
  const Outcome round = run(oblique, {"solve", "--set", "body.J=[1.0,1.0,0.6]"});
  EXPECT_EQ(round.code, 3);
  EXPECT_THAT(round.err, HasSubstr("J1 = J2"));
  const Outcome rising = run(oblique, {"solve", "--set", "potential.plane.model=neo-hookean"});
  EXPECT_EQ(rising.code, 3);
  EXPECT_THAT(rising.err, HasSubstr("W_t = 0"));
  // Where alpha = 0 is known.
  for (const char* const other : {"body.J=[1.0,1.0,0.6]", "potential.plane.model=neo-hookean"}) {
    const Outcome straight = run(third_, {"solve", "--set", start, "--set", other});
    EXPECT_EQ(straight.code, 2) << other;
    EXPECT_THAT(straight.err, HasSubstr("solve.start")) << other;
    EXPECT_THAT(straight.err, HasSubstr("alpha = 0")) << other;
  }
  for (const std::string& motion : {third_, oblique}) {
    const Outcome method =
        run(motion, {"solve", "--set", start, "--set", "solve.method=\"ceres\""});
    EXPECT_EQ(method.code, 2);
    EXPECT_THAT(method.err, HasSubstr("where alpha is an unknown"));
  }
}

TEST_F(ShearedByGravity, IsGoneOnWithByItsAlpha) {
  const auto interrupted = [&](const std::string& motion, const std::string& name) {
    const std::string table = directory_ / name;
    const std::vector<std::string> how{
        "--set", "output.columns=[\"event\",\"nu1\",\"nu2\",\"nu3\",\"xi\",\"zeta\",\"rho\"]", "-o",
        table};
    std::vector<std::string> few{"continue", "--set", "continuation.max_points=30"};
    few.insert(few.end(), how.begin(), how.end());
    EXPECT_EQ(run(motion, few).code, 0);
    std::vector<std::string> more{"continue", "--resume"};
    more.insert(more.end(), how.begin(), how.end());
    return run(motion, more);
  };
  const Outcome sheared = interrupted("branch = \"oblique\"\nnu = 0.48\n", "oblique.csv");
  EXPECT_EQ(sheared.code, 2);
  EXPECT_THAT(sheared.err, HasSubstr("found no column alpha"));
  // About axis 1 it is 0.
  const Outcome straight = interrupted("branch = \"i\"\nnu = 0.3\n", "straight.csv");
  EXPECT_EQ(straight.code, 0) << straight.err;
}

TEST_F(ShearedByGravity, IsInAnAtlas) {
  const std::vector<std::string> how{"--checkpoints", "1",
                                     "--set",         "solve.box=[0.2,4]",
                                     "--set",         "continuation.from=0.46",
                                     "--set",         "continuation.to=0.56"};
  const auto atlas = [&](std::vector<std::string> words) {
    words.insert(words.end(), how.begin(), how.end());
    return run(third_, words);
  };
  const std::string told = atlas({"atlas"}).out;
  EXPECT_THAT(told, HasSubstr("joins sheet"));
  EXPECT_THAT(told, HasSubstr("branch (oblique): at 1 of 1 checkpoints"));
  const Outcome table = atlas({"atlas", "-o", "-"});
  ASSERT_EQ(table.code, 0) << table.err;
  int sheared = 0;
  int oblique = 0;
  for (const Row& row : rows_of(table.out)) {
    sheared += row.at("branch") == "iii" && number(row.at("alpha")) > 0.0;
    oblique += row.at("branch") == "oblique";
  }
  EXPECT_GE(sheared, 10);
  EXPECT_GE(oblique, 10);
  // No curves of these are covered.
  EXPECT_THAT(atlas({"atlas", "--complete"}).out, HasSubstr("no curves of this kind are covered"));
}

}  // namespace
}  // namespace stationary::testing
