// `atlas --grid` from outside: a row a cell, against `atlas` of each cell; the cells' own tables; what is
// refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

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

class AtlasGrid : public ::testing::Test {
 protected:
  Outcome grid(const Words& more, const RunOptions& options = {}) const {
    Words words = words_;
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, options);
  }
  std::string text(const std::string& name) const { return text_of(directory_ / name); }

  TemporaryDirectory directory_;
  Words words_{"atlas",
               shipped("apart.toml"),
               "--grid",
               "--checkpoints",
               "3",
               "--set",
               "map.x={parameter=\"body.J.1\",from=1.2,to=1.8,count=3}",
               "--set",
               "map.y={parameter=\"potential.plane.lambda\",from=0.5,to=0.7,count=2}"};
};

#ifdef STATIONARY_HAS_HDF5
TEST_F(AtlasGrid, EachRowIsAnAtlas) {
  const Outcome outcome = grid({"-o", directory_ / "g.csv", "--tables", directory_ / "t.h5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(std::string(header_of(text("g.csv"))),
              StartsWith("body.J.1,potential.plane.lambda,status,sheets,events,first_instability,"
                         "first_event,complete_fraction,fold-nu_count,fold-nu_first,"));
  const auto rows = rows_of(text("g.csv"));
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[1].at("body.J.1"), "1.5");
  EXPECT_EQ(rows[4].at("potential.plane.lambda"), "0.7");
  silence_hdf5();
  const Handle file(H5Fopen((directory_ / "t.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  ASSERT_TRUE(file.valid());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string one = directory_ / "one.h5";
    const Outcome alone =
        run_program({"atlas", shipped("apart.toml"), "--checkpoints", "3", "-o", one, "--set",
                     "body.J.1=" + rows[k].at("body.J.1"), "--set",
                     "potential.plane.lambda=" + rows[k].at("potential.plane.lambda")});
    ASSERT_EQ(alone.code, 0) << alone.err;
    const json told = json::parse(text("one.meta.json"));
    EXPECT_EQ(rows[k].at("status"), told["sheets"].empty() ? "not-found" : "solved");
    EXPECT_EQ(rows[k].at("sheets"), std::to_string(told["sheets"].size()));
    EXPECT_EQ(rows[k].at("events"), std::to_string(told["events"].size()));
    // The cell's own table, dataset for dataset.
    const Handle whole(H5Fopen(one.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    for (const char* const column : {"sheet", "nu1", "xi", "re1"}) {
      const auto values = [&](hid_t in, const std::string& name) {
        const Handle set(H5Dopen2(in, name.c_str(), H5P_DEFAULT), H5Dclose);
        EXPECT_TRUE(set.valid()) << name;
        const Handle space(H5Dget_space(set.id()), H5Sclose);
        std::vector<double> out(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
        H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data());
        for (double& each : out) each = each == each ? each : -1.0;
        return out;
      };
      EXPECT_EQ(values(file.id(), "/" + std::to_string(k + 1) + "/" + column),
                values(whole.id(), column))
          << column << " of row " << k + 1;
    }
  }
  const json told = json::parse(text("g.meta.json"));
  EXPECT_EQ(schema_fault(told, json::parse(text_of(STATIONARY_SCHEMA))), "");
  EXPECT_EQ(told["command"], "atlas");
  EXPECT_EQ(told["counts"]["solved"], 6);
}
#endif

TEST_F(AtlasGrid, PartsThreadsAndInterruptionsDoNotChangeIt) {
  NEEDS_HDF5();
  ASSERT_EQ(grid({"-o", directory_ / "g.csv", "--tables", directory_ / "t.h5"}).code, 0);
  ASSERT_EQ(
      grid({"-o", directory_ / "h.csv", "--tables", directory_ / "u.h5", "--threads", "3"}).code,
      0);
  EXPECT_TRUE(text("h.csv") == text("g.csv"));
  EXPECT_TRUE(text("u.h5") == text("t.h5"));
  for (const std::string suffix : {".csv", ".h5"}) {
    Words merge{"--merge"};
    for (const char* const k : {"1", "2", "3"}) {
      const std::string name = directory_ / (std::string("p") + k + suffix);
      const std::string tables = directory_ / (std::string("t") + k + ".h5");
      ASSERT_EQ(grid({"-o", name, "--part", std::string(k) + "/3", "--tables", tables}).code, 0);
      merge.push_back(name);
      merge.insert(merge.begin() + 1, tables);
    }
    merge.insert(merge.end(), {"-o", directory_ / "m.csv", "--tables", directory_ / "n.h5"});
    const Outcome merged = grid(merge);
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_TRUE(text("m.csv") == text("g.csv")) << suffix;
    EXPECT_TRUE(text("n.h5") == text("t.h5")) << suffix;
  }
  RunOptions interrupted;
  interrupted.pending_signal = SIGINT;
  const Words into{"-o", directory_ / "i.csv", "--tables", directory_ / "j.h5"};
  const Outcome stopped = grid(into, interrupted);
  EXPECT_EQ(stopped.code, 130);
  EXPECT_THAT(stopped.out, HasSubstr("atlases"));
  EXPECT_THAT(stopped.err, HasSubstr("--resume"));
  Words resumed = into;
  resumed.emplace_back("--resume");
  ASSERT_EQ(grid(resumed).code, 0);
  EXPECT_TRUE(text("i.csv") == text("g.csv"));
  EXPECT_TRUE(text("j.h5") == text("t.h5"));
}

#ifdef STATIONARY_HAS_HDF5
TEST_F(AtlasGrid, MergesNoTablesOfOtherParts) {
  const auto part = [&](const std::string& k, const std::string& name, const Words& more = {}) {
    Words words{"--part",   k + "/2",
                "-o",       directory_ / (name + ".csv"),
                "--tables", directory_ / (name + ".h5")};
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(grid(words).code, 0);
  };
  part("1", "a");
  part("2", "b");
  part("1", "c", {"--set", "continuation.to=1.9"});
  part("2", "d", {"--set", "continuation.to=1.9"});
  const auto refused = [&](const Words& names, const std::string& words, bool into = true) {
    Words merge{"-o", directory_ / "m.csv"};
    if (into) merge.insert(merge.end(), {"--tables", directory_ / "m.h5"});
    merge.emplace_back("--merge");
    for (const std::string& each : names) merge.push_back(directory_ / each);
    const Outcome outcome = grid(merge);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_THAT(directory_.names(), Not(Contains("m.csv")));
    EXPECT_THAT(directory_.names(), Not(Contains("m.h5")));
  };
  refused({"a.csv", "b.csv"}, "found no tables of cells to merge");
  refused({"a.csv", "b.csv", "a.h5", "b.h5"}, "and no --tables", false);
  refused({"a.h5", "b.h5"}, "found no table of a part");
  refused({"a.csv", "b.csv", "a.h5"}, "found no part 2/2");
  refused({"a.csv", "b.csv", "a.h5", "a.h5"}, "twice");
  refused({"a.csv", "b.csv", "a.h5", "d.h5"}, "found another case");
  refused({"a.csv", "b.csv", "c.h5", "d.h5"}, "found tables of other parts");
  {
    // One number of one cell is another.
    silence_hdf5();
    const Handle file(H5Fopen((directory_ / "b.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    const Handle set(H5Dopen2(file.id(), "/5/xi", H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(set.id()), H5Sclose);
    std::vector<double> xi(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    ASSERT_FALSE(xi.empty());
    ASSERT_GE(H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, xi.data()), 0);
    xi.back() = std::nextafter(xi.back(), 0.0);
    ASSERT_GE(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, xi.data()), 0);
  }
  refused({"a.csv", "b.csv", "a.h5", "b.h5"}, "was changed since it was written");
}
#endif

/// At checkpoints alone there is no proof for every nu: this body has motions below the first.
TEST_F(AtlasGrid, NothingAtCheckpointsIsNoProof) {
  const std::string path = directory_.file(
      "none.toml",
      "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\nplane = { model = \"reciprocal-determinant\", c = "
      "1.0, k = 2.0 }\nthickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 "
      "}\n[motion]\n"
      "branch = \"iii\"\nnu = 1.05\n[continuation]\nfrom = 1.41\nto = 5.0\n[map]\nx = { parameter "
      "= \"body.J.2\", from = 0.6, to = 0.7, count = 2 }\n");
  const Words at_checkpoints{"atlas", path, "--grid", "--checkpoints", "4", "-o", "-"};
  const auto statuses = [](const Words& words) {
    std::vector<std::string> out;
    for (const Row& row : rows_of(run_program(words).out)) out.push_back(row.at("status"));
    return out;
  };
  EXPECT_THAT(statuses(at_checkpoints), ElementsAre("not-found", "not-found"));
  // Proven for every nu, where there is none.
  Words complete = at_checkpoints;
  complete.insert(complete.end(),
                  {"--set", "atlas.complete=true", "--set", "continuation.from=2.5"});
  EXPECT_THAT(statuses(complete), ElementsAre("none", "none"));
}

/// A sheet that is given up, or cut, is said to be, as by `continue`.
TEST_F(AtlasGrid, SaysWhichSheetsAreNotWhole) {
  const std::string stalls = directory_.file(
      "stall.toml",
      "[body]\nJ = [1.5, 1.5, 0.4]\n[potential]\nplane = { model = \"biot-log\", mu = 1.0, lambda "
      "= "
      "2.0 }\nthickness = { model = \"harmonic\", k = 2.0, rest = 1.0 }\nfibre = { k = 0.5, "
      "degrees "
      "= 45.0 }\n[motion]\nbranch = \"iii\"\nnu = 0.3\n[continuation]\nfrom = 0.0\nto = 2.5\n"
      "tolerance = 1e-6\n[map]\nx = { parameter = \"body.J.2\", from = 0.4, to = 0.41, count = 2 "
      "}\n");
  const Outcome one =
      run_program({"atlas", stalls, "--checkpoints", "3", "-o", directory_ / "one.csv"});
  EXPECT_EQ(one.code, 4);
  EXPECT_THAT(one.err, HasSubstr("was given up"));
  EXPECT_FALSE(rows_of(text("one.csv")).empty());
  const Outcome all = run_program({"atlas", stalls, "--grid", "--checkpoints", "3", "-o", "-"});
  EXPECT_EQ(all.code, 4);
  EXPECT_EQ(rows_of(all.out).size(), 2U);
  for (const Row& row : rows_of(all.out)) {
    EXPECT_EQ(row.at("status"), "failed");
    EXPECT_NE(row.at("sheets"), "");
    EXPECT_NE(row.at("message"), "");
  }
  Words few = words_;
  few.insert(few.end(), {"--set", "continuation.max_points=20", "-o", "-"});
  int cut = 0;
  for (const Row& row : rows_of(run_program(few).out))
    cut += row.at("message") == "stopped at continuation.max_points";
  EXPECT_GT(cut, 0);
}

TEST_F(AtlasGrid, RefusesWhatIsNoGrid) {
  const auto refused = [&](const Words& arguments, const std::string& words) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
  };
  const std::string file = shipped("apart.toml");
  refused({"atlas", file, "--grid"}, "[map]");
  refused({"atlas", file, "--grid", "--set", "map.x={parameter=\"nu\",from=0.1,to=1,count=3}"},
          "found \"nu\"");
  refused({"atlas", file, "--tables", "t.h5"}, "--grid");
  refused({"atlas", file, "--part", "1/2"}, "--grid");
  Words proven = words_;
  proven.emplace_back("--certify");
  refused(proven, "found it with --grid and no --tables");
  Words words = words_;
  words.insert(words.end(), {"--tables", directory_ / "t.csv"});
  refused(words, "--tables");
  EXPECT_THAT(directory_.names(), IsEmpty());
}

}  // namespace
}  // namespace stationary::testing
