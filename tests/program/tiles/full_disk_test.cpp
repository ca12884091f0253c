// Runs on a disk that fills up: a small tmpfs in a mount namespace of the test's own, then made larger. What
// was finished is kept and gone on with, and in the end the table is that of a run with room enough.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/journal_reading.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A command of the shell as root of namespaces of its own, with $1, $2, ....
Outcome in_namespace(const std::string& script, const Words& words) {
  RunOptions options;
  options.program = {"unshare", "--map-root-user", "--mount", "sh", "-c", script, "sh"};
  return run_program(words, options);
}

struct Filled {
  std::string name;
  std::string table;       ///< what -o names
  Words arguments;         ///< but -o
  std::vector<int> sizes;  ///< of the disk, in KiB: each too small
};
std::ostream& operator<<(std::ostream& out, const Filled& of) { return out << of.name; }

class FullDisk : public ::testing::TestWithParam<Filled> {
 protected:
  void SetUp() override {
    if (in_namespace("mount -t tmpfs -o size=64k none \"$1\"", {directory_.path()}).code != 0)
      GTEST_SKIP() << "no tmpfs can be mounted here: unshare --map-root-user --mount fails";
  }
  Words arguments() const {
    Words out = GetParam().arguments;
    if (out[0] != "study") return out;
    std::ostringstream table;
    table << "motion.nu,_tag\n";
    for (int k = 0; k < 200; ++k) table << 0.004 * k << ",\"t, " << k << "\"\n";
    out.insert(out.end(), {"--over", directory_.file("t.csv", table.str())});
    return out;
  }

  TemporaryDirectory directory_;
};

/// $1: where the disk goes; $2: its size; $3: where what is of interest goes; $4: the table's name.
constexpr const char* fill_and_go_on = R"(
disk=$1 size=$2 to=$3 name=$4
shift 4
mount -t tmpfs -o size="$size" none "$disk" || exit 99
"$@" -o "$disk/$name" 2> "$to/err1"
echo $? > "$to/code1"
ls -A "$disk" > "$to/names"
cp "$disk/$name.journal" "$to/journal"
mount -t tmpfs -o remount,size=64m none "$disk" || exit 98
"$@" -o "$disk/$name" --resume 2> "$to/err2"
echo $? > "$to/code2"
cp "$disk/$name" "$disk/x.meta.json" "$to"
)";

TEST_P(FullDisk, WhatWasFinishedIsGoneOnWith) {
  const std::string& name = GetParam().table;
  if (name.ends_with(".h5")) NEEDS_HDF5();
  Words whole = arguments();
  const std::string expected = directory_ / ("whole" + name);
  whole.insert(whole.end(), {"-o", expected});
  ASSERT_EQ(run_program(whole).code, 0);
  for (const int size : GetParam().sizes) {
    const TemporaryDirectory disk;
    const TemporaryDirectory to;
    Words words{disk.path(), std::to_string(size) + "k", to.path(), name, program_path()};
    const Words run = arguments();
    words.insert(words.end(), run.begin(), run.end());
    words.insert(words.end(), {"--threads", "1"});
    const Outcome outcome = in_namespace(fill_and_go_on, words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(text_of(to / "code1"), "4\n") << size;
    const std::string said = text_of(to / "err1");
    EXPECT_THAT(said, ::testing::AnyOf(HasSubstr("No space left on device"),
                                       HasSubstr("HDF5 could not write")));
    EXPECT_THAT(said, HasSubstr("stationary: failed: "));
    // No half of a table.
    EXPECT_EQ(text_of(to / "names"), name + ".journal\n") << size;
    EXPECT_EQ(text_of(to / "code2"), "0\n") << size << text_of(to / "err2");
    // The record that did not fit was taken back.
    EXPECT_EQ(text_of(to / "err2"), "") << size;
    EXPECT_TRUE(text_of(to / name) == text_of(expected)) << size;
    const auto kept = kept_tiles(text_of(to / "journal"));
    EXPECT_FALSE(kept.empty()) << size;
    EXPECT_EQ(json::parse(text_of(to / "x.meta.json"))["run"]["tiles"]["kept"], kept.size())
        << size;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, FullDisk,
    ::testing::Values(Filled{"Map",
                             "x.csv",
                             {"map", shipped("fibre_map.toml"), "--set", "map.x.count=41", "--set",
                              "map.y.count=9"},
                             {24, 80, 160}},
                      Filled{"MapAsColumns",
                             "x.h5",
                             {"map", shipped("fibre_map.toml"), "--set", "map.x.count=41", "--set",
                              "map.y.count=9"},
                             {80, 160}},
                      Filled{"Study", "x.csv", {"study", shipped("disc.toml")}, {16, 64, 112}}),
    [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace stationary::testing
