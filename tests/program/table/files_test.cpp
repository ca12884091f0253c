// What stands on disk afterwards: a whole table or what was there before, and no temporaries.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/file_lock.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Files : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string case_file_ = directory_.file("case.toml", good_case);
};

TEST_F(Files, UnwritableTargetsAreRefusedBeforeComputing) {
  directory_.file("file", "");
  fs::create_directory(directory_ / "folder");
  for (const std::string& target :
       {directory_ / "nowhere/x.csv", directory_ / "folder", directory_ / "file/x.csv",
        std::string("/proc/x.csv"), directory_ / std::string(300, 'x')}) {
    const Outcome outcome = run_program({"solve", case_file_, "-o", target});
    EXPECT_EQ(outcome.code, 2) << target;
    EXPECT_THAT(outcome.err, HasSubstr("-o "));
    EXPECT_THAT(outcome.err, HasSubstr("a file that can be written"));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "file", "folder"));
}

TEST_F(Files, ReadOnlyTargetIsKept) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anything";
  const std::string target = directory_.file("x.csv", "old\n");
  ::chmod(target.c_str(), 0400);
  EXPECT_EQ(run_program({"solve", case_file_, "-o", target}).code, 2);
  EXPECT_EQ(text_of(target), "old\n");
}

TEST_F(Files, MetadataThatCannotBeWrittenLeavesNoTable) {
  fs::create_directory(directory_ / "x.meta.json");
  const Outcome outcome = run_program({"solve", case_file_, "-o", directory_ / "x.csv"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("x.meta.json"));
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "x.meta.json"));
}

/// HDF5 or CSV by the suffix, of every command that writes a table; what is neither is refused
/// before anything is computed.
TEST_F(Files, TheSuffixSaysWhichFormat) {
  NEEDS_HDF5();
  std::ofstream(case_file_, std::ios::app)
      << "\n[continuation]\nparameter = \"nu\"\nfrom = 0.0\nto = 0.3\ntolerance = 1e-6\n"
         "[map]\nx = { parameter = \"nu\", from = 0.0, to = 0.3, count = 4 }\n";
  for (const char* command : {"solve", "continue", "atlas", "map"}) {
    const auto run = [&](const std::string& target) {
      std::vector<std::string> arguments{command, case_file_, "--quiet", "-o", target};
      if (std::string(command) == "atlas")
        arguments.insert(arguments.end(), {"--checkpoints", "2"});
      return run_program(arguments);
    };
    ASSERT_EQ(run(directory_ / "x.csv").code, 0) << command;
    const std::string csv = text_of(directory_ / "x.csv");
    ASSERT_EQ(run(directory_ / "plain").code, 0) << command;
    EXPECT_EQ(text_of(directory_ / "plain"), csv) << command;
    for (const char* name : {"x.h5", "x.hdf5", "x.h5"}) {
      ASSERT_EQ(run(directory_ / name).code, 0) << command;
      ASSERT_TRUE(is_column_file(directory_ / name)) << command;
      std::ostringstream text;
      text << column_file_table(directory_ / name, {})->rdbuf();
      EXPECT_EQ(text.str(), csv) << command;
    }
    for (const char* name : {"x.json", "x.tsv", "x.csv.gz", "x.", "x.H5"}) {
      const Outcome refused = run(directory_ / name);
      EXPECT_EQ(refused.code, 2) << name;
      EXPECT_THAT(refused.err, HasSubstr("expected .csv or none for CSV, .h5 or .hdf5 for HDF5"));
      EXPECT_FALSE(fs::exists(directory_ / name));
    }
  }
}

/// Without HDF5 its suffix is refused before anything is computed; a file of it is recognized.
TEST_F(Files, WithoutHdf5ThatIsSaid) {
  if (has_hdf5) GTEST_SKIP() << "built with HDF5";
  const Outcome refused = run_program({"solve", case_file_, "-o", directory_ / "x.h5"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("built without HDF5"));
  EXPECT_THAT(refused.err, HasSubstr("ends in .csv"));
  EXPECT_FALSE(fs::exists(directory_ / "x.h5"));
  const std::string table = directory_.file("y.h5", "\x89HDF\r\n\x1a\n and what follows");
  const Outcome read = run_program({"plot", table, "-o", directory_ / "y.svg"});
  EXPECT_EQ(read.code, 2);
  EXPECT_THAT(read.err, HasSubstr("found an HDF5 file; this program was built without HDF5"));
}

/// A disk that is full while HDF5 writes: the message and the exit code, no more.
TEST_F(Files, AFullDiskUnderHdf5IsAFailure) {
  NEEDS_HDF5();
  for (const long limit : {100L, 1000L, 5000L, 20'000L, 60'000L}) {
    const Outcome outcome = run_program({"map", STATIONARY_CASES "/map_biot_log.toml", "--set",
                                         "map.x.count=30", "-o", directory_ / "x.h5"},
                                        {.file_size_limit = limit});
    EXPECT_EQ(outcome.code, 4) << limit << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("HDF5 could not write")) << limit;
    // What was finished may be kept for --resume; nothing else.
    for (const std::string& each : directory_.names())
      EXPECT_TRUE(each == "case.toml" || each == "x.h5.journal") << limit << ": " << each;
  }
  const Outcome resumed = run_program({"map", STATIONARY_CASES "/map_biot_log.toml", "--set",
                                       "map.x.count=30", "-o", directory_ / "x.h5", "--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  for (const char* name : {"x.h5", "x.h5.meta.json", "x.meta.json"}) fs::remove(directory_ / name);
  const Outcome csv =
      run_program({"solve", case_file_, "-o", directory_ / "x.csv"}, {.file_size_limit = 100});
  EXPECT_EQ(csv.code, 4);
  EXPECT_THAT(csv.err, HasSubstr("writing"));
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml"));
}

/// What killed runs left of the same file goes with the next; what others left stays. A file of a run that
/// goes on is locked, whatever processes there are here: that run may be in a container, or elsewhere.
TEST_F(Files, LeftoversOfDeadProcessesAreCleared) {
  const std::string living = std::to_string(::getpid());
  const std::vector<std::string> stay{".x.csv.1234567x-0.tmp", ".x.csv.999999997-0.tmp",
                                      ".y.csv.999999999-0.tmp", "x.csv.999999999-0.tmp"};
  for (const std::string& name : stay) directory_.file(name, "");
  const int written = ::open((directory_ / stay[1]).c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_FALSE(lock_file(written));
  directory_.file(".x.csv." + living + "-0.tmp", "half");
  for (const char* name :
       {".x.csv.999999999-0.tmp", ".x.csv.999999998-12.tmp", ".x.meta.json.999999999-0.tmp"})
    directory_.file(name, "half");
  ASSERT_EQ(run_program({"solve", case_file_, "-o", directory_ / "x.csv"}).code, 0);
  std::vector<std::string> expected = stay;
  expected.insert(expected.end(), {"case.toml", "x.csv", "x.meta.json"});
  std::ranges::sort(expected);
  EXPECT_EQ(directory_.names(), expected);
  ::close(written);
}

/// Two that write the same file: the last one's is there in the end, and neither fails.
TEST_F(Files, ASecondWriterLeavesTheFirstOnesFile) {
  AtomicFile first(directory_ / "x.csv");
  first.write("first");
  const fs::path temporary = first.path();
  const int again = ::open(temporary.c_str(), O_RDWR | O_CLOEXEC);
  EXPECT_TRUE(lock_file(again));
  ::close(again);
  AtomicFile second(directory_ / "x.csv");
  second.write("second");
  EXPECT_TRUE(fs::exists(temporary));
  second.commit();
  first.commit();
  EXPECT_EQ(text_of(directory_ / "x.csv"), "first");
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "x.csv"));
}

TEST_F(Files, TheCaseItselfIsNoTarget) {
  EXPECT_EQ(run_program({"solve", case_file_, "-o", case_file_}).code, 2);
  EXPECT_EQ(text_of(case_file_), good_case);
}

TEST_F(Files, WrongInputLeavesAnOldTable) {
  const std::string target = directory_.file("x.csv", "old\n");
  EXPECT_EQ(run_program({"solve", case_file_, "-o", target, "--set", "motion.nu=x"}).code, 2);
  EXPECT_EQ(text_of(target), "old\n");
}

TEST_F(Files, AnOldTableIsReplacedAndKeepsItsPermissions) {
  const std::string target = directory_.file("x.csv", "old\n");
  ::chmod(target.c_str(), 0640);
  EXPECT_EQ(run_program({"solve", case_file_, "-o", target}).code, 0);
  EXPECT_TRUE(text_of(target).starts_with("branch,"));
  struct ::stat status {};
  ASSERT_EQ(::stat(target.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(Files, ALinkIsFollowed) {
  directory_.file("real.csv", "old\n");
  fs::create_symlink("real.csv", directory_ / "link.csv");
  EXPECT_EQ(run_program({"solve", case_file_, "-o", directory_ / "link.csv"}).code, 0);
  EXPECT_TRUE(fs::is_symlink(directory_ / "link.csv"));
  EXPECT_TRUE(text_of(directory_ / "real.csv").starts_with("branch,"));
}

TEST_F(Files, ADeviceIsWrittenDirectly) {
  EXPECT_EQ(run_program({"solve", case_file_, "-o", "/dev/null"}).code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_FALSE(fs::exists("/dev/null.meta.json"));
}

TEST_F(Files, AFullDiskIsAFailure) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const Outcome table = run_program({"solve", case_file_, "-o", "/dev/full"});
  EXPECT_EQ(table.code, 4);
  EXPECT_THAT(table.err, HasSubstr("No space left"));
  EXPECT_EQ(run_program({"solve", case_file_}, {.standard_output = "/dev/full"}).code, 4);
}

/// A file that were given the number of a closed stream would get the messages, too.
TEST_F(Files, MessagesOfAClosedStreamDoNotGoIntoTheTable) {
  const std::string table = directory_ / "x.csv";
  const std::vector<std::string> arguments{"solve", shipped("too_fast.toml"), "-o", table};
  EXPECT_EQ(run_program(arguments).code, 3);
  const std::string whole = text_of(table);
  ASSERT_TRUE(whole.starts_with("branch,"));
  for (const char* const closed : {"2>&-", ">&-", "<&- >&- 2>&-"}) {
    const std::string script = std::string("exec \"$0\" \"$@\" ") + closed;
    const Outcome outcome =
        run_program(arguments, {.program = {"sh", "-c", script, program_path()}});
    EXPECT_EQ(outcome.code, 3) << closed;
    EXPECT_EQ(text_of(table), whole) << closed;
  }
  const std::vector<std::string> streamed{"solve", case_file_, "-o", "-"};
  const Outcome lost =
      run_program(streamed, {.program = {"sh", "-c", "exec \"$0\" \"$@\" >&-", program_path()}});
  EXPECT_EQ(lost.code, 4);
  EXPECT_THAT(lost.err, HasSubstr("writing standard output"));
}

TEST_F(Files, InterruptedRunsWriteNothingAndSaySo) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Outcome outcome =
        run_program({"solve", case_file_, "-o", directory_ / "x.csv"}, {.pending_signal = signal});
    EXPECT_EQ(outcome.code, 130);
    EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
    EXPECT_THAT(directory_.names(), ElementsAre("case.toml"));
  }
}

/// As `timeout` and batch systems send it: to the process, and to the group that it is in.
TEST_F(Files, ASignalThatComesTwiceIsOne) {
  const Outcome outcome = run_program({"solve", case_file_, "-o", directory_ / "x.csv"},
                                      {.pending_signal = SIGINT, .other_pending_signal = SIGTERM});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml"));
}

/// /dev/stdout is a link, to what is called pipe:[...] and is no path.
TEST_F(Files, StandardOutputByNameMayBeAPipe) {
  const std::string whole = run_program({"solve", case_file_, "-o", "-"}).out;
  const Outcome piped =
      run_program({"solve", case_file_, "--quiet", "-o", "/dev/stdout"},
                  {.program = {"sh", "-c", "\"$0\" \"$@\" | cat", program_path()}});
  EXPECT_EQ(piped.err, "");
  EXPECT_EQ(piped.out, whole);
}

TEST_F(Files, KilledAtAnyTimeLeavesAWholeTableOrTheOldOne) {
  const std::string target = directory_.file("x.csv", "old\n");
  const std::string whole = run_program({"solve", case_file_, "-o", "-"}).out;
  for (int delay = 0; delay < 12; ++delay) {
    run_program({"solve", case_file_, "-o", target}, {.kill_after_ms = delay});
    const std::string text = text_of(target);
    EXPECT_TRUE(text == "old\n" || text == whole) << text;
  }
}

TEST(AtomicFile, IsNotThereUntilCommitted) {
  const TemporaryDirectory directory;
  {
    AtomicFile file(directory / "x");
    file.write("half");
    EXPECT_FALSE(fs::exists(directory / "x"));
  }
  EXPECT_THAT(directory.names(), IsEmpty());
  AtomicFile file(directory / "x");
  file.write("who");
  file.write("le");
  file.commit();
  EXPECT_EQ(text_of(directory / "x"), "whole");
  EXPECT_THAT(directory.names(), ElementsAre("x"));
}

TEST(AtomicFile, FailingRenameThrowsAndLeavesNoTemporary) {
  const TemporaryDirectory directory;
  {
    AtomicFile file(directory / "x");
    file.write("text");
    // A directory in the target's place since: the rename cannot succeed, not even for root.
    fs::create_directory(directory / "x");
    EXPECT_THROW(file.commit(), std::runtime_error);
  }
  EXPECT_THAT(directory.names(), ElementsAre("x"));
}

TEST(AtomicFile, MetadataNames) {
  EXPECT_EQ(metadata_path("a/x.csv"), "a/x.meta.json");
  EXPECT_EQ(metadata_path("a.b/x"), "a.b/x.meta.json");
}

}  // namespace
}  // namespace stationary::testing
