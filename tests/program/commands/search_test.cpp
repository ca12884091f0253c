// solve.all and output.certificate from outside: rows, columns, exit codes, messages, metadata.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string apart = STATIONARY_CASES "/apart.toml";
const std::string disc_case = STATIONARY_CASES "/disc.toml";

Outcome solved_case(const std::string& file, std::vector<std::string> more) {
  std::vector<std::string> arguments{"solve", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

/// (iii), J1 = J2, neo-hookean at J nu^2 = mu: a line of solutions.
constexpr const char* continuum = R"([body]
J = [1.0, 1.0, 0.6]
[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "harmonic", k = 1.0, rest = 3.0 }
[motion]
branch = "iii"
nu = 1.0
[solve]
all = true
)";

/// hencky, (i): the sheet through rest folds at zeta = sqrt e.
constexpr const char* folding = R"([body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "hencky", mu = 1.1, lambda = 0.8 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "i"
nu = 0.5
[solve]
start = [0, 0.8105, 1.6487, 0.708]
method = "newton"
[continuation]
parameter = "nu"
from = 0.4
to = 1.0
)";

std::string nu_at_fold(double times) {
  std::ostringstream out;
  out.precision(17);
  out << "motion.nu=" << std::sqrt(2.0 * 1.1 * 1.9 / (3.0 * std::exp(1.0) * 1.7)) * times;
  return out.str();
}

TEST(SolveAll, OneRowASheet) {
  const Outcome outcome = solved_case(apart, {"-o", "-", "--set", "solve.all=true"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("solve.start is not used"));
  EXPECT_THAT(std::string(header_of(outcome.out)), Not(HasSubstr("certified")));
  auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(number(rows[0]["xi"]), 48.91, 0.01);
  EXPECT_NEAR(number(rows[0]["zeta"]), 0.722, 0.001);
  EXPECT_NEAR(number(rows[1]["xi"]), 49.98, 0.01);
  EXPECT_NEAR(number(rows[1]["zeta"]), 0.0215, 0.0001);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k]["sheet"], std::to_string(k + 1));
    EXPECT_EQ(rows[k]["point"], "0");
    EXPECT_LT(number(rows[k]["error_bound"]), 1e-12);
    EXPECT_FALSE(rows[k]["class"].empty());
  }
  // The one solve finds from the case's own start is among them.
  auto alone = only_row(solved_case(apart, {"-o", "-"}).out);
  EXPECT_EQ(alone["xi"], rows[0]["xi"]);
  EXPECT_EQ(alone["zeta"], rows[0]["zeta"]);
}

TEST(SolveAll, NoneIsThreeAndProven) {
  const TemporaryDirectory directory;
  const Outcome outcome = solved_case(
      apart, {"-o", directory / "x.csv", "--set", "solve.all=true", "--set", "motion.nu=1.2"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no stationary ellipsoid in the box searched"));
  EXPECT_THAT(outcome.err, HasSubstr("proven that there is none"));
  EXPECT_THAT(outcome.err, HasSubstr("[0.001, 1000]"));
  EXPECT_TRUE(rows_of(text_of(directory / "x.csv")).empty());
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["rows"], 0);
  EXPECT_EQ(metadata["counts"]["proven"], 0);
  EXPECT_EQ(metadata["counts"]["undecided"], 0);
  EXPECT_GT(metadata["counts"]["boxes"].get<int>(), 1);
}

TEST(SolveAll, MetadataSaysWhatIsProven) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      solved_case(apart, {"-o", directory / "x.csv", "--set", "solve.all=true", "--certify"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["method"], "exhaustive search");
  EXPECT_EQ(metadata["rows"], 2);
  EXPECT_EQ(metadata["counts"]["proven"], 2);
  EXPECT_EQ(metadata["counts"]["undecided"], 0);
  EXPECT_EQ(metadata["counts"]["spectra"], 2);
  EXPECT_EQ(metadata["case"]["solve"]["all"], true);
  EXPECT_EQ(metadata["case"]["output"]["certificate"], true);
  EXPECT_THAT(metadata["message"].get<std::string>(), HasSubstr("[0.001, 1000]"));
}

TEST(SolveAll, ContinuumIsAFailureThatSaysWhere) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("line.toml", continuum);
  const Outcome outcome = solved_case(file, {"-o", directory / "x.csv"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("not decided"));
  EXPECT_THAT(outcome.err, HasSubstr("not isolated"));
  EXPECT_THAT(directory.names(), ::testing::ElementsAre("line.toml"));
}

TEST(SolveAll, DoubleRootIsReportedWithItsBox) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("fold.toml", folding);
  const std::string all = "solve.all=true";
  const Outcome at = solved_case(file, {"-o", "-", "--set", all, "--set", nu_at_fold(1.0)});
  EXPECT_EQ(at.code, 4);
  EXPECT_THAT(at.err, HasSubstr("a fold"));
  EXPECT_THAT(at.err, HasSubstr("zeta [1.6487"));
  EXPECT_THAT(at.out, IsEmpty());
  const Outcome before =
      solved_case(file, {"-o", "-", "--set", all, "--set", nu_at_fold(1.0 - 1e-10)});
  EXPECT_EQ(before.code, 0) << before.err;
  EXPECT_EQ(rows_of(before.out).size(), 2U);
  const Outcome after =
      solved_case(file, {"-o", "-", "--set", all, "--set", nu_at_fold(1.0 + 1e-10)});
  EXPECT_EQ(after.code, 3);
  EXPECT_THAT(after.err, HasSubstr("proven that there is none"));
}

/// hencky, (iii): two of four sheets meet in a fold, the other two go on.
TEST(SolveAll, WhatIsProvenBesideADoubleRootHasItsRows) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("beside.toml", R"([body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "hencky", mu = 1.0, lambda = 2.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "iii"
nu = 0.5947796761039316
[solve]
all = true
)");
  const Outcome outcome = solved_case(file, {"-o", directory / "x.csv"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("2 proven; not decided whether there are more in xi [0.8606"));
  EXPECT_THAT(outcome.err, HasSubstr("a fold"));
  EXPECT_EQ(rows_of(text_of(directory / "x.csv")).size(), 2U);
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["counts"]["undecided"], 1);
  EXPECT_THAT(metadata["warning"].get<std::string>(), HasSubstr("not decided"));
}

TEST(SolveAll, SummaryForAPerson) {
  const Outcome outcome = solved_case(apart, {"--set", "solve.all=true"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* words : {"proven to be all", "solution 1", "of 2", "solution 2", "(proven)",
                            "2 proven", "all solutions"})
    EXPECT_THAT(outcome.out, HasSubstr(words));
}

TEST(SolveAll, InABoxOfItsOwn) {
  const TemporaryDirectory directory;
  const auto within = [&](const std::string& box) {
    return solved_case(
        apart, {"-o", directory / "x.csv", "--set", "solve.all=true", "--set", "solve.box=" + box});
  };
  const auto all = rows_of(solved_case(apart, {"-o", "-", "--set", "solve.all=true"}).out);
  ASSERT_EQ(all.size(), 2U);
  // zeta = 0.722 and 0.0215.
  for (const auto& [box, of] :
       {std::pair{"[0.5, 100]", 0U}, std::pair{"[[1, 100], [0.01, 0.1], [0.1, 2]]", 1U},
        std::pair{"[[49, 100], [0.001, 10], [0.1, 2]]", 1U}}) {
    const Outcome outcome = within(box);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Row row = only_row(text_of(directory / "x.csv"));
    EXPECT_EQ(row.at("xi"), all[of].at("xi")) << box;
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    EXPECT_EQ(metadata["case"]["solve"]["box"].size(), 3U);
    EXPECT_THAT(metadata["skipped"].dump(), HasSubstr("solve.start"));
  }
  const Outcome none = within("[[1, 100], [0.01, 0.1], [1, 2]]");
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("xi in [1, 100], zeta in [0.01, 0.1], rho in [1, 2]: proven that "
                                  "there is none"));
}

/// (iii) with J1 = J2: of a solution and its mirror image each is in one of two boxes.
TEST(SolveAll, MirrorImagesInBoxesOfTheirOwn) {
  const std::string circle = STATIONARY_CASES "/circle.toml";
  const auto in = [&](const std::string& box) {
    return rows_of(solved_case(circle, {"-o", "-", "--set", "solve.all=true", "--set",
                                        "motion.nu=1.1", "--set", "solve.box=" + box})
                       .out);
  };
  const auto all = in("[0.001, 1000]");
  std::size_t ellipses = 0;
  for (const Row& row : all) {
    const double xi = number(row.at("xi"));
    const double zeta = number(row.at("zeta"));
    if (std::abs(xi - zeta) < 1e-6 * xi) continue;
    ++ellipses;
    const auto about = [](double x) {
      return "[" + std::to_string(0.9 * x) + ", " + std::to_string(1.1 * x) + "]";
    };
    const auto alone = in("[" + about(xi) + ", " + about(zeta) + ", [0.01, 100]]");
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_EQ(alone[0].at("xi"), row.at("xi"));
    EXPECT_EQ(alone[0].at("zeta"), row.at("zeta"));
  }
  EXPECT_EQ(ellipses % 2, 0U);
  EXPECT_GE(all.size(), 1U);
}

TEST(SolveAll, BoxesThatAreNone) {
  for (const auto& [box, words] :
       {std::pair{"[2, 1]", "found [2, 1]"}, std::pair{"[0, 1]", "1e-100"},
        std::pair{"[1]", "an array of 1 value"}, std::pair{"[[1, 2]]", "an array of 1 value"},
        std::pair{"[[1, 2], [1, 2], [2, 1]]", "solve.box.2"},
        std::pair{"[[1, 2], [1, 2], 3]", "solve.box.2"}, std::pair{"wide", "the string"},
        std::pair{"[]", "an array of 0 values"}, std::pair{"[1, inf]", "the number inf"}}) {
    const Outcome outcome =
        solved_case(apart, {"--set", "solve.all=true", "--set", std::string("solve.box=") + box});
    EXPECT_EQ(outcome.code, 2) << box;
    EXPECT_THAT(outcome.err, HasSubstr(words)) << box;
  }
  const Outcome unused = solved_case(disc_case, {"--set", "solve.box=[0.1, 10]"});
  EXPECT_EQ(unused.code, 0);
  EXPECT_THAT(unused.out, HasSubstr("solve.box"));
}

TEST(Certify, RowCarriesTheProof) {
  for (const std::vector<std::string>& way :
       {std::vector<std::string>{"--certify"}, {"--set", "output.certificate=true"}}) {
    std::vector<std::string> arguments{"-o", "-"};
    arguments.insert(arguments.end(), way.begin(), way.end());
    const Outcome outcome = solved_case(disc_case, arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_TRUE(header_of(outcome.out).ends_with(",krein5,certified,class_certified"));
    auto row = only_row(outcome.out);
    EXPECT_EQ(row["certified"], "yes");
    EXPECT_EQ(row["class_certified"], "yes");
    EXPECT_LT(number(row["error_bound"]), 1e-14);
    EXPECT_GT(number(row["error_bound"]), 1e-16);
    auto plain = only_row(solved_case(disc_case, {"-o", "-"}).out);
    for (const char* same : {"xi", "zeta", "rho", "class", "growth", "re1"})
      EXPECT_EQ(row[same], plain[same]) << same;
  }
}

TEST(Certify, WithoutSpectrumNoClass) {
  const Outcome outcome =
      solved_case(disc_case, {"--certify", "-o", "-", "--set", "output.spectrum=false"});
  EXPECT_TRUE(header_of(outcome.out).ends_with(",error_bound,certified")) << outcome.out;
}

TEST(Certify, WhatIsNotProvenSaysSo) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("fold.toml", folding);
  const Outcome outcome =
      solved_case(file, {"--certify", "-o", "-", "--set", nu_at_fold(1.0 - 2e-15)});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("not proven"));
  EXPECT_THAT(outcome.err, HasSubstr("fold"));
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["certified"], "no");
  EXPECT_EQ(row["class_certified"], "no");
  // Nor does the plan say otherwise.
  const Outcome words = solved_case(file, {"--certify", "--set", nu_at_fold(1.0 - 2e-15)});
  EXPECT_THAT(words.out, HasSubstr("error bound and class, to be proven"));
}

/// Every row of a followed curve is proven, the fold and where it is included.
TEST(Certify, RowsOfACurve) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("fold.toml", folding);
  const Outcome outcome = run_program({"continue", file, "--certify", "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  long proven = 0;
  long folds = 0;
  auto rows = rows_of(text_of(directory / "x.csv"));
  ASSERT_GT(rows.size(), 20U);
  for (auto& row : rows) {
    EXPECT_EQ(row["certified"], "yes") << row["nu1"] << " " << row["event"];
    proven += row["certified"] == "yes";
    if (row["event"] != "fold-nu") continue;
    ++folds;
    EXPECT_LE(std::stod(row["error_bound"]), 1e-11);
    EXPECT_EQ(row["class_certified"], "no");  // at its nu there are two solutions, or none
  }
  EXPECT_EQ(folds, 1);
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["counts"]["proven"], proven);
  for (const auto& event : metadata["events"]) {
    const double low = event.at("enclosure").at(0);
    const double high = event.at("enclosure").at(1);
    EXPECT_LT(low, high);
    EXPECT_NEAR(low, event.at("parameter").get<double>(), 1e-13);
    EXPECT_NEAR(high, event.at("parameter").get<double>(), 1e-13);
  }

  const Outcome words = run_program({"continue", file, "--certify"});
  EXPECT_THAT(words.out, HasSubstr(std::to_string(proven) + " of " + std::to_string(rows.size()) +
                                   " points proven"));
}

TEST(Certify, CheckAnnouncesIt) {
  const Outcome outcome = run_program(
      {"check", disc_case, "--set", "output.certificate=true", "--set", "solve.all=true"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("exhaustive search, to be proven complete"));
  EXPECT_THAT(outcome.out, HasSubstr("existence, uniqueness, error bound and class, to be proven"));
}

TEST(Certify, TwoPolarMotionsByRatesAndByMomenta) {
  for (const char* file : {"/two_polar.toml", "/two_polar_momenta.toml"}) {
    const Outcome outcome =
        solved_case(std::string(STATIONARY_CASES) + file, {"--certify", "-o", "-"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    auto row = only_row(outcome.out);
    EXPECT_EQ(row["certified"], "yes") << file;
    EXPECT_EQ(row["class_certified"], "yes") << file;
    EXPECT_LT(number(row["error_bound"]), 1e-13) << file;
  }
}

/// solve.all starts nowhere in particular: one line says so, and the metadata.
TEST(SolveAll, AStartIsNotUsed) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml", std::string(good_case) + "\n[solve]\nall = true\nstart = [0, 1.1, 0.9, 1]\n");
  const Outcome outcome = run_program({"solve", path, "-o", directory / "x.csv"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("solve.start is not used"));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
  EXPECT_THAT(text_of(directory / "x.meta.json"), HasSubstr("\"quantity\": \"solve.start\""));
}

/// That alpha = 0 balances is taken for granted of a formula that is isotropic at every point tried; where it is not
/// there is no motion, whatever the search proves of the rest.
TEST(SolveAll, WhatTheFormulaRefutesIsNoSolution) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\n"
      "plane = { expression = \"0.5*I1 + 1/d + (sin(2*alpha)-2*sin(alpha)*cos(alpha)) + "
      "sin(alpha)*exp(-1e8*(d-1.0672564774741016)^2)\" }\n"
      "thickness = { expression = \"a/rho + b/2*rho^2\", a = 1.0, b = 3.0 }\n"
      "[motion]\nbranch = \"iii\"\nnu = 0.3\n[solve]\nall = true\n");
  const Outcome outcome = solved_case(path, {"-o", "-"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("not decided"));
}

}  // namespace
}  // namespace stationary::testing
