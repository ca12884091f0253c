// Potentials written out in the case file, from outside: what `check` finds out about them, wrong
// ones, several states of rest, maps and families of them.
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
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::string case_with(const std::string& potential, const std::string& more = "") {
  return "[body]\nJ = [1.0, 1.7, 0.6]\n[motion]\nbranch = \"iii\"\nnu = 0.3\n[potential]\n" +
         potential + "\n" + more;
}

const std::string harmonic_thickness = "thickness = { model = \"harmonic\", k = 3.0, rest = 1.0 }";

TEST(ExpressionCase, CheckSaysWhatWasFoundOut) {
  const Outcome ogden = run_program({"check", STATIONARY_CASES "/ogden.toml"});
  EXPECT_EQ(ogden.code, 0) << ogden.err;
  EXPECT_THAT(ogden.out, HasSubstr("isotropic"));
  EXPECT_THAT(ogden.out, HasSubstr("lambda^a1 + mu_^a1"));
  const Outcome coupled = run_program({"check", STATIONARY_CASES "/mooney_rivlin.toml"});
  EXPECT_THAT(coupled.out, HasSubstr("an unknown"));
}

struct Wrong {
  const char* potential;
  const char* place;  ///< line and column
  const char* says;
};

TEST(ExpressionCase, WrongOnesAreRefusedAtTheirCharacter) {
  const TemporaryDirectory directory;
  const Wrong wrong[] = {
      {"plane = { expression = \"mu*lgo(d)\", mu = 1.0 }", ":7:28", "log"},
      {"plane = { expression = \"mu*(d - 1\", mu = 1.0 }", ":7:34", "the end"},
      {"plane = { expression = \"mu*rho\", mu = 1.0 }", ":7:28", "rho"},
      {"plane = { expression = \"d^2\", mu = 1.0 }", ":7:31", "does not occur"},
      {"plane = { expression = \"abs(t - 2)\" }", ":7:25", "second derivative"},
      {"plane = { expression = \"lambda^2 - mu_\" }", ":7:24", "lambda and mu_"},
      {"plane = { expression = \"d - log(d) + sqrt((lambda - mu_)^2)\" }", ":7:24", "has a kink"},
      {"plane = { expression = \"d + sqrt((xi - zeta)^2 + 4*alpha^2)\" }", ":7:24", "has a kink"},
      {"plane = { expression = 3 }", ":7:24", "a text"},
      {"plane = { expression = \"d\", model = \"biot\" }", ":7:29", "both model and expression"},
      {"plane = { expresion = \"d\" }", ":7:", "did you mean \"expression\""},
      {"plane = { expression = \"m*d\", m = nan }", ":7:35", "a finite number"},
      {"plane = { expression = \"\" }", ":7:25", "the end"},
      // Columns are counted in characters, as the file's are.
      {"plane = { expression = \"I1 - 2*log(d) + foo*λ\" }", ":7:41",
       "found \"foo\" at character 17"},
      {"plane = { expression = \"mu_*λ\" }", ":7:29", "write lambda"},
      {"plane = { expression = \"λ + μ\" }", ":7:25", "write lambda"},
      {"plane = { expression = \"d − 1\" }", ":7:27", "write \"-\""},
      {"plane = { expression = \"d²\" }", ":7:26", "write \"^2\""},
      {"plane = { expression = \"d + ( λ\" }", ":7:31", "write lambda"},
      {"plane = { expression = \"k*d\", k = 9007199254740993 }", ":7:35",
       "the integer 9007199254740993, which no double is exactly; expected a finite number"},
      {"plane = { expression = \"mu_*d\", mu_ = 1.0 }", ":7:33",
       "mu_ is the smaller principal stretch"},
      {"plane = { expression = \"(lambda+2*mu_+1e9)^1000+(2*lambda+mu_+1e9)^1000\" }", ":7:24",
       "numbers at a time"},
      {"plane = { expression = \"lambda*lambda_^2 - mu_\", lambda = 1.0 }", ":7:24",
       "lambda_ and mu_ must enter symmetrically"},
      // Constants that are no numbers.
      {"plane = { expression = \"d*0^-1\" }", ":7:28", "a division by 0"},
      {"plane = { expression = \"d + log(0)\" }", ":7:29", "a constant that is no finite number"},
      {"plane = { expression = \"d + log(-1)\" }", ":7:29", "a constant that is no finite number"},
      {"plane = { expression = \"1/d+d+0*log(-1)\" }", ":7:33",
       "a constant that is no finite number"},
      {"plane = { expression = \"d + sqrt(k)\", k = -1.0 }", ":7:29", "no finite number"},
      {"plane = { expression = \"(k*d)^-1\", k = 0.0 }", ":7:24", "no finite number"},
      {"plane = { expression = \"d*d/k\", k = 0.0 }", ":7:28",
       "a constant that is no finite number"},
  };
  for (const Wrong& each : wrong) {
    const std::string path =
        directory.file("wrong.toml", case_with(each.potential + ("\n" + harmonic_thickness)));
    const Outcome outcome = run_program({"check", path});
    EXPECT_EQ(outcome.code, 2) << each.potential;
    EXPECT_THAT(outcome.err, StartsWith("stationary: " + path + each.place)) << each.potential;
    EXPECT_THAT(outcome.err, HasSubstr(each.says)) << each.potential;
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

/// What vanishes at the parameters is finite all the same.
TEST(ExpressionCase, ConstantsThatAreZeroPass) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "zero.toml",
      case_with(
          "plane = { expression = \"I1/2 - log(d) + sqrt(k) + 0^a + k^a + (-2)^n + k^2*d + min(k, "
          "1)*t + log(1 + k)\", k = 0.0, a = 0.5, n = 2.0 }\n" +
          harmonic_thickness));
  const Outcome outcome = run_program({"check", path});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

/// Where a parameter's own derivative is not finite, the stretches' are.
TEST(ExpressionCase, AParameterThatIsZeroIsSolvedWithoutAWord) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "zero.toml", case_with("plane = { expression = \"(I1 - 2)/2 - log(d) + sqrt(k)*d + d^2/8\", "
                             "k = 0.0 }\n" +
                             harmonic_thickness));
  for (const char* const method : {"auto", "ceres"}) {
    const Outcome outcome =
        run_program({"solve", path, "--set", std::string("solve.method=") + method});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("Ceres"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("stopped short")));
  }
}

/// What a parameter that is 0, or a negative one to a whole one, has no slope by is moved by no rounding of it.
TEST(ExpressionCase, ErrorBoundsAreNumbersWhereParametersHaveNoSlope) {
  const TemporaryDirectory directory;
  const std::string thickness =
      "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n";
  const auto file = [&](const std::string& plane) {
    return directory.file("case.toml", case_with("plane = { " + plane + " }\n" + thickness));
  };
  const std::string plain = file("expression = \"c/d + k/2*I1\", c = 1.0, k = 2.0");
  const double xi = number(only_row(run_program({"solve", plain, "-o", "-"}).out).at("xi"));
  for (const char* const text : {"sqrt(z)*t", "z^0.3*t", "z^m*t"}) {
    const std::string path =
        file("expression = \"c/d + k/2*I1 + " + std::string(text) +
             "\", c = 1.0, k = 2.0, z = 0.0" + (std::string(text) == "z^m*t" ? ", m = 2.0" : ""));
    const Outcome one = run_program({"solve", path, "-o", "-"});
    ASSERT_EQ(one.code, 0) << text << one.err;
    const Row row = only_row(one.out);
    EXPECT_NEAR(number(row.at("xi")), xi, 1e-14) << text;
    EXPECT_LT(number(row.at("error_bound")), 1e-14) << text;
    const Outcome family =
        run_program({"continue", path, "--set", "continuation={from=0.0,to=0.6}", "-o", "-"});
    EXPECT_EQ(family.code, 0) << text << family.err;
  }
  const std::string square =
      file("expression = \"c/d + k/2*I1 + z^2*t\", c = 1.0, k = 2.0, z = -2.1");
  const Row expected = only_row(run_program({"solve", square, "-o", "-"}).out);
  const Outcome whole = run_program(
      {"solve", file("expression = \"c/d + k/2*I1 + z^m*t\", c = 1.0, k = 2.0, z = -2.1, m = 2.0"),
       "-o", "-"});
  ASSERT_EQ(whole.code, 0) << whole.err;
  const Row got = only_row(whole.out);
  EXPECT_NEAR(number(got.at("xi")), number(expected.at("xi")), 1e-14);
  EXPECT_EQ(got.at("class"), expected.at("class"));
  EXPECT_LT(number(got.at("error_bound")), 1e-13);
}

/// A number with a point before its exponent has no name in it.
TEST(ExpressionCase, APartMayBeCalledAsAnExponent) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program(
      {"check",
       directory.file("case.toml",
                      case_with("plane = { expression = \"I1/2 - log(d)*e3\", let = { e3 = "
                                "\"1.e3*0.001\" } }\n" +
                                harmonic_thickness))});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

/// A note is of names the potential would have; the facts call the stretch what it is called here.
TEST(ExpressionCase, HiddenNamesInNotesAndFacts) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "hidden.toml",
      case_with("plane = { expression = \"lambda*(lambda_^2 + mu_^2) - log(d)\", lambda = 0.5 }\n"
                "thickness = { expression = \"t/rho+rho^2\", t = 1.0 }"));
  const Outcome outcome = run_program({"check", path});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("t is the parameter")));
  EXPECT_THAT(outcome.out, HasSubstr("lambda is the parameter here"));
  EXPECT_THAT(outcome.out, HasSubstr("symmetric in lambda_ and mu_"));
  EXPECT_THAT(outcome.out, HasSubstr("made of d, lambda_, mu_"));
}

TEST(ExpressionCase, EveryStateOfRestIsFoundAndProven) {
  const Outcome outcome =
      run_program({"solve", STATIONARY_CASES "/double_well.toml", "--set", "motion.nu=0", "--set",
                   "solve.all=true", "--certify", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<Row> rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 3U);
  const double d[] = {1.0, 1.5, 2.0};
  const char* classes[] = {"stable", "unstable", "stable"};
  for (std::size_t k = 0; k < 3; ++k) {
    Row row = rows[k];
    EXPECT_NEAR(number(row["xi"]), std::sqrt(d[k]), 4e-16 * d[k]);
    EXPECT_EQ(row["xi"], row["zeta"]);
    EXPECT_EQ(row["certified"], "yes");
    EXPECT_EQ(row["class"], classes[k]);
  }
}

TEST(ExpressionCase, EveryThicknessIsFoundAndAStartChoosesOne) {
  const std::string two_wells = STATIONARY_CASES "/two_wells.toml";
  const Outcome all = run_program(
      {"solve", two_wells, "--set", "motion.nu=0.01", "--set", "solve.all=true", "-o", "-"});
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_EQ(rows_of(all.out).size(), 3U);
  const auto from = [&](const std::string& rho) {
    return number(only_row(
        run_program({"solve", two_wells, "--set", "solve.start=[0, 1, 1, " + rho + "]", "-o", "-"})
            .out)["rho"]);
  };
  EXPECT_NEAR(from("0.8"), 0.8, 0.05);
  EXPECT_NEAR(from("1.4"), 1.4, 0.05);
  // Connected to rest: the well nearest to 1.
  EXPECT_NEAR(number(only_row(run_program({"solve", two_wells, "-o", "-"}).out)["rho"]), 0.8, 0.05);
}

TEST(ExpressionCase, NoStateOfRestIsSaidSo) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "open.toml", case_with("plane = { expression = \"-log(d)\" }\n" + harmonic_thickness));
  const Outcome outcome = run_program({"solve", path});
  EXPECT_EQ(outcome.code, 3) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("no state of rest was found"));
}

/// min(k, 0) is not 0 for this k: neither separable nor isotropic, whatever holds for k > 0.
TEST(ExpressionCase, FactsAreThoseOfTheParametersGiven) {
  const TemporaryDirectory directory;
  const std::string isotropic = "mu/2*(I1 - 2 - 2*log(d)) + log(d)^2 + 1/rho + rho^2 + min(k, 0)*";
  const auto check = [&](const std::string& term) {
    const std::string path = directory.file(
        "branch.toml",
        case_with("coupled = { expression = \"" + isotropic + term + "\", mu = 1.0, k = -0.5 }"));
    return run_program({"check", path}).out;
  };
  const std::string coupled = check("log(d)*log(rho)");
  EXPECT_THAT(coupled, HasSubstr("potential     coupled, isotropic"));
  EXPECT_THAT(coupled, HasSubstr("separable (a potential of the plane and one of the thickness): "
                                 "does not hold"));
  const std::string oriented = check("alpha");
  EXPECT_THAT(oriented, HasSubstr("isotropic (a function of t, d and rho): does not hold"));
  EXPECT_THAT(oriented, HasSubstr("V_alpha = 0 at alpha = 0: does not hold"));
}

/// Numbers whose products are none: refused for what they are.
TEST(ExpressionCase, SizesThatCannotBeComputedWithAreRefused) {
  const TemporaryDirectory directory;
  for (const char* size : {"1e120", "1e200", "1e300"}) {
    const std::string path =
        directory.file("size.toml", case_with("plane = { expression = \"" + std::string(size) +
                                              "*(I1 + 1/d)\" }\n" + harmonic_thickness));
    const Outcome outcome = run_program({"solve", path});
    EXPECT_EQ(outcome.code, 2) << size;
    EXPECT_THAT(outcome.err,
                HasSubstr(":7:24: potential.plane.expression: found second derivatives"));
    EXPECT_THAT(outcome.err, HasSubstr("at most 1e+100"));
  }
}

/// Terms far larger than their sum: the energy is that of the sum, in a row as in a followed curve.
TEST(ExpressionCase, EnergyIsThatOfTheSum) {
  const TemporaryDirectory directory;
  const auto energies = [&](const std::string& expression) {
    const std::string path = directory.file(
        "sum.toml",
        case_with("plane = { expression = \"" + expression + "\" }\n" + harmonic_thickness,
                  "[continuation]\nparameter = \"nu\"\nfrom = 0.0\nto = 0.3\n"));
    std::vector<double> out;
    out.push_back(number(only_row(run_program({"solve", path, "-o", "-"}).out)["energy"]));
    out.push_back(number(rows_of(run_program({"continue", path, "-o", "-"}).out).back()["energy"]));
    return out;
  };
  const auto plain = energies("I1 + 1/d");
  EXPECT_NEAR(plain[0], plain[1], 1e-15);
  for (const double each : energies("1e15*(d + 1) - 1e15*d - 1e15 + I1 + 1/d"))
    EXPECT_NEAR(each, plain[0], 1e-14);
}

/// (iii) with J1 = J2, whichever part is a formula: the circle, and a vertical branch as of the
/// built-in model that the formula writes out.
TEST(ExpressionCase, CirclesAndVerticalBranches) {
  const TemporaryDirectory directory;
  const std::string head = "[body]\nJ = [1.0, 1.0, 0.6]\n[motion]\nbranch = \"iii\"\nnu = 0.3\n";
  const std::string more =
      "\n[continuation]\nfrom = 0.0\nto = 0.5\n parameter = \"nu\"\n"
      "[map]\nx = { parameter = \"nu\", from = 0.0, to = 0.5, count = 3 }\n";
  const std::string written_plane =
      "plane = { expression = \"mu/2*(I1 - 2 - 2*log(d)) + la/2*log(d)^2\", mu = 0.64, la = 2.0 "
      "}\n";
  const std::string built_in = "plane = { model = \"neo-hookean\", mu = 0.64, lambda = 2.0 }\n";
  const std::string written_thickness = "thickness = { expression = \"1.5*(rho - 1)^2\" }\n";
  const std::string potentials[] = {built_in + harmonic_thickness,
                                    written_plane + harmonic_thickness,
                                    built_in + written_thickness, written_plane + written_thickness,
                                    "plane = { expression = \"I1 + 1/d\" }\n" + harmonic_thickness};
  std::vector<Row> neo_hookean;
  for (const std::string& potential : potentials) {
    const std::string path =
        directory.file("circle.toml", head + "[potential]\n" + potential + more);
    const bool isolated = potential.find("1/d") != std::string::npos;
    const Outcome solved = run_program({"solve", path, "--certify", "-o", "-"});
    EXPECT_EQ(solved.code, 0) << potential << solved.err;
    Row circle = only_row(solved.out);
    EXPECT_EQ(circle["xi"], circle["zeta"]);
    EXPECT_EQ(circle["certified"], "yes") << potential;
    for (const char* command : {"continue", "map"})
      EXPECT_EQ(run_program({command, path, "--quiet", "-o", directory / "x.csv"}).code, 0)
          << command << " " << potential;
    EXPECT_EQ(run_program({"atlas", path, "--quiet", "--checkpoints", "4"}).code, 0) << potential;

    const Outcome at_one_nu = run_program({"solve", path, "--set", "motion.nu=0.8"});
    EXPECT_EQ(at_one_nu.code, isolated ? 0 : 3) << potential << at_one_nu.err;
    if (isolated) continue;
    neo_hookean.push_back(circle);
    EXPECT_THAT(at_one_nu.err, HasSubstr("vertical branch"));
    const Outcome followed =
        run_program({"continue", path, "--set", "motion.nu=0.8", "--set", "continuation.to=1.0",
                     "--set", "solve.start=[0, 2.2, 0.626, 1]", "-o", "-"});
    EXPECT_EQ(followed.code, 0) << followed.err;
    for (Row& row : rows_of(followed.out)) EXPECT_NEAR(number(row["nu3"]), 0.8, 1e-15);
  }
  for (Row& row : neo_hookean) EXPECT_NEAR(number(row["xi"]), number(neo_hookean[0]["xi"]), 4e-16);
}

/// A coupled formula that is separable is solved as plane and thickness are, and followed in a
/// parameter that both parts have.
TEST(ExpressionCase, ASeparableCoupledFormulaIsTakenApart) {
  const TemporaryDirectory directory;
  const std::string whole =
      "coupled = { expression = \"mu/2*(I1 - 2 - 2*log(d)) + log(d)^2 + mu*(1/rho + rho)^2\", "
      "mu = 1.0 }";
  const std::string parts =
      "plane = { expression = \"mu/2*(I1 - 2 - 2*log(d)) + log(d)^2\", mu = MU }\n"
      "thickness = { expression = \"mu*(1/rho + rho)^2\", mu = MU }";
  const auto in_parts = [&](const std::string& mu) {
    std::string out = parts;
    for (std::size_t k = out.find("MU"); k != std::string::npos; k = out.find("MU"))
      out.replace(k, 2, mu);
    return out;
  };
  const std::string coupled = directory.file("coupled.toml", case_with(whole));
  const Outcome check = run_program({"check", coupled});
  EXPECT_THAT(check.out, HasSubstr("potential     separable, isotropic"));
  EXPECT_THAT(check.out, HasSubstr("1 equation, from the rest thickness"));
  const std::vector<std::string> sets{"--set", "motion.branch=\"i\"", "--certify", "-o", "-"};
  const auto solved = [&](const std::string& path) {
    std::vector<std::string> arguments{"solve", path};
    arguments.insert(arguments.end(), sets.begin(), sets.end());
    return only_row(run_program(arguments).out);
  };
  Row a = solved(coupled);
  Row b = solved(directory.file("parts.toml", case_with(in_parts("1.0"))));
  EXPECT_EQ(a["certified"], "yes");
  for (const char* column : {"xi", "zeta", "rho", "class", "negative"})
    EXPECT_EQ(a[column], b[column]) << column;
  const Outcome family = run_program(
      {"continue", coupled, "--set", "motion.branch=\"i\"", "--set",
       "continuation={ parameter = \"potential.coupled.mu\", from = 1.0, to = 2.0 }", "-o", "-"});
  ASSERT_EQ(family.code, 0) << family.err;
  Row last = rows_of(family.out).back();
  Row expected = solved(directory.file("end.toml", case_with(in_parts("2.0"))));
  for (const char* column : {"xi", "zeta", "rho", "growth", "im1"})
    EXPECT_NEAR(number(last[column]), number(expected[column]), 1e-13) << column;
  // Events in it are proven, of the one parameter in both parts.
  const Outcome proven =
      run_program({"continue", coupled, "--set", "motion.nu=0.7", "--certify", "--set",
                   "continuation={ parameter = \"potential.coupled.mu\", from = 0.8, to = 2.0 }"});
  EXPECT_EQ(proven.code, 0) << proven.err;
  EXPECT_THAT(proven.out, HasSubstr("proven within"));
}

/// One whose addend is of both is solved whole where the unit stretches may be outside its domain.
TEST(ExpressionCase, ADomainWithoutTheUnitStretchesIsSolved) {
  const TemporaryDirectory directory;
  const auto solved = [&](const std::string& text) {
    const Outcome outcome = run_program(
        {"solve",
         directory.file("case.toml", case_with("coupled = { expression = \"mu/2*(I1 + rho^2) - " +
                                               text + "\", mu = 1.0, c = 1.0 }\n")),
         "-o", "-"});
    EXPECT_EQ(outcome.code, 0) << text << outcome.err;
    return outcome.code == 0 ? only_row(outcome.out) : Row();
  };
  Row apart = solved("c*log(d - 2) - c*log(rho)");
  Row together = solved("c*log((d - 2)*rho)");
  for (const char* const column : {"xi", "zeta", "rho"})
    EXPECT_NEAR(number(together[column]), number(apart[column]), 1e-13) << column;
}

TEST(ExpressionCase, IsFollowedInItsParameterAndMapped) {
  const TemporaryDirectory directory;
  const std::string plane =
      "plane = { expression = \"mu/2*(I1 - 2 - 2*log(d)) + la/2*log(d)^2\", mu = 1.0, la = 2.0 }\n";
  const std::string named = "plane = { model = \"neo-hookean\", mu = 1.0, lambda = 2.0 }\n";
  const auto continued = [&](const std::string& potential, const std::string& parameter) {
    const std::string path = directory.file(
        "followed.toml",
        case_with(potential + harmonic_thickness, "[continuation]\nparameter = \"potential.plane." +
                                                      parameter + "\"\nfrom = 1.0\nto = 3.0\n"));
    const Outcome outcome = run_program({"continue", path, "-o", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return rows_of(outcome.out).back();
  };
  Row written = continued(plane, "la");
  Row built_in = continued(named, "lambda");
  EXPECT_EQ(written["potential.plane.la"], "3");
  for (const char* column : {"xi", "zeta"})
    EXPECT_NEAR(number(written[column]), number(built_in[column]), 4e-16) << column;

  const auto mapped = [&](const std::string& potential) {
    const std::string path = directory.file(
        "mapped.toml",
        case_with(potential + harmonic_thickness,
                  "[map]\nx = { parameter = \"nu\", from = 0.0, to = 0.7, count = 5 }\n"
                  "y = { parameter = \"potential.plane.mu\", from = 0.8, to = 1.6, count = 3 }\n"));
    const Outcome outcome = run_program({"map", path, "-o", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return rows_of(outcome.out);
  };
  const std::vector<Row> map = mapped(plane);
  const std::vector<Row> same = mapped(named);
  ASSERT_EQ(map.size(), 15U);
  for (std::size_t k = 0; k < map.size(); ++k) {
    Row a = map[k];
    Row b = same[k];
    // Only of a built-in model is it known that none exists.
    EXPECT_EQ(a["status"] == "solved", b["status"] == "solved");
    EXPECT_EQ(a["class"], b["class"]);
    if (a["status"] == "solved") {
      EXPECT_NEAR(number(a["xi"]), number(b["xi"]), 4e-16);
    }
  }
}

}  // namespace
}  // namespace stationary::testing
