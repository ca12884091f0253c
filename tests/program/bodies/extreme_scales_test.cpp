// The same body in other units: J in one of mass times length squared, V in one of energy, nu in
// the time that goes with them. All powers of two: what comes out is the same number in those
// units, to the last bit, or the case is refused; never is a claim made of an overflow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

std::string number_text(double x) {
  char out[40];
  std::snprintf(out, sizeof out, "%.17g", x);
  return out;
}

struct Units {
  int inertia;  ///< exponents of two
  int energy;
  int rate() const { return (energy - inertia) / 2; }

  std::map<std::string, int> columns() const {
    std::map<std::string, int> out{
        {"nu1", rate()}, {"pi1", inertia + rate()}, {"energy", energy}, {"growth", rate()}};
    for (const char* part : {"re", "im"})
      for (int k = 1; k <= 5; ++k) out[part + std::to_string(k)] = rate();
    return out;
  }

  std::string case_text() const {
    const auto J = [&](double x) { return number_text(std::ldexp(x, inertia)); };
    const auto V = [&](double x) { return number_text(std::ldexp(x, energy)); };
    const auto nu = [&](double x) { return number_text(std::ldexp(x, rate())); };
    return "[body]\nJ = [" + J(1.0) + ", " + J(1.7) + ", " + J(0.6) + "]\n[potential]\n" +
           "plane = { model = \"neo-hookean\", mu = " + V(1.0) + ", lambda = " + V(2.0) + " }\n" +
           "thickness = { model = \"reciprocal-quadratic\", a = " + V(1.0) + ", b = " + V(3.0) +
           " }\n[motion]\nbranch = \"i\"\nnu = " + nu(0.5) +
           "\n[continuation]\nparameter = \"nu\"\nfrom = 0.0\nto = " + nu(0.7) +
           "\ntolerance = 1e-5\n";
  }
};

Outcome run_in(const Units& units, const char* command) {
  const TemporaryDirectory directory;
  return run_program({command, directory.file("case.toml", units.case_text()), "-o", "-"});
}

void expect_same(const std::string& plain, const std::string& scaled, const Units& units) {
  const auto a = rows_of(plain);
  const auto b = rows_of(scaled);
  ASSERT_EQ(a.size(), b.size());
  const auto exponents = units.columns();
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (const auto& [column, text] : a[k]) {
      const auto exponent = exponents.find(column);
      if (exponent == exponents.end() || text.empty()) {
        EXPECT_EQ(text, b[k].at(column)) << column << " in row " << k;
      } else {
        EXPECT_EQ(std::ldexp(number(text), exponent->second), number(b[k].at(column)))
            << column << " in row " << k;
      }
    }
  }
}

TEST(ExtremeScales, TheSameInOtherUnitsOrRefused) {
  for (const char* command : {"solve", "continue"}) {
    const Outcome plain = run_in({0, 0}, command);
    ASSERT_EQ(plain.code, 0) << plain.err;
    int same = 0;
    int refused = 0;
    for (const Units units :
         {Units{40, 0},    Units{-40, 0},   Units{290, 0},     Units{-290, 0},   Units{0, 290},
          Units{0, -290},  Units{290, 290}, Units{-290, -290}, Units{145, -145}, Units{-145, 145},
          Units{310, 0},   Units{-310, 0},  Units{500, 0},     Units{0, 500},    Units{0, -500},
          Units{-1000, 0}, Units{1000, 0},  Units{0, 1000},    Units{900, 900},  Units{-900, -900},
          Units{290, -290}}) {
      SCOPED_TRACE(std::string(command) + " " + std::to_string(units.inertia) + " " +
                   std::to_string(units.energy));
      const Outcome scaled = run_in(units, command);
      if (scaled.code == 0) {
        expect_same(plain.out, scaled.out, units);
        ++same;
      } else {
        EXPECT_EQ(scaled.code, 2) << scaled.err;
        EXPECT_THAT(scaled.err, HasSubstr("units"));
        ++refused;
      }
    }
    EXPECT_EQ(same, 10);
    EXPECT_EQ(refused, 11);
  }
}

/// Of a kind whose formulas leave the range of doubles before the body does: four coordinates about axis 3,
/// gravity's second derivatives. {J}, {V} and {g} stand for what a number is times.
struct ScaledBody {
  const char* name;
  std::array<double, 3> J;
  const char* potential;  ///< of V(x) and g(x)
  const char* branch;
  double nu;
};

std::string in_units(const ScaledBody& body, const Units& units) {
  std::string potential = body.potential;
  // Gravity is of the size of g/sqrt J.
  for (const auto& [mark, exponent] :
       {std::pair{"V(", units.energy}, std::pair{"g(", units.energy + units.inertia / 2}}) {
    for (std::size_t at; (at = potential.find(mark)) != std::string::npos;) {
      const std::size_t end = potential.find(')', at);
      const double x = std::stod(potential.substr(at + 2, end - at - 2));
      potential.replace(at, end + 1 - at, number_text(std::ldexp(x, exponent)));
    }
  }
  std::string J;
  for (const double each : body.J)
    J += (J.empty() ? "" : ", ") + number_text(std::ldexp(each, units.inertia));
  return "[body]\nJ = [" + J + "]\n" + potential + "\n[motion]\nbranch = \"" + body.branch +
         "\"\nnu = " + number_text(std::ldexp(body.nu, units.rate())) + "\n";
}

TEST(ExtremeScales, WhatIsClaimedIsTheSame) {
  const ScaledBody bodies[] = {
      {"coupled",
       {3.97, 1.32, 3.81},
       "[potential]\ncoupled = { model = \"neo-hookean-3d\", mu = V(1.79), lambda = V(0.172) }",
       "iii",
       0.075},
      {"fluid", {1.0, 1.0, 1.0}, "volume = 1.0\n[gravity]\ng = g(4.0)", "iii", 0.4},
      {"gravity",
       {1.3, 1.1, 0.9},
       "[gravity]\ng = g(1.5)\n[potential]\n"
       "coupled = { model = \"neo-hookean-3d\", mu = V(1.0), lambda = V(2.0) }",
       "i",
       0.3},
      {"fibre",
       {1.3, 1.1, 0.9},
       "[gravity]\ng = g(0.5)\n[potential]\n"
       "coupled = { model = \"neo-hookean-3d\", mu = V(1.0), lambda = V(2.0) }\n"
       "fibre = { k = V(0.4), degrees = 30 }",
       "iii",
       0.3}};
  for (const ScaledBody& body : bodies) {
    const auto row_in = [&](const Units& units) {
      const TemporaryDirectory directory;
      const Outcome outcome = run_program(
          {"solve", directory.file("case.toml", in_units(body, units)), "-o", "-", "--certify"});
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      const auto rows = rows_of(outcome.out);
      return rows.empty() ? Row() : rows.front();
    };
    const Row plain = row_in({0, 0});
    ASSERT_FALSE(plain.empty()) << body.name;
    for (const Units units : {Units{140, 140}, Units{-140, -140}, Units{176, 176},
                              Units{-200, -200}, Units{250, 250}, Units{-280, -280}}) {
      SCOPED_TRACE(std::string(body.name) + " " + std::to_string(units.inertia));
      // g would be beyond its own limit.
      if (std::string(body.potential).find("g(") != std::string::npos &&
          std::abs(units.energy + units.inertia / 2) > 290)
        continue;
      const Row scaled = row_in(units);
      ASSERT_FALSE(scaled.empty());
      for (const char* column : {"class", "negative", "certified", "class_certified", "krein1",
                                 "krein2", "krein3", "krein4", "krein5"})
        EXPECT_EQ(scaled.at(column), plain.at(column)) << column;
      for (const char* column : {"alpha", "xi", "zeta", "rho"})
        EXPECT_NEAR(number(scaled.at(column)), number(plain.at(column)),
                    1e-14 * std::abs(number(plain.at(column))))
            << column;
      for (const char* part : {"re", "im"})
        for (int k = 1; k <= 5; ++k) {
          const std::string column = part + std::to_string(k);
          if (plain.at(column).empty()) continue;
          EXPECT_NEAR(std::ldexp(number(scaled.at(column)), -units.rate()),
                      number(plain.at(column)), 1e-12)
              << column;
        }
    }
  }
}

TEST(ExtremeScales, WhichNumberIsOutOfScaleIsSaid) {
  for (const auto& [setting, key] : {std::pair{"body.J=[1.0, 1e200, 1.0]", "body.J.1"},
                                     {"potential.fibre.degrees=2e6", "potential.fibre.degrees"}}) {
    const Outcome outcome = run_program({"check", shipped("fibre.toml"), "--set", setting});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(std::string(key) + ": found "));
  }
}

/// A rate whose square overflows beside inertias that make up for it.
TEST(ExtremeScales, AnOverflowIsNoProof) {
  const TemporaryDirectory directory;
  const std::string path =
      directory.file("case.toml",
                     "[body]\nJ = [1e-303, 1.7e-303, 0.6e-303]\n[potential]\n"
                     "plane = { model = \"neo-hookean\", mu = 1.0, lambda = 2.0 }\n"
                     "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n"
                     "[motion]\nbranch = \"i\"\nnu = 1e151\n");
  const Outcome outcome = run_program({"solve", path});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("body.J"));
}

/// A circle is walked to from rest in any units: its balance has those of V, not those of 1.
TEST(ExtremeScales, CirclesHaveNoScaleOfTheirOwn) {
  const TemporaryDirectory directory;
  const auto solved = [&](int energy, const char* branch, double nu) {
    const auto V = [&](double x) { return number_text(std::ldexp(x, energy)); };
    const std::string path =
        directory.file("case.toml",
                       "[body]\nJ = [1.0, 1.0, 0.6]\n[potential]\nplane = { model = "
                       "\"reciprocal-determinant\", c = " +
                           V(1.0) + ", k = " + V(2.0) +
                           " }\nthickness = { model = \"reciprocal-quadratic\", a = " + V(1.0) +
                           ", b = " + V(3.0) + " }\n[motion]\nbranch = \"" + branch +
                           "\"\nnu = " + number_text(std::ldexp(nu, energy / 2)) + "\n");
    const Outcome out = run_program({"solve", path, "-o", "-"});
    EXPECT_EQ(out.code, 0) << energy << ": " << out.err;
    return out.code == 0 ? only_row(out.out) : Row();
  };
  for (const char* branch : {"i", "iii"}) {
    for (const double nu : {0.0, 0.3}) {
      const Row plain = solved(0, branch, nu);
      for (const int energy : {-200, -56, 50, 66, 200}) {
        const Row scaled = solved(energy, branch, nu);
        for (const char* column : {"xi", "zeta", "rho", "error_bound", "class"})
          EXPECT_EQ(scaled.at(column), plain.at(column)) << branch << nu << ' ' << energy;
      }
    }
  }
  // Far from the stretches 1.
  const std::string far =
      directory.file("far.toml",
                     "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\nplane = { model = "
                     "\"reciprocal-determinant\", c = 1e30, "
                     "k = 2e10 }\nthickness = { model = \"reciprocal-quadratic\", a = 1e10, b = "
                     "3e10 }\n[motion]\nbranch = "
                     "\"i\"\nnu = 0.0\n");
  const Outcome out = run_program({"solve", far, "-o", "-"});
  EXPECT_EQ(out.code, 0) << out.err;
  EXPECT_NEAR(number(only_row(out.out).at("xi")), 84089.64152537145, 1e-10);
}

/// A range far beyond the body's own scale, and one that is nothing but rounding.
TEST(ExtremeScales, AnyRangeIsFollowed) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", Units{0, 0}.case_text());
  const auto rows = [&](const std::string& from, const std::string& to) {
    const Outcome out = run_program({"continue", path, "--set", "continuation.from=" + from,
                                     "--set", "continuation.to=" + to, "-o", "-"});
    EXPECT_EQ(out.code, 0) << out.err;
    return rows_of(out.out);
  };
  const auto far = rows("0.0", "1e12");
  EXPECT_EQ(far.back().at("event"), "escape");
  EXPECT_NEAR(number(far.back().at("nu1")), 0.766964988845, 1e-9);
  const auto near = rows("0.5", "0.5000000000000001");
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(near.front().at("event"), "limit");
  EXPECT_EQ(near.back().at("nu1"), "0.5000000000000001");
}

/// Modes of the size of nu^2 would not keep their digits.
TEST(ExtremeScales, SpinsThatAreNearlyRestAreRefused) {
  for (const char* const nu : {"1e-99", "-1e-99", "0"})
    EXPECT_EQ(
        run_program({"solve", shipped("disc.toml"), "--set", std::string("motion.nu=") + nu}).code,
        0);
  for (const char* const nu : {"1e-101", "-1e-160"}) {
    const Outcome outcome =
        run_program({"solve", shipped("disc.toml"), "--set", std::string("motion.nu=") + nu});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("expected 0 or numbers from 1e-100 to 1e+45"), std::string::npos)
        << outcome.err;
  }
  EXPECT_EQ(run_program({"map", shipped("disc.toml"), "--set",
                         "map={x={parameter=\"nu\",from=1e-300,to=1.0,count=3}}"})
                .code,
            2);
}

/// A body of the modified neo-Hookean formula about axis 3, which its spin draws out along axis 1 without bound.
std::string needle() {
  return std::string("[body]\nJ = [1.112, 0.4243, 1.451]\n[potential.coupled]\nexpression = ") +
         "\"mu/2*(I1 + rho^2)*(d*rho)^(-2/3) + k/2*(d*rho-1)^2\"\nmu = 1.665\nk = 3.879\n" +
         "[motion]\nbranch = \"iii\"\nnu = 1.0\n"
         "[continuation]\nfrom = 0.0\nto = 2.25\ntolerance = 1e-6\n";
}

/// With D = det S and m = mu D^(-2/3): rho^2 = (1 - J1 nu^2/m) xi^2 = (1 - J2 nu^2/m) zeta^2, and an equation of D
/// is left,
///   m (2 rho^2 - xi^2 - zeta^2)/3 + k (D - 1) D = 0.
TEST(ExtremeScales, BoundsOfANeedleAreAboveItsErrors) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"continue", directory.file("case.toml", needle()), "-o", "-"});
  int compared = 0;
  for (const Row& row : rows_of(outcome.out)) {
    const double xi = number(row.at("xi"));
    if (!row.at("event").empty() || xi < 100.0 || xi > 2e4) continue;
    const Number50 nu2 = Number50(number(row.at("nu3"))) * Number50(number(row.at("nu3")));
    std::array<Number50, 3> x;
    const auto equation = [&](const Number50& D) {
      const Number50 m = Number50(1.665) * pow(D, Number50(-2) / 3);
      const Number50 by_xi = 1 - Number50(1.112) * nu2 / m;
      const Number50 by_zeta = 1 - Number50(0.4243) * nu2 / m;
      const Number50 rho2 = pow(D * D * by_xi * by_zeta, Number50(1) / 3);
      x = {sqrt(rho2 / by_xi), sqrt(rho2 / by_zeta), sqrt(rho2)};
      return m * (2 * rho2 - x[0] * x[0] - x[1] * x[1]) / 3 + Number50(3.879) * (D - 1) * D;
    };
    Number50 D = Number50(xi) * Number50(number(row.at("zeta"))) * Number50(number(row.at("rho")));
    for (int k = 0; k < 6; ++k) {
      const Number50 h = D * Number50("1e-30");
      const Number50 f = equation(D);
      D -= f * h / (equation(D + h) - f);
    }
    (void)equation(D);
    const char* names[] = {"xi", "zeta", "rho"};
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = abs(Number50(number(row.at(names[k]))) / x[k] - 1).convert_to<double>();
      EXPECT_LE(error, number(row.at("error_bound"))) << xi << ' ' << names[k];
      EXPECT_LE(error, 1e-15) << xi << ' ' << names[k];
    }
    EXPECT_LE(number(row.at("error_bound")), 1e-9) << xi;
    ++compared;
  }
  EXPECT_GE(compared, 6);
}

/// With gravity it is not of a closed form; a coupled balance in doubles is rounding there.
TEST(ExtremeScales, ANeedleIsFollowedToWhereItEscapes) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", needle());
  for (const char* const tolerance : {"1e-6", "1e-8"}) {
    const Outcome outcome =
        run_program({"continue", path, "-o", "-", "--set", "gravity={g=0.5}", "--set",
                     std::string("continuation.tolerance=") + tolerance});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = rows_of(outcome.out);
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows.back().at("event"), "escape");
    EXPECT_GT(number(rows.back().at("xi")), 1e5);
    EXPECT_LT(rows.size(), 10000U) << tolerance;
  }
}

/// A fluid of 10^18 times the volume and of as much gravity: a million times the stretches at the same nu, up
/// to where the sheet escapes.
TEST(ExtremeScales, AFluidOfAnyVolumeIsFollowedToItsEnd) {
  const TemporaryDirectory directory;
  const auto followed = [&](const std::string& volume) {
    const Outcome outcome =
        run_program({"continue",
                     directory.file("case.toml", "[body]\nJ = [1.0, 1.0, 0.6]\nvolume = " + volume +
                                                     "\n[gravity]\ng = " + volume +
                                                     "\n[motion]\nbranch = \"iii\"\nnu = 0.3\n"
                                                     "[continuation]\nfrom = 0.0\nto = 3.0\n"),
                     "-o", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<Row> events;
    for (const Row& row : rows_of(outcome.out))
      if (!row.at("event").empty()) events.push_back(row);
    return events;
  };
  const auto plain = followed("1.0");
  const auto large = followed("1e18");
  ASSERT_EQ(plain.size(), 6U);
  ASSERT_EQ(large.size(), plain.size());
  for (std::size_t k = 0; k < plain.size(); ++k) {
    EXPECT_EQ(large[k].at("event"), plain[k].at("event"));
    if (plain[k].at("event") == "escape") continue;  // the first point beyond the bounds
    EXPECT_NEAR(number(large[k], "nu3"), number(plain[k], "nu3"), 1e-12);
    for (const char* column : {"xi", "zeta", "rho"})
      EXPECT_NEAR(number(large[k], column), 1e6 * number(plain[k], column),
                  1e-9 * number(large[k], column));
  }
  EXPECT_GT(number(large.back(), "xi"), 1e8);
}

}  // namespace
}  // namespace stationary::testing
