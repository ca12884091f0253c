// Events of bodies with more symmetry than their equations show, from outside: sheets of circles, a
// momentum more that is kept, a potential that is isotropic in other words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::ElementsAre;

/// `continue` of a case as text, the table's rows.
std::vector<Row> table_followed(const std::string& text, int code = 0) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"continue", directory.file("case.toml", text), "-o", "-"});
  EXPECT_EQ(outcome.code, code) << outcome.err;
  return rows_of(outcome.out);
}

/// The events between the ends.
std::vector<Row> between_ends(const std::vector<Row>& rows) {
  std::vector<Row> out = events_of(rows);
  EXPECT_GE(out.size(), 2U);
  if (out.size() < 2) return {};
  return {out.begin() + 1, out.end() - 1};
}

std::vector<std::string> names(const std::vector<Row>& events) {
  std::vector<std::string> out;
  for (const Row& each : events) out.push_back(each.at("event"));
  return out;
}

std::string class_beside(const std::vector<Row>& rows, std::string_view event, int step) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].at("event") == event)
      return rows[static_cast<std::size_t>(static_cast<int>(k) + step)].at("class");
  return "none";
}

/// V = m (ln^2 lambda + ln^2 mu + ln^2 rho) with J1 = J2 = J3 and det S = 1: on the circle zeta = rho,
/// v = ln zeta, nu^2 = 6 v e^(-2 v), which turns at v = 1/2. A term in det S alone changes nothing.
TEST(SymmetricBodies, ACircleOfAHeldVolumeTurnsWhereItsClosedFormDoes) {
  for (const char* l : {"-2.0", "0.0", "1.0", "3.0"}) {
    for (const std::string branch : {"i", "ii"}) {
      const std::vector<Row> rows = table_followed(
          "[body]\nJ = [1.0, 1.0, 1.0]\nvolume = 1.0\n[potential]\n"
          "coupled = { expression = \"m*(log(lambda_)^2+log(mu_)^2+log(rho)^2)+l/2*log(d*rho)^2\", "
          "m = 1.0, l = " +
          std::string(l) +
          " }\n"
          "[motion]\nbranch = \"" +
          branch +
          "\"\nnu = 0.3\n"
          "[continuation]\nfrom = 0.3\nto = 1.6\ntolerance = 1e-5\n");
      std::vector<Row> turns;
      for (const Row& each : between_ends(rows))
        if (each.at("event") == "fold-nu") turns.push_back(each);
      ASSERT_EQ(turns.size(), 1U) << branch << " " << l;
      const std::string nu = branch == "i" ? "nu1" : "nu2";
      EXPECT_NEAR(number(turns[0].at(nu)), std::sqrt(3.0 / std::numbers::e), 1e-14);
      EXPECT_NEAR(number(turns[0].at("rho")), std::exp(0.5), 1e-13);
      EXPECT_EQ(rows.back().at("event"), "limit");
    }
  }
}

/// The axis leaves a body that is round about it towards both others; in its plane alpha moves with
/// it, so that one direction changes its sign and not two.
TEST(SymmetricBodies, TheAxisOfARoundBodyTiltsOnce) {
  for (const double J3 : {0.8, 0.7}) {
    const std::vector<Row> rows = table_followed(
        "[body]\nJ = [1.0, " + std::to_string(J3) + ", " + std::to_string(J3) +
        "]\n[potential]\ncoupled = { model = \"neo-hookean-3d\", mu = 1.0, lambda = 2.0 }\n"
        "[motion]\nbranch = \"i\"\nnu = 0.3\n"
        "[continuation]\nfrom = 0.1\nto = 1.0\ntolerance = 1e-6\n");
    EXPECT_THAT(names(between_ends(rows)), ElementsAre("tilt"));
    EXPECT_EQ(class_beside(rows, "tilt", -1), "elliptic");
    EXPECT_EQ(class_beside(rows, "tilt", +1), "unstable");
  }
}

/// Stretched to thousands the derivatives of V in double are rounding: J2 nu^2 zeta^2 = m at the one
/// place where the circle breaks.
TEST(SymmetricBodies, ACircleBreaksOnce) {
  const std::vector<Row> rows = table_followed(
      "[body]\nJ = [1.0, 1.0, 1.0]\n[potential]\n"
      "coupled = { expression = \"m*(log(lambda_)^2+log(mu_)^2+log(rho)^2)+l/2*log(d*rho)^2\", "
      "m = 1.0, l = 10.0 }\n[motion]\nbranch = \"i\"\nnu = 0.3\n"
      "[continuation]\nfrom = 0.0\nto = 1.6\ntolerance = 1e-10\n");
  const std::vector<Row> events = between_ends(rows);
  ASSERT_THAT(names(events), ElementsAre("ellipse-23", "fold-nu"));
  EXPECT_NEAR(number(events[0].at("nu1")) * number(events[0].at("zeta")), 1.0, 1e-14);
}

/// c11 = c22, c66 = (c11 - c12)/2: isotropic. With J1 = J2 the function of `oblique` is 0 all along.
TEST(SymmetricBodies, WhatVanishesAllAlongIsNoEvent) {
  for (const char* branch : {"i", "ii"}) {
    const std::vector<Row> rows = table_followed(
        "[body]\nJ = [1.0, 1.0, 0.5]\n[potential]\n"
        "plane = { model = \"orthotropic-saint-venant-kirchhoff\", c11 = 3.0, c22 = 3.0, "
        "c12 = 1.0, c66 = 1.0 }\nthickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 "
        "}\n"
        "[motion]\nbranch = \"" +
        std::string(branch) +
        "\"\nnu = 0.3\n"
        "[continuation]\nfrom = 0.0\nto = 1.2\ntolerance = 1e-6\n");
    EXPECT_THAT(names(between_ends(rows)), ElementsAre()) << branch;
  }
}

/// J1 = J2: a momentum about the material axis is kept too, and Lambda passes 0 with no turn of |pi|
/// and no change of `negative`. Where: by another linearization, in 50 digits, between these two.
TEST(SymmetricBodies, GrowthThatNoOtherSignTellsIsToldAsUnexplained) {
  const TemporaryDirectory directory;
  const std::string file =
      directory.file("case.toml",
                     "[body]\nJ = [1.705, 1.705, 1.705]\n[potential]\n"
                     "plane = { model = \"reciprocal-determinant\", c = 1.408, k = 1.949 }\n"
                     "thickness = { model = \"harmonic\", k = 0.791, rest = 1.454 }\n"
                     "[motion]\nbranch = \"iii\"\nnu = 0.055\n"
                     "[continuation]\nfrom = 0.0\nto = 1.5\ntolerance = 1e-6\n");
  const std::string straight = directory.file("a.csv", "");
  ASSERT_EQ(run_program({"continue", file, "-o", straight}).code, 0);
  const Outcome tilted = run_program(
      {"continue", file, "--from", straight + ":tilt", "--set", "motion.branch=tilted", "-o", "-"});
  ASSERT_EQ(tilted.code, 0) << tilted.err;
  const std::vector<Row> rows = rows_of(tilted.out);
  std::vector<Row> found;
  for (const Row& each : between_ends(rows))
    if (each.at("event") == "unexplained") found.push_back(each);
  ASSERT_EQ(found.size(), 1U);
  const double nu = std::hypot(number(found[0].at("nu1")), number(found[0].at("nu3")));
  EXPECT_GT(nu, 1.04046);
  EXPECT_LT(nu, 1.04412);
  EXPECT_EQ(class_beside(rows, "unexplained", -1), "stable");
  EXPECT_EQ(class_beside(rows, "unexplained", +1), "unstable");
}

/// A two-polar family on its circle is (iii) at nu = omega + theta', whose momentum turns there.
TEST(SymmetricBodies, ACircleOfATwoPolarFamilyTellsWhereItLosesItsStability) {
  const std::string body =
      "[body]\nJ = [0.837, 0.837, 0.837]\n[gravity]\npi_G_rho = 1.44\n[potential]\n"
      "coupled = { model = \"neo-hookean-3d\", mu = 1.482, lambda = 0.956 }\n";
  const std::string range =
      "[continuation]\nparameter = \"potential.coupled.lambda\"\nfrom = 0.85\nto = 0.96\n"
      "tolerance = 1e-6\n";
  const std::vector<Row> rows = table_followed(
      body + "[motion]\nbranch = \"two-polar\"\nomega = 0.824\ntheta_dot = 0.673\n" + range);
  const std::vector<Row> events = between_ends(rows);
  ASSERT_THAT(names(events), ElementsAre("unexplained"));
  EXPECT_NEAR(number(events[0].at("potential.coupled.lambda")), 0.899644090833, 1e-9);
  EXPECT_EQ(class_beside(rows, "unexplained", -1), "stable");
  EXPECT_EQ(class_beside(rows, "unexplained", +1), "unstable");
}

/// A pitchfork whose mirror axes are not the material ones is not passed; nothing escapes there.
/// On the circle E + c P, P the momentum of turns in the material, is definite for the c above the wobble and
/// below half of nu + R, R the frequency of shear in turned axes; these part where the two are equal. No
/// frequencies meet there, and `negative` stays 4.
TEST(SymmetricBodies, ACircleIsNoMoreDefiniteWhereNoFrequenciesMeet) {
  const std::vector<Row> rows = table_followed(
      "[body]\nJ = [0.302, 0.302, 1.292]\nvolume = 1.934\n[potential]\n"
      "plane = { model = \"hencky\", mu = 0.3251, lambda = 0.5872 }\n"
      "thickness = { model = \"harmonic\", k = 0.6175, rest = 2.056 }\n"
      "[motion]\nbranch = \"iii\"\nnu = 0.1\n"
      "[continuation]\nfrom = 0.0\nto = 1.4\ntolerance = 1e-6\n");
  const std::vector<Row> events = between_ends(rows);
  const auto at =
      std::ranges::find(events, "unexplained", [](const Row& each) { return each.at("event"); });
  ASSERT_NE(at, events.end());
  EXPECT_NEAR(number(at->at("nu3")), 1.148456264430534014073985, 1e-9);
  EXPECT_EQ(class_beside(rows, "unexplained", -1), "stable");
  EXPECT_EQ(class_beside(rows, "unexplained", 1), "elliptic");
  EXPECT_EQ(std::ranges::count(names(events), "unexplained"), 1);
}

/// A coefficient that enters no balance of the circle: its ellipses come to it all the same, at
/// mu = J (omega^2 + theta_dot^2)(1 + J (omega + theta_dot)^2/k), xi^2 = zeta^2 = 1 + J (omega + theta_dot)^2/k.
TEST(SymmetricBodies, EllipsesMeetACircleThatTheParameterLeavesAlone) {
  const std::string body =
      "[body]\nJ = [1.566, 1.566, 1.206]\n[potential]\n"
      "plane = { expression = \"mu/2*(I1/d - 2) + k/2*(d-1)^2\", mu = 0.8728, k = 3.326 }\n"
      "thickness = { model = \"reciprocal-quadratic\", a = 0.006926, b = 637.5 }\n";
  const std::string range =
      "[continuation]\nparameter = \"potential.plane.mu\"\nfrom = 0.2182\nto = 3.491\n";
  const std::vector<Row> two_polar = table_followed(
      body + "[motion]\nbranch = \"two-polar\"\nomega = 0.31701\ntheta_dot = 0.40706\n" + range);
  ASSERT_FALSE(two_polar.empty());
  const Row& last =
      two_polar.front().at("event") == "ellipse" ? two_polar.front() : two_polar.back();
  EXPECT_EQ(last.at("event"), "ellipse");
  EXPECT_NEAR(number(last.at("potential.plane.mu")), 0.519759457834063615039, 1e-14);
  EXPECT_NEAR(number(last.at("xi")), 1.116623738279989655, 1e-13);
  EXPECT_NEAR(number(last.at("zeta")), 1.116623738279989655, 1e-13);
  const std::vector<Row> third =
      table_followed(body +
                     "[motion]\nbranch = \"iii\"\nnu = 0.6\n[solve]\n"
                     "start = [0, 3.1254491982997803, 0.4953452866428406, 0.022147978811976516]\n" +
                     range);
  ASSERT_FALSE(third.empty());
  const Row& end = third.front().at("event") == "ellipse" ? third.front() : third.back();
  EXPECT_EQ(end.at("event"), "ellipse");
  EXPECT_NEAR(number(end.at("potential.plane.mu")), 0.6593178285027, 1e-12);
}

/// An axis that turns where J1 = J2 does so at that double: J2 is known to half a unit, and so is the place.
TEST(SymmetricBodies, AnEventAtANumberOfTheBodyHasABracket) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      "[body]\nJ = [1.582, 1.582, 2.032]\n[potential]\n"
      "coupled = { model = \"neo-hookean-3d\", mu = 0.04129, lambda = 2.487 }\n"
      "[motion]\nbranch = \"i\"\nnu = 0.1145\n[continuation]\nparameter = \"body.J.0\"\n"
      "from = 0.3955\nto = 6.328\ntolerance = 1e-6\n");
  const Outcome outcome = run_program({"continue", path, "-o", directory / "x.csv", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  int seen = 0;
  for (const auto& event : metadata["events"]) {
    EXPECT_LT(event["bracket"][0], event["bracket"][1]) << event;
    EXPECT_LE(event["bracket"][0], event["parameter"]) << event;
    EXPECT_GE(event["bracket"][1], event["parameter"]) << event;
    seen += event["parameter"] == 1.582;
  }
  EXPECT_GE(seen, 1);
}

TEST(SymmetricBodies, AnEndAtModerateStretchesIsNoEscape) {
  const std::vector<Row> rows = table_followed(
      "[body]\nJ = [1.5, 1.5, 0.4]\n[potential]\n"
      "plane = { model = \"biot-log\", mu = 1.0, lambda = 2.0 }\n"
      "thickness = { model = \"harmonic\", k = 2.0, rest = 1.0 }\n"
      "fibre = { k = 0.5, degrees = 45.0 }\n[motion]\nbranch = \"iii\"\nnu = 0.3\n"
      "[continuation]\nfrom = 0.0\nto = 2.5\ntolerance = 1e-6\n",
      4);
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.back().at("event"), "stalled");
  EXPECT_NEAR(number(rows.back().at("nu3")), 0.937404977, 1e-6);
}

/// Of a sphere three frequencies are near one another: a map leaves them to what `solve` has them by. Lambda of the
/// plane are -2, -2 + nu^2 and -2 - 3 nu^2 but for higher powers.
TEST(SymmetricBodies, FrequenciesOfASphereAreTheSameInAMap) {
  const TemporaryDirectory directory;
  const std::string path =
      directory.file("case.toml",
                     "[body]\nJ = [1.0, 1.0, 1.0]\n[potential]\n"
                     "plane = { model = \"biot\", mu = 1.0, lambda = 0.0 }\n"
                     "thickness = { model = \"harmonic\", k = 2.0, rest = 1.0 }\n"
                     "[motion]\nbranch = \"i\"\nnu = 0.001\n"
                     "[map]\nx = { parameter = \"nu\", from = 1e-4, to = 1e-3, count = 3 }\n");
  const Outcome map = run_program({"map", path, "-o", "-"});
  ASSERT_EQ(map.code, 0) << map.err;
  const auto cells = rows_of(map.out);
  ASSERT_EQ(cells.size(), 3U);
  for (const Row& cell : cells) {
    const Outcome alone =
        run_program({"solve", path, "-o", "-", "--set", "motion.nu=" + cell.at("nu1")});
    ASSERT_EQ(alone.code, 0) << alone.err;
    const auto rows = rows_of(alone.out);
    ASSERT_EQ(rows.size(), 1U);
    int near = 0;
    const double nu2 = std::pow(number(cell.at("nu1")), 2);
    for (const std::string k : {"1", "2", "3", "4", "5"}) {
      EXPECT_EQ(cell.at("im" + k), rows.front().at("im" + k)) << k;
      const double im = number(cell.at("im" + k));
      for (const double lambda : {2.0 - nu2, 2.0, 2.0 + 3.0 * nu2})
        near += std::abs(im * im - lambda) <= 10.0 * nu2 * nu2 + 1e-13;
    }
    EXPECT_GE(near, 3) << cell.at("nu1");
  }
}

}  // namespace
}  // namespace stationary::testing
