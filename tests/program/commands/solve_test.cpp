// solve from outside: the table, its columns and metadata, the summary, the exit codes.
#include "solver/solve/solve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/program/case/case_file.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* solve_columns =
    "branch,sheet,point,nu1,nu2,nu3,alpha,xi,zeta,rho,lambda,mu,angle,pi1,pi2,pi3,energy,residual,"
    "compatibility,error_bound,class,growth,negative,re1,im1,krein1,re2,im2,krein2,re3,im3,krein3,"
    "re4,im4,krein4,re5,im5,krein5";

TEST(Solve, TableReadsBackToTheLastBit) {
  const Outcome outcome = run_program({"solve", shipped("disc.toml"), "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_TRUE(outcome.out.starts_with(std::string(solve_columns) + '\n'));
  EXPECT_TRUE(outcome.out.ends_with("\n"));
  EXPECT_EQ(outcome.out.find('\r'), std::string::npos);

  const Case input = read_case(shipped("disc.toml"));
  const Problem problem = input.problem();
  const Equilibrium expected = solve(problem, std::get<AxisRotation>(input.motion).nu);
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["branch"], "i");
  EXPECT_EQ(row["sheet"], "1");
  EXPECT_EQ(row["point"], "0");
  EXPECT_EQ(number(row["nu1"]), 0.5);
  EXPECT_EQ(number(row["alpha"]), 0.0);
  EXPECT_EQ(number(row["xi"]), expected.q.xi);
  EXPECT_EQ(number(row["zeta"]), expected.q.zeta);
  EXPECT_EQ(number(row["rho"]), expected.q.rho);
  EXPECT_EQ(number(row["residual"]), expected.residual);
  EXPECT_EQ(number(row["error_bound"]), expected.error_bound);
  EXPECT_EQ(number(row["energy"]), energy(input.body, input.potential, expected.q, expected.nu));
  const double inertia =
      1.7 * expected.q.zeta * expected.q.zeta + 0.6 * expected.q.rho * expected.q.rho;
  EXPECT_NEAR(number(row["pi1"]), 0.5 * inertia, 1e-15);
  EXPECT_EQ(number(row["lambda"]), std::max(expected.q.xi, expected.q.zeta));
}

TEST(Solve, ClosedFormOfTheMainCase) {
  const Outcome outcome = run_program({"solve", shipped("disc.toml"), "-o", "-"});
  auto row = only_row(outcome.out);
  const double a2 = 2.0 - 1.7 * 0.25;
  EXPECT_NEAR(number(row["xi"]), std::pow(a2, 0.125) * std::pow(2.0, -0.375), 4e-16);
  EXPECT_NEAR(number(row["zeta"]), std::pow(2.0, 0.125) * std::pow(a2, -0.375), 4e-16);
  EXPECT_NEAR(number(row["rho"]), std::cbrt(1.0 / (3.0 - 0.6 * 0.25)), 4e-16);
}

TEST(Solve, NoAngleOnTheCircle) {
  const Outcome outcome = run_program({"solve", shipped("circle.toml"), "-o", "-"});
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["angle"], "");
  EXPECT_EQ(row["lambda"], row["mu"]);
}

TEST(Solve, ChosenColumnsKeepTheirOrder) {
  const Outcome outcome =
      run_program({"solve", shipped("disc.toml"), "-o", "-", "--set",
                   "output.columns=[\"class\", \"energy\", \"event\", \"xi\", \"branch\"]"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("branch,xi,energy,class\ni,")) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with(",unstable\n")) << outcome.out;
}

/// The proof of a class takes the spectrum, whether its columns are asked for or not.
TEST(Solve, TheProofOfAClassAlone) {
  const std::vector<std::string> solve{"solve", shipped("disc.toml"), "-q", "-o", "-", "--set"};
  auto proven = solve;
  proven.insert(proven.end(), {"output.columns=[\"xi\", \"class_certified\"]", "--certify"});
  const Outcome outcome = run_program(proven);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("xi,class_certified\n")) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with(",yes\n")) << outcome.out;
  auto none = solve;
  none.emplace_back("output.columns=[\"omega\"]");
  const Outcome refused = run_program(none);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("\"growth\""));
}

TEST(Solve, MetadataStandsBesideTheTable) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"solve", shipped("disc.toml"), "-o", directory / "x.csv", "--threads", "2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, outcome.out.find("\ncost")), [&] {
    const std::string alone = run_program({"solve", shipped("disc.toml")}).out;
    return alone.substr(0, alone.find("\ncost"));
  }());  // the same summary as without a table
  EXPECT_THAT(run_program({"solve", shipped("disc.toml"), "-o", directory / "x.csv", "-q"}).out,
              IsEmpty());
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(directory.names(), ::testing::ElementsAre("x.csv", "x.meta.json"));
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["program"], "stationary");
  EXPECT_EQ(metadata["run"]["command_line"][1], "solve");
  EXPECT_EQ(metadata["rows"], 1);
  EXPECT_GE(metadata["run"]["seconds"].get<double>(), 0.0);
  EXPECT_EQ(metadata["case"]["body"]["J"], nlohmann::json({1.0, 1.7, 0.6}));
  EXPECT_EQ(metadata["case"]["potential"]["plane"]["c"], 1.0);
  EXPECT_EQ(metadata["case"]["solve"]["method"], "auto");
  EXPECT_EQ(metadata["case"]["output"]["spectrum"], true);
  EXPECT_EQ(metadata["connection"], "rest");
  EXPECT_FALSE(metadata["message"].get<std::string>().empty());
  EXPECT_GT(metadata["counts"]["extended_residuals"].get<int>(), 0);
  EXPECT_FALSE(metadata["plan"].empty());
  for (const auto& item : metadata["skipped"]) EXPECT_FALSE(item["why"].get<std::string>().empty());
}

TEST(Solve, SummaryForAPerson) {
  const Outcome outcome = run_program({"solve", shipped("disc.toml")});
  EXPECT_EQ(outcome.code, 0);
  for (const char* word :
       {"branch (i), nu = (0.5, 0, 0)", "xi", "zeta", "rho", "principal", "momenta", "energy",
        "residual", "error bound", "alpha", "not an unknown"})
    EXPECT_THAT(outcome.out, HasSubstr(word));
  EXPECT_THAT(run_program({"solve", shipped("disc.toml"), "--quiet"}).out, IsEmpty());
}

TEST(Solve, NoneExistsIsThreeAndAnEmptyTable) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"solve", shipped("too_fast.toml"), "-o", directory / "x.csv"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no stationary ellipsoid exists"));
  EXPECT_THAT(outcome.err, HasSubstr("J3 nu^2"));
  EXPECT_EQ(text_of(directory / "x.csv"), std::string(solve_columns) + '\n');
  EXPECT_EQ(nlohmann::json::parse(text_of(directory / "x.meta.json"))["rows"], 0);
}

TEST(Solve, NotFoundIsThreeAndSaysThatItProvesNothing) {
  const Outcome outcome = run_program({"solve", shipped("circle.toml"), "--set", "motion.nu=50"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("was found"));
}

/// Of a start beyond the numbers Ceres would tell in its own words.
TEST(Solve, AStartWithoutNumbersIsNoMatterOfALog) {
  const Outcome outcome =
      run_program({"solve", shipped("disc.toml"), "-o", "-", "--set", "solve.start=[0,1e200,1,1]"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST(Solve, TheWalkSaysHowFarItCame) {
  const Outcome outcome =
      run_program({"solve", shipped("maclaurin.toml"), "--set", "body.volume=1e60"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("The sheet of the rest state does not reach |nu| = 0.3"));
}

TEST(Solve, SpinReversedLeavesTheShape) {
  const Outcome forward = run_program({"solve", shipped("disc.toml"), "-o", "-"});
  const Outcome backward =
      run_program({"solve", shipped("disc.toml"), "-o", "-", "--set", "motion.nu=-0.5"});
  auto a = only_row(forward.out);
  auto b = only_row(backward.out);
  EXPECT_EQ(a["xi"], b["xi"]);
  EXPECT_EQ(a["energy"], b["energy"]);
  EXPECT_EQ('-' + a["pi1"], b["pi1"]);
  EXPECT_EQ(a["growth"], b["growth"]);
}

TEST(Solve, EveryMethodFindsTheSame) {
  const double expected =
      number(only_row(run_program({"solve", shipped("disc.toml"), "-o", "-"}).out)["xi"]);
  for (const std::string_view method : method_names) {
    const Outcome outcome = run_program(
        {"solve", shipped("disc.toml"), "-o", "-", "--set", "solve.method=" + std::string(method)});
    ASSERT_EQ(outcome.code, 0) << method << outcome.err;
    EXPECT_NEAR(number(only_row(outcome.out)["xi"]), expected, 1e-15) << method;
  }
}

}  // namespace
}  // namespace stationary::testing
