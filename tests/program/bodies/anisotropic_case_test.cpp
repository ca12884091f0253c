// Anisotropic bodies and oblique axes from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

Outcome run_with_sets(std::vector<std::string> arguments,
                      const std::vector<std::string>& sets = {}) {
  for (const std::string& each : sets) {
    arguments.push_back("--set");
    arguments.push_back(each);
  }
  return run_program(arguments);
}

const std::string fibre_case = shipped("fibre.toml");
const std::string oblique_case = shipped("oblique.toml");

TEST(AnisotropicCase, CheckPrintsTheFacts) {
  const Outcome skew = run_with_sets({"check", fibre_case});
  EXPECT_EQ(skew.code, 0) << skew.err;
  EXPECT_THAT(skew.out, HasSubstr("fibre: k = 0.4, degrees = 30"));
  EXPECT_THAT(skew.out, HasSubstr("separable, anisotropic, V_alpha != 0 at alpha = 0"));
  EXPECT_THAT(skew.out, HasSubstr("an unknown"));
  const Outcome even = run_with_sets({"check", fibre_case}, {"potential.fibre.degrees=90"});
  EXPECT_THAT(even.out, HasSubstr("even in alpha: V_alpha = 0 at alpha = 0"));
  const Outcome pair = run_with_sets({"check", fibre_case}, {"potential.second_fibre.k=0.4",
                                                             "potential.second_fibre.degrees=-30"});
  EXPECT_THAT(pair.out, HasSubstr("even in alpha"));
  const Outcome oblique = run_with_sets({"check", oblique_case});
  EXPECT_THAT(oblique.out, HasSubstr("about an axis in the plane of axes 1 and 2, |nu| = 0.5"));
}

TEST(AnisotropicCase, SolvesAboutAxisThreeWithAlpha) {
  const Outcome outcome = run_with_sets({"solve", fibre_case, "--certify", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["branch"], "iii");
  EXPECT_NEAR(number(row["alpha"]), -0.0109021879560, 1e-12);
  EXPECT_EQ(row["certified"], "yes");
  EXPECT_EQ(row["class"], "stable");
  EXPECT_EQ(row["class_certified"], "yes");
}

TEST(AnisotropicCase, ObliqueMotionsOfBothAxesOrOne) {
  const Outcome both = run_with_sets({"solve", oblique_case, "-o", "-"}, {"motion.axis=\"1\""});
  ASSERT_EQ(both.code, 0) << both.err;
  auto one = only_row(both.out);
  EXPECT_EQ(one["branch"], "oblique");
  EXPECT_NEAR(std::hypot(number(one["nu1"]), number(one["nu2"])), 0.5, 1e-15);
  EXPECT_EQ(one["nu3"], "0");
  EXPECT_NEAR(number(one["pi1"]) * number(one["nu2"]), number(one["pi2"]) * number(one["nu1"]),
              1e-15);
  auto two = only_row(run_with_sets({"solve", oblique_case, "-o", "-"}, {"motion.axis=\"2\""}).out);
  EXPECT_LT(std::abs(number(two["nu1"])), std::abs(number(two["nu2"])));
  // Every one, with proof: these two.
  const Outcome every = run_with_sets({"solve", oblique_case, "-o", "-"}, {"solve.all=true"});
  ASSERT_EQ(every.code, 0) << every.err;
  auto all = rows_of(every.out);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(number(all[0]["alpha"]), number(one["alpha"]), 1e-14);
  EXPECT_NEAR(number(all[1]["alpha"]), number(two["alpha"]), 1e-14);
}

TEST(AnisotropicCase, ContinuesTheObliqueFamilyAndGoesOn) {
  const TemporaryDirectory directory;
  const std::string whole = directory / "whole.csv";
  const std::string cut = directory / "cut.csv";
  const std::vector<std::string> coarse{"continuation.tolerance=1e-5"};
  ASSERT_EQ(run_with_sets({"continue", oblique_case, "--quiet", "-o", whole}, coarse).code, 0);
  auto rows = rows_of(text_of(whole));
  ASSERT_GT(rows.size(), 20U);
  EXPECT_EQ(rows.front()["event"], "limit");
  EXPECT_EQ(rows.front()["nu1"], "0");
  EXPECT_EQ(rows.back()["event"], "limit");
  int tilts = 0;
  for (auto& row : rows) {
    tilts += row["event"] == "tilt";
    EXPECT_LE(number(row["residual"]), 1e-15);
  }
  EXPECT_EQ(tilts, 1);
  // Stopped, and gone on with.
  std::vector<std::string> short_of = coarse;
  short_of.push_back("continuation.max_points=20");
  ASSERT_EQ(run_with_sets({"continue", oblique_case, "--quiet", "-o", cut}, short_of).code, 0);
  const Outcome on =
      run_with_sets({"continue", oblique_case, "--resume", "--quiet", "-o", cut}, coarse);
  ASSERT_EQ(on.code, 0) << on.err;
  auto again = rows_of(text_of(cut));
  EXPECT_NEAR(number(again.back()["alpha"]), number(rows.back()["alpha"]), 1e-12);
  EXPECT_EQ(again.back()["event"], "limit");
}

/// About axis 1 a skew fibre leaves a force: nothing is there to be followed, as `solve` says.
TEST(AnisotropicCase, NothingToContinueAboutAnAxisThatTheFibreLeaves) {
  const std::vector<std::string> about{"motion.branch=\"i\"", "motion.nu=0.5"};
  const Outcome solved = run_with_sets({"solve", fibre_case}, about);
  EXPECT_EQ(solved.code, 3);
  const std::string reason = "leaves a force V_alpha";
  EXPECT_THAT(solved.err, HasSubstr(reason));
  for (const char* nu : {"motion.nu=0.5", "motion.nu=0.0"}) {
    auto sets = about;
    sets.emplace_back(nu);
    const Outcome followed = run_with_sets({"continue", fibre_case}, sets);
    EXPECT_EQ(followed.code, 3) << followed.err;
    EXPECT_THAT(followed.err, HasSubstr(reason));
    if (std::string(nu) == "motion.nu=0.5") {
      EXPECT_THAT(followed.err, HasSubstr("no stationary ellipsoid in the box searched"));
    }
  }
}

/// Turned, a fibre along an axis leaves a force as well, so that about axis 1 there is nothing to
/// follow in its angle; about axis 3 alpha moves, from 0 on.
TEST(AnisotropicCase, TurnsAFibreAwayFromAnAxis) {
  const std::vector<std::string> turning{
      "potential.fibre.degrees=0", "continuation.parameter=\"potential.fibre.degrees\"",
      "continuation.from=-5", "continuation.to=5", "motion.nu=0.3"};
  auto about_one = turning;
  about_one.emplace_back("motion.branch=\"i\"");
  const Outcome refused = run_with_sets({"continue", fibre_case}, about_one);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("continuation.parameter: found \"potential.fibre.degrees\""));
  EXPECT_THAT(refused.err, HasSubstr("leaves a force V_alpha"));
  // So does the stiffness of one of a pair.
  const Outcome pair =
      run_with_sets({"continue", fibre_case},
                    {"potential.second_fibre.k=0.4", "potential.second_fibre.degrees=-30",
                     "continuation.parameter=\"potential.fibre.k\"", "continuation.from=0.3",
                     "continuation.to=0.5", "motion.nu=0.3", "motion.branch=\"ii\""});
  EXPECT_EQ(pair.code, 2);
  EXPECT_THAT(pair.err, HasSubstr("leaves a force V_alpha"));

  const Outcome outcome = run_with_sets({"continue", fibre_case, "-o", "-"}, turning);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  EXPECT_GT(number(rows.front().at("alpha")), 1e-4);
  EXPECT_LT(number(rows.back().at("alpha")), -1e-4);
  for (const Row& row : rows) {
    EXPECT_LT(number(row.at("residual")), 1e-14);
    EXPECT_EQ(row.at("event"),
              row.at("point") == "0" || row.at("point") == rows.back().at("point") ? "limit" : "");
  }
}

TEST(AnisotropicCase, ContinuesInTheAngle) {
  const Outcome outcome =
      run_with_sets({"continue", fibre_case, "-o", "-"},
                    {"continuation.parameter=\"potential.fibre.degrees\"", "continuation.from=0",
                     "continuation.to=90", "continuation.tolerance=1e-5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto rows = rows_of(outcome.out);
  EXPECT_NEAR(number(rows.front()["alpha"]), 0.0, 1e-15);
  EXPECT_NEAR(number(rows.back()["alpha"]), 0.0, 1e-15);
  EXPECT_EQ(rows.back()["potential.fibre.degrees"], "90");
}

constexpr const char* map_over_nu = "map.x={parameter=\"nu\",from=0.0,to=0.95,count=6}";
constexpr const char* map_over_angle =
    "map.y={parameter=\"potential.fibre.degrees\",from=0,to=90,count=4}";

/// A cell is what solve finds at its parameters, whichever these are; without the search for other
/// sheets, which solve makes where that of rest ends.
TEST(AnisotropicCase, MapsAreSolvesOfTheirOwn) {
  for (const char* y : {"potential.fibre.degrees\",from=0,to=90",
                        "potential.fibre.k\",from=0.1,to=2", "potential.plane.mu\",from=0.5,to=1.5",
                        "potential.thickness.a\",from=0.5,to=2", "body.J.1\",from=0.3,to=3"}) {
    const Outcome outcome =
        run_with_sets({"map", fibre_case, "-o", "-"},
                      {map_over_nu, "map.y={parameter=\"" + std::string(y) + ",count=4}"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = rows_of(outcome.out);
    ASSERT_EQ(rows.size(), 24U) << y;
    const std::string key = std::string(y).substr(0, std::string(y).find('"'));
    for (const std::size_t k : {0U, 8U, 15U, 21U}) {
      ASSERT_EQ(rows[k].at("status"), "solved") << key << " " << k;
      const Row one =
          only_row(run_with_sets({"solve", fibre_case, "-o", "-"},
                                 {"motion.nu=" + rows[k].at("nu"), key + "=" + rows[k].at(key)})
                       .out);
      for (const char* column : {"class", "negative", "krein1"})
        EXPECT_EQ(rows[k].at(column), one.at(column)) << key << " " << k << " " << column;
      for (const char* column : {"alpha", "xi", "zeta", "rho", "angle", "pi3", "energy", "im5"}) {
        EXPECT_EQ(rows[k].at(column).empty(), one.at(column).empty());
        if (one.at(column).empty()) continue;  // no angle of a circle, no fifth mode at rest
        EXPECT_NEAR(number(rows[k].at(column)), number(one.at(column)),
                    1e-13 * (1.0 + std::abs(number(one.at(column)))))
            << key << " " << k << " " << column;
      }
    }
  }
}

TEST(AnisotropicCase, MapsDoNotDependOnThreadsOrTheGridsOrder) {
  const std::vector<std::string> cells{map_over_nu, map_over_angle, "output.spectrum=false"};
  const Outcome one = run_with_sets({"map", fibre_case, "-o", "-", "--threads", "1"}, cells);
  EXPECT_EQ(run_with_sets({"map", fibre_case, "-o", "-", "--threads", "3"}, cells).out, one.out);
  const Outcome turned =
      run_with_sets({"map", fibre_case, "-o", "-"},
                    {"map.y={parameter=\"nu\",from=0.0,to=0.95,count=6}",
                     "map.x={parameter=\"potential.fibre.degrees\",from=0,to=90,count=4}",
                     "output.spectrum=false"});
  const auto rows = rows_of(one.out);
  const auto turned_rows = rows_of(turned.out);
  ASSERT_EQ(rows.size(), turned_rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& other = turned_rows[(k % 6) * 4 + k / 6];
    for (const char* column : {"status", "alpha", "xi", "zeta", "rho", "error_bound"})
      EXPECT_EQ(rows[k].at(column), other.at(column)) << k << " " << column;
  }
}

TEST(AnisotropicCase, MapsComputeWhatIsAskedForAndSayHow) {
  const TemporaryDirectory directory;
  const auto metadata_of = [&](const std::vector<std::string>& options,
                               const std::vector<std::string>& columns) {
    std::vector<std::string> arguments{"map", fibre_case, "-o", directory / "x.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::vector<std::string> sets{map_over_nu, map_over_angle};
    sets.insert(sets.end(), columns.begin(), columns.end());
    const Outcome outcome = run_with_sets(arguments, sets);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(text_of(directory / "x.meta.json"));
  };
  const auto bare = metadata_of({}, {R"(output.columns=["alpha"])"});
  EXPECT_EQ(bare["counts"]["spectra"], 0);
  EXPECT_EQ(bare["counts"]["potentials"], 0);
  EXPECT_EQ(bare["counts"]["scalar_lanes"], 4);
  EXPECT_EQ(bare["run"]["instructions"], "scalar");
  EXPECT_EQ(bare["plan"].back()["quantity"], "cells");
  const auto all = metadata_of({"--certify"}, {});
  EXPECT_EQ(all["counts"]["spectra"], all["counts"]["solved"]);
  EXPECT_EQ(all["counts"]["proven"], all["counts"]["solved"]);
  EXPECT_LT(all["counts"]["solved"], 24) << "some sheets escape before";
  for (const Row& row : rows_of(text_of(directory / "x.csv")))
    EXPECT_EQ(row.at("certified"), row.at("status") == "solved" ? "yes" : "");
}

TEST(AnisotropicCase, MapsProveThatNoneIsAboutAnAxisThatIsNoneOfSymmetry) {
  const std::vector<std::string> cells{
      "motion.branch=\"i\"", "map.x={parameter=\"nu\",from=0.0,to=0.4,count=3}", map_over_angle};
  const Outcome outcome = run_with_sets({"map", fibre_case, "-o", "-"}, cells);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const Row& row : rows_of(outcome.out)) {
    const double degrees = number(row.at("potential.fibre.degrees"));
    const bool even = degrees == 0.0 || degrees == 90.0;
    const bool rests = row.at("nu") == "0";
    EXPECT_EQ(row.at("status"), even || rests ? "solved" : "none-exists") << row.at("point");
  }
  const Outcome none =
      run_with_sets({"map", fibre_case, "-o", "-"},
                    {"motion.branch=\"ii\"", "map.x={parameter=\"nu\",from=0.2,to=0.4,count=2}"});
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("no stationary ellipsoid in any of 2 cells: 2 none-exists"));
}

TEST(AnisotropicCase, NoMotionAboutAnAxisThatIsNoneOfSymmetry) {
  const Outcome outcome = run_with_sets({"solve", fibre_case}, {"motion.branch=\"i\""});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no stationary ellipse about this axis"));
  EXPECT_THAT(outcome.err, HasSubstr("no stationary ellipsoid in the box searched"));
  EXPECT_THAT(outcome.err, HasSubstr("the nearest residual is"));
}

TEST(AnisotropicCase, WrongInputIsRefusedByName) {
  struct Fault {
    std::vector<std::string> sets;
    std::string fragment;
  };
  const std::string orthotropic =
      "potential.plane={ model = \"orthotropic-saint-venant-kirchhoff\", c11 = 2.0, c22 = 1.0, "
      "c12 = 2.0, c66 = 0.4 }";
  for (const Fault& fault : std::vector<Fault>{
           {{"potential.fibre.k=-1"}, "potential.fibre.k: found k = -1; expected k > 0"},
           {{"potential.fibre.kk=1"}, "did you mean \"k\"?"},
           {{"potential.fibre=3"}, "expected a table"},
           {{orthotropic}, "expected c11 c22 > c12^2"},
           {{"motion.branch=\"tilted\""}, "with an anisotropic potential"},
           {{"motion.branch=\"two-polar\""}, "with an anisotropic potential"},
           {{"motion.branch=\"oblique\"", "motion.nu=0"}, "expected nu > 0"},
           {{"motion.branch=\"oblique\"", "motion.axis=\"3\""}, "one of \"1\", \"2\""},
           {{"motion.axis=\"1\""}, "found axis, which branch \"iii\" does not take"},
           {{"solve.method=\"ceres\""}, "with an anisotropic potential"},
       }) {
    const Outcome outcome = run_with_sets({"check", fibre_case}, fault.sets);
    EXPECT_EQ(outcome.code, 2) << fault.fragment;
    EXPECT_THAT(outcome.err, HasSubstr(fault.fragment));
  }
}

TEST(AnisotropicCase, ContinueAsksWhichObliqueFamily) {
  const std::vector<std::string> coarse{"motion.branch=\"oblique\"", "continuation.to=0.6",
                                        "continuation.tolerance=1e-6"};
  const Outcome neither = run_with_sets({"continue", fibre_case}, coarse);
  EXPECT_EQ(neither.code, 2);
  EXPECT_THAT(neither.err, HasSubstr("motion.axis: found no such key, and oblique motions with "
                                     "|nu| = 0.5 of the families of both axes"));
  std::vector<std::string> second = coarse;
  second.push_back("motion.axis=\"2\"");
  const Outcome named = run_with_sets({"continue", fibre_case, "-o", "-"}, second);
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_GT(std::abs(number(rows_of(named.out).back()["nu2"])), 0.59);
}

TEST(AnisotropicCase, AtlasHasTheObliqueSheets) {
  const TemporaryDirectory directory;
  const std::vector<std::string> sets{"continuation.to=0.5", "continuation.tolerance=1e-6",
                                      "output.certificate=true"};
  const Outcome written =
      run_with_sets({"atlas", fibre_case, "-o", directory / "x.csv", "--checkpoints", "3"}, sets);
  ASSERT_EQ(written.code, 0) << written.err;
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  ASSERT_EQ(metadata["sheets"].size(), 3U);
  EXPECT_EQ(metadata["sheets"][0]["branch"], "iii");
  EXPECT_EQ(metadata["sheets"][2]["branch"], "oblique");
  ASSERT_EQ(metadata["checkpoints"].size(), 6U);
  for (const auto& at : metadata["checkpoints"]) EXPECT_TRUE(at["complete"].get<bool>()) << at;
  EXPECT_EQ(metadata["remarks"][0]["branch"], "i");
  long unproven = 0;
  for (const Row& row : rows_of(text_of(directory / "x.csv")))
    unproven += row.at("certified") != "yes";
  EXPECT_EQ(metadata["counts"]["proven"].get<long>() + unproven, metadata["rows"].get<long>());
  EXPECT_EQ(unproven, 0);
  const Outcome printed = run_with_sets({"atlas", fibre_case, "--checkpoints", "3"}, sets);
  ASSERT_EQ(printed.code, 0) << printed.err;
  EXPECT_THAT(printed.out, HasSubstr("branch (oblique): at 3 of 3 checkpoints"));
  EXPECT_THAT(printed.out, HasSubstr("branch (ii): not looked for"));
}

TEST(AnisotropicCase, OrthotropicPlaneInEveryBranch) {
  const std::string plane =
      "potential.plane={ model = \"orthotropic-saint-venant-kirchhoff\", c11 = 3.0, c22 = 1.0, "
      "c12 = 0.5, c66 = 0.4 }";
  const TemporaryDirectory directory;
  std::string text = text_of(fibre_case);
  const auto fibre = text.find("fibre     =");
  text.erase(fibre, text.find('\n', fibre) - fibre);
  const std::string path = directory.file("orthotropic.toml", text);
  for (const char* branch : {"\"i\"", "\"ii\"", "\"iii\""}) {
    const Outcome outcome =
        run_with_sets({"solve", path, "--certify", "-o", "-"},
                      {plane, std::string("motion.branch=") + branch, "motion.nu=0.2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    auto row = only_row(outcome.out);
    EXPECT_EQ(row["alpha"], "0");
    EXPECT_EQ(row["certified"], "yes");
    EXPECT_EQ(row["class_certified"], "yes");
  }
}

/// V is even in alpha, and less with alpha != 0 than at its least without.
const char* const leaning_case = R"([body]
J = [0.5498, 1.351, 0.827]
volume = 0.5
[potential]
plane     = { model = "orthotropic-saint-venant-kirchhoff", c11 = 0.9378, c22 = 2.134, c12 = 0.1849, c66 = 0.3036 }
thickness = { model = "reciprocal-quadratic", a = 2.183, b = 0.6789 }
[motion]
branch = "iii"
nu = 0.1
[continuation]
from = 0.0
to = 0.6
[map]
x = { parameter = "nu", from = 0.0, to = 1.4, count = 15 }
)";

TEST(AnisotropicCase, OfAnEvenPotentialTheSheetFromRestHasNoShearEvenWhereThatMakesLessOfIt) {
  const TemporaryDirectory directory;
  const std::string leaning = directory.file("leaning.toml", leaning_case);
  const Outcome solved = run_with_sets({"solve", leaning, "-o", "-"});
  ASSERT_EQ(solved.code, 0) << solved.err;
  auto row = only_row(solved.out);
  EXPECT_EQ(row["alpha"], "0");
  EXPECT_NEAR(number(row["xi"]), 0.3344528349874476, 1e-15);
  EXPECT_NEAR(number(row["zeta"]), 1.02364148544089, 1e-14);
  EXPECT_EQ(row["class"], "unstable");
  const Outcome map = run_with_sets({"map", leaning, "-o", "-"});
  ASSERT_EQ(map.code, 0) << map.err;
  const auto cells = rows_of(map.out);
  ASSERT_EQ(cells.size(), 15U);
  for (const Row& cell : cells) EXPECT_EQ(cell.at("status"), "solved") << cell.at("nu");
  EXPECT_EQ(cells[1].at("alpha"), "0");
  EXPECT_NEAR(number(cells[1].at("xi")), 0.3344528349874476, 1e-15);
}

TEST(AnisotropicCase, NoMotionAboutAMaterialAxisIsOblique) {
  const TemporaryDirectory directory;
  const std::string leaning = directory.file("leaning.toml", leaning_case);
  // A motion about axis 2.
  const Outcome solved = run_with_sets(
      {"solve", leaning, "-o", "-"}, {"motion.branch=oblique", "motion.axis=\"2\"",
                                      "motion.nu=0.55", "solve.start=[0.0, 1.206, 0.2448, 1.694]"});
  EXPECT_EQ(solved.code, 3);
  EXPECT_THAT(solved.err, HasSubstr("came to a motion about axis 2"));
  const Outcome atlas =
      run_with_sets({"atlas", leaning, "-o", "-"}, {"atlas.checkpoints=4", "motion.nu=0.4667"});
  ASSERT_EQ(atlas.code, 0) << atlas.err;
  int about_two = 0;
  for (const Row& row : rows_of(atlas.out)) {
    about_two += row.at("branch") == "ii";
    EXPECT_NE(row.at("event"), "unexplained");
    if (row.at("branch") != "oblique" || row.at("event") == "oblique") continue;
    EXPECT_GT(std::abs(number(row.at("alpha"))), 1e-9) << row.at("nu1") << " " << row.at("nu2");
  }
  EXPECT_GT(about_two, 100);
}

/// mu = J1 nu^2 leaves zeta^2 + alpha^2 = 1.5 free, with xi zeta = e + alpha^2: a sheet at nu = 1.
TEST(AnisotropicCase, ShearedMotionsAtOneRate) {
  const TemporaryDirectory directory;
  const std::string upright = directory.file("upright.toml", R"([body]
J = [1.0, 2.0, 0.8]
[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 1.0 }
thickness = { model = "harmonic", k = 1.4, rest = 0.8 }
fibre     = { k = 1.0, degrees = 90.0 }
[motion]
branch = "iii"
nu = 0.5
[continuation]
from = 0.0
to = 1.6
[atlas]
checkpoints = 6
)");
  const Outcome atlas = run_with_sets({"atlas", upright, "-o", "-"});
  ASSERT_EQ(atlas.code, 0) << atlas.err;
  int at_one = 0;
  double most = 0.0;
  for (const Row& row : rows_of(atlas.out)) {
    if (row.at("branch") != "iii" || number(row.at("alpha")) == 0.0) continue;
    ++at_one;
    const double alpha = number(row.at("alpha"));
    const double zeta = number(row.at("zeta"));
    EXPECT_NE(row.at("event"), "fold-nu");
    EXPECT_NE(row.at("event"), "stalled");
    EXPECT_NEAR(number(row.at("nu3")), 1.0, 1e-11);
    EXPECT_NEAR(zeta * zeta + alpha * alpha, 1.5, 1e-10);
    EXPECT_NEAR(number(row.at("xi")) * zeta, std::exp(1.0) + alpha * alpha, 1e-9);
    most = std::max(most, std::abs(alpha));
  }
  EXPECT_GT(at_one, 20);
  EXPECT_GT(most, 1.0);
}

}  // namespace
}  // namespace stationary::testing
