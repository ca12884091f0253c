// `atlas` from outside: the table of all sheets, what is said of them, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

TEST(AtlasCommand, WritesEverySheetAndItsMetadata) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"atlas", shipped("apart.toml"), "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::set<std::string> sheets;
  std::map<std::string, std::string> branches;
  for (const Row& row : rows_of(text_of(directory / "x.csv"))) {
    sheets.insert(row.at("sheet"));
    branches[row.at("sheet")] = row.at("branch");
  }
  EXPECT_THAT(sheets, ::testing::ElementsAre("1", "2", "3", "4", "5", "6"));
  EXPECT_THAT(branches, ::testing::ElementsAre(
                            ::testing::Pair("1", "i"), ::testing::Pair("2", "ii"),
                            ::testing::Pair("3", "iii"), ::testing::Pair("4", "iii"),
                            ::testing::Pair("5", "tilted"), ::testing::Pair("6", "tilted")));
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["command"], "atlas");
  ASSERT_EQ(metadata["sheets"].size(), 6U);
  EXPECT_EQ(metadata["sheets"][0]["entry"], "rest");
  EXPECT_EQ(metadata["sheets"][3]["entry"], "search");
  EXPECT_EQ(metadata["sheets"][5]["parent"]["sheet"], 2);
  EXPECT_EQ(metadata["sheets"][5]["joins"]["sheet"], 4);
  EXPECT_EQ(metadata["checkpoints"].size(), 3U * 256U);
  for (const auto& at : metadata["checkpoints"]) EXPECT_TRUE(at["complete"].get<bool>()) << at;
}

TEST(AtlasCommand, ThreadsDoNotChangeTheTable) {
  const Outcome one = run_program({"atlas", shipped("circle.toml"), "-o", "-", "--threads", "1"});
  const Outcome two = run_program({"atlas", shipped("circle.toml"), "-o", "-", "--threads", "2"});
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(one.err + two.err, "");
}

TEST(AtlasCommand, SummaryNamesSheetsParentsAndWhatIsProven) {
  const Outcome outcome = run_program({"atlas", shipped("circle.toml")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* words : {"from rest", "found at nu = ", "leaves sheet 2 at ellipse",
                            "at 256 of 256 checkpoints", "fold-nu"})
    EXPECT_THAT(outcome.out, HasSubstr(words));
}

/// The spin's sense does not matter.
TEST(AtlasCommand, RangesBelowZeroAreTheSameAbove) {
  const auto table = [](const char* from, const char* to) {
    return run_program({"atlas", shipped("neo_hookean.toml"), "-o", "-", "--set",
                        std::string("continuation.from=") + from, "--set",
                        std::string("continuation.to=") + to})
        .out;
  };
  EXPECT_EQ(table("-1.0", "0.5"), table("0.0", "1.0"));
  EXPECT_EQ(table("-1.0", "-0.5"), table("0.5", "1.0"));
}

TEST(AtlasCommand, WhatIsRefused) {
  EXPECT_EQ(run_program({"atlas", shipped("inertia.toml")}).code, 2);
  EXPECT_THAT(run_program({"atlas", shipped("inertia.toml")}).err,
              HasSubstr("continuation.parameter: found body.J.1"));
  EXPECT_THAT(run_program({"atlas", shipped("too_fast.toml")}).err,
              HasSubstr("continuation: found no such key"));
  EXPECT_EQ(run_program({"atlas", shipped("apart.toml"), "--checkpoints", "0"}).code, 2);
}

TEST(AtlasCommand, AnInterruptEndsItWithItsOwnCode) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"atlas", shipped("apart.toml"), "-o", directory / "x.csv"},
                                      {.pending_signal = SIGINT});
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("not complete"));
}

}  // namespace
}  // namespace stationary::testing
