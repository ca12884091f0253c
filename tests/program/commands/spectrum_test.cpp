// The spectrum from outside: columns, summary, plan, and that none of it is computed unasked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string main_case = STATIONARY_CASES "/disc.toml";

std::map<std::string, std::string> solved_row(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "solve");
  arguments.insert(arguments.end(), {"-o", "-"});
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return only_row(outcome.out);
}

nlohmann::json metadata_of_solve(const std::vector<std::string>& overrides) {
  const TemporaryDirectory directory;
  std::vector<std::string> arguments{"solve", main_case, "-o", directory / "x.csv"};
  for (const std::string& each : overrides) {
    arguments.emplace_back("--set");
    arguments.push_back(each);
  }
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(text_of(directory / "x.meta.json"));
}

TEST(SpectrumOutput, OfTheMainCase) {
  // Growth and third mode from the closed forms of the two blocks.
  auto row = solved_row({main_case});
  EXPECT_EQ(row["class"], "unstable");
  EXPECT_EQ(row["negative"], "1");
  EXPECT_NEAR(number(row["growth"]), 0.1543037674, 1e-10);
  EXPECT_EQ(row["re1"], row["growth"]);
  EXPECT_EQ(row["im1"], "0");
  EXPECT_EQ(row["krein1"], "0");
  EXPECT_NEAR(number(row["im3"]), 1.8153678880, 1e-10);
  double last = 0.0;
  for (const char* k : {"2", "3", "4", "5"}) {
    EXPECT_EQ(row[std::string("re") + k], "0");
    EXPECT_EQ(row[std::string("krein") + k], "1");
    const double im = number(row[std::string("im") + k]);
    EXPECT_GT(im, last);
    last = im;
  }
}

TEST(SpectrumOutput, KreinSignsAndClassOfANegativeMode) {
  auto row = solved_row({STATIONARY_CASES "/second_axis.toml"});
  EXPECT_EQ(row["class"], "elliptic");
  EXPECT_EQ(row["growth"], "0");
  EXPECT_EQ(row["negative"], "2");
  EXPECT_EQ(row["krein1"], "-1");
}

TEST(SpectrumOutput, FourModesAtRestLeaveTheFifthEmpty) {
  auto row = solved_row({main_case, "--set", "motion.nu=0"});
  EXPECT_EQ(row["class"], "stable");
  EXPECT_NE(row["im4"], "");
  for (const char* column : {"re5", "im5", "krein5"}) {
    ASSERT_TRUE(row.contains(column));
    EXPECT_EQ(row[column], "") << column;
  }
  EXPECT_THAT(run_program({"check", main_case, "--set", "motion.nu=0"}).out,
              HasSubstr("4 modes from"));
}

TEST(SpectrumOutput, MetadataCountItAndNameTheClass) {
  const auto metadata = metadata_of_solve({});
  EXPECT_EQ(metadata["counts"]["spectra"], 1);
  EXPECT_EQ(metadata["class"], "unstable");
  EXPECT_TRUE(metadata["skipped"].empty());
  EXPECT_EQ(metadata["plan"].back()["quantity"], "spectrum");
}

TEST(SpectrumOutput, SwitchedOffNoneOfItIsComputed) {
  const auto metadata = metadata_of_solve({"output.spectrum=false"});
  EXPECT_EQ(metadata["counts"]["spectra"], 0);
  EXPECT_FALSE(metadata.contains("class"));
  EXPECT_EQ(metadata["skipped"][0]["quantity"], "spectrum");
  EXPECT_EQ(metadata["skipped"][0]["how"], "skipped");
  EXPECT_EQ(metadata["skipped"][0]["why"], "output.spectrum = false");

  const std::vector<std::string> off{"--set", "output.spectrum=false"};
  const Outcome table = run_program({"solve", main_case, "-o", "-", off[0], off[1]});
  EXPECT_TRUE(header_of(table.out).ends_with(",error_bound")) << table.out;
  for (const char* command : {"solve", "check"}) {
    const Outcome outcome = run_program({command, main_case, off[0], off[1]});
    EXPECT_THAT(outcome.out, HasSubstr("spectrum      skipped\n"));
    EXPECT_THAT(outcome.out, HasSubstr("output.spectrum = false"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("growth")));
  }
}

TEST(SpectrumOutput, ColumnsWithoutItSkipItInATableOnly) {
  const std::string columns = "output.columns=[\"xi\", \"zeta\"]";
  const auto metadata = metadata_of_solve({columns});
  EXPECT_EQ(metadata["counts"]["spectra"], 0);
  EXPECT_THAT(metadata["skipped"][0]["why"].get<std::string>(), HasSubstr("output.columns"));
  EXPECT_THAT(run_program({"check", main_case, "--set", columns}).out, HasSubstr("skipped"));
  EXPECT_THAT(run_program({"solve", main_case, "--set", columns}).out, HasSubstr("unstable: "));
  EXPECT_EQ(metadata_of_solve({"output.columns=[\"xi\", \"im3\"]"})["counts"]["spectra"], 1);
}

TEST(SpectrumOutput, SummaryHasTheModesAndWhatTheClassClaims) {
  const Outcome outcome = run_program({"solve", main_case});
  for (const char* text : {"unstable: a real pair of eigenvalues", "growth 0.154303767405", "im s",
                           "Krein", "error bound of s^2", "1.81536788799", "1 spectrum"})
    EXPECT_THAT(outcome.out, HasSubstr(text));
  // Two negative directions, and stable all the same.
  const Outcome circle = run_program({"solve", STATIONARY_CASES "/circle.toml"});
  EXPECT_THAT(circle.out, HasSubstr("stable: "));
  EXPECT_THAT(circle.out, HasSubstr("momentum"));
}

TEST(SpectrumOutput, PlanNamesTheBlocks) {
  struct Line {
    const char* file;
    const char* branch;
    const char* blocks;
  };
  for (const Line& line : {Line{"disc.toml", "i", "2 blocks: xi, zeta, rho (3)"},
                           Line{"disc.toml", "ii", "alpha, pi1, pi3 (2)"},
                           Line{"disc.toml", "iii", "3 blocks: pi1, pi2 (1), rho (1)"},
                           Line{"coupled.toml", "iii", "alpha, xi, zeta, rho (4)"}}) {
    const Outcome outcome = run_program({"check", std::string(STATIONARY_CASES "/") + line.file,
                                         "--set", std::string("motion.branch=") + line.branch});
    EXPECT_THAT(outcome.out, HasSubstr(line.blocks));
    EXPECT_THAT(outcome.out, HasSubstr("reflections split"));
  }
}

}  // namespace
}  // namespace stationary::testing
