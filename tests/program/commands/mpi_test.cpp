// stationary-mpi under mpirun, more ranks than processors: the same bytes as of one process, ranks that
// are killed, signals, wrong input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/program/json_schema.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

Words joined(std::initializer_list<Words> all) {
  Words out;
  for (const Words& each : all) out.insert(out.end(), each.begin(), each.end());
  return out;
}

const char* mpi_program() { return program_of("STATIONARY_MPI_PROGRAM", STATIONARY_MPI_PROGRAM); }

RunOptions ranks(int count) {
  RunOptions out;
  out.program = {"mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                 "-n",     std::to_string(count), mpi_program()};
  return out;
}

/// Of the processes that have this word among their arguments and are not mpirun.
std::vector<pid_t> processes(const std::string& word) {
  std::vector<pid_t> out;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string line = text_of(entry.path() / "cmdline");
    if (line.find(word) != std::string::npos && line.starts_with(mpi_program()))
      out.push_back(std::stoi(name));
  }
  return out;
}

class Mpi : public ::testing::Test {
 protected:
  json told(const std::string& name) const {
    json out = json::parse(text_of(directory_ / (name + ".meta.json")));
    EXPECT_EQ(schema_fault(out, json::parse(text_of(STATIONARY_SCHEMA))), "");
    return out;
  }
  static json without_run(json of) {
    of.erase("run");
    return of;
  }
  std::string study_table(int rows) const {
    std::ostringstream table;
    table << "motion.nu,_tag\n";
    for (int k = 0; k < rows; ++k)
      table << 1.0 / rows * k << (k % 17 == 3 ? "x" : "") << ",\"t, " << k << "\"\n";
    return directory_.file("t.csv", table.str());
  }
  void expect_same_bytes(const Words& arguments) const {
    const Outcome alone =
        run_program(joined({arguments, {"-o", directory_ / "alone.csv", "--threads", "2"}}));
    for (const int count : {1, 2, 4}) {
      const Outcome all = run_program(
          joined({arguments, {"-o", directory_ / "all.csv", "--threads", "2"}}), ranks(count));
      EXPECT_EQ(all.code, alone.code) << all.err;
      EXPECT_TRUE(text_of(directory_ / "all.csv") == text_of(directory_ / "alone.csv")) << count;
      EXPECT_EQ(without_run(told("all")), without_run(told("alone"))) << count;
      EXPECT_EQ(told("all")["run"]["ranks"], count);
      EXPECT_FALSE(std::filesystem::exists(directory_ / "all.csv.journal"));
    }
  }

  TemporaryDirectory directory_;
  const Words map_{
      "map", shipped("map_biot_log.toml"), "--set", "map.x.count=61", "--set", "map.y.count=200"};
};

TEST_F(Mpi, MapsHaveTheSameBytes) { expect_same_bytes(map_); }

TEST_F(Mpi, StudiesHaveTheSameBytes) {
  expect_same_bytes({"study", shipped("disc.toml"), "--over", study_table(100)});
}

TEST_F(Mpi, GridsOfAtlasesHaveTheSameBytes) {
  expect_same_bytes({"atlas", shipped("apart.toml"), "--grid", "--checkpoints", "3", "--set",
                     "map.x={parameter=\"body.J.1\",from=1.2,to=1.8,count=3}", "--set",
                     "map.y={parameter=\"body.J.0\",from=0.9,to=1.1,count=2}"});
}

/// Of all ranks one merges, and the others write nothing.
TEST_F(Mpi, OneRankMerges) {
  const Words study{"study", shipped("disc.toml")};
  const Words over{"--over", study_table(20)};
  const Words grid{"atlas",
                   shipped("apart.toml"),
                   "--grid",
                   "--checkpoints",
                   "2",
                   "--set",
                   "map.x={parameter=\"body.J.1\",from=1.2,to=1.8,count=2}"};
  const std::pair<Words, Words> commands[] = {{map_, {}}, {study, over}, {grid, {}}};
  // Any other rank is killed where it is about to change a file.
  RunOptions how = ranks(3);
  how.program.insert(
      how.program.end() - 1,
      {"sh", "-c", "[ $OMPI_COMM_WORLD_RANK = 0 ] || export LD_PRELOAD=$FAULT_SHIM; exec \"$@\"",
       "sh"});
  how.environment = {std::string("FAULT_SHIM=") + STATIONARY_FAULT_SHIM, "FAULT_AT=1",
                     "FAULT_WHEN=before", "FAULT_UNDER=" + directory_.path()};
  for (const auto& [words, more] : commands) {
    const std::string part = directory_ / "part.csv";
    const std::string whole = directory_ / "whole.csv";
    ASSERT_EQ(run_program(joined({words, more, {"--part", "1/1", "-o", part}})).code, 0);
    const Outcome outcome = run_program(joined({words, {"--merge", part, "-o", whole}}), how);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(text_of(whole) == text_of(part));
  }
}

TEST_F(Mpi, HelpAndWrongInputEndAtOnceAndAreSaidOnce) {
  const Outcome help = run_program({"--help"}, ranks(3));
  EXPECT_EQ(help.code, 0) << help.err;
  EXPECT_TRUE(help.out.starts_with("Usage: stationary-mpi")) << help.out;
  EXPECT_EQ(help.out.find("Usage:", 1), std::string::npos);
  for (const Words& wrong : {Words{"map", "none.toml"}, Words{"map", "--nonsense"},
                             Words{"atlas", shipped("apart.toml")}, Words{"solve"}}) {
    const Outcome outcome = run_program(wrong, ranks(3));
    EXPECT_EQ(outcome.code, 2);
    const std::size_t first = outcome.err.find("stationary: ");
    EXPECT_NE(first, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("stationary: ", first + 1), std::string::npos) << outcome.err;
  }
  // What only rank 0 finds out lets the others go too.
  const Outcome nowhere = run_program(joined({map_, {"-o", directory_ / "no/x.csv"}}), ranks(3));
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("cannot write"));
}

/// What one rank alone finds wrong that rank says, for none of the others can.
TEST_F(Mpi, ARankThatCannotReadTheCaseSaysSo) {
  RunOptions how = ranks(3);
  how.program.insert(how.program.end() - 1,
                     {"sh", "-c", "cd \"$HERE\"/$OMPI_COMM_WORLD_RANK && exec \"$@\"", "sh"});
  how.environment = {"HERE=" + directory_.path()};
  for (const char* const rank : {"0", "1", "2"}) {
    std::filesystem::create_directory(directory_ / rank);
    if (std::string_view(rank) != "1")
      std::filesystem::copy(shipped("disc.toml"), directory_ / rank + "/case.toml");
  }
  const Outcome outcome = run_program(
      {"study", "case.toml", "--over", study_table(20), "-o", directory_ / "x.csv"}, how);
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("stationary: rank 1: case.toml: no readable file"));
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("rank 2: ")));
  EXPECT_FALSE(std::filesystem::exists(directory_ / "x.csv"));
}

/// As srun without PMI starts them: each would do all of the work.
TEST_F(Mpi, TasksThatMpiDoesNotSeeAreRefused) {
  for (const char* const task : {"0", "3"}) {
    RunOptions how;
    how.program = {mpi_program()};
    how.environment = {"PMI_SIZE=4", std::string("PMI_RANK=") + task};
    const Outcome outcome = run_program(joined({map_, {"-o", directory_ / "x.csv"}}), how);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    if (std::string_view(task) == "0")
      EXPECT_THAT(outcome.err,
                  AllOf(HasSubstr("found 4 processes by PMI_SIZE"), HasSubstr("srun --mpi=pmix")));
    else
      EXPECT_EQ(outcome.err, "");
    EXPECT_FALSE(std::filesystem::exists(directory_ / "x.csv"));
  }
}

/// A rank that gets no threads ends all of them, with its reason.
TEST_F(Mpi, ARankWithoutThreadsSaysSo) {
  for (const char* const rank : {"0", "1"}) {
    RunOptions how = ranks(3);
    how.program.insert(how.program.end() - 1, {"sh", "-c",
                                               "[ $OMPI_COMM_WORLD_RANK != $WHICH ] || export "
                                               "FAULT_THREADS=3 LD_PRELOAD=$SHIM; exec \"$@\"",
                                               "sh"});
    how.environment = {std::string("SHIM=") + STATIONARY_FAULT_SHIM, std::string("WHICH=") + rank};
    const Outcome outcome =
        run_program(joined({map_, {"-o", directory_ / "x.csv", "--threads", "20"}}), how);
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cannot begin a thread"));
  }
}

/// mpirun gives rank 0 a terminal, and writes what comes of it into a file.
TEST_F(Mpi, WritesNoColours) {
  RunOptions how = ranks(2);
  how.environment = {"TERM=xterm"};
  const Outcome outcome = run_program(map_, how);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("case"));
  EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << outcome.err;
}

/// Rank `which` of four is killed while they work; then they go on, another number of them.
class KilledRank : public Mpi, public ::testing::WithParamInterface<int> {};

TEST_P(KilledRank, WhatWasFinishedIsKept) {
  const std::string table = study_table(3000);
  const Words words{"study", shipped("disc.toml"), "--over", table, "-o", directory_ / "x.csv"};
  Words alone = words;
  alone.back() = directory_ / "alone.csv";
  ASSERT_EQ(run_program(alone).code, 0);
  const std::string journal = directory_ / "x.csv.journal";
  auto running = std::async(std::launch::async, [&] {
    return run_program(joined({words, {"--threads", "1"}}), ranks(4));
  });
  std::error_code none;
  while (std::filesystem::file_size(journal, none) < 100'000 || none) {
    if (running.wait_for(std::chrono::milliseconds(1)) == std::future_status::ready) break;
  }
  std::vector<pid_t> pids = processes(directory_ / "x.csv");
  std::ranges::sort(pids);  // in the order of their ranks
  ASSERT_EQ(pids.size(), 4U) << "they had ended";
  ::kill(pids[static_cast<std::size_t>(GetParam())], SIGKILL);
  const Outcome outcome = running.get();
  EXPECT_NE(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("signal 9 (Killed)"));
  while (!processes(directory_ / "x.csv").empty())
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const Outcome again = GetParam() == 0 ? run_program(joined({words, {"--resume"}}))
                                        : run_program(joined({words, {"--resume"}}), ranks(2));
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(text_of(directory_ / "x.csv") == text_of(directory_ / "alone.csv"));
  EXPECT_GT(told("x")["run"]["tiles"]["kept"].get<int>(), 0);
}
INSTANTIATE_TEST_SUITE_P(Ranks, KilledRank, ::testing::Values(0, 1, 3));

/// As Slurm tells a job that its time is over.
TEST_F(Mpi, TerminatedTheyEndWithAWholeJournal) {
  const std::string table = study_table(3000);
  const Words words{"study", shipped("disc.toml"), "--over", table, "-o", directory_ / "x.csv"};
  Words alone = words;
  alone.back() = directory_ / "alone.csv";
  ASSERT_EQ(run_program(alone).code, 0);
  const std::string journal = directory_ / "x.csv.journal";
  auto running = std::async(std::launch::async, [&] {
    return run_program(joined({words, {"--threads", "1"}}), ranks(3));
  });
  std::error_code none;
  while (std::filesystem::file_size(journal, none) < 100'000 || none) {
    if (running.wait_for(std::chrono::milliseconds(1)) == std::future_status::ready) break;
  }
  // One rank has the signal, and all end.
  std::vector<pid_t> pids = processes(directory_ / "x.csv");
  std::ranges::sort(pids);
  ASSERT_EQ(pids.size(), 3U) << "they had ended";
  ::kill(pids[1], SIGTERM);
  const Outcome outcome = running.get();
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("--resume goes on with them"));
  EXPECT_EQ(told("x")["status"], "interrupted");
  const Outcome again = run_program(joined({words, {"--resume"}}), ranks(4));
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(text_of(directory_ / "x.csv") == text_of(directory_ / "alone.csv"));
}

}  // namespace
}  // namespace stationary::testing
