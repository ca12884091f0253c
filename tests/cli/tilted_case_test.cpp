// Branch "tilted" from outside: one motion, the family from branch to branch, going on with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/cli/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string tilted_case = STATIONARY_CASES "/tilted.toml";

TEST(TiltedCase, CheckSaysWhatIsComputed) {
  const Outcome outcome = run_program({"check", tilted_case});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("tilted in the 1-3 plane, |nu| = 1.07"));
  EXPECT_THAT(outcome.out, HasSubstr("sqrt(J1/J3) xi"));
  const Outcome other = run_program({"check", tilted_case, "--set", "motion.plane=\"23\""});
  EXPECT_THAT(other.out, HasSubstr("tilted in the 2-3 plane"));
  EXPECT_THAT(other.out, HasSubstr("sqrt(J2/J3) zeta"));
}

TEST(TiltedCase, OneMotionAsARow) {
  const Outcome outcome = run_program({"solve", tilted_case, "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["branch"], "tilted");
  EXPECT_NEAR(std::atan2(number(row["nu3"]), number(row["nu1"])), 0.5526723959, 5e-11);
  EXPECT_EQ(row["nu2"], "0");
  EXPECT_NEAR(number(row["xi"]), 0.57054735, 5e-9);
  EXPECT_NEAR(number(row["pi1"]) * number(row["nu3"]), number(row["pi3"]) * number(row["nu1"]),
              1e-13);
  EXPECT_EQ(row["class"], "unstable");
  EXPECT_NEAR(number(row["growth"]), 0.20382668, 5e-9);
  const Outcome summary = run_program({"solve", tilted_case});
  EXPECT_THAT(summary.out, HasSubstr("from rest to the tilt of branch (i)"));
  EXPECT_THAT(summary.out, HasSubstr("connection    rest"));
}

TEST(TiltedCase, FromAStartTheSameMotion) {
  const auto from = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"solve", tilted_case, "-o", "-"};
    all.insert(all.end(), more.begin(), more.end());
    return only_row(run_program(all).out);
  };
  auto walked = from({});
  auto started = from({"--set", "solve.start=[0, 0.6, 3, 0.7]"});
  for (const char* column : {"nu1", "nu3", "xi", "zeta", "rho"})
    EXPECT_NEAR(number(walked[column]), number(started[column]), 1e-13) << column;
}

TEST(TiltedCase, ProofsAreRefusedByName) {
  const Outcome outcome = run_program({"solve", tilted_case, "--certify"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--certify: found it with branch \"tilted\""));
}

TEST(TiltedCase, WhereThereIsNoneItSaysWhereTheFamilyEnds) {
  const Outcome outcome = run_program({"solve", tilted_case, "--set", "motion.nu=1.3"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("branch (i) at nu = 1.05486"));
  EXPECT_THAT(outcome.err, HasSubstr("to 1.08359 (tilt)"));
}

TEST(TiltedCase, TheFamilyFromBranchToBranch) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"continue", tilted_case, "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(text_of(directory / "x.csv"));
  ASSERT_GE(rows.size(), 10U);
  EXPECT_EQ(rows.front().at("event"), "tilt");
  EXPECT_EQ(rows.front().at("nu3"), "0");
  EXPECT_EQ(rows.back().at("event"), "tilt");
  EXPECT_EQ(rows.back().at("nu1"), "0");
  double tilt = -1.0;
  for (const Row& row : rows) {
    const double next = std::atan2(number(row.at("nu3")), number(row.at("nu1")));
    EXPECT_GT(next, tilt);
    tilt = next;
  }
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["case"]["motion"]["plane"], "13");
  ASSERT_EQ(metadata["events"].size(), 2U);
  EXPECT_EQ(metadata["events"][0]["event"], "tilt");
}

TEST(TiltedCase, AnInterruptedTableGoesOn) {
  const TemporaryDirectory directory;
  const std::vector<std::string> command{"continue", tilted_case, "-o", directory / "x.csv"};
  ASSERT_EQ(run_program(command).code, 0);
  const auto whole = rows_of(text_of(directory / "x.csv"));
  auto stopped = command;
  stopped.insert(stopped.end(), {"--set", "continuation.max_points=5"});
  ASSERT_EQ(run_program(stopped).code, 0);
  auto resumed = command;
  resumed.emplace_back("--resume");
  const Outcome outcome = run_program(resumed);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(text_of(directory / "x.csv"));
  for (const auto end : {0, 1}) {
    const Row& a = end == 0 ? whole.front() : whole.back();
    const Row& b = end == 0 ? rows.front() : rows.back();
    EXPECT_EQ(a.at("event"), b.at("event"));
    for (const char* column : {"nu1", "nu3", "xi", "rho"})
      EXPECT_NEAR(number(a.at(column)), number(b.at(column)), 1e-12) << column;
  }
}

}  // namespace
}  // namespace stationary::testing
