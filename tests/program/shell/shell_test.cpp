// What stands beside the program: the completion of bash, and the manual's page, which must know every
// command and option that the help knows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::set<std::string> found(const std::string& text, const std::regex& pattern) {
  std::set<std::string> out;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    out.insert((*at)[1]);
  return out;
}

std::set<std::string> commands() {
  const std::string help = run_program({"help"}).out;
  const std::string list = help.substr(help.find("Subcommands:"));
  return found(list, std::regex("\n  ([a-z]+) "));
}
std::set<std::string> options(const std::string& command) {
  return found(run_program({"help", command}).out, std::regex("\n  (?:-[a-z],)?(--[a-z-]+)"));
}

/// What the completion offers for the last of these words.
std::vector<std::string> completed(const std::vector<std::string>& line) {
  std::string words;
  for (const std::string& word : line) words += " '" + word + "'";
  const std::string script = "source '" STATIONARY_SHELL "/stationary.bash'; COMP_WORDS=('" +
                             std::string(program_path()) + "'" + words +
                             "); COMP_CWORD=" + std::to_string(line.size()) +
                             "; _stationary; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const std::string command = "bash -c \"$(cat <<'SCRIPT'\n" + script + "\nSCRIPT\n)\"";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string each; std::getline(lines, each);)
    if (!each.empty()) out.push_back(each);
  return out;
}

TEST(Completion, OffersCommandsAndTheirOptions) {
  EXPECT_THAT(completed({"con"}), ElementsAre("continue"));
  EXPECT_THAT(completed({"continue", "--fr"}), ElementsAre("--from"));
  EXPECT_THAT(completed({"help", "ma"}), ElementsAre("map"));
  for (const std::string& command : commands()) {
    EXPECT_THAT(completed({command}), Contains(command));
    if (command == "help") continue;
    const std::vector<std::string> offered = completed({command, "--"});
    EXPECT_EQ(std::set<std::string>(offered.begin(), offered.end()), options(command)) << command;
  }
}

TEST(Completion, OffersFilesElsewhere) {
  EXPECT_THAT(completed({"solve", STATIONARY_CASES "/fol"}),
              ElementsAre(STATIONARY_CASES "/fold.toml"));
  const TemporaryDirectory directory;
  const std::string spaced = directory.file("my own case.toml", "");
  EXPECT_THAT(completed({"solve", directory / "my"}), ElementsAre(spaced));
}

TEST(Manual, KnowsEveryCommandAndOption) {
  const std::string page = text_of(STATIONARY_SHELL "/stationary.1.scd");
  ASSERT_GE(commands().size(), 8U);
  for (const std::string& command : commands()) {
    EXPECT_THAT(page, HasSubstr("\n*" + command + "*")) << command;
    for (const std::string& option : options(command))
      EXPECT_THAT(page, HasSubstr("*" + option + "*")) << command;
  }
}

}  // namespace
}  // namespace stationary::testing
