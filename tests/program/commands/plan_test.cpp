// What a command says it computes and leaves out, in metadata and by `check`, is what it does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/json_schema.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// Every key that some command does not use.
constexpr const char* with_every_key = R"(
[body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "reciprocal-determinant", c = 1.0, k = 2.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "iii"
nu = 0.1
[solve]
all = true
start = [0.0, 1.0, 1.0, 1.0]
method = "newton"
box = [0.1, 10.0]
[continuation]
from = 0.0
to = 0.2
events = ["fold-nu"]
[map]
x = { parameter = "nu", from = 0.0, to = 0.2, count = 3 }
[curve]
event = "ellipse"
parameters = ["nu", "body.J.1"]
from = [0.0, 1.0]
to = [0.2, 2.0]
)";

json written_metadata(const TemporaryDirectory& directory) {
  const json out = json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(schema_fault(out, json::parse(text_of(STATIONARY_SCHEMA))), "");
  return out;
}

std::map<std::string, std::string> by_quantity(const json& items) {
  std::map<std::string, std::string> out;
  for (const json& each : items) out[each["quantity"]] = each["how"];
  return out;
}

TEST(Plan, EachCommandNamesTheKeysThatItDoesNotUse) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", with_every_key);
  const std::map<std::string, std::vector<std::string>> unused{
      {"solve", {"solve.start", "solve.method"}},
      {"continue", {"solve.all", "solve.box"}},
      {"sensitivity", {"solve.start", "solve.method"}},
      {"map", {"solve.start", "solve.method", "solve.all", "solve.box"}},
      {"atlas", {"solve.start", "solve.method", "continuation.events"}}};
  for (const auto& [command, keys] : unused) {
    const Outcome outcome = run_program({command, file, "-o", directory / "x.csv", "-q"});
    ASSERT_EQ(outcome.code, 0) << command << outcome.err;
    const json metadata = written_metadata(directory);
    auto skipped = by_quantity(metadata["skipped"]);
    for (const std::string& key : keys) EXPECT_EQ(skipped[key], "not used") << command << key;
    EXPECT_EQ(skipped.size(), keys.size()) << command << metadata["skipped"];
    const auto plan = by_quantity(metadata["plan"]);
    EXPECT_EQ(plan.contains("all solutions"), command == "solve" || command == "sensitivity")
        << command;
    EXPECT_EQ(plan.contains("events"), command == "continue") << command;
    EXPECT_EQ(plan.contains("sheets"), command == "atlas") << command;
  }
}

TEST(Plan, AnAtlasCountsWhatItSearchedAndFollowed) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", with_every_key);
  ASSERT_EQ(run_program({"atlas", file, "-o", directory / "x.csv", "-q"}).code, 0);
  const json metadata = written_metadata(directory);
  const json& counts = metadata["counts"];
  EXPECT_EQ(counts["checkpoints"], metadata["checkpoints"].size());
  EXPECT_GE(counts["points_evaluated"].get<long>(), metadata["rows"].get<long>());
  EXPECT_GT(counts["continuation_steps"].get<long>(), 0);
  EXPECT_EQ(counts["cover_boxes"], 0);
  ASSERT_EQ(run_program({"atlas", file, "--complete", "-o", directory / "x.csv", "-q"}).code, 0);
  EXPECT_GT(written_metadata(directory)["counts"]["cover_boxes"].get<long>(), 0);
}

TEST(Plan, CheckSaysWhatACurveOfTheCaseAsksFor) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", with_every_key);
  EXPECT_THAT(run_program({"check", file}).out, Not(HasSubstr("`curve`")));
  const Outcome outside = run_program({"check", file, "--set", "curve.to=[0.2, 1.5]"});
  EXPECT_EQ(outside.code, 0) << outside.err;
  EXPECT_THAT(outside.out,
              HasSubstr("`curve` needs --from: curve.from.1: found body.J.1 = 1.7 outside"));
  const Outcome refused = run_program(
      {"check", file, "--set", "curve.parameters=[\"potential.thickness.a\", \"body.J.1\"]",
       "--set", "curve.from=[1.0, 1.0]", "--set", "curve.to=[2.0, 2.0]", "--set",
       "curve.event=\"zero-momentum\""});
  EXPECT_EQ(refused.code, 0) << refused.err;
  EXPECT_THAT(refused.out, HasSubstr("`curve` refuses it: "));
}

}  // namespace
}  // namespace stationary::testing
