// A table with fewer columns that is gone on with: what is told of its curve is what a run never
// interrupted tells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

class ResumeColumns : public ::testing::Test {
 protected:
  std::vector<std::string> command(const std::string& file, const std::vector<std::string>& more) {
    std::vector<std::string> out{"continue", shipped(file), "-o", directory_ / "x.csv"};
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }
  /// Stopped after so many points, and gone on with.
  Outcome resumed(const std::string& file, const std::vector<std::string>& more, int points) {
    auto stopped = command(file, more);
    stopped.insert(stopped.end(), {"--set", "continuation.max_points=" + std::to_string(points)});
    const Outcome first = run_program(stopped);
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_THAT(first.err, HasSubstr("continuation.max_points"));
    auto on = command(file, more);
    on.emplace_back("--resume");
    return run_program(on);
  }
  /// The class of each segment and where it begins and ends.
  std::vector<std::string> told() {
    std::vector<std::string> out;
    const auto metadata = nlohmann::json::parse(text_of(directory_ / "x.meta.json"));
    for (const auto& each : metadata.at("segments"))
      out.push_back(each.at("class").dump() + each.at("from").at("event").dump() +
                    each.at("to").at("event").dump());
    return out;
  }

  TemporaryDirectory directory_;
};

TEST_F(ResumeColumns, ClassesWithoutTheirColumn) {
  struct Cut {
    const char* file;
    const char* columns;
    std::size_t segments;
    int points;
  };
  for (const Cut& each :
       {Cut{"fold.toml", R"(["event","nu1","xi","zeta","rho","growth","segment"])", 2, 100},
        Cut{"fold.toml", R"(["event","nu1","xi","zeta","rho","growth"])", 2, 50},
        Cut{"double_well.toml", R"(["event","nu3","xi","zeta","rho","growth"])", 2, 600}}) {
    SCOPED_TRACE(each.columns);
    const std::vector<std::string> columns{"--set", std::string("output.columns=") + each.columns};
    ASSERT_EQ(run_program(command(each.file, columns)).code, 0);
    const auto whole = told();
    ASSERT_GE(whole.size(), each.segments);
    const Outcome outcome = resumed(each.file, columns, each.points);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(told(), whole);
  }
}

/// The class at rest is another leaf's, whichever columns of nu there are.
TEST_F(ResumeColumns, RestHasNoSay) {
  const std::vector<std::string> settings{
      "--set", "continuation.from=-0.5",
      "--set", "continuation.to=0.5",
      "--set", R"(output.columns=["event","nu1","xi","zeta","rho","class","segment"])"};
  const Outcome outcome = resumed("fold.toml", settings, 43);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<Row> rest;
  for (const Row& row : rows_of(text_of(directory_ / "x.csv")))
    if (row.at("nu1") == "0") rest.push_back(row);
  EXPECT_EQ(rest.size(), 1U);
  EXPECT_EQ(told(), std::vector<std::string>{R"("unstable""limit""limit")"});
}

/// What was not proven is not told as proven.
TEST_F(ResumeColumns, ProofsWithoutTheirColumnsAreRefused) {
  for (const char* missing : {"certified", "class_certified"}) {
    const std::string other = std::string(missing) == "certified" ? "class_certified" : "certified";
    const std::vector<std::string> settings{
        "--certify", "--set",
        R"(output.columns=["event","nu2","xi","zeta","rho","class",")" + other + "\"]"};
    const Outcome outcome = resumed("second_axis.toml", settings, 10);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(std::string("found no column ") + missing));
  }
}

}  // namespace
}  // namespace stationary::testing
