// map from outside: its cells and their statuses, that threads do not matter, what is refused, what an
// interruption leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/program/diagram/map_diagram.hpp"
#include "solver/program/table/column_file.hpp"
#include "tests/program/mapped.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Map, HasARowACellInTheGridsOrder) {
  const Outcome outcome = mapped();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(header_of(outcome.out),
            "branch,point,nu1,nu2,nu3,alpha,xi,zeta,rho,lambda,mu,angle,pi1,pi2,pi3,energy,"
            "residual,compatibility,error_bound,class,growth,negative,re1,im1,krein1,re2,im2,"
            "krein2,re3,im3,krein3,re4,im4,krein4,re5,im5,krein5,status,nu,body.J.1");
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 13U * 9U);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].at("point"), std::to_string(k));
    EXPECT_NEAR(number(rows[k].at("nu")), 1.5 * static_cast<double>(k % 13) / 12.0, 1e-15);
    EXPECT_EQ(rows[k].at("nu"), rows[k].at("nu1"));
    EXPECT_NEAR(number(rows[k].at("body.J.1")),
                0.3 * std::pow(10.0, static_cast<double>(k / 13) / 8.0), 1e-15);
    const bool solved = rows[k].at("status") == "solved";
    EXPECT_EQ(rows[k].at("xi").empty(), !solved);
    EXPECT_EQ(rows[k].at("class").empty(), !solved);
  }
}

/// A cell is what solve finds at its parameters.
TEST(Map, CellsAreSolvesOfTheirOwn) {
  const auto rows = rows_of(mapped().out);
  for (const std::size_t k : {0U, 30U, 58U, 90U, 116U}) {
    const Outcome solve = run_program({"solve", map_case, "--set", "motion.nu=" + rows[k].at("nu"),
                                       "--set", "body.J.1=" + rows[k].at("body.J.1"), "-o", "-"});
    if (rows[k].at("status") != "solved") continue;
    const Row one = only_row(solve.out);
    for (const char* column : {"xi", "zeta", "rho", "class", "negative"})
      EXPECT_EQ(rows[k].at(column), one.at(column)) << k << " " << column;
  }
}

/// Columns left out cost nothing; those left in are what they are among all.
TEST(Map, ColumnsAskedForAloneAreComputed) {
  const TemporaryDirectory directory;
  const auto all = rows_of(mapped().out);
  const auto counts_with = [&](const std::string& columns, const std::vector<std::string>& same) {
    const Outcome one = mapped({"output.columns=" + columns}, {"-o", directory / "x.csv"});
    EXPECT_EQ(one.code, 0) << one.err;
    const auto rows = rows_of(text_of(directory / "x.csv"));
    EXPECT_EQ(rows.size(), all.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (const std::string& column : same)
        EXPECT_EQ(rows[k].at(column), all[k].at(column)) << k << " " << column;
    return nlohmann::json::parse(text_of(directory / "x.meta.json"))["counts"];
  };
  const auto bare = counts_with(R"(["xi","residual"])", {"xi", "residual"});
  EXPECT_EQ(bare["potentials"], 0);
  EXPECT_EQ(bare["spectra"], 0);
  const auto energy = counts_with(R"(["energy"])", {"energy"});
  EXPECT_EQ(energy["potentials"], energy["solved"]);
  EXPECT_EQ(energy["spectra"], 0);
  const auto classes = counts_with(R"(["class","negative","pi1"])", {"class", "negative", "pi1"});
  EXPECT_EQ(classes["spectra"], classes["solved"]);
  EXPECT_EQ(classes["potentials"], 0);
  EXPECT_LE(classes["scalar_spectra"], 9) << "nu = 0 alone";
  (void)counts_with(R"(["growth","im3","krein2"])", {"growth", "im3", "krein2"});
}

TEST(Map, ThreadsAndTheGridsOrderDoNotMatter) {
  const std::vector<std::string> larger{"map.x.count=61", "map.y.count=40"};
  const Outcome one = mapped(larger, {"-o", "-", "--threads", "1"});
  EXPECT_EQ(mapped(larger, {"-o", "-", "--threads", "7"}).out, one.out);
  const Outcome turned =
      mapped({"map.y={parameter=\"nu\",from=0.0,to=1.5,count=61}",
              "map.x={parameter=\"body.J.1\",from=0.3,to=3.0,count=40,scale=\"log\"}"});
  const auto rows = rows_of(one.out);
  const auto turned_rows = rows_of(turned.out);
  ASSERT_EQ(rows.size(), turned_rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& other = turned_rows[(k % 61) * 40 + k / 61];
    for (const char* column : {"nu", "body.J.1", "status", "xi", "zeta", "rho", "error_bound"})
      ASSERT_EQ(rows[k].at(column), other.at(column)) << k << " " << column;
  }
}

TEST(Map, OneParameterAndNeitherIsNu) {
  const std::string text =
      "title = \"t\"\n[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\n"
      "plane = { model = \"neo-hookean\", mu = 1.0, lambda = 2.0 }\n"
      "thickness = { model = \"harmonic\", k = 3.0, rest = 0.7 }\n"
      "[motion]\nbranch = \"iii\"\nnu = 0.4\n"
      "[map]\nx = { parameter = \"potential.plane.mu\", from = 0.5, to = 2, count = 5 }\n";
  const TemporaryDirectory directory;
  const std::string file = directory.file("one.toml", text);
  const auto rows = rows_of(run_program({"map", file, "-o", "-"}).out);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[2].at("potential.plane.mu"), "1.25");
  const Row one =
      only_row(run_program({"solve", file, "--set", "potential.plane.mu=1.25", "-o", "-"}).out);
  EXPECT_EQ(rows[2].at("xi"), one.at("xi"));
  const auto both =
      rows_of(run_program({"map", file, "--set",
                           "map.y={parameter=\"potential.thickness.rest\",from=0.7,to=1,count=4}",
                           "-o", "-"})
                  .out);
  ASSERT_EQ(both.size(), 20U);
  EXPECT_EQ(both[2].at("rho"), rows[2].at("rho"));
  EXPECT_EQ(both[19].at("potential.thickness.rest"), "1");
  EXPECT_EQ(both[19].at("rho"), "1");
}

/// reciprocal-determinant (i): J2 nu^2 < k, and what lies beyond does not exist.
TEST(Map, StatusesAtTheBoundaryOfExistence) {
  const Outcome outcome =
      run_program({"map", STATIONARY_CASES "/disc.toml", "--set", "body.J=[1,2,0.1]", "--set",
                   "map.x={parameter=\"nu\",from=0.5,to=1.5,count=101}", "-o", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const Row& row : rows_of(outcome.out)) {
    EXPECT_EQ(row.at("status"), number(row.at("nu")) < 1.0 ? "solved" : "none-exists")
        << row.at("nu");
  }
}

/// Beyond a fold whose sheet returns to rest, with another sheet and a stretch where the balance is
/// singular to rounding further off: nothing there is the rest state's, and nothing has failed.
TEST(Map, NothingIsFoundPastAFold) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "fold.toml",
      "[body]\nJ = [0.79091, 0.90158, 1.7624]\n[potential]\n"
      "plane = { expression = \"mu/2*(I1-2*d)+k*(d-1)^2*(d-2)^2\", mu = 1.0, k = 0.4 }\n"
      "thickness = { model = \"harmonic\", k = 1.0, rest = 1.0 }\n"
      "[motion]\nbranch = \"iii\"\nnu = 0.5\n[map]\n"
      "x = { parameter = \"nu\", from = 0.0, to = 1.0, count = 21 }\n"
      "y = { parameter = \"potential.plane.mu\", from = 0.5, to = 2.0, count = 151 }\n");
  const Outcome outcome = run_program({"map", path, "-o", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 21U * 151U);
  int found = 0;
  for (const Row& row : rows) {
    if (row.at("status") != "solved") {
      EXPECT_EQ(row.at("status"), "not-found") << row.at("point");
      continue;
    }
    ++found;
    EXPECT_LE(number(row.at("nu")), 0.35);
    EXPECT_LT(number(row.at("xi")) * number(row.at("zeta")), 1.5) << row.at("point");
  }
  EXPECT_GE(found, 6 * 151);
}

TEST(Map, NothingInAnyCellIsNoEquilibrium) {
  const Outcome outcome =
      run_program({"map", STATIONARY_CASES "/disc.toml", "--set",
                   "map.x={parameter=\"nu\",from=1.5,to=2,count=3}", "-o", "-"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no stationary ellipsoid in any of 3 cells: 3 none-exists"));
  EXPECT_EQ(rows_of(outcome.out).size(), 3U);
}

TEST(Map, ColumnsAsAskedAndAlwaysTheStatus) {
  const Outcome outcome = mapped({"output.columns=[\"zeta\",\"xi\"]"});
  EXPECT_EQ(header_of(outcome.out), "xi,zeta,status,nu,body.J.1");
  const Outcome certified =
      mapped({"output.columns=[\"class\",\"certified\"]"}, {"-o", "-", "--certify"});
  EXPECT_EQ(header_of(certified.out), "class,status,certified,nu,body.J.1");
  for (const Row& row : rows_of(certified.out))
    EXPECT_EQ(row.at("certified").empty(), row.at("status") != "solved");
}

TEST(Map, SummaryForAPerson) {
  const Outcome outcome = mapped({}, {});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("x             nu from 0 to 1.5, 13 values"),
                                 HasSubstr("9 values, logarithmic"),
                                 HasSubstr("cells         117:"), HasSubstr("classes")));
}

TEST(Map, MetadataBesideTheTable) {
  const TemporaryDirectory directory;
  EXPECT_EQ(mapped({}, {"-o", directory / "m.csv"}).code, 0);
  EXPECT_THAT(directory.names(), ElementsAre("m.csv", "m.meta.json"));
  const auto metadata = nlohmann::json::parse(text_of(directory / "m.meta.json"));
  EXPECT_EQ(metadata.at("rows"), 117);
  EXPECT_EQ(metadata.at("command"), "map");
  EXPECT_EQ(metadata.at("status"), "done");
  EXPECT_EQ(metadata.at("case").at("map").at("y").at("scale"), "log");
  EXPECT_EQ(metadata.at("counts").at("solved").get<int>() +
                metadata.at("counts").at("not-found").get<int>(),
            117);
}

TEST(Map, WrongInputIsRefusedWithItsPlace) {
  const auto refused = [](const std::vector<std::string>& overrides, const std::string& why) {
    const Outcome outcome = mapped(overrides);
    EXPECT_EQ(outcome.code, 2) << why;
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_THAT(outcome.out, IsEmpty());
  };
  refused({"map.x.parameter=mu"}, "map.x.parameter: found the string \"mu\"; expected one of");
  refused({"map.y.parameter=body.J.3"}, "did you mean \"body.J.0\"?");
  refused({"map.y.parameter=motion.nu"}, "which is x's too");
  refused({"map.x.count=1"}, "map.x.count: found 1; expected a whole number from 2 to");
  refused({"map.x.count=2.5"}, "found 2.5; expected a whole number");
  refused({"map.x.count=5000000"}, "map.y.count: found 5000000 by 9 cells; expected at most");
  refused({"map.x.to=-1"}, "map.x.to: found the empty range from 0 to -1; expected from < to");
  refused({"map.x.scale=log"}, "map.x.from: found 0 with scale = \"log\"; expected from > 0");
  refused({"map.x.scale=logarithmic"}, "expected one of \"linear\", \"log\"");
  refused({"map.y={parameter=\"potential.plane.mu\",from=-1.0,to=1.0,count=4}"},
          "map.y.from: found potential.plane.mu = -1; expected mu > 0");
  refused({"map.z=1"}, "expected one of \"x\", \"y\" in [map]");
  refused({"map.x.cuont=1"}, "did you mean \"count\"?");
  refused({"map.x=1"}, "map.x: found the integer 1; expected a table");
  const TemporaryDirectory directory;
  const std::string file = directory.file("bad.toml", std::string(text_of(map_case)) + "\nz = 1\n");
  EXPECT_THAT(run_program({"map", file}).err, HasSubstr("bad.toml:"));
  const Outcome without = run_program({"map", STATIONARY_CASES "/disc.toml"});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("map: found no such key"));
  const Outcome backwards = run_program({"map", STATIONARY_CASES "/tilted.toml", "--set",
                                         "map.x={parameter=\"nu\",from=-1,to=2,count=3}"});
  EXPECT_EQ(backwards.code, 2);
  EXPECT_THAT(backwards.err, HasSubstr("expected nu >= 0 (it is the length |nu| there)"));
}

struct OtherKind {
  std::string file;
  std::vector<std::string> axes;  ///< map.x, map.y
  int solved;                     ///< at least so many cells
  std::string how = "each solved by itself";
};

/// Of kinds of motion that have no lanes: every cell is what solve says at its numbers.
TEST(Map, CellsOfEveryKindAreWhatSolveFinds) {
  const std::vector<OtherKind> kinds{
      {"tilted.toml",
       {"map.x={parameter=\"nu\",from=1.06,to=1.1,count=5}",
        "map.y={parameter=\"body.J.1\",from=1.69,to=1.71,count=3}"},
       3,
       "followed once"},
      {"tilted.toml",
       {"map.x={parameter=\"body.J.1\",from=1.69,to=1.71,count=3}",
        "map.y={parameter=\"nu\",from=1.06,to=1.1,count=3}"},
       3},
      {"two_polar.toml",
       {"map.x={parameter=\"motion.omega\",from=0.9,to=1.3,count=4}",
        "map.y={parameter=\"potential.plane.lambda\",from=1.5,to=2.5,count=3}"},
       6,
       "searches that serve all cells of a block"},
      {"two_polar.toml",
       {"map.x={parameter=\"potential.plane.lambda\",from=1.5,to=2.5,count=2}",
        "map.y={parameter=\"motion.omega\",from=0.9,to=1.3,count=2}"},
       2},
      {"two_polar_momenta.toml",
       {"map.x={parameter=\"motion.s3\",from=0.6,to=0.9,count=3}",
        "map.y={parameter=\"motion.p_theta\",from=-0.5,to=-0.3,count=2}"},
       3,
       "searches that serve all cells of a block"},
      {"oblique.toml",
       {"map.x={parameter=\"nu\",from=0.0,to=0.4,count=3}",
        "map.y={parameter=\"potential.fibre.k\",from=0.3,to=0.5,count=2}"},
       3,
       "followed once"},
      {"oblique.toml",
       {"map.x={parameter=\"nu\",from=0.2,to=0.4,count=2}",
        "map.y={parameter=\"body.J.1/nu\",from=4,to=5,count=2}"},
       1},
      {"disc.toml",
       {"map.x={parameter=\"nu\",from=0.2,to=0.4,count=2}",
        "map.y={parameter=\"body.J.1/nu\",from=4,to=5,count=2}"},
       4},
      {"disc.toml",
       {"map.x={parameter=\"body.J.1/nu\",from=4,to=5,count=2}",
        "map.y={parameter=\"nu\",from=0.2,to=0.4,count=2}"},
       4}};
  for (const OtherKind& kind : kinds) {
    std::vector<std::string> map{"map", STATIONARY_CASES "/" + kind.file};
    for (const std::string& axis : kind.axes) {
      map.emplace_back("--set");
      map.push_back(axis);
    }
    const Outcome summary = run_program(map);
    EXPECT_EQ(summary.code, 0) << summary.err;
    EXPECT_THAT(summary.out, HasSubstr(kind.how)) << kind.file;
    map.insert(map.end(), {"-o", "-"});
    const Outcome outcome = run_program(map);
    ASSERT_EQ(outcome.code, 0) << kind.file << ": " << outcome.err;
    map.insert(map.end(), {"--threads", "1"});
    EXPECT_EQ(run_program(map).out, outcome.out) << kind.file;
    int solved = 0;
    for (const Row& row : rows_of(outcome.out)) {
      std::vector<std::string> solve{"solve", STATIONARY_CASES "/" + kind.file, "-o", "-"};
      for (const std::string& axis : kind.axes) {
        const std::string key = axis.substr(axis.find('"') + 1);
        const std::string parameter = key.substr(0, key.find('"'));
        solve.emplace_back("--set");
        if (const std::size_t over = parameter.find("/nu"); over != std::string::npos) {
          std::ostringstream text;
          text.precision(17);
          text << number(row.at(parameter)) * number(row.at("nu"));
          solve.push_back(parameter.substr(0, over) + "=" + text.str());
        } else {
          solve.push_back((parameter == "nu" ? "motion.nu" : parameter) + "=" + row.at(parameter));
        }
      }
      if (row.contains("nu") && number(row.at("nu")) == 0.0) {
        EXPECT_EQ(row.at("status"), "none-exists") << kind.file;
        continue;
      }
      const Outcome one = run_program(solve);
      EXPECT_EQ(one.code == 0, row.at("status") == "solved") << kind.file << ": " << one.err;
      if (one.code != 0) continue;
      ++solved;
      const Row expected = rows_of(one.out).front();
      for (const auto& [column, cell] : expected) {
        if (!row.contains(column) || column == "point" || column == "sheet") continue;
        if (column == "error_bound") {  // it knows how far the last correction came
          EXPECT_NEAR(number(row.at(column)), number(cell), 0.5 * number(cell)) << kind.file;
        } else {
          EXPECT_EQ(row.at(column), cell) << kind.file << " " << column;
        }
      }
      EXPECT_EQ(row.contains("omega"), expected.contains("omega"));
    }
    EXPECT_GE(solved, kind.solved) << kind.file;
  }
}

TEST(Map, CellsOfOtherKindsAreProvenWhereThatIsAsked) {
  const Outcome outcome =
      run_program({"map", STATIONARY_CASES "/tilted.toml", "--set",
                   "map.x={parameter=\"nu\",from=1.06,to=1.08,count=3}", "--certify", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const Row& row : rows_of(outcome.out)) {
    EXPECT_EQ(row.at("certified"), "yes");
    EXPECT_EQ(row.at("class_certified"), "yes");
  }
}

/// From 1e-200 to 1e200 the ratio of the two is none of doubles.
TEST(Map, LogarithmicAxesHaveNoInfiniteValues) {
  const MapAxis axis{.parameter = "potential.coupled.k",
                     .from = 1e-200,
                     .to = 1e200,
                     .count = 5,
                     .scale = AxisScale::log};
  const std::vector<double> values = axis.values();
  const double expected[] = {1e-200, 1e-100, 1.0, 1e100, 1e200};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(values[k] / expected[k], 1.0, 1e-12) << k;
}

TEST(Map, CornersOfTheDomainInWhicheverOrder) {
  // mu + lambda > 0 holds on the grid though not with x and the case's own lambda.
  const Outcome outcome =
      mapped({"potential.plane.lambda=-0.5",
              "map.x={parameter=\"potential.plane.mu\",from=0.1,to=1.0,count=3}",
              "map.y={parameter=\"potential.plane.lambda\",from=0.5,to=1.0,count=3}"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

/// Once its table is begun, or before its first cell.
void expect_an_interrupted_map(const char* name, bool before) {
  const TemporaryDirectory directory;
  const std::string target = directory / name;
  auto arguments = map_command({"map.x.count=3000", "map.y.count=2000"});
  arguments.insert(arguments.end(), {"-o", target, "--threads", "1"});
  RunOptions options;
  if (before) {
    options.pending_signal = SIGINT;
  } else {
    options.interrupt_once_written = target;
  }
  const Outcome outcome = run_program(arguments, options);
  SCOPED_TRACE(outcome.err);
  EXPECT_EQ(outcome.code, 130);
  const std::string stem = std::string(name).substr(0, 1);
  EXPECT_THAT(directory.names(),
              ElementsAre(name, std::string(name) + ".journal", stem + ".meta.json"));
  const auto metadata = nlohmann::json::parse(text_of(directory / "m.meta.json"));
  EXPECT_EQ(metadata.at("status"), "interrupted");
  const auto rows = metadata.at("rows").get<std::size_t>();
  EXPECT_LT(rows, before ? 1U : 6000000U);
  EXPECT_THAT(outcome.err,
              HasSubstr("interrupted after " + std::to_string(rows) + " of 6000000 cells" +
                        (rows > 0 ? ", which are written" : "; --resume begins anew")));
  const std::vector<std::string> wanted{"point"};
  TableReader table = is_column_file(target)
                          ? TableReader(column_file_table(target, wanted), target)
                          : TableReader(target);
  std::size_t read = 0;
  while (table.next()) ++read;
  EXPECT_EQ(read, rows);
}

TEST(Map, InterruptedWritesWhatIsComplete) {
  for (const char* name : {"m.csv", "m.h5"}) {
    if (!has_hdf5 && name[2] == 'h') continue;
    SCOPED_TRACE(name);
    for (const bool before : {false, true}) expect_an_interrupted_map(name, before);
  }
}

}  // namespace
}  // namespace stationary::testing
