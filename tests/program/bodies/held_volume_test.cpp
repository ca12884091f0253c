// Bodies with their volume held, with gravity or without, from outside: every number may be followed, stiff
// bodies come to them, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

/// Every number of a body may be followed: with true slopes few points are enough, and each is what
/// `solve` finds there.
TEST(HeldVolume, EveryNumberMayBeFollowed) {
  const std::string head = "[body]\nJ = [1.0, 1.7, 0.6]\nvolume = 1.0\n[gravity]\ng = 2.0\n";
  const std::string elastic =
      "[potential]\nplane = { model = \"neo-hookean\", mu = 1, lambda = 2 }\n"
      "thickness = { model = \"reciprocal-quadratic\", a = 1, b = 3 }\n";
  int compared = 0;
  for (const std::string branch : {"i", "ii", "iii"}) {
    for (const std::string key : {"body.volume", "gravity.g", "body.J.0", "body.J.1", "body.J.2",
                                  "potential.plane.mu", "potential.thickness.a"}) {
      const TemporaryDirectory directory;
      const std::string path =
          directory.file("case.toml", head + elastic + "[motion]\nbranch = \"" + branch +
                                          "\"\nnu = 0.4\n[continuation]\nparameter = \"" + key +
                                          "\"\nfrom = 0.5\nto = 3.5\ntolerance = 1e-6\n");
      const Outcome outcome = run_program({"continue", path, "-o", directory / "table.csv"});
      ASSERT_EQ(outcome.code, 0) << branch << key << outcome.err;
      const std::vector<Row> rows = rows_of(text_of(directory / "table.csv"));
      EXPECT_LT(rows.size(), 400U) << branch << ' ' << key;
      ASSERT_GE(rows.size(), 5U) << branch << ' ' << key;
      const Row& row = rows[rows.size() / 3];
      std::ostringstream start;
      start.precision(17);
      start << "solve.start=[0.0," << row.at("xi") << ',' << row.at("zeta") << ',' << row.at("rho")
            << ']';
      const Outcome again = run_program(
          {"solve", path, "-o", "-", "--set", key + "=" + row.at(key), "--set", start.str()});
      ASSERT_EQ(again.code, 0) << branch << key << again.err;
      for (const std::string column : {"xi", "zeta", "rho", "pressure"})
        EXPECT_NEAR(number(only_row(again.out).at(column)) / number(row.at(column)), 1.0, 1e-13)
            << branch << ' ' << key << ' ' << column;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 21);
}

/// V + (k/2) ln^2(d rho) comes to the held volume as 1/k, by what its pressure does to the stretches
/// (40 digits, by an independent computation); its fifth mode is then -k sum 1/(J s^2).
TEST(HeldVolume, StiffBodiesComeToTheHeldVolume) {
  const std::string heavy = "[gravity]\ng = 2\n[motion]\nbranch = \"iii\"\nnu = 0.6\n";
  const std::string body = "[body]\nJ = [1, 1.7, 0.6]\n";
  const std::string elastic = "mu/2*(I1 + rho^2 - 3)";
  const TemporaryDirectory directory;
  const auto row = [&](const std::string& text) {
    return only_row(run_program({"solve", directory.file("case.toml", text), "-o", "-"}).out);
  };
  const Row held = row(body + "volume = 1\n[potential]\ncoupled = { expression = \"" + elastic +
                       "\", mu = 1 }\n" + heavy);
  EXPECT_NEAR(number(held.at("pressure")), 1.2882175387147790407, 1e-14);
  const std::pair<const char*, double> moved[] = {
      {"xi", -0.41431705956}, {"zeta", -0.62713423316}, {"rho", -0.27586298722}};
  for (const double k : {1e3, 1e4, 1e5, 1e6}) {
    const Row stiff =
        row(body + "[potential]\ncoupled = { expression = \"" + elastic +
            " + k/2*ln(d*rho)^2\", mu = 1, k = " + std::to_string(k) + " }\n" + heavy);
    const double doubt = 2.0 * number(stiff.at("error_bound"));
    for (const auto& [column, slope] : moved)
      EXPECT_NEAR(k * (number(stiff.at(column)) - number(held.at(column))), slope,
                  1.0 / k + k * doubt)
          << column << ", k = " << k;
    double rate = 0.0;
    const double J[] = {1.0, 1.7, 0.6};
    const char* const stretch[] = {"xi", "zeta", "rho"};
    for (int each = 0; each < 3; ++each)
      rate += 1.0 / (J[each] * std::pow(number(held.at(stretch[each])), 2));
    const double fifth = number(stiff.at("im5"));
    EXPECT_NEAR(fifth * fifth / (k * rate), 1.0, 10.0 / k);
    for (const std::string column : {"im1", "im2", "im3", "im4"})
      EXPECT_NEAR(number(stiff.at(column)), number(held.at(column)), 10.0 / k + k * doubt);
    EXPECT_EQ(stiff.at("class"), held.at("class"));
  }
}

TEST(HeldVolume, WrongInputIsRefusedByName) {
  const std::string body = "[body]\nJ = [1, 1, 1]\n";
  const std::string motion = "[motion]\nbranch = \"iii\"\nnu = 0.3\n";
  const std::string plane = "plane = { model = \"neo-hookean\", mu = 1, lambda = 2 }\n";
  const std::string thickness = "thickness = { model = \"harmonic\", k = 1, rest = 1 }\n";
  const std::pair<std::string, const char*> faults[] = {
      {body + "volume = 0\n" + motion, "body.volume"},
      {body + "volume = \"1\"\n" + motion, "body.volume"},
      {body + "[gravity]\ng = 4\n" + motion, "potential"},
      {body + "volume = 1\n[gravity]\ng = -4\n" + motion, "gravity.g"},
      {body + "volume = 1\n[gravity]\ng = 4\npi_G_rho = 1\n" + motion, "g or pi_G_rho"},
      {body + "volume = 1\n[gravity]\n" + motion, "g or pi_G_rho"},
      {body + "[potential]\n" + plane + motion, "thickness"},
      {"[body]\nJ = [1, 2, 1]\nvolume = 1\n[gravity]\ng = 4\n" + motion +
           "[continuation]\nparameter = \"body.J.0\"\nfrom = 0.5\nto = 1\n",
       "J1 = J2"},
      {body + "[gravity]\ng = 4\n[potential]\n" + plane + "fibre = { k = 0.4, degrees = 30 }\n" +
           motion,
       "thickness"},
      {body + "[potential]\n" + plane + thickness + motion + "[solve]\nstart = [0.1, 1, 1, 1]\n",
       "alpha = 0"},
      {body + "[potential]\n" + plane + thickness + "[motion]\nbranch = \"oblique\"\nnu = 0.3\n",
       "or with gravity"}};
  for (const auto& [text, said] : faults) {
    const TemporaryDirectory directory;
    const Outcome outcome = run_program({"check", directory.file("case.toml", text)});
    EXPECT_EQ(outcome.code, 2) << text;
    EXPECT_THAT(outcome.err, HasSubstr(said)) << text;
  }
}

/// lambda ln C pushes every stretch and cancels along the volume: the same motion whatever lambda is.
TEST(HeldVolume, ABulkModulusSaysNothingOfAHeldVolume) {
  const TemporaryDirectory directory;
  const std::string path =
      directory.file("case.toml",
                     "[body]\nJ = [1.0, 1.0, 1.0]\nvolume = 0.01\n[potential]\n"
                     "coupled = { model = \"neo-hookean-3d\", mu = 1.0, lambda = 1.0 }\n"
                     "[motion]\nbranch = \"iii\"\nnu = 0.5\n");
  std::vector<double> xi;
  for (const char* const lambda : {"1", "1000", "1e6"}) {
    const Outcome outcome = run_program(
        {"solve", path, "-o", "-", "--set", std::string("potential.coupled.lambda=") + lambda});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    xi.push_back(number(rows_of(outcome.out).at(0).at("xi")));
  }
  EXPECT_NEAR(xi[1], xi[0], 1e-14);
  EXPECT_NEAR(xi[2], xi[0], 1e-14);
}

/// On its way to an escape d is 1e-5, and the shear's stiffness a difference of terms in 1/d.
TEST(HeldVolume, AThinFibredBodyHasOneOblique) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      "[body]\nJ = [0.34092, 0.382212, 1.76309]\nvolume = 1.18321\n[potential]\n"
      "plane = { model = \"biot-log\", mu = 1.73217, lambda = 1.72307 }\n"
      "fibre = { k = 0.534645, degrees = 90.0 }\n"
      "thickness = { model = \"harmonic\", k = 2.17859, rest = 0.484033 }\n"
      "[motion]\nbranch = \"i\"\nnu = 0.712881\n[continuation]\nfrom = 0.0\nto = 1.53\n");
  for (const char* const tolerance : {"1e-6", "1e-8"}) {
    const Outcome outcome = run_program(
        {"continue", path, "-o", "-", "--set", std::string("continuation.tolerance=") + tolerance});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::vector<double> found;
    for (const Row& row : rows_of(outcome.out))
      if (row.at("event") == "oblique") found.push_back(number(row.at("nu1")));
    ASSERT_EQ(found.size(), 1U) << tolerance;
    EXPECT_NEAR(found[0], 1.09515592920738341602, 1e-14);
  }
}

}  // namespace
}  // namespace stationary::testing
