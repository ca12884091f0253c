// The tutorial of the documentation: every command of its `console` blocks is run, in order and in
// one directory, and what it prints is compared. "…" stands for anything, on a line of its own for
// any lines.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

constexpr const char* ellipsis = "…";

struct Step {
  std::vector<std::string> arguments;
  std::vector<std::string> expected;
};

/// Words of a command line; quotes keep spaces together.
std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> out;
  std::string word;
  bool quoted = false;
  for (const char c : line + " ") {
    if (c == '\'') {
      quoted = !quoted;
    } else if (c == ' ' && !quoted) {
      if (!word.empty()) out.push_back(std::exchange(word, {}));
    } else {
      word += c;
    }
  }
  return out;
}

std::vector<Step> steps_of(const std::string& path) {
  std::vector<Step> out;
  std::istringstream text(text_of(path));
  bool in_block = false;
  for (std::string line; std::getline(text, line);) {
    if (line == "```console" || line == "```") {
      in_block = line == "```console";
      continue;
    }
    if (!in_block) continue;
    if (line.starts_with("$ ")) {
      std::vector<std::string> arguments = words(line.substr(2));
      EXPECT_EQ(arguments.front(), "stationary") << line;
      arguments.erase(arguments.begin());
      out.push_back({std::move(arguments), {}});
    } else {
      out.back().expected.push_back(line);
    }
  }
  return out;
}

std::string pattern_of(const std::vector<std::string>& lines) {
  static const std::regex special(R"([.^$|()\[\]{}*+?\\])");
  std::string out;
  for (const std::string& line : lines) {
    if (line == ellipsis) {
      out += "(?:[^\n]*\n)*";
      continue;
    }
    std::string text = std::regex_replace(line, special, R"(\$&)");
    for (std::size_t at = text.find(ellipsis); at != std::string::npos; at = text.find(ellipsis))
      text.replace(at, std::string(ellipsis).size(), "[^\n]*");
    out += text + "\n";
  }
  return out;
}

TEST(Tutorial, EveryCommandPrintsWhatItSays) {
  const TemporaryDirectory directory;
  std::filesystem::create_directory_symlink(STATIONARY_CASES, directory / "cases");
  const std::vector<Step> steps = steps_of(STATIONARY_DOCS "/tutorial.md");
  ASSERT_GE(steps.size(), 9U);
  for (const Step& step : steps) {
    std::string line;
    for (const std::string& word : step.arguments) line += " " + word;
    RunOptions there;
    there.directory = directory.path();
    const Outcome outcome = run_program(step.arguments, there);
    const std::string printed = outcome.out + outcome.err;
    EXPECT_TRUE(std::regex_match(printed, std::regex(pattern_of(step.expected))))
        << line << "\nprinted\n"
        << printed;
  }
}

/// What the pages and the README link to is there.
TEST(Documentation, LinksLeadSomewhere) {
  namespace fs = std::filesystem;
  std::vector<fs::path> pages{fs::path(STATIONARY_DOCS) / ".." / "README.md",
                              fs::path(STATIONARY_DOCS) / ".." / "CHANGELOG.md"};
  for (const auto& entry : fs::directory_iterator(STATIONARY_DOCS))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  ASSERT_GE(pages.size(), 12U);
  const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  int links = 0;
  for (const fs::path& page : pages) {
    const std::string text = text_of(page.string());
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
      const std::string target = (*at)[1];
      if (target.starts_with("http")) continue;
      ++links;
      EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page << ": " << target;
    }
  }
  EXPECT_GE(links, 40);
}

}  // namespace
}  // namespace stationary::testing
