// On a terminal, here a pseudo terminal, and only there: colours, and the bar with its estimate.
#include "solver/program/text/terminal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>

#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// NO_COLOR and TERM as a test wants them; nothing: not there.
using Environment = std::map<std::string, std::optional<std::string>>;

const Environment with_colours{{"TERM", "xterm"}, {"NO_COLOR", std::nullopt}};

/// Both streams of a run on a terminal of its own. It is interrupted as soon as `until` is among them.
std::string on_terminal(const std::vector<std::string>& arguments, const Environment& environment,
                        const std::string& until = {}) {
  std::vector<std::string> all{"stationary"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& each : all) pointers.push_back(each.data());
  pointers.push_back(nullptr);

  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    for (const auto& [name, value] : environment) {
      if (value) {
        ::setenv(name.c_str(), value->c_str(), 1);
      } else {
        ::unsetenv(name.c_str());
      }
    }
    ::execv(program_path(), pointers.data());
    ::_exit(127);
  }
  EXPECT_GT(child, 0);
  std::string out;
  std::array<char, 4096> part{};
  bool interrupted = false;
  // The end of a terminal is an error of reading.
  for (ssize_t count = 0; (count = ::read(terminal, part.data(), part.size())) > 0;) {
    out.append(part.data(), static_cast<std::size_t>(count));
    if (interrupted || until.empty() || out.find(until) == std::string::npos) continue;
    interrupted = true;
    ::kill(child, SIGINT);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  EXPECT_TRUE(WIFEXITED(status));
  return out;
}

const char* const escape = "\x1b[";

TEST(Terminal, HeadingsAreBoldAndAlarmsRed) {
  const std::string summary = on_terminal({"solve", shipped("disc.toml")}, with_colours);
  EXPECT_THAT(summary, HasSubstr("\x1b[1mcase          \x1b[0mThin disc"));
  EXPECT_THAT(summary, HasSubstr("\x1b[1mspectrum      \x1b[0munstable"));
  EXPECT_THAT(on_terminal({"solve", "missing.toml"}, with_colours),
              HasSubstr("\x1b[1m\x1b[31mstationary:\x1b[0m "));
}

TEST(Terminal, NoColoursWhereTheyAreNotWanted) {
  const std::vector<Environment> without{{{"TERM", "xterm"}, {"NO_COLOR", "1"}},
                                         {{"TERM", "xterm"}, {"NO_COLOR", ""}},
                                         {{"TERM", "dumb"}, {"NO_COLOR", std::nullopt}},
                                         {{"TERM", std::nullopt}, {"NO_COLOR", std::nullopt}}};
  for (const Environment& each : without) {
    const std::string summary = on_terminal({"models", "biot", "--help"}, each) +
                                on_terminal({"check", shipped("disc.toml")}, each) +
                                on_terminal({"solve", "missing.toml"}, each);
    EXPECT_THAT(summary, HasSubstr("Thin disc"));
    EXPECT_THAT(summary, HasSubstr("missing.toml"));
    EXPECT_THAT(summary, Not(HasSubstr(escape)));
  }
}

TEST(Terminal, NoColoursInFilesAndPipes) {
  ::setenv("TERM", "xterm", 1);
  ::unsetenv("NO_COLOR");
  const Outcome solved = run_program({"solve", shipped("disc.toml")});
  EXPECT_THAT(solved.out, HasSubstr("Thin disc"));
  EXPECT_THAT(solved.out, Not(HasSubstr(escape)));
  const Outcome refused = run_program({"solve", "missing.toml"});
  EXPECT_THAT(refused.err, HasSubstr("missing.toml"));
  EXPECT_THAT(refused.err, Not(HasSubstr(escape)));
}

TEST(Terminal, TheBarSaysHowLongItWillTake) {
  // It would take minutes, so that there is a first second; it is interrupted as soon as it says so.
  const std::string shown = on_terminal(
      {"atlas", shipped("neo_hookean.toml"), "--checkpoints", "1000000"}, with_colours, " left");
  EXPECT_THAT(shown,
              ContainsRegex("\\[#* *\\] searching the checkpoints, about [0-9]+ (s|min|h) left"));
  EXPECT_THAT(shown, HasSubstr("interrupted"));
  // One that is told to be quiet shows no bar.
  const std::string quiet =
      on_terminal({"continue", shipped("fold.toml"), "--quiet"}, with_colours);
  EXPECT_THAT(quiet, Not(HasSubstr("[")));
}

TEST(Terminal, DurationsArePlain) {
  EXPECT_EQ(rough_duration(0.2), "1 s");
  EXPECT_EQ(rough_duration(89.5), "90 s");
  EXPECT_EQ(rough_duration(150.0), "2 min");
  EXPECT_EQ(rough_duration(3000.0), "50 min");
  EXPECT_EQ(rough_duration(20000.0), "6 h");
}

}  // namespace
}  // namespace stationary::testing
