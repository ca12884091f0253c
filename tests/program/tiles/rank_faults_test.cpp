// Ranks that are killed, at random moments and around their calls that change files: what was finished is
// not computed again, of what was under way no more than the ranks were at, and what comes of it in the end
// is the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <thread>

#include "tests/program/journal_reading.hpp"
#include "tests/program/program.hpp"
#include "tests/program/tiles/traced_work.hpp"

namespace stationary::testing {
namespace {

namespace fs = std::filesystem;

const char* rank_tiles() { return program_of("STATIONARY_RANK_TILES", STATIONARY_RANK_TILES); }

class RankFaults : public ::testing::Test {
 protected:
  /// Of one rank's death Open MPI tells the others gently and then waits for a second, 90 times here.
  void SetUp() override { ::setenv("OMPI_MCA_odls_base_sigkill_timeout", "0", 1); }
  Words command(int ranks, const Words& more = {}) const {
    Words out{"mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
              "-n",     std::to_string(ranks)};
    out.insert(out.end(), more.begin(), more.end());
    out.insert(out.end(), {rank_tiles(), table_, work_.trace, std::to_string(work_.rows),
                           std::to_string(work_.milliseconds)});
    return out;
  }
  /// The ranks, in their order.
  std::vector<pid_t> processes() const {
    std::vector<pid_t> out;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      const std::string line = text_of(entry.path() / "cmdline");
      if (line.starts_with(rank_tiles()) && line.find(table_) != std::string::npos)
        out.push_back(std::stoi(name));
    }
    std::ranges::sort(out);
    return out;
  }
  std::set<std::size_t> kept() const { return kept_tiles(text_of(table_ + ".journal")); }
  /// The tiles begun since, none of which was kept before.
  std::set<std::size_t> begun_since(const std::map<std::size_t, int>& before,
                                    const std::set<std::size_t>& kept_before) const {
    std::set<std::size_t> out;
    for (const auto& [tile, times] : work_.begun()) {
      const auto was = before.find(tile);
      if (was != before.end() && times == was->second) continue;
      EXPECT_FALSE(kept_before.contains(tile)) << "tile " << tile << " was finished";
      out.insert(tile);
    }
    return out;
  }
  /// Of these, how many will be computed twice.
  static std::size_t lost(const std::set<std::size_t>& begun, const std::set<std::size_t>& kept) {
    std::size_t out = 0;
    for (const std::size_t tile : begun) out += kept.contains(tile) ? 0 : 1;
    return out;
  }
  /// By this process alone, what is left of it.
  std::string finish() const {
    const cli::TiledRun tiled{
        .journal = table_, .resume = fs::exists(table_ + ".journal"), .part = {}};
    const cli::Run run;
    cli::TileRunner runner(work_.work(), tiled, run);
    std::string out;
    EXPECT_TRUE(runner.run([&](const cli::Share&, const std::string& text) { out += text; }));
    runner.finish();
    return out;
  }

  TemporaryDirectory directory_;
  TemporaryDirectory beside_;
  std::string table_ = directory_ / "x";
  TracedWork work_{.trace = beside_ / "trace"};
};

class KilledAtRandom : public RankFaults, public ::testing::WithParamInterface<int> {
 protected:
  pid_t start() const {
    const Words words = command(GetParam());
    std::vector<char*> pointers;
    for (const std::string& each : words) pointers.push_back(const_cast<char*>(each.c_str()));
    pointers.push_back(nullptr);
    pid_t out = 0;
    EXPECT_EQ(::posix_spawnp(&out, "mpirun", nullptr, nullptr, pointers.data(), environ), 0);
    return out;
  }
  void wait_for_work(const std::map<std::size_t, int>& begun_before) const {
    for (int k = 0; k < 5000 && work_.begun() == begun_before; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  void kill_one_of(pid_t mpirun, std::size_t which) const {
    const std::vector<pid_t> all = processes();
    const auto ranks = static_cast<std::size_t>(GetParam());
    if (which < all.size()) {
      ::kill(all[which], SIGKILL);
      return;
    }
    ::kill(mpirun, SIGKILL);
    if (which == ranks)
      for (const pid_t each : all) ::kill(each, SIGKILL);
  }
  /// Until mpirun and its ranks have ended. Open MPI may not see that one of them died while it began, and
  /// ranks whose mpirun died go on; after a while all are killed.
  void wait_for(pid_t mpirun) const {
    using Clock = std::chrono::steady_clock;
    const auto patience = Clock::now() + std::chrono::seconds(1);
    for (bool ended = false; !ended || !processes().empty();) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      int status = 0;
      ended = ended || ::waitpid(mpirun, &status, WNOHANG) == mpirun;
      if (Clock::now() < patience) continue;
      for (const pid_t each : processes()) ::kill(each, SIGKILL);
      if (!ended) ::kill(mpirun, SIGKILL);
    }
  }
};

TEST_P(KilledAtRandom, NothingFinishedIsLost) {
  constexpr std::size_t kills = 25;
  const auto ranks = static_cast<std::size_t>(GetParam());
  work_.rows = 3000;
  work_.milliseconds = 5;
  std::mt19937 random(static_cast<unsigned>(ranks));
  std::uniform_int_distribution<int> moment(0, 150'000);  // microseconds
  // A rank, all of them at once, or mpirun alone.
  std::uniform_int_distribution<std::size_t> who(0, ranks + 1);
  std::size_t twice = 0;
  for (std::size_t killed = 0; killed < kills;) {
    const auto begun_before = work_.begun();
    const auto kept_before = kept();
    const pid_t mpirun = start();
    // Once in a while as they begin; else while they work.
    if (killed % 5 != 0) wait_for_work(begun_before);
    std::this_thread::sleep_for(std::chrono::microseconds(moment(random)));
    const auto begun = begun_since(begun_before, kept_before);
    kill_one_of(mpirun, who(random));
    wait_for(mpirun);
    const auto kept_now = kept();
    if (fs::exists(table_)) {  // it was at its end
      EXPECT_EQ(text_of(table_), work_.whole_text());
      for (const std::string& each : {table_, table_ + ".journal", work_.trace}) fs::remove(each);
      continue;
    }
    ++killed;
    for (const std::size_t tile : kept_before) EXPECT_TRUE(kept_now.contains(tile)) << tile;
    (void)begun_since(begun_before, kept_before);
    twice += lost(begun, kept_now);
  }
  // What each rank was at, and a result that had not yet come to rank 0; on average, for a rank may have
  // had no processor for a while.
  EXPECT_LE(twice, 2 * ranks * kills);
  EXPECT_GT(twice, 0U);
  const auto begun_before = work_.begun();
  const auto kept_before = kept();
  EXPECT_EQ(run_program({}, {.program = command(GetParam())}).code, 0);
  EXPECT_EQ(begun_since(begun_before, kept_before).size() + kept_before.size(), work_.tiles());
  EXPECT_EQ(text_of(table_), work_.whole_text());
  EXPECT_FALSE(fs::exists(table_ + ".journal"));
}
INSTANTIATE_TEST_SUITE_P(Ranks, KilledAtRandom, ::testing::Values(2, 4));

TEST_F(RankFaults, KilledAroundEveryCallThatChangesAFile) {
  constexpr int ranks = 2;
  work_.rows = 12;
  work_.milliseconds = 1;
  int killed = 0;
  bool ended = false;
  for (int at = 1; !ended; ++at) {
    for (const char* const when : {"before", "half", "after"}) {
      const Words fault{"-x", std::string("LD_PRELOAD=") + STATIONARY_FAULT_SHIM,
                        "-x", "FAULT_UNDER=" + directory_.path(),
                        "-x", "FAULT_AT=" + std::to_string(at),
                        "-x", std::string("FAULT_WHEN=") + when};
      const Outcome first = run_program({}, {.program = command(ranks, fault)});
      while (!processes().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      ended = first.code == 0;
      if (ended) break;
      ++killed;
      // The table is there whole or not at all.
      if (fs::exists(table_)) {
        EXPECT_EQ(text_of(table_), work_.whole_text()) << at << when;
      }
      const auto begun_before = work_.begun();
      const auto kept_before = kept();
      EXPECT_LE(lost(begun_since({}, {}), kept_before), 2U * ranks) << at << when;
      EXPECT_EQ(finish(), work_.whole_text()) << at << when << first.err;
      EXPECT_EQ(begun_since(begun_before, kept_before).size() + kept_before.size(), work_.tiles())
          << at << when;
      fs::remove(table_);
      fs::remove(work_.trace);
      for (const std::string& left : directory_.names()) fs::remove(directory_ / left);
    }
  }
  // The title, each tile's record and text, a flush, a rename, another flush, the removal.
  EXPECT_GE(killed, 3 * (2 * static_cast<int>(work_.tiles()) + 4));
}

}  // namespace
}  // namespace stationary::testing
