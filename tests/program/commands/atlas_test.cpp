// `atlas` from outside: the table of all sheets, what is said of them, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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
  EXPECT_EQ(metadata["checkpoints"].size(), 5U * 256U);  // two planes of tilted axes
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
  for (const char* wrong : {"atlas.checkpoints=0", "atlas.checkpoints=2.5", "atlas.complete=1"}) {
    const Outcome outcome = run_program({"atlas", shipped("apart.toml"), "--set", wrong});
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr(std::string(wrong).substr(0, std::string(wrong).find('='))));
  }
}

TEST(AtlasCommand, NoSheetIsNoStationaryEllipsoid) {
  const Outcome outcome = run_program({"atlas", shipped("fold.toml"), "--checkpoints", "2", "--set",
                                       "continuation.from=5", "--set", "continuation.to=6"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no stationary ellipsoid was found with nu from 5 to 6: at "
                                     "each checkpoint none exists in the box"));
}

TEST(AtlasCommand, AnInterruptEndsItWithItsOwnCode) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"atlas", shipped("apart.toml"), "-o", directory / "x.csv"},
                                      {.pending_signal = SIGINT});
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("not complete"));
}

/// No table but a journal: the searches it has are not made again, and the table is that of a run
/// never interrupted.
TEST(AtlasCommand, ResumedItIsWhatItWouldHaveBeen) {
  const TemporaryDirectory directory;
  const std::string table = directory / "x.csv";
  const std::string journal = table + ".journal";
  const std::vector<std::string> command{"atlas", shipped("apart.toml"), "-o",
                                         table,   "--checkpoints",       "24"};
  const auto run = [&](std::vector<std::string> more, const RunOptions& options = {}) {
    more.insert(more.begin(), command.begin(), command.end());
    return run_program(more, options);
  };
  ASSERT_EQ(run({}).code, 0);
  const std::string whole = text_of(table);
  auto told = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_THAT(directory.names(), ::testing::ElementsAre("x.csv", "x.meta.json"));
  EXPECT_EQ(run({"--resume"}).code, 2);  // there is no journal
  // Full after some searches: none of the rest is kept.
  RunOptions full;
  full.file_size_limit = 3000;
  EXPECT_EQ(run({"--threads", "1"}, full).code, 4);
  const std::string kept = text_of(journal);
  EXPECT_GT(kept.size(), 1000U);
  for (const char* threads : {"1", "2"}) {
    std::ofstream(journal, std::ios::binary) << kept;
    const Outcome outcome = run({"--resume", "--threads", threads});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(text_of(table) == whole);
    auto again = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    for (auto* each : {&told, &again}) each->erase("run");
    EXPECT_EQ(again, told);
    EXPECT_FALSE(std::filesystem::exists(journal));
  }
  std::ofstream(journal, std::ios::binary) << kept;
  const Outcome other = run({"--resume", "--set", "body.J.1=1.6"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("of another case"));
  EXPECT_EQ(run({"--resume", "--checkpoints", "25"}).code, 2);
}

TEST(AtlasCommand, InterruptedItKeepsItsSearches) {
  const TemporaryDirectory directory;
  const std::vector<std::string> command{
      "atlas", shipped("apart.toml"), "-o", directory / "x.csv", "--checkpoints", "4"};
  const Outcome outcome = run_program(command, {.pending_signal = SIGINT});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("--resume"));
  EXPECT_TRUE(std::filesystem::exists(directory / "x.csv.journal"));
  auto resumed = command;
  resumed.emplace_back("--resume");
  EXPECT_EQ(run_program(resumed).code, 0);
  const std::string found = text_of(directory / "x.csv");
  ASSERT_EQ(run_program(command).code, 0);
  EXPECT_TRUE(text_of(directory / "x.csv") == found);
}

TEST(AtlasCommand, SheetsThatAreCutShortAreSaidToBe) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"atlas", shipped("apart.toml"), "-o", directory / "x.csv", "--checkpoints", "4",
                   "--set", "continuation.max_points=20"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("stopped at continuation.max_points"));
  const Outcome whole =
      run_program({"atlas", shipped("apart.toml"), "-o", directory / "y.csv", "--checkpoints", "4",
                   "--set", "continuation.start_row=\"a.csv:3\""});
  EXPECT_EQ(whole.code, 0);
  EXPECT_THAT(whole.err, Not(HasSubstr("max_points")));
  bool told = false;
  const auto metadata = nlohmann::json::parse(text_of(directory / "y.meta.json"));
  for (const auto& each : metadata.at("skipped"))
    told = told || each.at("quantity") == "continuation.start_row";
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace stationary::testing
