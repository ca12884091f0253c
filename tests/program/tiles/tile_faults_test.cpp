// Work in tiles whose process is killed at random moments: what it had finished is not computed again,
// and what comes of it in the end is what a run that nobody stops has.
#include <fcntl.h>
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
#include <sstream>
#include <thread>

#include "solver/program/text/input_error.hpp"
#include "solver/program/tiles/tiled_run.hpp"
#include "tests/program/program.hpp"

namespace stationary::cli {
namespace {

using stationary::testing::TemporaryDirectory;
using stationary::testing::text_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::size_t all_rows = 400;
constexpr std::size_t rows_a_tile = 3;
constexpr std::size_t all_tiles = (all_rows + rows_a_tile - 1) / rows_a_tile;

/// What a row says, of a length of its own.
std::string row_text(std::size_t row) {
  return std::to_string(row * row) + std::string(row % 7, '\n') + std::string(row % 3, '\0');
}
std::string whole_text() {
  std::string out;
  for (std::size_t k = 0; k < all_rows; ++k) out += row_text(k);
  return out;
}

class TileFaults : public ::testing::Test {
 protected:
  /// A line for every tile that is begun, at once in the file.
  TiledWork work(int milliseconds) const {
    return {.hash = "0123456789abcdef",
            .share = {0, all_rows},
            .rows_a_tile = rows_a_tile,
            .unit = "rows",
            .compute = [this, milliseconds](const Share& rows) -> std::optional<std::string> {
              const int trace = ::open(trace_.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
              const std::string line = std::to_string(rows.first / rows_a_tile) + "\n";
              EXPECT_EQ(::write(trace, line.data(), line.size()),
                        static_cast<ssize_t>(line.size()));
              ::close(trace);
              std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
              std::string out;
              for (std::size_t k = rows.first; k < rows.last; ++k) out += row_text(k);
              return out;
            }};
  }
  /// All of it, in this process.
  std::string run(bool resume, int threads, int milliseconds = 0) {
    cli::Run how;
    how.threads = threads;
    how.complain = [this](const std::string& line) { said_.push_back(line); };
    const TiledRun tiled{.journal = table_, .resume = resume, .part = {}};
    TileRunner runner(work(milliseconds), tiled, how);
    std::string out;
    EXPECT_TRUE(runner.run([&](const Share&, const std::string& text) { out += text; }));
    Metadata told;
    runner.describe(told);
    computed_ = told.tiles->computed;
    kept_ = told.tiles->kept;
    runner.finish();
    return out;
  }
  /// How often each tile was begun.
  std::map<std::size_t, int> begun() const {
    std::map<std::size_t, int> out;
    std::istringstream lines(text_of(trace_));
    for (std::size_t tile = 0; lines >> tile;) ++out[tile];
    return out;
  }
  std::set<std::size_t> finished() const {
    std::set<std::size_t> out;
    const Journal journal(table_, hash_of({"0123456789abcdef", "", "1/1"}), true);
    for (std::size_t k = 0; k < all_tiles; ++k)
      if (journal.has(k)) out.insert(k);
    return out;
  }
  /// A journal of about so many tiles.
  std::string interrupted(std::size_t tiles) const {
    Journal journal(table_, hash_of({"0123456789abcdef", "", "1/1"}), false);
    const TiledWork all = work(0);
    for (std::size_t k = 0; k < tiles; ++k)
      journal.add(k, all.compute({k * rows_a_tile, (k + 1) * rows_a_tile}).value());
    return text_of(table_ + ".journal");
  }
  void write_journal(const std::string& text) const {
    std::ofstream(table_ + ".journal", std::ios::binary) << text;
  }

  TemporaryDirectory directory_;
  std::string table_ = directory_ / "x.csv";
  std::string trace_ = directory_ / "trace";
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
    const auto begun_before = begun();
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
    if (WIFEXITED(status)) {  // it had ended
      std::filesystem::remove(trace_);
      before.clear();
      continue;
    }
    ++killed;
    int twice = 0;
    for (const auto& [tile, times] : begun()) {
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
  EXPECT_EQ(run(std::filesystem::exists(table_ + ".journal"), threads), whole_text());
  EXPECT_EQ(kept_, before.size());
  EXPECT_EQ(computed_ + kept_, all_tiles);
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
    EXPECT_EQ(run(true, 1), whole_text()) << size;
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
    EXPECT_EQ(run(true, 1), whole_text()) << byte;
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

/// Nothing was in it when the run was killed.
TEST_F(TileFaults, AJournalThatWasOnlyBegunIsGoneOnWith) {
  const std::string title = interrupted(0);
  for (std::size_t size = 0; size <= title.size(); ++size) {
    write_journal(title.substr(0, size));
    EXPECT_EQ(run(true, 2), whole_text());
    EXPECT_EQ(kept_, 0U);
  }
}

}  // namespace
}  // namespace stationary::cli
