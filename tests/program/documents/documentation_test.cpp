// The pages of docs/: links that lead somewhere, every case in the gallery, every event and class
// described, every public header and function of the library in its reference, and examples that are
// those the consumer's test compiles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "lib/stability/spectrum.hpp"
#include "solver/motion/event.hpp"
#include "solver/program/table/table.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string page(const std::string& name) { return text_of(STATIONARY_DOCS "/" + name); }

/// What the pages and the README link to is there.
TEST(Documentation, LinksLeadSomewhere) {
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

/// What a page names as a file of the project is there, with or without its suffix.
TEST(Documentation, PathsAreThoseOfTheSources) {
  const fs::path top = STATIONARY_SOURCES;
  const std::regex path("`((?:tests|lib|solver|cases|results|cmake|docs)/[A-Za-z0-9_./-]*)`");
  int paths = 0;
  for (const auto& entry : fs::directory_iterator(STATIONARY_DOCS)) {
    if (entry.path().extension() != ".md") continue;
    std::string text = text_of(entry.path().string());
    text = text.substr(0, text.find("## Headers that have moved"));
    for (std::sregex_iterator at(text.begin(), text.end(), path), end; at != end; ++at) {
      const std::string named = (*at)[1];
      const bool there = std::ranges::any_of(
          std::array{"", ".cpp", ".toml"},
          [&](const char* suffix) { return fs::exists(top / (named + suffix)); });
      EXPECT_TRUE(there) << entry.path() << ": " << named;
      ++paths;
    }
  }
  EXPECT_GE(paths, 40);
}

TEST(Gallery, HasEveryCaseWithItsPicture) {
  const std::string gallery = page("gallery.md");
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(STATIONARY_CASES)) {
    const std::string stem = entry.path().stem().string();
    EXPECT_THAT(gallery, HasSubstr("](../cases/" + stem + ".toml)"));
    ++cases;
    for (const std::string& picture : {stem, stem + "_atlas"}) {
      if (fs::exists(STATIONARY_RESULTS "/" + picture + ".svg")) {
        EXPECT_THAT(gallery, HasSubstr("](../results/" + picture + ".svg)"));
      }
    }
  }
  EXPECT_GE(cases, 20);
}

TEST(EventsPage, DescribesEveryEventAndClassWithAPicture) {
  const std::string events = page("events.md");
  const auto described = [&](std::string_view name) {
    if (name.empty()) return;  // no event
    EXPECT_THAT(events, HasSubstr("### `" + std::string(name) + "`\n")) << name;
    EXPECT_THAT(events, HasSubstr("](pictures/" + std::string(name) + ".svg)")) << name;
  };
  for (const std::string_view name : event_names) described(name);
  for (const std::string_view name : stability_names) described(name);
}

TEST(TablePage, HasEveryColumnInItsOrder) {
  std::string text = page("table.md");
  text = text.substr(text.find("```\n") + 4);
  text = text.substr(0, text.find("```"));
  const std::regex word("[a-z_0-9]+");
  std::vector<std::string> columns;
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at)
    columns.push_back(at->str());
  EXPECT_THAT(columns, ::testing::ElementsAreArray(column_names));
}

/// From solver/CMakeLists.txt, where the public headers stand first.
std::vector<std::string> public_headers() {
  std::vector<std::string> out;
  bool listed = false;
  for (const std::string& line : lines_of(text_of(STATIONARY_SOURCES "/solver/CMakeLists.txt"))) {
    if (line ==
        "# The public headers, and after them what they include; the others are not installed.")
      listed = true;
    if (listed && line.empty()) break;
    if (listed && line.ends_with(".hpp"))
      out.push_back("solver/" + line.substr(line.find_first_not_of(' ')));
  }
  for (const char* name :
       {"lib/body/body.hpp", "solver/motion/problem.hpp", "solver/motion/equilibrium.hpp"})
    out.emplace_back(name);
  return out;
}

/// Its types, functions and public member functions.
std::set<std::string> public_names(const std::string& header) {
  static const std::regex type(R"(^(?:class|struct|enum class) (\w+).*)");
  static const std::regex function(
      R"(^(?:  )?(?:virtual |explicit |static |constexpr |inline )*[A-Za-z][\w:<>,&* ]* [&*]?(\w+)\(.*)");
  std::set<std::string> out;
  bool is_private = false;
  for (std::string line : lines_of(text_of(STATIONARY_SOURCES "/" + header))) {
    line = line.substr(0, line.find("//"));
    if (line == " private:") is_private = true;
    if (line == "};") is_private = false;
    std::smatch found;
    if (!is_private &&
        (std::regex_match(line, found, type) || std::regex_match(line, found, function)))
      out.insert(found[1]);
  }
  return out;
}

TEST(LibraryPage, NamesEveryPublicHeaderAndFunction) {
  const std::string text = page("library.md");
  std::set<std::string> words;
  static const std::regex word(R"(\w+)");
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at)
    words.insert(at->str());
  const std::vector<std::string> headers = public_headers();
  ASSERT_GE(headers.size(), 17U);
  std::size_t names = 0;
  for (const std::string& header : headers) {
    EXPECT_THAT(text, HasSubstr(fs::path(header).filename().string() + "`")) << header;
    for (const std::string& name : public_names(header)) {
      EXPECT_TRUE(words.contains(name)) << header << ": " << name;
      ++names;
    }
  }
  EXPECT_GE(names, 100U);
}

/// Without what indentation and comments' columns do.
std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' '; });
  return text;
}

TEST(LibraryPage, ExamplesAreThoseOfTheConsumer) {
  const std::string consumer =
      without_spaces(text_of(STATIONARY_SOURCES "/tests/consumer/reference.cpp"));
  int blocks = 0;
  bool in_block = false;
  for (const std::string& line : lines_of(page("library.md"))) {
    if (line.starts_with("```")) {
      in_block = line == "```cpp";
      blocks += in_block ? 1 : 0;
    } else if (in_block) {
      EXPECT_THAT(consumer, HasSubstr(without_spaces(line) + "\n"));
    }
  }
  EXPECT_GE(blocks, 8);
}

}  // namespace
}  // namespace stationary::testing
