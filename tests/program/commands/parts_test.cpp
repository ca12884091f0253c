// --part and --merge from outside: the parts of a run and the table of all of them against that of a run
// that is not shared out, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/json_schema.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What is shared out: a command, its case and its options.
struct Shared {
  std::string name;
  Words arguments;
};
std::ostream& operator<<(std::ostream& out, const Shared& of) { return out << of.name; }

Words set(const std::string& key_and_value) { return {"--set", key_and_value}; }
Words joined(std::initializer_list<Words> all) {
  Words out;
  for (const Words& each : all) out.insert(out.end(), each.begin(), each.end());
  return out;
}

const Words map_words{"map", shipped("map_biot_log.toml")};

class Parts : public ::testing::TestWithParam<Shared> {
 protected:
  Words arguments() const {
    Words out = GetParam().arguments;
    if (out[0] != "study") return out;
    std::ostringstream table;
    // Numbers as a person spells them, which a column of doubles would lose.
    const char* const spelled[] = {"1.50", "", "-0", "1E3", "007.5", "nan"};
    table << "motion.nu,_tag,_measured,body.J.1\n";
    for (int k = 0; k < 50; ++k)
      table << 0.02 * k << (k % 17 == 3 ? "x" : "") << ",\"t, " << k << "\"," << spelled[k % 6]
            << ',' << (k % 6 == 0 ? "1.70" : "1.8") << '\n';
    return joined({out, {"--over", directory_.file("t.csv", table.str())}});
  }
  std::string part_name(std::size_t k) const {
    return directory_ / ("p" + std::to_string(k) + (columnar_ ? ".h5" : ".csv"));
  }
  Words parts(std::size_t n) const {
    Words out;
    for (std::size_t k = 1; k <= n; ++k) out.push_back(part_name(k));
    return out;
  }
  Outcome part(std::size_t k, std::size_t n) const {
    return run_program(
        joined({arguments(),
                {"--part", std::to_string(k) + "/" + std::to_string(n), "-o", part_name(k)}}));
  }
  static json without_run(const std::string& path) {
    json out = json::parse(text_of(path));
    EXPECT_EQ(schema_fault(out, json::parse(text_of(STATIONARY_SCHEMA))), "");
    out.erase("run");
    return out;
  }

  TemporaryDirectory directory_;
  bool columnar_ = false;
};

TEST_P(Parts, TogetherTheyAreTheWhole) {
  const std::string whole = directory_ / "whole.csv";
  const Outcome outcome = run_program(joined({arguments(), {"-o", whole}}));
  const json told = without_run(directory_ / "whole.meta.json");
  for (const std::size_t n : {1U, 3U, 7U}) {
    std::string rows(header_of(text_of(whole)));
    rows += '\n';
    std::size_t first = 1;
    for (std::size_t k = 1; k <= n; ++k) {
      const Outcome one = part(k, n);
      ASSERT_EQ(one.code, 0) << one.err;
      const json said = without_run(directory_ / ("p" + std::to_string(k) + ".meta.json"));
      EXPECT_EQ(said["part"]["number"], k);
      EXPECT_EQ(said["part"]["of"], n);
      EXPECT_EQ(said["part"]["first_row"], first);
      first += said["rows"].get<std::size_t>();
      const std::string text = text_of(part_name(k));
      rows += text.substr(text.find('\n') + 1);
    }
    EXPECT_TRUE(rows == text_of(whole)) << n;
    // In whatever order they are named.
    Words named = parts(n);
    std::ranges::reverse(named);
    const std::string merged = directory_ / "merged.csv";
    const Words merge = GetParam().arguments;
    const Outcome all = run_program(joined({merge, {"--merge"}, named, {"-o", merged}}));
    EXPECT_EQ(all.code, outcome.code) << all.err;
    EXPECT_EQ(all.err, outcome.err);
    EXPECT_TRUE(text_of(merged) == text_of(whole)) << n;
    EXPECT_EQ(without_run(directory_ / "merged.meta.json"), told) << n;
    const json run = json::parse(text_of(directory_ / "merged.meta.json"))["run"];
    EXPECT_EQ(run["parts"], n);
  }
}

TEST_P(Parts, AsColumnFilesToo) {
  NEEDS_HDF5();
  for (const char* const name : {"whole.h5", "whole.csv"})
    (void)run_program(joined({arguments(), {"-o", directory_ / name}}));
  columnar_ = true;
  for (std::size_t k = 1; k <= 3; ++k) ASSERT_EQ(part(k, 3).code, 0);
  for (const std::string suffix : {".h5", ".csv"}) {
    const std::string merged = directory_ / ("merged" + suffix);
    const Outcome outcome =
        run_program(joined({GetParam().arguments, {"--merge"}, parts(3), {"-o", merged}}));
    EXPECT_TRUE(text_of(merged) == text_of(directory_ / ("whole" + suffix)))
        << suffix << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Parts,
    ::testing::Values(
        Shared{"NuIsX", joined({map_words, set("map.x.count=61"), set("map.y.count=40")})},
        Shared{"NuIsY", joined({map_words, set("map.y={parameter=\"nu\",from=0.0,to=1.5,count=61}"),
                                set("map.x={parameter=\"body.J.1\",from=0.3,to=3.0,count=40}")})},
        Shared{"NoNu",
               joined({map_words, set("map.x={parameter=\"body.J.0\",from=0.5,to=2.0,count=45}"),
                       set("map.y={parameter=\"body.J.1\",from=0.3,to=3.0,count=33}")})},
        Shared{"OneAxis",
               {"map", shipped("disc.toml"), "--set",
                "map.x={parameter=\"nu\",from=0.0,to=1.5,count=1201}"}},
        Shared{"NothingIsSolved",
               {"map", shipped("disc.toml"), "--set",
                "map.x={parameter=\"nu\",from=1.5,to=2,count=5}"}},
        Shared{"SingleCells",
               {"map", shipped("tilted.toml"), "--set",
                "map.x={parameter=\"nu\",from=1.06,to=1.1,count=5}", "--set",
                "map.y={parameter=\"body.J.1\",from=1.69,to=1.71,count=3}"}},
        Shared{"Study", {"study", shipped("disc.toml")}}),
    [](const auto& of) { return of.param.name; });

class Merging : public ::testing::Test {
 protected:
  Outcome part(const std::string& name, const std::string& share, Words more = {}) const {
    return run_program(
        joined({map_words, count_, more, {"--part", share, "-o", directory_ / name}}));
  }
  void refused(Words names, const std::string& words, Words more = {}) const {
    Words paths;
    for (const std::string& each : names) paths.push_back(directory_ / each);
    const std::string out = directory_ / "merged.csv";
    const Outcome outcome =
        run_program(joined({map_words, count_, more, {"--merge"}, paths, {"-o", out}}));
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_FALSE(std::filesystem::exists(out));
  }

  TemporaryDirectory directory_;
  Words count_{"--set", "map.x.count=13", "--set", "map.y.count=9"};
};

TEST_F(Merging, RefusesWhatIsNoWhole) {
  ASSERT_EQ(part("a.csv", "1/3").code, 0);
  ASSERT_EQ(part("b.csv", "2/3").code, 0);
  ASSERT_EQ(part("c.csv", "3/3").code, 0);
  ASSERT_EQ(part("d.csv", "2/2").code, 0);
  ASSERT_EQ(part("e.csv", "2/3", set("body.J.1=1.9")).code, 0);
  ASSERT_EQ(part("f.csv", "2/3", {"--certify"}).code, 0);
  refused({"a.csv", "c.csv"}, "found no part 2/3");
  refused({"a.csv", "b.csv"}, "found no part 3/3");
  refused({"a.csv", "b.csv", "b.csv", "c.csv"}, "b.csv (part 2/3) twice");
  refused({"a.csv", "d.csv", "c.csv"}, "d.csv (part 2/2) beside");
  refused({"a.csv", "e.csv", "c.csv"}, "found another case than that of");
  refused({"a.csv", "f.csv", "c.csv"}, "found another case than that of");
  refused({"a.csv", "b.csv", "c.csv"}, "found parts of another case", set("body.J.1=1.9"));
  refused({"a.csv", "none.csv"}, "cannot read");
  const Outcome whole = run_program(joined({map_words, count_, {"-o", directory_ / "w.csv"}}));
  ASSERT_EQ(whole.code, 0);
  refused({"w.csv"}, "does not say which part it is of");
  const std::string text = text_of(directory_ / "b.csv");
  directory_.file("b.csv", text.substr(0, text.size() - 20));
  refused({"a.csv", "b.csv", "c.csv"}, "b.csv:40:1: found 39 cells");
  std::string changed = text;
  const std::size_t digit = changed.find_last_of("12345678");
  changed[digit] = static_cast<char>(changed[digit] + 1);
  directory_.file("b.csv", changed);
  refused({"a.csv", "b.csv", "c.csv"}, "was changed since it was written");
}

TEST_F(Merging, RefusesPartsOfNothing) {
  for (const char* share : {"0/3", "4/3", "1", "a/b", "1/0", ""}) {
    const Outcome outcome = part("a.csv", share);
    EXPECT_EQ(outcome.code, 2) << share;
    EXPECT_THAT(outcome.err, HasSubstr("--part")) << share;
  }
  EXPECT_EQ(run_program(joined({map_words, count_, {"--part", "1/2"}})).code, 2);
  EXPECT_EQ(run_program(joined({map_words, count_, {"--part", "1/2", "-o", "-"}})).code, 2);
  EXPECT_EQ(run_program(joined({map_words, {"--merge", "a.csv"}})).code, 2);
  EXPECT_EQ(run_program(joined({map_words, {"--merge", "a.csv", "--part", "1/2"}})).code, 2);
  EXPECT_THAT(directory_.names(), IsEmpty());
}

TEST_F(Merging, ReplacesNoPart) {
  ASSERT_EQ(part("a.csv", "1/1").code, 0);
  const std::string text = text_of(directory_ / "a.csv");
  const Outcome outcome = run_program(
      joined({map_words, count_, {"--merge", directory_ / "a.csv", "-o", directory_ / "a.csv"}}));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is a part"));
  EXPECT_TRUE(text_of(directory_ / "a.csv") == text);
}

/// x.csv, x.h5 and x have one x.meta.json.
TEST_F(Merging, ReplacesNoPartsMetadata) {
  ASSERT_EQ(part("a.csv", "1/1").code, 0);
  const std::string told = text_of(directory_ / "a.meta.json");
  for (const char* const name : {"a", "a.h5"}) {
    const Outcome outcome = run_program(
        joined({map_words, count_, {"--merge", directory_ / "a.csv", "-o", directory_ / name}}));
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr("a.meta.json is the metadata of "));
    EXPECT_THAT(outcome.err, HasSubstr("a.csv, a part"));
  }
  EXPECT_TRUE(text_of(directory_ / "a.meta.json") == told);
}

TEST_F(Merging, RefusesPartsOfAnotherCommand) {
  ASSERT_EQ(part("map.csv", "1/1").code, 0);
  const std::string over = directory_.file("t.csv", "motion.nu\n0.3\n");
  const Words study{"study", shipped("map_biot_log.toml")};
  const Words atlas = joined({{"atlas", "--grid", shipped("apart.toml"), "--checkpoints", "2"},
                              set("map.x={parameter=\"body.J.1\",from=1.2,to=1.8,count=2}")});
  ASSERT_EQ(
      run_program(
          joined({study, {"--over", over, "--part", "1/1"}, {"-o", directory_ / "study.csv"}}))
          .code,
      0);
  ASSERT_EQ(run_program(joined({atlas, {"--part", "1/1", "-o", directory_ / "atlas.csv"}})).code,
            0);
  const std::pair<std::string, Words> commands[] = {
      {"map", joined({map_words, count_})}, {"study", study}, {"atlas", atlas}};
  for (const auto& [name, words] : commands) {
    for (const auto& [other, unused] : commands) {
      if (name == other) continue;
      const Outcome outcome = run_program(joined(
          {words, {"--merge", directory_ / (other + ".csv"), "-o", directory_ / "merged.csv"}}));
      EXPECT_EQ(outcome.code, 2) << name << " of " << other << ": " << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr("found a part of the command \"" + other + "\""));
    }
  }
}

TEST_F(Merging, RefusesPartsOfAnotherVersion) {
  const std::string over = directory_.file("t.csv", "motion.nu\n0.3\n");
  const Words study{"study", shipped("disc.toml")};
  ASSERT_EQ(part("map.csv", "1/1").code, 0);
  ASSERT_EQ(run_program(
                joined({study, {"--over", over, "--part", "1/1", "-o", directory_ / "study.csv"}}))
                .code,
            0);
  const std::pair<std::string, Words> commands[] = {{"map", joined({map_words, count_})},
                                                    {"study", study}};
  for (const auto& [name, words] : commands) {
    const std::string metadata = name + ".meta.json";
    const json own = json::parse(text_of(directory_ / metadata));
    for (const auto& [key, value, said] :
         {std::tuple{"version", json("0.0.1"), "what version \"0.0.1\" wrote"},
          {"schema", json(1), "metadata of schema 1"}}) {
      json changed = own;
      changed[key] = value;
      directory_.file(metadata, changed.dump());
      const Outcome outcome = run_program(joined(
          {words, {"--merge", directory_ / (name + ".csv"), "-o", directory_ / "merged.csv"}}));
      EXPECT_EQ(outcome.code, 2) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(said));
    }
  }
}

/// Messages in the table name the files, so they are to be spelled alike; which are not is told.
TEST_F(Merging, RefusesAStudysFilesInTwoSpellings) {
  const std::string over = directory_.file("t.csv", "motion.nu\n0.3\n0.4\n");
  const auto study = [&](const std::string& of, const std::string& share, const std::string& name) {
    return run_program(
        {"study", shipped("disc.toml"), "--over", of, "--part", share, "-o", directory_ / name});
  };
  ASSERT_EQ(study(over, "1/2", "a.csv").code, 0);
  ASSERT_EQ(study(directory_ / "./t.csv", "2/2", "b.csv").code, 0);
  const Outcome merged =
      run_program({"study", shipped("disc.toml"), "--merge", directory_ / "a.csv",
                   directory_ / "b.csv", "-o", directory_ / "merged.csv"});
  EXPECT_EQ(merged.code, 2);
  EXPECT_THAT(merged.err, HasSubstr("found --over \"" + (directory_ / "./t.csv") + "\" beside"));
}

TEST_F(Merging, AMissingPartIsNamedAsItWasGiven) {
  const Outcome outcome = run_program(joined(
      {map_words, count_, {"--merge", directory_ / "none", "-o", directory_ / "merged.csv"}}));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("cannot read " + (directory_ / "none") + ";"));
}

/// The case of a whole is that of its parts, with what an option added to it.
TEST_F(Merging, ProvenRowsOfAStudyAreNotAskedForAgain) {
  const std::string over = directory_.file("t.csv", "motion.nu\n0.3\n0.4\n");
  const Words study{"study", shipped("disc.toml")};
  const Words parts{directory_ / "a.csv", directory_ / "b.csv"};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string share = std::to_string(k + 1) + "/2";
    const Outcome one = run_program(
        joined({study, {"--over", over, "--certify", "--part", share, "-o", parts[k]}}));
    ASSERT_EQ(one.code, 0) << one.err;
  }
  const Outcome all =
      run_program(joined({study, {"--merge"}, parts, {"-o", directory_ / "merged.csv"}}));
  EXPECT_EQ(all.code, 0) << all.err;
  for (const char* const name : {"a.meta.json", "merged.meta.json"})
    EXPECT_EQ(json::parse(text_of(directory_ / name))["case"]["output"]["certificate"], true);
}

TEST_F(Merging, MorePartsThanCells) {
  count_ = {"--set", "map.x.count=2", "--set", "map.y.count=2"};
  Words names;
  for (int k = 1; k <= 7; ++k) {
    const std::string name = "p" + std::to_string(k) + ".csv";
    ASSERT_EQ(part(name, std::to_string(k) + "/7").code, 0);
    names.push_back(directory_ / name);
  }
  const std::string merged = directory_ / "merged.csv";
  ASSERT_EQ(run_program(joined({map_words, count_, {"--merge"}, names, {"-o", merged}})).code, 0);
  EXPECT_EQ(rows_of(text_of(merged)).size(), 4U);
}

/// A part goes on where it was interrupted, as a whole does.
TEST_F(Merging, AnInterruptedPartIsResumed) {
  count_ = {"--set", "map.x.count=201", "--set", "map.y.count=90"};
  ASSERT_EQ(part("a.csv", "2/2").code, 0);
  const std::string whole = text_of(directory_ / "a.csv");
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  const Words words = joined({map_words, count_, {"--part", "2/2", "-o", directory_ / "b.csv"}});
  EXPECT_EQ(run_program(words, interrupted).code, 130);
  refused({"b.csv"}, "interrupted");
  EXPECT_EQ(run_program(joined({words, {"--resume"}})).code, 0);
  EXPECT_TRUE(text_of(directory_ / "b.csv") == whole);
}

}  // namespace
}  // namespace stationary::testing
