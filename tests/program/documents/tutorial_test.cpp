// The pages of the documentation that have them: every command of their `console` blocks is
// run, in order and in one directory, and what it prints is compared. "…" stands for anything, on a
// line of its own for any lines. A `toml` block that begins with "# NAME.toml" is that file, and a
// `text` block is NAME.csv where the line before it ends in "`NAME.csv`:".
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/program/needs_gnuplot.hpp"
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
    // As a build without Ceres Solver says it.
    out += std::regex_replace(text, std::regex("then Ceres"), "then (?:Ceres|Levenberg-Marquardt)");
    out += "\n";
  }
  return out;
}

void write_files_of(const std::string& path, const TemporaryDirectory& directory) {
  static const std::regex csv_name(".*`([^`]+\\.csv)`:");
  std::istringstream text(text_of(path));
  std::string name;
  std::string file;
  std::string before;
  bool in_block = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      if (!name.empty()) directory.file(name, file);
      in_block = line == "```toml" || line == "```text";
      name.clear();
      file.clear();
      if (std::smatch found; line == "```text" && std::regex_match(before, found, csv_name))
        name = found[1];
    } else if (in_block) {
      if (file.empty() && line.starts_with("# ") && line.ends_with(".toml")) name = line.substr(2);
      file += line + "\n";
    } else if (!line.empty()) {
      before = line;
    }
  }
}

/// Runs the commands of a page, of which there are so many at least.
void expect_as_printed(const std::string& path, std::size_t least) {
  const TemporaryDirectory directory;
  std::filesystem::create_directory_symlink(STATIONARY_CASES, directory / "cases");
  write_files_of(path, directory);
  const std::vector<Step> steps = steps_of(path);
  ASSERT_GE(steps.size(), least);
  for (const Step& step : steps) {
    if (step.arguments.front() == "plot" && !has_gnuplot()) continue;
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

class Page : public ::testing::TestWithParam<std::string> {};

TEST_P(Page, EveryCommandPrintsWhatItSays) {
  expect_as_printed(STATIONARY_DOCS "/" + GetParam() + ".md", 2);
}

INSTANTIATE_TEST_SUITE_P(Documentation, Page,
                         ::testing::Values("tutorial", "howto", "use", "everything", "gravity"),
                         [](const auto& param) { return param.param; });

TEST(Readme, ItsCommandPrintsWhatItSays) { expect_as_printed(STATIONARY_DOCS "/../README.md", 1); }

}  // namespace
}  // namespace stationary::testing
