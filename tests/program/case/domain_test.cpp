// Numbers outside the domain of a body or a model: of two that vary together, both count.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

/// mu + lambda > 0: at the least mu the case's own lambda is not allowed, and at no cell is a pair refused.
class DomainOfTwo : public ::testing::Test {
 protected:
  std::string case_file(const std::string& rest) const {
    return directory_.file("case.toml",
                           "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\n"
                           "plane = { model = \"hencky\", mu = 1.0, lambda = -0.5 }\n"
                           "thickness = { model = \"harmonic\", k = 1.0, rest = 1.0 }\n" +
                               rest);
  }
  const std::string about_axis_ = "[motion]\nbranch = \"i\"\nnu = 0.1\n";
  const std::string map_ =
      "[map]\nx = { parameter = \"potential.plane.mu\", from = 0.2, to = 1.5, count = 4 }\n"
      "y = { parameter = \"potential.plane.lambda\", from = 0.5, to = 1.0, count = 3, "
      "scale = \"log\" }\n";
  TemporaryDirectory directory_;
};

TEST_F(DomainOfTwo, EveryCellOfAMapIsSolved) {
  const Outcome outcome = run_program({"map", case_file(about_axis_ + map_), "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 12U);
  for (const Row& row : rows) EXPECT_EQ(row.at("status"), "solved");
}

TEST_F(DomainOfTwo, NoCellOfAMapOfAnotherKindFails) {
  const Outcome outcome = run_program(
      {"map", case_file("[motion]\nbranch = \"tilted\"\nplane = \"13\"\nnu = 0.5\n" + map_), "-o",
       "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 12U);
  for (const Row& row : rows) EXPECT_NE(row.at("status"), "failed");
}

TEST_F(DomainOfTwo, NoAtlasOfAGridFails) {
  const Outcome outcome = run_program(
      {"atlas", case_file(about_axis_ + "[continuation]\nfrom = 0.0\nto = 0.2\n" + map_), "--grid",
       "--checkpoints", "1", "-o", directory_ / "grid.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("12: 12 solved"));
  EXPECT_THAT(outcome.out,
              HasSubstr("potential.plane.lambda from 0.5 to 1, 3 values, logarithmic"));
}

TEST_F(DomainOfTwo, ACurvesRectangleIsAllowed) {
  const std::string curve =
      "[continuation]\nfrom = 0.0\nto = 0.2\n[curve]\nevent = \"fold-momentum\"\n"
      "parameters = [\"potential.plane.mu\", \"potential.plane.lambda\"]\n"
      "from = [0.2, 0.5]\nto = [1.5, 1.0]\n";
  EXPECT_EQ(run_program({"check", case_file(about_axis_ + curve)}).code, 0);
  // A corner that is not, whichever number is blamed.
  const Outcome refused =
      run_program({"check", case_file(about_axis_ + curve), "--set", "curve.from.1=-0.4"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("curve.from.0: found potential.plane.mu = 0.2; expected mu + "
                                     "lambda > 0"));
  const Outcome other = run_program({"check", case_file(about_axis_ + curve), "--set",
                                     "curve.from.0=0.6", "--set", "curve.from.1=-0.7"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err,
              HasSubstr("curve.from.1: found potential.plane.lambda = -0.7; expected mu + "
                        "lambda > 0"));
}

/// Where the only balance lies outside a domain in principal stretches nothing is left undecided.
TEST(Domain, WhatLiesOutsideItIsExcluded) {
  const TemporaryDirectory directory;
  for (const char* const domain :
       {"lambda>0.87", "lambda>1", "mu_<0.8", "lambda*mu_>0.9", "lambda^2+mu_^2>1.6", "d>0.9"}) {
    const Outcome outcome = run_program(
        {"solve",
         directory.file("case.toml",
                        "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\nplane = { expression = \"c/d + "
                        "k/2*I1\", domain = \"" +
                            std::string(domain) +
                            "\", c = 1.0, k = 2.0 }\nthickness = { model = "
                            "\"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n[motion]\nbranch = "
                            "\"iii\"\nnu = 0.3\n"),
         "--set", "solve.all=true"});
    EXPECT_EQ(outcome.code, 3) << domain;
    EXPECT_THAT(outcome.err, HasSubstr("proven that there is none")) << domain;
  }
}

/// A held volume alone is a fluid; a fibre needs something elastic beside it.
TEST(Domain, AFluidHasNoFibre) {
  const TemporaryDirectory directory;
  const std::string file = directory.file(
      "case.toml",
      "[body]\nJ = [1.0, 1.7, 0.6]\nvolume = 1.0\n[gravity]\ng = 1.0\n"
      "[potential]\nfibre = { k = 0.4, degrees = 0 }\n[motion]\nbranch = \"iii\"\nnu = 0.1\n");
  const Outcome outcome = run_program({"solve", file});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("potential.fibre: found a fibre alone"));
}

}  // namespace
}  // namespace stationary::testing
