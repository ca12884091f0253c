// Anisotropic potentials written out in the case file: built-in ones rewritten are the same
// potential to the whole program, fibres stand beside written-out isotropic parts, and what has no
// form of its own to rely on (evenness, a state of rest) is found out or said not to be known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

const std::string named_thickness =
    "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n";
const std::string written_thickness =
    "thickness = { expression = \"a/rho + b/2*rho^2\", a = 1.0, b = 3.0 }\n";
const std::string neo_hookean_text = "mu/2*(I1 - 2 - 2*log(d)) + lambda_/2*log(d)^2";
const std::string fibre_term =
    "k/2*((xi*cos(pi/6) + alpha*sin(pi/6))^2 + (alpha*cos(pi/6) + zeta*sin(pi/6))^2 - 1)^2";

/// Potentials that are one: by model, and written out.
struct Pair {
  std::string named;
  std::string written;
};

const Pair fibred{"plane = { model = \"neo-hookean\", mu = 1.0, lambda = 2.0 }\n" +
                      named_thickness + "fibre = { k = 0.4, degrees = 30.0 }\n",
                  "plane = { expression = \"" + neo_hookean_text + " + " + fibre_term +
                      "\", mu = 1.0, lambda_ = 2.0, k = 0.4 }\n" + written_thickness};
const Pair orthotropic{
    "plane = { model = \"orthotropic-saint-venant-kirchhoff\", c11 = 3.0, c22 = 1.0, c12 = 0.5, "
    "c66 = 0.4 }\n" +
        named_thickness,
    "plane = { expression = \"c11/8*(xi^2 + alpha^2 - 1)^2 + c22/8*(zeta^2 + alpha^2 - 1)^2 + "
    "c12/4*(xi^2 + alpha^2 - 1)*(zeta^2 + alpha^2 - 1) + c66/2*(alpha*(xi + zeta))^2\", c11 = 3.0, "
    "c22 = 1.0, c12 = 0.5, c66 = 0.4 }\n" +
        named_thickness};
/// The fibre beside a written-out plane.
const Pair beside_plane{fibred.named, "plane = { expression = \"" + neo_hookean_text +
                                          "\", mu = 1.0, lambda_ = 2.0 }\n" + written_thickness +
                                          "fibre = { k = 0.4, degrees = 30.0 }\n"};
const std::string coupled_text = "mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + lambda_/2*log(d*rho)^2";
const Pair beside_coupled{
    "coupled = { model = \"neo-hookean-3d\", mu = 1.0, lambda = 2.0 }\n"
    "fibre = { k = 0.4, degrees = 30.0 }\n",
    "coupled = { expression = \"" + coupled_text +
        "\", mu = 1.0, lambda_ = 2.0 }\nfibre = { k = 0.4, degrees = 30.0 }\n"};
const Pair coupled{beside_coupled.named, "coupled = { expression = \"" + coupled_text + " + " +
                                             fibre_term +
                                             "\", mu = 1.0, lambda_ = 2.0, k = 0.4 }\n"};

std::string case_text(const std::string& potential, const std::string& motion) {
  return "[body]\nJ = [1.0, 1.7, 0.6]\n[motion]\n" + motion + "\n[potential]\n" + potential;
}

Outcome run_case(const std::string& command, const std::string& potential,
                 const std::string& motion, const std::vector<std::string>& more = {}) {
  const TemporaryDirectory directory;
  std::vector<std::string> arguments{command,
                                     directory.file("case.toml", case_text(potential, motion))};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

void expect_near(Row& a, Row& b, const std::vector<std::string>& columns, double error,
                 const std::string& what) {
  for (const std::string& column : columns) {
    if (a[column].empty()) {
      EXPECT_EQ(b[column], "") << column << what;
    } else {
      EXPECT_NEAR(number(a[column]), number(b[column]), error) << column << what;
    }
  }
}

const std::vector<std::string> state{"nu1", "nu2", "nu3", "alpha", "xi", "zeta", "rho"};
const std::vector<std::string> modes{"growth", "negative", "re1", "im1", "krein1", "re2",
                                     "im2",    "krein2",   "re3", "im3", "krein3", "re4",
                                     "im4",    "krein4",   "re5", "im5", "krein5"};

void expect_same_motions(const Pair& pair, const std::string& motion,
                         const std::vector<std::string>& more = {}) {
  const std::string what = " of " + pair.written + motion;
  std::vector<std::string> options{"-o", "-"};
  options.insert(options.end(), more.begin(), more.end());
  const Outcome named = run_case("solve", pair.named, motion, options);
  const Outcome written = run_case("solve", pair.written, motion, options);
  ASSERT_EQ(named.code, 0) << named.err;
  ASSERT_EQ(written.code, 0) << written.err << what;
  auto a = rows_of(named.out);
  auto b = rows_of(written.out);
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t k = 0; k < a.size(); ++k) {
    expect_near(a[k], b[k], state, 1e-14, what);
    expect_near(a[k], b[k], {"energy"}, 1e-14, what);
    expect_near(a[k], b[k], modes, 1e-10, what);
    for (const char* column : {"class", "certified", "class_certified"})
      EXPECT_EQ(a[k][column], b[k][column]) << column << what;
    EXPECT_LE(number(b[k]["residual"]), 1e-15) << what;
  }
}

const std::string third = "branch = \"iii\"\nnu = 0.5";
const std::string about_first = "branch = \"oblique\"\naxis = \"1\"\nnu = 0.5";
const std::string about_second = "branch = \"oblique\"\naxis = \"2\"\nnu = 0.5";

TEST(AnisotropicExpression, BuiltInOnesRewrittenHaveTheSameMotions) {
  for (const Pair* pair : {&fibred, &beside_plane, &coupled, &beside_coupled}) {
    expect_same_motions(*pair, third, {"--certify"});
    expect_same_motions(*pair, about_first, {"--certify"});
    expect_same_motions(*pair, about_second);
  }
  for (const char* branch : {"i", "ii", "iii"})
    expect_same_motions(orthotropic, "branch = \"" + std::string(branch) + "\"\nnu = 0.2",
                        {"--certify"});
}

TEST(AnisotropicExpression, AndTheSameSearches) {
  const std::vector<std::string> all{"--set", "solve.all=true"};
  expect_same_motions(fibred, third, all);
  expect_same_motions(fibred, about_first, all);
  expect_same_motions(beside_plane, third, all);
  expect_same_motions(orthotropic, "branch = \"i\"\nnu = 0.2", all);
  // A written-out fibre's boxes are excluded like a built-in one's: nothing is left undecided.
  const Outcome outcome = run_case("solve", fibred.written, third, all);
  EXPECT_THAT(outcome.out, HasSubstr("proven to be all"));
}

/// Two fibres at 30 and 150 degrees: that V is even in alpha is known at points alone, and confirmed by the whole
/// formula's derivatives, its isotropic terms among them.
TEST(AnisotropicExpression, WhatIsTakenForGrantedIsConfirmed) {
  const std::string fibres =
      "plane = { expression = \"mu/2*(I1-2-2*log(d)) + la/2*log(d)^2 + k/2*(A^2+B^2)\", mu = 1.0, "
      "la = "
      "2.0, k = 0.4, let = { c=\"cos(30*pi/180)\", s=\"sin(30*pi/180)\", f=\"cos(150*pi/180)\", "
      "g=\"sin(150*pi/180)\", A=\"(xi*c+alpha*s)^2+(alpha*c+zeta*s)^2-1\", "
      "B=\"(xi*f+alpha*g)^2+(alpha*f+zeta*g)^2-1\" } }\n" +
      named_thickness;
  const Outcome one = run_case("solve", fibres, third, {"-o", "-", "--certify"});
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(rows_of(one.out).at(0).at("certified"), "assuming");
  const Outcome all = run_case("solve", fibres, third, {"--set", "solve.all=true"});
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("proven to be all"));
}

TEST(AnisotropicExpression, CheckPrintsWhatWasFoundOut) {
  const Outcome skew = run_case("check", fibred.written, third);
  EXPECT_EQ(skew.code, 0) << skew.err;
  EXPECT_THAT(skew.out, HasSubstr("isotropic (a function of t, d and rho): does not hold"));
  EXPECT_THAT(skew.out, HasSubstr("V_alpha = 0 at alpha = 0: does not hold"));
  EXPECT_THAT(skew.out, HasSubstr("separable, anisotropic, V_alpha != 0 at alpha = 0"));
  const Outcome even = run_case("check", orthotropic.written, third);
  EXPECT_THAT(even.out, HasSubstr("even in alpha: V(-alpha) = V(alpha): holds"));
  EXPECT_THAT(even.out, HasSubstr("anisotropic, even in alpha"));
  // V_alpha = 0 at alpha = 0 does not make it even.
  const Outcome cubic =
      run_case("check",
               "plane = { expression = \"I1 - 2*log(d) + c*alpha^3*(2*xi - zeta)\", c = 0.5 }\n" +
                   named_thickness,
               third);
  EXPECT_THAT(cubic.out, HasSubstr("V(-alpha) = V(alpha): does not hold"));
  EXPECT_THAT(cubic.out, HasSubstr("separable, anisotropic, V_alpha = 0 at alpha = 0"));
}

TEST(AnisotropicExpression, MaterialAxesAreServedWhereVAlphaVanishes) {
  const Outcome refused = run_case("solve", fibred.written, "branch = \"i\"\nnu = 0.5");
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("no stationary ellipse about this axis"));
  EXPECT_THAT(refused.err, HasSubstr("nearest residual"));
  // Not even, yet V_alpha = 0 at alpha = 0: the isotropic motion stays one.
  const std::string cubic =
      "plane = { expression = \"I1 - 2*log(d) + c*alpha^3*(2*xi - zeta)\", c = 0.5 }\n" +
      named_thickness;
  const std::string isotropic = "plane = { expression = \"I1 - 2*log(d)\" }\n" + named_thickness;
  const std::string motion = "branch = \"i\"\nnu = 0.3";
  const Outcome with = run_case("solve", cubic, motion, {"-o", "-"});
  const Outcome without = run_case("solve", isotropic, motion, {"-o", "-"});
  ASSERT_EQ(with.code, 0) << with.err;
  auto a = only_row(with.out);
  auto b = only_row(without.out);
  EXPECT_EQ(a["alpha"], "0");
  expect_near(a, b, state, 1e-14, "");
  expect_near(a, b, modes, 1e-10, "");
}

TEST(AnisotropicExpression, IsFollowedInAParameterOfItsOwn) {
  const auto followed = [](const std::string& potential, const std::string& key) {
    return run_case("continue", potential, about_first,
                    {"-o", "-", "--quiet", "--set", "continuation.parameter=\"" + key + "\"",
                     "--set", "continuation.from=0.2", "--set", "continuation.to=0.6", "--set",
                     "continuation.tolerance=1e-5"});
  };
  const Outcome named = followed(fibred.named, "potential.fibre.k");
  ASSERT_EQ(named.code, 0) << named.err;
  auto a = rows_of(named.out);
  for (const auto& [potential, key] : {std::pair(fibred.written, "potential.plane.k"),
                                       std::pair(beside_plane.written, "potential.fibre.k"),
                                       std::pair(coupled.written, "potential.coupled.k")}) {
    const Outcome written = followed(potential, key);
    ASSERT_EQ(written.code, 0) << written.err;
    auto b = rows_of(written.out);
    ASSERT_GT(b.size(), 2U);
    EXPECT_EQ(b.front()["event"], "limit");
    EXPECT_EQ(b.back()["event"], "limit");
    EXPECT_EQ(number(b.back()[key]), 0.6);
    if (potential == coupled.written) continue;
    expect_near(a.front(), b.front(), state, 1e-14, key);
    expect_near(a.back(), b.back(), state, 1e-14, key);
  }
}

TEST(AnisotropicExpression, StatesOfRestAreFoundOrNotSaidToBeThere) {
  // Away from the unit, and sheared.
  const std::string away =
      "plane = { expression = \"(xi - 1.6)^2 + (zeta - 0.8)^2 + 2*(alpha - 0.3)^2\" }\n" +
      named_thickness;
  const std::string at_rest = "branch = \"iii\"\nnu = 0.0";
  const Outcome found = run_case("solve", away, at_rest, {"-o", "-"});
  ASSERT_EQ(found.code, 0) << found.err;
  auto row = only_row(found.out);
  EXPECT_NEAR(number(row["xi"]), 1.6, 1e-14);
  EXPECT_NEAR(number(row["zeta"]), 0.8, 1e-14);
  EXPECT_NEAR(number(row["alpha"]), 0.3, 1e-14);
  // None: V falls as xi grows.
  const Outcome none = run_case(
      "solve", "plane = { expression = \"1/xi + (zeta - 1)^2 + alpha^2\" }\n" + named_thickness,
      at_rest, {"--set", "solve.method=\"newton\""});
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("no rest state, a minimum of V, was found"));
}

TEST(AnisotropicExpression, WhatIsForIsotropicOnesIsRefused) {
  for (const char* branch : {"tilted", "two-polar"}) {
    const Outcome outcome =
        run_case("check", fibred.written, "branch = \"" + std::string(branch) + "\"\nnu = 0.5");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("with an anisotropic potential"));
  }
  const Outcome oblique = run_case(
      "check", beside_plane.written.substr(0, beside_plane.written.find("fibre")), about_first);
  EXPECT_EQ(oblique.code, 2);
  EXPECT_THAT(oblique.err, HasSubstr("with an isotropic potential"));
  const Outcome thick =
      run_case("check", "plane = { expression = \"xi^2 + rho\" }\n" + named_thickness, third);
  EXPECT_EQ(thick.code, 2);
  EXPECT_THAT(thick.err, HasSubstr("rho"));
}

}  // namespace
}  // namespace stationary::testing
