// Tables as the page holds them: the file's own texts, what is a number, and what is refused.
#include "solver/program/explore/page_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <regex>
#include <sstream>

#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

PageTable table_of(const std::string& csv) {
  TableReader reader(std::make_unique<std::istringstream>(csv), "folder/x.csv");
  return read_page_table(reader);
}

std::string refusal_of(const std::string& csv) {
  try {
    table_of(csv);
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(PageTable, KeepsTheTextsOfTheFile) {
  const PageTable table =
      table_of("branch,event,xi,class,body.J.0\ni,,1.50,stable,0.1\ni,tilt,,,1e-3\n");
  EXPECT_EQ(table.file, "x.csv");
  EXPECT_EQ(table.rows, 2U);
  EXPECT_THAT(table.parameters, ElementsAre("body.J.0"));
  ASSERT_EQ(table.columns.size(), 5U);
  EXPECT_FALSE(table.columns[0].is_number);
  EXPECT_THAT(table.columns[1].words, ElementsAre("", "tilt"));
  EXPECT_TRUE(table.columns[2].is_number);
  EXPECT_EQ(table.columns[2].numbers, "1.50,");
  EXPECT_THAT(table.columns[3].words, ElementsAre("stable", ""));
  EXPECT_EQ(table.columns[4].numbers, "0.1,1e-3");
}

TEST(PageTable, IsOfMotions) {
  for (const char* const other :
       {"case,branch,boxes\na,i,1\n", "xi;zeta\n1;2\n", "sheet,branch,momentum_from\n1,i,0\n",
        "branch,event,class\ni,tilt,stable\n"})
    EXPECT_THAT(refusal_of(other), HasSubstr("found no column of numbers that tells of motions"));
  EXPECT_EQ(refusal_of("nu,body.J.1,class\n1,2,stable\n"), "taken");
  EXPECT_EQ(refusal_of("sheet,xi\n1,1\n2.0,1\n,1\n"), "taken");
  for (const char* const sheet : {"1.5", "-1", "0", "99999999999", "abc"})
    EXPECT_THAT(refusal_of("xi,sheet\n1," + std::string(sheet) + "\n"),
                HasSubstr("x.csv:2:3: sheet: found \"" + std::string(sheet) + "\""));
}

TEST(PageTable, SeesFromTheCellsWhatAnUnknownColumnIs) {
  const PageTable table = table_of("nu3,mine,yours\n1,2,3\n2,,x\n");
  EXPECT_TRUE(table.columns[1].is_number);
  EXPECT_EQ(table.columns[1].numbers, "2,");
  EXPECT_THAT(table.columns[1].words, IsEmpty());
  EXPECT_FALSE(table.columns[2].is_number);
  EXPECT_THAT(table.columns[2].words, ElementsAre("3", "x"));
}

TEST(PageTable, ParametersOfAMapAreItsTwo) {
  EXPECT_THAT(table_of("branch,xi,status,nu,body.J.1/body.J.0\ni,1,solved,1,2\n").parameters,
              ElementsAre("nu", "body.J.1/body.J.0"));
  EXPECT_THAT(table_of("branch,nu1,xi\ni,1,2\n").parameters, IsEmpty());
  EXPECT_THAT(table_of("branch,nu1,what? no. 1\ni,1,x\n").parameters, IsEmpty());
}

TEST(PageTable, RefusesWhatTheProgramWouldNotHaveWritten) {
  EXPECT_THAT(refusal_of("branch,xi\ni,wide\n"), HasSubstr("folder/x.csv:2:3: xi: found \"wide\""));
  EXPECT_THAT(refusal_of("branch,xi,class\ni,1,safe\n"), HasSubstr("stable, elliptic"));
  EXPECT_THAT(refusal_of("branch,body.J.0\ni,heavy\n"), HasSubstr("body.J.0"));
  EXPECT_THAT(refusal_of("branch,xi\n"), HasSubstr("found no rows"));
  EXPECT_THAT(refusal_of(""), HasSubstr("found an empty file"));
  EXPECT_EQ(refusal_of("branch,xi\ni,1\n"), "taken");
}

TEST(PageTable, TakesTitleAndMetadataFromBesideTheFile) {
  const TemporaryDirectory folder;
  const std::string path = folder.file("x.csv", "branch,xi\ni,1\n");
  EXPECT_EQ(read_page_table(path, std::nullopt).title, "x.csv");
  const std::string metadata = R"({"case": {"title": "A disc"}})";
  folder.file("x.meta.json", metadata);
  const PageTable table = read_page_table(path, std::nullopt);
  EXPECT_EQ(table.title, "A disc");
  EXPECT_EQ(table.metadata, metadata);
  EXPECT_EQ(table.warning, "");
  EXPECT_EQ(read_page_table(path, "Mine").title, "Mine");
}

TEST(PageTable, LeavesOutMetadataThatCannotBeRead) {
  const TemporaryDirectory folder;
  const std::string path = folder.file("x.csv", "branch,xi\ni,1\n");
  const auto warning = [&] {
    const PageTable table = read_page_table(path, std::nullopt);
    EXPECT_EQ(table.metadata, "");
    EXPECT_EQ(table.title, "x.csv");
    return table.warning;
  };
  EXPECT_EQ(warning(), "");
  for (const char* const broken : {"", "{\"case\": {\"title\": \"A disc\"}", "[]", "\xff"}) {
    folder.file("x.meta.json", broken);
    EXPECT_THAT(warning(),
                AllOf(HasSubstr("x.meta.json cannot be read: "), Not(HasSubstr("json."))));
  }
  for (const auto& [part, value] : std::vector<std::pair<std::string, std::string>>{
           {"command", "7"},
           {"message", "[]"},
           {"case", "\"x\""},
           {"events", "5"},
           {"events", "[5]"},
           {"events", R"([{"event": "tilt", "point": null}])"},
           {"segments", R"([{"sheet": 1, "segment": "2"}])"},
           {"classes", R"([{"branch": "i", "status": "proven", "from": 0, "to": null}])"},
           {"classes",
            R"([{"branch": "i", "status": "proven", "from": 0, "to": 1, "sheets": "none"}])"},
           {"skipped", "{}"}}) {
    folder.file("x.meta.json", "{\"" + part + "\": " + value + "}");
    EXPECT_THAT(warning(), HasSubstr("its " + part + " is not as the program writes it")) << value;
  }
  // A million arrays in one another: what copies such a tree runs out of stack.
  const std::size_t deep = 1'000'000;
  folder.file("x.meta.json", "{\"case\": " + std::string(deep, '[') + std::string(deep, ']') + "}");
  EXPECT_THAT(warning(), HasSubstr("x.meta.json cannot be read: it nests more deeply"));
  std::filesystem::remove(folder / "x.meta.json");
  std::filesystem::create_directory(folder / "x.meta.json");
  EXPECT_THAT(warning(), HasSubstr("x.meta.json cannot be read: it is no file"));
}

TEST(PageTable, LeavesOutMetadataOfAnotherTable) {
  const TemporaryDirectory folder;
  const std::string text = text_of(STATIONARY_RESULTS "/fold.csv");
  const std::string own = text_of(STATIONARY_RESULTS "/fold.meta.json");
  const std::string path = folder.file("x.csv", text);
  folder.file("x.meta.json", own);
  const auto page = [&] { return read_page_table(path, std::nullopt); };
  EXPECT_EQ(page().warning, "");
  EXPECT_EQ(page().metadata, own);
  // As a spreadsheet saves it: the rows are the same.
  folder.file("x.csv", std::regex_replace(text, std::regex("\n"), "\r\n"));
  EXPECT_EQ(page().warning, "");
  const std::size_t digit = text.find_last_of("0123456789");
  std::string changed = text;
  changed[digit] = changed[digit] == '1' ? '2' : '1';
  folder.file("x.csv", changed);
  EXPECT_THAT(page().warning, HasSubstr("x.meta.json is not of this table: its checksum"));
  EXPECT_EQ(page().metadata, "");
  folder.file("x.csv", text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  EXPECT_THAT(page().warning, HasSubstr("x.meta.json is not of this table: it is of "));
  EXPECT_EQ(page().metadata, "");
}

TEST(PageTable, KnowsTheMetadataOfEveryCommandsTable) {
  const TemporaryDirectory folder;
  const auto warning = [&](const std::string& name) {
    const PageTable table = read_page_table(name, std::nullopt);
    EXPECT_NE(table.metadata, "") << name;
    return table.warning;
  };
  EXPECT_EQ(warning(STATIONARY_RESULTS "/two_polar.csv"), "");
  EXPECT_EQ(warning(STATIONARY_RESULTS "/every_sheet.csv"), "");
  EXPECT_EQ(warning(STATIONARY_RESULTS "/neo_hookean_atlas.csv"), "");
  EXPECT_EQ(warning(STATIONARY_RESULTS "/elastic_sphere_fold_nu.csv"), "");
  const std::string map = folder / "map.csv";
  const Outcome mapped = run_program({"map", shipped("fibre_map.toml"), "--set", "map.x.count=3",
                                      "--set", "map.y.count=2", "-o", map, "-q"});
  EXPECT_EQ(mapped.err, "");
  EXPECT_EQ(warning(map), "");
  if (!has_hdf5) return;
  const std::string columns = folder / "x.h5";
  EXPECT_EQ(run_program({"solve", shipped("fold.toml"), "-o", columns, "-q"}).err, "");
  EXPECT_EQ(warning(columns), "");
  std::filesystem::remove(folder / "x.meta.json");
  EXPECT_EQ(warning(columns), "");
}

}  // namespace
}  // namespace stationary::testing
