// Work in tiles whose process is killed at random moments: what it had finished is not computed again,
// and what comes of it in the end is what a run that nobody stops has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "solver/program/text/input_error.hpp"
#include "solver/program/tiles/tiled_run.hpp"
#include "tests/program/program.hpp"
#include "tests/program/tiles/traced_work.hpp"

namespace stationary::cli {
namespace {

using stationary::testing::TemporaryDirectory;
using stationary::testing::text_of;
using stationary::testing::TracedWork;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class TileFaults : public ::testing::Test {
 protected:
  /// All of it, in this process.
  std::string run(bool resume, int threads, int milliseconds = 0) {
    cli::Run how;
    how.threads = threads;
    how.complain = [this](const std::string& line) { said_.push_back(line); };
    const TiledRun tiled{.journal = table_, .resume = resume, .part = {}};
    TracedWork work = work_;
    work.milliseconds = milliseconds;
    TileRunner runner(work.work(), tiled, how);
    std::string out;
    EXPECT_TRUE(runner.run([&](const Share&, const std::string& text) { out += text; }));
    Metadata told;
    runner.describe(told);
    computed_ = told.tiles->computed;
    kept_ = told.tiles->kept;
    runner.finish();
    return out;
  }
  std::set<std::size_t> finished() const {
    std::set<std::size_t> out;
    const Journal journal(table_, hash_of({"0123456789abcdef", "", "1/1"}), true);
    for (std::size_t k = 0; k < work_.tiles(); ++k)
      if (journal.has(k)) out.insert(k);
    return out;
  }
  /// A journal of about so many tiles.
  std::string interrupted(std::size_t tiles) const {
    Journal journal(table_, hash_of({"0123456789abcdef", "", "1/1"}), false);
    journal.begin();
    const TiledWork all = work_.work();
    for (std::size_t k = 0; k < tiles; ++k)
      journal.add(k, all.compute({k * work_.rows_a_tile, (k + 1) * work_.rows_a_tile}).value());
    return text_of(table_ + ".journal");
  }
  void write_journal(const std::string& text) const {
    std::ofstream(table_ + ".journal", std::ios::binary) << text;
  }

  TemporaryDirectory directory_;
  std::string table_ = directory_ / "x.csv";
  TracedWork work_{.trace = directory_ / "trace"};
  std::vector<std::string> said_;
  std::size_t computed_ = 0;
  std::size_t kept_ = 0;
};

TEST_F(TileFaults, KilledAtFiftyMomentsNothingFinishedIsLost) {
  constexpr int kills = 50;
  constexpr int threads = 3;
  std::mt19937 random(20);
  int killed = 0;
  std::set<std::size_t> before;
  while (killed < kills) {
    const bool resume = std::filesystem::exists(table_ + ".journal");
    const auto begun_before = work_.begun();
    const pid_t child = ::fork();
    if (child == 0) {
      (void)run(resume, threads, 5);
      ::_exit(0);
    }
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution<int>(0, 20000)(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    // The journal is there before the first tile begins, and goes when all are done.
    const bool journal_is_done =
        !work_.begun().empty() && !std::filesystem::exists(table_ + ".journal");
    if (WIFEXITED(status) || journal_is_done) {  // it had ended, or had nothing left but to exit
      std::filesystem::remove(work_.trace);
      before.clear();
      continue;
    }
    ++killed;
    int twice = 0;
    for (const auto& [tile, times] : work_.begun()) {
      const auto was = begun_before.find(tile);
      const int now = times - (was == begun_before.end() ? 0 : was->second);
      EXPECT_FALSE(before.contains(tile) && now > 0) << "tile " << tile << " was finished";
      twice += was != begun_before.end() && now > 0 ? 1 : 0;
    }
    // Of those computed again none but what was under way in threads of the run killed before.
    EXPECT_LE(twice, threads);
    if (!std::filesystem::exists(table_ + ".journal")) continue;
    const std::set<std::size_t> after = finished();
    for (const std::size_t tile : before) EXPECT_TRUE(after.contains(tile)) << tile;
    before = after;
  }
  EXPECT_EQ(run(std::filesystem::exists(table_ + ".journal"), threads), work_.whole_text());
  EXPECT_EQ(kept_, before.size());
  EXPECT_EQ(computed_ + kept_, work_.tiles());
  EXPECT_FALSE(std::filesystem::exists(table_ + ".journal"));
}

TEST_F(TileFaults, CutAtEveryByteOfItsLastRecord) {
  constexpr std::size_t tiles = 20;
  const std::string whole = interrupted(tiles);
  const std::string but_one = interrupted(tiles - 1);
  ASSERT_LT(but_one.size(), whole.size());
  for (std::size_t size = but_one.size(); size <= whole.size(); ++size) {
    write_journal(whole.substr(0, size));
    said_.clear();
    EXPECT_EQ(run(true, 1), work_.whole_text()) << size;
    EXPECT_EQ(kept_, size == whole.size() ? tiles : tiles - 1) << size;
    if (size == but_one.size() || size == whole.size()) {
      EXPECT_THAT(said_, IsEmpty()) << size;
    } else {
      EXPECT_THAT(said_, ElementsAre(HasSubstr("x.csv.journal: its last " +
                                               std::to_string(size - but_one.size()) + " bytes")));
    }
  }
}

TEST_F(TileFaults, OfEveryBitThatIsFlippedOneTileIsComputedAgain) {
  constexpr std::size_t tiles = 12;
  const std::string whole = interrupted(tiles);
  for (std::size_t byte = 0; byte < whole.size(); ++byte) {
    std::string flipped = whole;
    flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << (byte % 8)));
    write_journal(flipped);
    said_.clear();
    EXPECT_EQ(run(true, 1), work_.whole_text()) << byte;
    EXPECT_GE(kept_, tiles - 1) << byte;
    EXPECT_THAT(said_, SizeIs(1)) << byte;
    EXPECT_THAT(said_.front(), HasSubstr("x.csv.journal: ")) << byte;
  }
}

TEST_F(TileFaults, AnotherWorksJournalIsLeftAlone) {
  const std::string text = interrupted(5);
  EXPECT_THROW(Journal(table_, hash_of({"another"}), true), InputError);
  EXPECT_EQ(text_of(table_ + ".journal"), text);
}

TEST_F(TileFaults, OneRunAtATimeHasIt) {
  const std::string text = interrupted(5);
  const Journal first(table_, hash_of({"0123456789abcdef", "", "1/1"}), true);
  for (const bool resume : {true, false}) {
    try {
      const Journal second(table_, hash_of({"0123456789abcdef", "", "1/1"}), resume);
      ADD_FAILURE() << resume;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("x.csv.journal: another run is writing it"));
    }
  }
  EXPECT_EQ(text_of(table_ + ".journal"), text);
}

/// Only begin() empties it, so what is refused in between loses nothing. What is lost then is told.
TEST_F(TileFaults, AFinishedTileIsNotDiscardedWithoutAWord) {
  const std::string text = interrupted(5);
  for (const char* const work : {"0123456789abcdef", "another"}) {
    write_journal(text);
    Journal journal(table_, hash_of({work, "", "1/1"}), false);
    EXPECT_EQ(text_of(table_ + ".journal"), text);
    journal.begin();
    EXPECT_LT(text_of(table_ + ".journal").size(), text.size());
    if (std::string_view(work) == "another")
      EXPECT_THAT(journal.remarks(), IsEmpty());
    else
      EXPECT_THAT(journal.remarks(),
                  ElementsAre(HasSubstr("x.csv.journal: 5 finished tiles of this work")));
  }
}

TEST_F(TileFaults, AJournalThatWasNotBegunIsNotLeft) {
  { const Journal journal(table_, hash_of({"any"}), false); }
  EXPECT_FALSE(std::filesystem::exists(table_ + ".journal"));
}

/// Nothing was in it when the run was killed.
TEST_F(TileFaults, AJournalThatWasOnlyBegunIsGoneOnWith) {
  const std::string title = interrupted(0);
  for (std::size_t size = 0; size <= title.size(); ++size) {
    write_journal(title.substr(0, size));
    EXPECT_EQ(run(true, 2), work_.whole_text());
    EXPECT_EQ(kept_, 0U);
  }
}

}  // namespace
}  // namespace stationary::cli
