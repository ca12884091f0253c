// `study` from outside: its rows against those of the commands it runs, bad rows, what is refused, the
// journal, threads, formats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "solver/program/table/column_file.hpp"
#include "tests/program/json_schema.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class Study : public ::testing::Test {
 protected:
  Outcome run(const std::string& table, std::vector<std::string> more = {},
              const RunOptions& options = {}) const {
    const std::string over = directory_.file("t.csv", table);
    std::vector<std::string> arguments{"study", case_file_, "--over", over, "-o", out_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments, options);
  }
  std::vector<Row> rows() const { return rows_of(text_of(out_)); }
  json metadata() const { return json::parse(text_of(directory_ / "x.meta.json")); }

  TemporaryDirectory directory_;
  std::string case_file_ = directory_.file("case.toml", std::string(good_case) + R"(
[continuation]
from = 0.0
to = 1.5
tolerance = 1e-6
)");
  std::string out_ = directory_ / "x.csv";
  std::string journal_ = directory_ / "x.csv.journal";
};

const char* const materials = R"(_name,motion.nu,potential.plane.mu
plain,0.3,1.5
"b, in ""quotes""",0.4,
wrong,fast,1.0
outside,0.3,-1.0
far,30,1.0
)";

TEST_F(Study, RowsAreThoseOfSolve) {
  const Outcome outcome = run(materials, {"--do", "solve"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<Row> found = rows();
  ASSERT_EQ(found.size(), 5U);
  EXPECT_THAT(std::string(header_of(text_of(out_))),
              StartsWith("study_row,_name,motion.nu,potential.plane.mu,status,message,branch,sheet,"
                         "point,nu1,"));
  const std::vector<std::vector<std::string>> set{
      {"--set", "motion.nu=0.3", "--set", "potential.plane.mu=1.5"}, {"--set", "motion.nu=0.4"}};
  for (std::size_t k = 0; k < set.size(); ++k) {
    std::vector<std::string> arguments{"solve", case_file_, "-o", "-"};
    arguments.insert(arguments.end(), set[k].begin(), set[k].end());
    for (const auto& [column, cell] : only_row(run_program(arguments).out))
      EXPECT_EQ(found[k].at(column), cell) << column;
    EXPECT_EQ(found[k].at("status"), "solved");
    EXPECT_EQ(found[k].at("study_row"), std::to_string(k + 1));
  }
  EXPECT_EQ(found[1].at("_name"), "b, in \"quotes\"");
  EXPECT_EQ(found[1].at("potential.plane.mu"), "");
}

TEST_F(Study, ABadRowIsARowWithItsReason) {
  const Outcome outcome = run(materials);
  EXPECT_EQ(outcome.code, 0);
  const std::vector<Row> found = rows();
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[2].at("status"), "bad-input");
  EXPECT_EQ(found[2].at("message"), directory_ / "t.csv" +
                                        ":4:7: motion.nu: found the string "
                                        "\"fast\"; expected a finite number (the spin along the "
                                        "branch's axis; |nu| in \"tilted\", \"oblique\")");
  EXPECT_EQ(found[3].at("status"), "bad-input");
  EXPECT_THAT(found[3].at("message"), HasSubstr("mu > 0"));
  EXPECT_EQ(found[4].at("status"), "none");
  EXPECT_THAT(found[4].at("message"), Not(IsEmpty()));
  for (const std::size_t k : {2U, 3U, 4U}) EXPECT_EQ(found[k].at("xi"), "");
  EXPECT_THAT(outcome.err, HasSubstr("2 of 5 rows failed, the first of them row 3: "));
  EXPECT_THAT(outcome.out, HasSubstr("2 solved, 1 none, 2 bad-input"));
  const json told = metadata();
  EXPECT_EQ(told["counts"]["bad-input"], 2);
  EXPECT_EQ(told["study"]["do"], "solve");
  EXPECT_EQ(told["study"]["rows"], 5);
  EXPECT_EQ(told["status"], "done");
  EXPECT_EQ(schema_fault(told, json::parse(text_of(STATIONARY_SCHEMA))), "");
}

/// A study of what another run wrote, under its name but for the suffix.
TEST_F(Study, ReplacesNoMetadataOfItsTable) {
  const std::string over = directory_.file("t.csv", "motion.nu\n0.3\n");
  const std::string told = directory_.file("t.meta.json", "{}\n");
  const Outcome outcome =
      run_program({"study", shipped("disc.toml"), "--over", over, "-o", directory_ / "t.h5"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("t.csv, the table of --over"));
  EXPECT_EQ(text_of(told), "{}\n");
  // Nor the table itself, where it is named as they are.
  const std::string table = directory_.file("u.meta.json", "motion.nu\n0.3\n");
  const Outcome own =
      run_program({"study", shipped("disc.toml"), "--over", table, "-o", directory_ / "u.csv"});
  EXPECT_EQ(own.code, 2);
  EXPECT_THAT(own.err, HasSubstr("u.meta.json is the table of --over"));
  EXPECT_EQ(text_of(table), "motion.nu\n0.3\n");
}

TEST_F(Study, FourOnlyWhereAllFail) {
  EXPECT_EQ(run("motion.nu\nfast\nslow\n").code, 4);
  EXPECT_EQ(rows().size(), 2U);
  EXPECT_EQ(run("motion.nu\nfast\n30\n").code, 0);
  EXPECT_EQ(run("motion.nu\n30\n").code, 0);
}

TEST_F(Study, RefusesATableOfOtherThings) {
  const auto refused = [&](const std::string& table, const std::string& words) {
    const Outcome outcome = run(table);
    EXPECT_EQ(outcome.code, 2) << table;
    EXPECT_THAT(outcome.err, HasSubstr(words)) << table;
    EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "t.csv"));
  };
  refused("motion.nuu\n0.3\n", "did you mean \"motion.nu\"");
  refused("nu\n0.3\n", "names no key of a case");
  refused("output.columns\n1\n", "--set");
  refused("motion.nu,motion.nu\n1,2\n", "twice");
  refused("body.J.1,body.J\n1.1,\"[1,1.7,0.6]\"\n", "replaces what \"body.J.1\" sets");
  refused("motion.nu\n", "no rows");
  refused("motion.nu\n1,2\n", "2 cells");
  EXPECT_EQ(run("motion.nu\n0.3\n", {"--do", "nothing"}).code, 2);
  EXPECT_EQ(run_program({"study", case_file_}).code, 2);
}

/// What no row puts right is refused before anything is computed.
/// Its cells go into a table of CSV, or of HDF5 whose texts a NUL ends.
TEST_F(Study, TakesTextsOfOneLineInUtf8) {
  const struct {
    std::string table;
    const char* fault;
  } all[] = {
      {"\"_a\nb\",motion.nu\nx,0.3\n", "t.csv:1:1: _a\\x0Ab: found a column's name of two lines"},
      {"_m,motion.nu\ngr\xf6\xdf,0.3\n", "t.csv:2:1: _m: found bytes that are no UTF-8"},
      {std::string("_m,motion.nu\nb,0.2\na\0b,0.3\n", 28), "t.csv:3:1: _m: found a NUL byte"}};
  for (const auto& [table, fault] : all) {
    const Outcome outcome = run(table);
    EXPECT_EQ(outcome.code, 2) << fault;
    EXPECT_THAT(outcome.err, HasSubstr(fault));
  }
  ASSERT_EQ(run("_m,motion.nu\n\"gr\u00f6\u00df\ne\",0.3\n").code, 0);
  EXPECT_THAT(text_of(out_), HasSubstr("\"gr\u00f6\u00df\ne\",0.3,solved"));
}

TEST_F(Study, WhatIsWrongWithTheCaseIsNoRowsFault) {
  for (const char* const wrong : {"foo=1", "body.J.0=-1", "output.columns=[\"nothing\"]"}) {
    const Outcome outcome = run("motion.nu\n0.3\n0.4\n", {"--set", wrong});
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr(wrong)) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out_));
  }
  EXPECT_EQ(run("body.J.0\n1.0\n\n", {"--set", "body.J.0=-1"}).code, 0);
  EXPECT_EQ(run("body.J.0\n-2\n1.0\n", {"--set", "body.J.0=-1"}).code, 0);
}

TEST_F(Study, WithoutATableOfRowsSaysWhatIsMissing) {
  const Outcome outcome = run_program({"study", case_file_, "--do", "solve", "-o", out_});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("study: found no table of rows; expected --over TABLE"));
}

TEST_F(Study, RefusesOptionsOfAnotherTask) {
  const std::string table = "motion.nu\n0.3\n";
  for (const char* const task : {"solve", "continue"})
    EXPECT_EQ(run(table, {"--do", task, "--checkpoints", "3"}).code, 2);
  for (const char* const task : {"continue", "atlas"}) {
    const Outcome outcome = run(table, {"--do", task, "--certify"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("expected --do solve"));
  }
}

TEST_F(Study, ConditionsOfADomainNeedNoQuotes) {
  case_file_ = directory_.file("case.toml", text_of(shipped("elastic_sphere.toml")));
  ASSERT_EQ(run("potential.coupled.domain\nrho > 0.2\n0.2 < rho\n\"[\"\"0.2 < rho\"\", \"\"xi < "
                "9\"\"]\"\n")
                .code,
            0);
  for (const Row& row : rows()) EXPECT_EQ(row.at("status"), "solved") << row.at("message");
}

TEST_F(Study, OverVolumesHasTheirPressures) {
  std::string text = text_of(shipped("isochoric.toml"));
  const std::size_t at = text.find("volume");
  text.erase(at, text.find('\n', at) - at);
  case_file_ = directory_.file("case.toml", text);
  ASSERT_EQ(run("body.volume\n1.0\n1.1\n").code, 0);
  for (const Row& row : rows())
    EXPECT_EQ(row.at("pressure"),
              only_row(run_program({"solve", case_file_, "--set",
                                    "body.volume=" + row.at("body.volume"), "-o", "-"})
                           .out)
                  .at("pressure"));
}

TEST_F(Study, ColumnsThatAreNoPathsAreNoHdf5) {
  NEEDS_HDF5();
  out_ = directory_ / "x.h5";
  for (const char* names : {"_L,_L/D", "_L/D,_L", "_L//D,_M", "_L/,_M"}) {
    const Outcome outcome = run(std::string(names) + ",motion.nu\n1,2,0.3\n");
    EXPECT_EQ(outcome.code, 2) << names;
    EXPECT_THAT(outcome.err, HasSubstr("write CSV")) << names;
    EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "t.csv")) << names;
  }
  EXPECT_EQ(run("_L/D,_L/E,motion.nu\n1,2,0.3\n").code, 0);
}

TEST_F(Study, ReadsAPipe) {
  const std::string pipe = directory_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "motion.nu\n0.3\n"; });
  const Outcome outcome = run_program({"study", case_file_, "--over", pipe, "-o", out_});
  writer.join();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(rows().size(), 1U);
}

TEST_F(Study, TextsNeedNoQuotes) {
  ASSERT_EQ(run("motion.branch,potential.plane.model,solve.method,title\n"
                "ii,hencky,newton,a title\n"
                "i,neo-hookean,auto,\n")
                .code,
            0);
  EXPECT_EQ(rows()[0].at("branch"), "ii");
  EXPECT_EQ(rows()[0].at("status"), "solved") << rows()[0].at("message");
  EXPECT_EQ(rows()[1].at("branch"), "i");
}

/// The material without its own numbers in the case: rows give them.
TEST_F(Study, ACaseThatIsOneOnlyWithARow) {
  directory_.file("case.toml", R"([body]
J = [1.0, 1.7, 0.6]
[potential]
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[potential.plane]
model = "neo-hookean"
mu = 1.0
[motion]
branch = "i"
)");
  ASSERT_EQ(run("motion.nu,potential.plane.lambda\n0.3,2.0\n").code, 0);
  EXPECT_EQ(rows()[0].at("status"), "solved") << rows()[0].at("message");
  EXPECT_TRUE(metadata()["case"].is_null());
  EXPECT_EQ(schema_fault(metadata(), json::parse(text_of(STATIONARY_SCHEMA))), "");
}

TEST_F(Study, ManySolutionsOfARow) {
  const std::string over = directory_.file("t.csv", "_tag,motion.nu\na,\nb,1.2\n");
  const Outcome outcome = run_program(
      {"study", shipped("apart.toml"), "--over", over, "-o", out_, "--set", "solve.all=true"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Outcome alone =
      run_program({"solve", shipped("apart.toml"), "-o", "-", "--set", "solve.all=true"});
  const std::size_t solutions = rows_of(alone.out).size();
  ASSERT_GE(solutions, 2U);
  ASSERT_EQ(rows().size(), solutions + 1);
  EXPECT_EQ(rows()[solutions - 1].at("study_row"), "1");
  EXPECT_EQ(rows()[solutions].at("study_row"), "2");
  EXPECT_EQ(rows()[solutions].at("status"), "none");
  EXPECT_EQ(metadata()["counts"]["solved"], 1);
}

TEST_F(Study, ContinueIsToldInARow) {
  const std::string over = directory_.file("t.csv", "body.J.1\n1.7\n1.2\n");
  ASSERT_EQ(
      run_program({"study", shipped("fold.toml"), "--over", over, "--do", "continue", "-o", out_})
          .code,
      0);
  const std::string one = directory_ / "one.csv";
  for (const Row& row : rows()) {
    ASSERT_EQ(run_program({"continue", shipped("fold.toml"), "-o", one, "--set",
                           "body.J.1=" + row.at("body.J.1")})
                  .code,
              0);
    const json told = json::parse(text_of(directory_ / "one.meta.json"));
    EXPECT_EQ(row.at("sheets"), "1");
    EXPECT_EQ(row.at("events"), std::to_string(told["events"].size()));
    EXPECT_EQ(row.at("complete_fraction"), "");
    std::map<std::string, std::pair<long, double>> events;
    double first = 1e300;
    for (const json& each : told["events"]) {
      auto& [count, least] = events.try_emplace(each["event"], 0, 1e300).first->second;
      ++count;
      least = std::min(least, each["parameter"].get<double>());
      first = std::min(first, least);
    }
    EXPECT_FALSE(events.empty());
    EXPECT_EQ(number(row.at("first_event")), first);
    for (const auto& [name, of] : events) {
      EXPECT_EQ(row.at(name + "_count"), std::to_string(of.first)) << name;
      EXPECT_EQ(number(row.at(name + "_first")), of.second) << name;
    }
    double instability = 1e300;
    const json& segments = told["segments"];
    const auto calm = [](const json& s) {
      return s["class"] == "stable" || s["class"] == "elliptic";
    };
    const auto bad = [](const json& s) {
      return s["class"] == "unstable" || s["class"] == "oscillatory";
    };
    for (std::size_t k = 1; k < segments.size(); ++k) {
      if (calm(segments[k - 1]) && bad(segments[k]))
        instability = std::min(instability, segments[k - 1]["to"]["parameter"].get<double>());
      if (bad(segments[k - 1]) && calm(segments[k]))
        instability = std::min(instability, segments[k]["from"]["parameter"].get<double>());
    }
    if (instability < 1e300) {
      EXPECT_EQ(number(row.at("first_instability")), instability);
    } else {
      EXPECT_EQ(row.at("first_instability"), "");
    }
  }
}

TEST_F(Study, AtlasIsToldInARow) {
  const std::string over = directory_.file("t.csv", "continuation.to\n1.0\n1.1\n");
  ASSERT_EQ(run_program({"study", shipped("apart.toml"), "--over", over, "--do", "atlas",
                         "--checkpoints", "3", "-o", out_})
                .code,
            0);
  const std::string one = directory_ / "one.csv";
  for (const Row& row : rows()) {
    EXPECT_EQ(row.at("status"), "solved") << row.at("message");
    ASSERT_EQ(run_program({"atlas", shipped("apart.toml"), "--checkpoints", "3", "-o", one, "--set",
                           "continuation.to=" + row.at("continuation.to")})
                  .code,
              0);
    const json told = json::parse(text_of(directory_ / "one.meta.json"));
    EXPECT_EQ(row.at("sheets"), std::to_string(told["sheets"].size()));
    EXPECT_EQ(row.at("events"), std::to_string(told["events"].size()));
    long complete = 0;
    for (const json& at : told["checkpoints"]) complete += at["complete"].get<bool>();
    EXPECT_EQ(number(row.at("complete_fraction")),
              static_cast<double>(complete) / static_cast<double>(told["checkpoints"].size()));
  }
}

/// So many rows that tiles end out of order.
std::string many_rows() {
  std::ostringstream out;
  out << "motion.nu,_tag\n";
  for (int k = 0; k < 200; ++k)
    out << 0.005 * k << (k % 17 == 3 ? "x" : "") << ",\"t, " << k << "\"\n";
  return out.str();
}

TEST_F(Study, ThreadsDoNotChangeIt) {
  ASSERT_EQ(run(many_rows(), {"--threads", "1"}).code, 0);
  const std::string one = text_of(out_);
  json told = metadata();
  ASSERT_EQ(run(many_rows(), {"--threads", "4"}).code, 0);
  EXPECT_TRUE(text_of(out_) == one);
  json again = metadata();
  for (json* each : {&told, &again}) each->erase("run");
  EXPECT_EQ(told, again);
  EXPECT_EQ(rows().size(), 200U);
  EXPECT_EQ(rows()[3].at("status"), "bad-input");
  EXPECT_THAT(directory_.names(), Not(Contains("x.csv.journal")));
}

#ifdef STATIONARY_HAS_HDF5
/// What is empty in a column of whole numbers is one of them in HDF5, which the column says.
TEST_F(Study, CountsOfAColumnFileSayWhatIsMissing) {
  const std::string over = directory_.file("t.csv", "motion.nu\n0.3\n");
  const std::string out = directory_ / "x.h5";
  ASSERT_EQ(run_program({"study", shipped("disc.toml"), "--over", over, "-o", out}).code, 0);
  const hid_t file = H5Fopen(out.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_GT(H5Aexists_by_name(file, "krein1", "_FillValue", H5P_DEFAULT), 0);
  EXPECT_LE(H5Aexists_by_name(file, "xi", "_FillValue", H5P_DEFAULT), 0);
  H5Fclose(file);
}
#endif

TEST_F(Study, ColumnFileHoldsTheSame) {
  NEEDS_HDF5();
  ASSERT_EQ(run(materials).code, 0);
  const std::string csv = text_of(out_);
  const std::string file = directory_ / "x.h5";
  const std::string over = directory_ / "t.csv";
  ASSERT_EQ(run_program({"study", case_file_, "--over", over, "-o", file}).code, 0);
  const auto stream = column_file_table(file, {});
  const auto found = rows_of({std::istreambuf_iterator<char>(*stream), {}});
  const auto expected = rows_of(csv);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    // Numbers too, as they were spelled.
    for (const auto& [column, cell] : expected[k])
      EXPECT_EQ(found[k].at(column), cell) << column << " " << k;
  }
  EXPECT_EQ(json::parse(column_file_metadata(file))["study"]["rows"], 5);
}

TEST_F(Study, StandardOutputTakesTheTableAlone) {
  const std::string over = directory_.file("t.csv", materials);
  const Outcome outcome = run_program({"study", case_file_, "--over", over, "-o", "-"});
  ASSERT_EQ(run(materials).code, 0);
  EXPECT_EQ(outcome.out, text_of(out_));
}

TEST_F(Study, InterruptedItKeepsItsJournal) {
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  const Outcome outcome = run(many_rows(), {}, interrupted);
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("--resume"));
  EXPECT_THAT(outcome.out, HasSubstr("rows          " + std::to_string(rows().size()) + ": "));
  EXPECT_THAT(text_of(journal_), StartsWith("stationary journal 2 "));
  EXPECT_LT(rows().size(), 200U);
  EXPECT_EQ(metadata()["status"], "interrupted");
  ASSERT_EQ(run(many_rows(), {"--resume"}).code, 0);
  const std::string found = text_of(out_);
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "t.csv", "x.csv", "x.meta.json"));
  ASSERT_EQ(run(many_rows()).code, 0);
  EXPECT_TRUE(text_of(out_) == found);
}

/// A full disk in the middle of the journal: its last record is cut short.
TEST_F(Study, ResumedItIsWhatItWouldHaveBeen) {
  ASSERT_EQ(run(many_rows()).code, 0);
  const std::string whole = text_of(out_);
  std::filesystem::remove(out_);
  RunOptions full;
  full.file_size_limit = static_cast<long>(whole.size() / 2);
  EXPECT_EQ(run(many_rows(), {"--threads", "1"}, full).code, 4);
  const std::string kept = text_of(journal_);
  ASSERT_GT(kept.size(), whole.size() / 4);
  EXPECT_FALSE(std::filesystem::exists(out_));
  for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, std::size_t{700}}) {
    std::ofstream(journal_, std::ios::binary) << kept.substr(0, kept.size() - cut);
    const Outcome outcome = run(many_rows(), {"--resume", "--threads", "2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(text_of(out_) == whole) << cut;
  }
}

/// The finished rows are taken from the journal and not computed again.
TEST_F(Study, ResumingComputesNoRowTwice) {
  RunOptions full;
  full.file_size_limit = 30000;
  ASSERT_EQ(run(many_rows(), {"--threads", "1"}, full).code, 4);
  const std::string kept = text_of(journal_);
  RunOptions interrupted;  // nothing is begun
  interrupted.pending_signal = SIGINT;
  ASSERT_EQ(run(many_rows(), {"--resume"}, interrupted).code, 130);
  EXPECT_GT(text_of(journal_).size(), kept.size() / 2);
  ASSERT_EQ(run(many_rows(), {"--resume"}).code, 0);
  EXPECT_EQ(rows().size(), 200U);
}

TEST_F(Study, ResumesNothingElse) {
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  const auto refused = [&](const std::string& table, std::vector<std::string> more,
                           const std::string& words) {
    more.emplace_back("--resume");
    const Outcome outcome = run(table, more);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
  };
  refused(many_rows(), {}, "found no ");
  ASSERT_EQ(run(many_rows(), {}, interrupted).code, 130);
  const std::string kept = text_of(journal_);
  refused(materials, {}, "of another case");
  refused(many_rows(), {"--do", "continue"}, "of another case");
  refused(many_rows(), {"--set", "body.J.1=1.8"}, "of another case");
  EXPECT_EQ(text_of(journal_), kept);
  const Outcome nowhere =
      run_program({"study", case_file_, "--over", directory_ / "t.csv", "--resume"});
  EXPECT_EQ(nowhere.code, 2);
}

}  // namespace
}  // namespace stationary::testing
