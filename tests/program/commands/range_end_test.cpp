// Where the range of `continue` ends at a place that is an event's, or all but one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

std::string in_all_digits(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

std::vector<Row> followed_over(const std::string& file, const std::vector<std::string>& settings) {
  std::vector<std::string> command{"continue", shipped(file), "-o", "-"};
  for (const std::string& each : settings) command.insert(command.end(), {"--set", each});
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.code == 0 ? rows_of(outcome.out) : std::vector<Row>();
}

/// J1 = J2 is itself an event of a family in J: no other explains what changes there.
TEST(RangeEnd, AtEqualInertiasNothingIsUnexplained) {
  const std::vector<std::vector<std::string>> ranges{
      {"inertia.toml", "continuation.to=1.0"},
      {"disc.toml", "body.J=[1.0,1.5,0.6]", "motion.branch=i", "motion.nu=0.3",
       "continuation={parameter=\"body.J.1\",from=1.0,to=2.0}"},
      {"disc.toml", "body.J=[1.0,0.8,0.6]", "motion.branch=ii", "motion.nu=0.3",
       "continuation={parameter=\"body.J.1\",from=0.5,to=1.0}"}};
  for (const auto& each : ranges) {
    const auto rows = followed_over(each.front(), {each.begin() + 1, each.end()});
    ASSERT_GT(rows.size(), 3U) << each.back();
    for (const Row& row : rows) {
      EXPECT_NE(row.at("event"), "unexplained") << each.back();
      EXPECT_NE(row.at("class"), "marginal") << each.back();
    }
  }
}

/// A double a hair below a fold is where the sheet turns.
TEST(RangeEnd, AHairBelowAFoldIsReached) {
  for (const char* const file : {"broken_pitchfork.toml", "circle.toml"}) {
    double fold = 0.0;
    for (const Row& row : followed_over(file, {}))
      if (row.at("event") == "fold-nu") fold = number(row.at("nu3"));
    ASSERT_GT(fold, 0.0) << file;
    double to = fold;
    for (int k = 0; k < 6; ++k) {
      to = std::nextafter(to, 0.0);
      const auto rows = followed_over(
          file, {"motion.nu=" + in_all_digits(0.9 * fold), "continuation.to=" + in_all_digits(to)});
      ASSERT_GT(rows.size(), 3U);
      EXPECT_TRUE(rows.back().at("event") == "limit" || rows.front().at("event") == "limit") << k;
      for (const Row& row : rows) EXPECT_LE(number(row.at("nu3")), to) << file;
    }
  }
}

}  // namespace
}  // namespace stationary::testing
