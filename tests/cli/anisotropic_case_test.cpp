// Anisotropic bodies and oblique axes from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/cli/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

Outcome run(std::vector<std::string> arguments, const std::vector<std::string>& sets = {}) {
  for (const std::string& each : sets) {
    arguments.push_back("--set");
    arguments.push_back(each);
  }
  return run_program(arguments);
}

const std::string fibre_case = shipped("fibre.toml");
const std::string oblique_case = shipped("oblique.toml");

TEST(AnisotropicCase, CheckPrintsTheFacts) {
  const Outcome skew = run({"check", fibre_case});
  EXPECT_EQ(skew.code, 0) << skew.err;
  EXPECT_THAT(skew.out, HasSubstr("fibre: k = 0.4, degrees = 30"));
  EXPECT_THAT(skew.out, HasSubstr("separable, anisotropic, V_alpha != 0 at alpha = 0"));
  EXPECT_THAT(skew.out, HasSubstr("an unknown"));
  const Outcome even = run({"check", fibre_case}, {"potential.fibre.degrees=90"});
  EXPECT_THAT(even.out, HasSubstr("even in alpha: V_alpha = 0 at alpha = 0"));
  const Outcome pair = run({"check", fibre_case},
                           {"potential.second_fibre.k=0.4", "potential.second_fibre.degrees=-30"});
  EXPECT_THAT(pair.out, HasSubstr("even in alpha"));
  const Outcome oblique = run({"check", oblique_case});
  EXPECT_THAT(oblique.out, HasSubstr("about an axis in the plane of axes 1 and 2, |nu| = 0.5"));
}

TEST(AnisotropicCase, SolvesAboutAxisThreeWithAlpha) {
  const Outcome outcome = run({"solve", fibre_case, "--certify", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["branch"], "iii");
  EXPECT_NEAR(number(row["alpha"]), -0.0109021879560, 1e-12);
  EXPECT_EQ(row["certified"], "yes");
  EXPECT_EQ(row["class"], "stable");
  EXPECT_EQ(row["class_certified"], "no");
}

TEST(AnisotropicCase, ObliqueMotionsOfBothAxesOrOne) {
  const Outcome both = run({"solve", oblique_case, "-o", "-"}, {"motion.axis=\"1\""});
  ASSERT_EQ(both.code, 0) << both.err;
  auto one = only_row(both.out);
  EXPECT_EQ(one["branch"], "oblique");
  EXPECT_NEAR(std::hypot(number(one["nu1"]), number(one["nu2"])), 0.5, 1e-15);
  EXPECT_EQ(one["nu3"], "0");
  EXPECT_NEAR(number(one["pi1"]) * number(one["nu2"]), number(one["pi2"]) * number(one["nu1"]),
              1e-15);
  auto two = only_row(run({"solve", oblique_case, "-o", "-"}, {"motion.axis=\"2\""}).out);
  EXPECT_LT(std::abs(number(two["nu1"])), std::abs(number(two["nu2"])));
  // Every one, with proof: these two.
  const Outcome every = run({"solve", oblique_case, "-o", "-"}, {"solve.all=true"});
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
  ASSERT_EQ(run({"continue", oblique_case, "--quiet", "-o", whole}, coarse).code, 0);
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
  ASSERT_EQ(run({"continue", oblique_case, "--quiet", "-o", cut}, short_of).code, 0);
  const Outcome on = run({"continue", oblique_case, "--resume", "--quiet", "-o", cut}, coarse);
  ASSERT_EQ(on.code, 0) << on.err;
  auto again = rows_of(text_of(cut));
  EXPECT_NEAR(number(again.back()["alpha"]), number(rows.back()["alpha"]), 1e-12);
  EXPECT_EQ(again.back()["event"], "limit");
}

TEST(AnisotropicCase, ContinuesInTheAngle) {
  const Outcome outcome =
      run({"continue", fibre_case, "-o", "-"},
          {"continuation.parameter=\"potential.fibre.degrees\"", "continuation.from=0",
           "continuation.to=90", "continuation.tolerance=1e-5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto rows = rows_of(outcome.out);
  EXPECT_NEAR(number(rows.front()["alpha"]), 0.0, 1e-15);
  EXPECT_NEAR(number(rows.back()["alpha"]), 0.0, 1e-15);
  EXPECT_EQ(rows.back()["potential.fibre.degrees"], "90");
}

TEST(AnisotropicCase, NoMotionAboutAnAxisThatIsNoneOfSymmetry) {
  const Outcome outcome = run({"solve", fibre_case}, {"motion.branch=\"i\""});
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
    const Outcome outcome = run({"check", fibre_case}, fault.sets);
    EXPECT_EQ(outcome.code, 2) << fault.fragment;
    EXPECT_THAT(outcome.err, HasSubstr(fault.fragment));
  }
}

TEST(AnisotropicCase, AtlasHasTheObliqueSheets) {
  const TemporaryDirectory directory;
  const std::vector<std::string> sets{"continuation.to=0.5", "continuation.tolerance=1e-6",
                                      "output.certificate=true"};
  const Outcome written =
      run({"atlas", fibre_case, "-o", directory / "x.csv", "--checkpoints", "3"}, sets);
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
  EXPECT_LE(unproven, 2);  // the rows of the oblique sheets at rest
  const Outcome printed = run({"atlas", fibre_case, "--checkpoints", "3"}, sets);
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
    const Outcome outcome = run({"solve", path, "--certify", "-o", "-"},
                                {plane, std::string("motion.branch=") + branch, "motion.nu=0.2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    auto row = only_row(outcome.out);
    EXPECT_EQ(row["alpha"], "0");
    EXPECT_EQ(row["certified"], "yes");
    EXPECT_EQ(row["class_certified"], "yes");
  }
}

}  // namespace
}  // namespace stationary::testing
