// A map that is killed around each of its calls that change files, on full disks, in two runs at once: what
// comes of it in the end has the bytes of a map that nothing happened to.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/program/journal_reading.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class InterruptedMap : public ::testing::Test {
 protected:
  Outcome map(const std::string& out, const RunOptions& options = {}, bool resume = false) const {
    Words words{"map",       shipped("map_biot_log.toml"),
                "--set",     "map.x.count=61",
                "--set",     "map.y.count=60",
                "-o",        out,
                "--set",     "output.columns=[\"xi\",\"class\"]",
                "--threads", "1"};
    if (resume) words.emplace_back("--resume");
    return run_program(words, options);
  }
  json run_of(const std::string& name) const {
    return json::parse(text_of(directory_ / (name + ".meta.json")))["run"];
  }

  TemporaryDirectory directory_;
  std::string out_ = directory_ / "x.csv";
  std::string journal_ = directory_ / "x.csv.journal";
};

TEST_F(InterruptedMap, KilledAroundEveryCallThatChangesAFile) {
  const std::string whole = directory_ / "whole.csv";
  ASSERT_EQ(map(whole).code, 0);
  const std::string expected = text_of(whole);
  const int tiles = run_of("whole")["tiles"]["computed"];
  ASSERT_GE(tiles, 5);
  int killed = 0;
  bool ended = false;
  for (int at = 1; !ended; ++at) {
    ASSERT_LT(at, 200);
    for (const char* const when : {"before", "half", "after"}) {
      RunOptions faulty;
      faulty.environment = {std::string("LD_PRELOAD=") + STATIONARY_FAULT_SHIM,
                            "FAULT_AT=" + std::to_string(at), std::string("FAULT_WHEN=") + when,
                            "FAULT_CLOCK=100000"};
      const Outcome first = map(out_, faulty);
      ended = first.code == 0;
      if (ended) break;
      ASSERT_EQ(first.code, 128 + SIGKILL) << first.err;
      ++killed;
      // The table is there whole or not at all.
      if (std::filesystem::exists(out_)) {
        EXPECT_TRUE(text_of(out_) == expected) << at << when;
      }
      const bool begun = std::filesystem::exists(journal_);
      const std::size_t kept = kept_tiles(text_of(journal_)).size();
      const Outcome second = map(out_, {}, begun);
      EXPECT_EQ(second.code, 0) << at << when << second.err;
      EXPECT_TRUE(text_of(out_) == expected) << at << when;
      const json run = run_of("x")["tiles"];
      // None that was whole in the journal is computed again.
      EXPECT_EQ(run["kept"].get<std::size_t>(), kept) << at << when;
      EXPECT_EQ(run["computed"].get<int>() + run["kept"].get<int>(), tiles);
      for (const char* const name : {"x.csv", "x.meta.json"})
        std::filesystem::remove(directory_ / name);
      EXPECT_THAT(directory_.names(), ElementsAre("whole.csv", "whole.meta.json"));
    }
  }
  // Title, tiles with a flush each, table, metadata, two flushes, two renames, one removal.
  EXPECT_GT(killed, 3 * (2 * tiles + 6));
}

TEST_F(InterruptedMap, OnAFullDiskItKeepsWhatFits) {
  // A map whose tiles are kept from the beginning.
  const auto fibres = [](const std::string& out, const RunOptions& options, bool resume) {
    Words words{"map",       shipped("fibre_map.toml"),
                "--set",     "map.x.count=41",
                "--set",     "map.y.count=9",
                "-o",        out,
                "--threads", "1"};
    if (resume) words.emplace_back("--resume");
    return run_program(words, options);
  };
  const std::string whole = directory_ / "whole.csv";
  ASSERT_EQ(fibres(whole, {}, false).code, 0);
  RunOptions full;
  full.file_size_limit = 40'000;
  const Outcome outcome = fibres(out_, full, false);
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("x.csv"));
  EXPECT_THAT(outcome.err, HasSubstr("File too large"));
  EXPECT_FALSE(std::filesystem::exists(out_));
  const Outcome second = fibres(out_, {}, true);
  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(second.err, "");  // the record that did not fit was taken back
  EXPECT_TRUE(text_of(out_) == text_of(whole));
  EXPECT_GT(run_of("x")["tiles"]["kept"].get<int>(), 0);
}

TEST_F(InterruptedMap, AFileThatIsNoJournalStays) {
  directory_.file("x.csv.journal", "hello\n");
  const Outcome refused = map(out_);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("which is no journal"));
  EXPECT_EQ(text_of(journal_), "hello\n");
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv.journal"));
  directory_.file("x.csv.journal", "");  // of a run that was killed before it wrote
  EXPECT_EQ(map(out_).code, 0);
}

/// Of the cells that there are, and what --resume makes of it.
TEST_F(InterruptedMap, ItPrintsItsSummary) {
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  const Outcome outcome = map(out_, interrupted);
  ASSERT_EQ(outcome.code, 130) << outcome.err;
  const std::size_t rows = rows_of(text_of(out_)).size();
  EXPECT_LT(rows, 3660U);
  EXPECT_THAT(outcome.out, HasSubstr("cells         " + std::to_string(rows) + ": "));
  EXPECT_THAT(outcome.err,
              HasSubstr("interrupted after " + std::to_string(rows) + " of 3660 cells"));
  EXPECT_THAT(outcome.err, HasSubstr("--resume"));
}

/// The lock is what another run, here or on another machine, would hold.
TEST_F(InterruptedMap, TwoRunsOnOneJournalAreRefused) {
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  ASSERT_EQ(map(out_, interrupted).code, 130);
  const std::string kept = text_of(journal_);
  const int file = ::open(journal_.c_str(), O_RDWR | O_CLOEXEC);
  struct ::flock whole {};
  whole.l_type = F_WRLCK;
  ASSERT_EQ(::fcntl(file, F_OFD_SETLK, &whole), 0);
  for (const bool resume : {false, true}) {
    const Outcome outcome = map(out_, {}, resume);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("x.csv.journal: another run is writing it"));
  }
  EXPECT_TRUE(text_of(journal_) == kept);
  // Nor does a run that is refused take away what another one writes.
  const std::string written = directory_.file(".x.csv.999999999-0.tmp", "half");
  EXPECT_EQ(map(out_).code, 2);
  EXPECT_EQ(text_of(written), "half");
  ::close(file);
  EXPECT_EQ(map(out_, {}, true).code, 0);
}

/// As file systems say it that have no locks, or whose server does not answer for them.
TEST_F(InterruptedMap, WithoutLocksItIsRefusedByName) {
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  ASSERT_EQ(map(out_, interrupted).code, 130);
  const std::string kept = text_of(journal_);
  for (const int reason : {ENOLCK, EOPNOTSUPP, EINVAL}) {
    RunOptions unlocked;
    unlocked.environment = {std::string("LD_PRELOAD=") + STATIONARY_FAULT_SHIM,
                            "FAULT_LOCK=" + std::to_string(reason)};
    for (const bool resume : {false, true}) {
      const Outcome outcome = map(out_, unlocked, resume);
      EXPECT_EQ(outcome.code, 2) << outcome.err;
      EXPECT_THAT(outcome.err,
                  HasSubstr(std::string("x.csv.journal: its file system has no locks (") +
                            std::strerror(reason) + ")"));
    }
  }
  EXPECT_TRUE(text_of(journal_) == kept);
  EXPECT_EQ(map(out_, {}, true).code, 0);
}

/// Where the system begins few threads: a failure with its reason, at once.
TEST_F(InterruptedMap, WithoutThreadsItFails) {
  for (const char* const threads : {"0", "1", "3"}) {
    RunOptions few;
    few.environment = {std::string("LD_PRELOAD=") + STATIONARY_FAULT_SHIM,
                       std::string("FAULT_THREADS=") + threads};
    const Outcome outcome =
        run_program({"map", shipped("map_biot_log.toml"), "--threads", "8", "-o", out_}, few);
    EXPECT_EQ(outcome.code, 4) << threads;
    EXPECT_THAT(outcome.err, HasSubstr("cannot begin a thread")) << threads;
    // TBB has its own, as many as there are processors.
    const Outcome atlas = run_program({"atlas", shipped("apart.toml"), "--checkpoints", "2",
                                       "--threads", "8", "-o", directory_ / "a.csv"},
                                      few);
    EXPECT_THAT(atlas.code, ::testing::AnyOf(0, 4)) << threads << atlas.err;
    if (atlas.code == 4) EXPECT_THAT(atlas.err, HasSubstr("stationary: failed: "));
  }
}

}  // namespace
}  // namespace stationary::testing
