// The command: the page it writes, what it refuses, and what it says where it was built without the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr bool has_page = STATIONARY_HAS_PAGE;
constexpr bool has_live = STATIONARY_HAS_LIVE;
const char* const shipped_table = STATIONARY_RESULTS "/fold.csv";

TEST(Explore, WritesOneFileThatIsAPage) {
  if (!has_page) GTEST_SKIP() << "the program is built without the page";
  const TemporaryDirectory folder;
  const Outcome done = run_program(
      {"explore", shipped_table, "-o", folder / "x.html", "--title", "<b>&", "--no-live"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, AllOf(HasSubstr("x.html: 1 table, "), HasSubstr(" rows, ")));
  EXPECT_THAT(folder.names(), ElementsAre("x.html"));
  const std::string page = text_of(folder / "x.html");
  EXPECT_THAT(page, HasSubstr("<title>&lt;b&gt;&amp;</title>"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("id=\"events\""));
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_THAT(page, Not(HasSubstr("attachShadow")));
  EXPECT_THAT(page, Not(HasSubstr("@DATA@")));
}

TEST(Explore, TheSameTablesGiveTheSameBytes) {
  if (!has_page) GTEST_SKIP() << "the program is built without the page";
  const TemporaryDirectory folder;
  for (const char* const name : {"a.html", "b.html"})
    EXPECT_EQ(run_program({"explore", shipped_table, "-o", folder / name, "--quiet"}).out, "");
  EXPECT_EQ(text_of(folder / "a.html"), text_of(folder / "b.html"));
}

/// Curves are drawn over a map of the same two numbers: of another body they say nothing of it.
TEST(Explore, TellsOfCurvesOfAnotherBody) {
  if (!has_page) GTEST_SKIP() << "the program is built without the page";
  const TemporaryDirectory folder;
  const std::string map = folder / "map.csv";
  for (const bool other : {false, true}) {
    const Outcome made =
        run_program({"map", STATIONARY_CASES "/elastic_sphere.toml", "-q", "-o", map, "--set",
                     other ? "body.J.2=2" : "body.J.2=1", "--set",
                     "map.x={parameter=\"nu\",from=0.1,to=0.5,count=3}", "--set",
                     "map.y={parameter=\"potential.coupled.mu\",from=0.1,to=0.5,count=2}"});
    ASSERT_EQ(made.code, 0) << made.err;
    const Outcome page =
        run_program({"explore", map, STATIONARY_RESULTS "/elastic_sphere_ellipse.csv", "-o",
                     folder / "x.html", "-q", "--no-live"});
    EXPECT_EQ(page.code, 0) << page.err;
    EXPECT_EQ(page.err.empty(), !other) << page.err;
    if (other) EXPECT_THAT(page.err, HasSubstr("its curves are of another body than the map's"));
  }
}

TEST(Explore, TellsOfMetadataThatItLeavesOut) {
  if (!has_page) GTEST_SKIP() << "the program is built without the page";
  const TemporaryDirectory folder;
  const std::string table = folder.file("x.csv", text_of(shipped_table));
  folder.file("x.meta.json", text_of(STATIONARY_RESULTS "/disc.meta.json"));
  const auto told = [&] {
    const Outcome done = run_program({"explore", table, "-o", folder / "x.html", "--quiet"});
    EXPECT_EQ(done.code, 0);
    EXPECT_EQ(done.out, "");
    return done.err;
  };
  EXPECT_THAT(told(), HasSubstr("x.meta.json is not of this table"));
  folder.file("x.meta.json", "{");
  EXPECT_THAT(told(), HasSubstr("x.meta.json cannot be read: "));
  folder.file("x.meta.json", text_of(STATIONARY_RESULTS "/fold.meta.json"));
  EXPECT_EQ(told(), "");
}

TEST(Explore, SaysWhatIsMissingWhereItWasBuiltWithoutThePage) {
  if (has_page) GTEST_SKIP() << "the program is built with the page";
  const TemporaryDirectory folder;
  const Outcome failed = run_program({"explore", shipped_table, "-o", folder / "x.html"});
  EXPECT_EQ(failed.code, 4);
  EXPECT_THAT(failed.err, AllOf(HasSubstr("node and npm"), HasSubstr("package-lock.json")));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Explore, RefusesWrongArguments) {
  const TemporaryDirectory folder;
  const auto refused = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(refused({"explore", shipped_table, "-o", folder / "x.svg"}),
              AllOf(HasSubstr("\".svg\""), HasSubstr(".html")));
  EXPECT_THAT(refused({"explore", shipped_table, "-o", folder / "x"}), HasSubstr("no extension"));
  EXPECT_THAT(refused({"explore", shipped_table}), HasSubstr("--output"));
  EXPECT_THAT(refused({"explore", "-o", folder / "x.html"}), HasSubstr("FILE"));
  EXPECT_THAT(refused({"explore", shipped("fold.toml"), "-o", folder / "x.html", "--no-live"}),
              AllOf(HasSubstr("--no-live"), HasSubstr("cannot open a case")));
  EXPECT_THAT(refused({"explore", shipped("fold.toml"), shipped_table, "-o", folder / "x.html"}),
              HasSubstr("one case by itself"));
  const std::string table = folder.file("t.html", "branch,xi\ni,1\n");
  EXPECT_THAT(refused({"explore", table, "-o", table}), HasSubstr("is a file it is made of"));
  EXPECT_EQ(text_of(table), "branch,xi\ni,1\n");
  EXPECT_THAT(folder.names(), ElementsAre("t.html"));
}

TEST(Explore, OpensACaseWithItsSolver) {
  if (!has_live) GTEST_SKIP() << "the program is built without the solver of pages";
  const TemporaryDirectory folder;
  const Outcome done = run_program({"explore", shipped("fold.toml"), "-o", folder / "x.html"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("x.html: a case, "));
  const std::string page = text_of(folder / "x.html");
  EXPECT_THAT(page, HasSubstr("'wasm-unsafe-eval'; worker-src blob:"));
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_THAT(page, Not(HasSubstr("@LIVE@")));
}

TEST(Explore, SaysWhatIsMissingForACaseWhereItWasBuiltWithoutItsSolver) {
  if (!has_page || has_live) GTEST_SKIP() << "the program is built with the solver of pages";
  const TemporaryDirectory folder;
  const Outcome failed = run_program({"explore", shipped("fold.toml"), "-o", folder / "x.html"});
  EXPECT_EQ(failed.code, 4);
  EXPECT_THAT(failed.err, AllOf(HasSubstr("clang-19"), HasSubstr("wasi-libc")));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Explore, RefusesAWrongCase) {
  if (!has_page) GTEST_SKIP() << "the program is built without the page";
  const TemporaryDirectory folder;
  const std::string path = folder.file("x.toml", "[body]\nJ = [1.0]\n");
  const Outcome refused = run_program({"explore", path, "-o", folder / "x.html"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("body.J"));
  EXPECT_THAT(folder.names(), ElementsAre("x.toml"));
}

TEST(Explore, RefusesABrokenTableWithItsPlace) {
  if (!has_page) GTEST_SKIP() << "the program is built without the page";
  const TemporaryDirectory folder;
  const std::string table = folder.file("t.csv", "branch,xi\ni,1\ni,wide\n");
  const Outcome refused = run_program({"explore", shipped_table, table, "-o", folder / "x.html"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("t.csv:3:3"), HasSubstr("wide")));
  EXPECT_THAT(folder.names(), ElementsAre("t.csv"));
}

}  // namespace
}  // namespace stationary::testing
