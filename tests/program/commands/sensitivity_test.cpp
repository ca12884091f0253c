// `sensitivity` from outside: laws of scale that hold of every kind of motion, closed forms, errors
// that hold the true ones, uncertainties, what is left open and what is refused.
//
// With units of time 1/s as long, rates and frequencies are s times as large, energies s^2: by Euler
//   sum 2 c dX/dc + sum r dX/dr = w X,   c: coefficients of V, r: nu, rates or momenta of the case,
// w = 0 of stretches, 1 of frequencies, rates and momenta, 2 of energies. With units of mass 1/s:
//   sum J dX/dJ + sum c dX/dc = w X,     w = 1 of momenta and energies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "tests/program/json_schema.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

std::vector<Row> slopes(const std::string& path, const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{"sensitivity", path, "-o", "-"};
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.code == 0 ? rows_of(outcome.out) : std::vector<Row>();
}

bool is_coefficient(const std::string& key) {
  return key.starts_with("potential.") && !key.ends_with(".degrees") && !key.ends_with(".rest");
}
bool is_rate(const std::string& key) { return key == "nu" || key.starts_with("motion."); }
bool is_inertia(const std::string& key) { return key.starts_with("body.J."); }

bool starts_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
  return std::ranges::any_of(beginnings, [&](const auto& each) { return text.starts_with(each); });
}

/// Powers of the unit of time and of mass in a column.
int time_weight(const std::string& column) {
  if (column == "energy") return 2;
  const std::vector<std::string> rates{"nu",    "pi",    "re", "im",     "growth",
                                       "omega", "theta", "s3", "p_theta"};
  return starts_with_any(column, rates) ? 1 : 0;
}
int mass_weight(const std::string& column) {
  return column == "energy" || starts_with_any(column, {"pi", "s3", "p_theta"}) ? 1 : 0;
}

struct Shipped {
  const char* name;
  bool has_all_inertia;  ///< J1 and J2 are numbers of the motion
};
void PrintTo(const Shipped& shipped, std::ostream* out) { *out << shipped.name; }

class SensitivityOf : public ::testing::TestWithParam<Shipped> {};

TEST_P(SensitivityOf, LawsOfScale) {
  const std::string path = shipped(std::string(GetParam().name) + ".toml");
  const Row solved = only_row(run_program({"solve", path, "-o", "-"}).out);
  const std::vector<Row> rows = slopes(path);
  ASSERT_GE(rows.size(), 5u);
  int compared = 0;
  for (const auto& [column, text] : solved) {
    const std::string slope = "d_" + column;
    if (!rows.front().contains(slope) || text.empty() || column == "angle") continue;
    double by_time = 0.0;
    double by_mass = 0.0;
    double size = std::abs(number(text));
    double error = 0.0;
    for (const Row& row : rows) {
      const std::string& key = row.at("number");
      const double term = number(row.at("value")) * number(row.at(slope));
      error += 2.0 * std::abs(number(row.at("value"))) * number(row.at("error"));
      size = std::max(size, std::abs(term));
      by_time += is_coefficient(key) ? 2.0 * term : is_rate(key) ? term : 0.0;
      by_mass += is_coefficient(key) || is_inertia(key) ? term : 0.0;
    }
    const double most = 1e-10 * size + error;
    EXPECT_NEAR(by_time, time_weight(column) * number(text), most) << column;
    if (GetParam().has_all_inertia) {
      EXPECT_NEAR(by_mass, mass_weight(column) * number(text), most) << column;
    }
    EXPECT_LE(error, 1e-6 * (size + 1.0)) << column << ": that says little";
    ++compared;
  }
  EXPECT_GE(compared, 12);
}

INSTANTIATE_TEST_SUITE_P(All, SensitivityOf,
                         ::testing::Values(Shipped{"disc", true}, Shipped{"second_axis", true},
                                           Shipped{"third_axis", true}, Shipped{"tilted", true},
                                           Shipped{"fibre", true}, Shipped{"oblique", true},
                                           Shipped{"two_polar", false}),
                         [](const auto& each) { return std::string(each.param.name); });

/// The error bound of S is no less than what half a unit in the last place of every number of the
/// case comes to.
void expect_bound_of_inputs(const std::string& path, double at_least) {
  const Row solved = only_row(run_program({"solve", path, "-o", "-"}).out);
  const double bound = number(solved.at("error_bound"));
  double largest = 0.0;
  for (const std::string stretch : {"xi", "zeta", "rho"}) {
    double sum = 0.0;
    for (const Row& row : slopes(path)) {
      const std::string& slope = row.at("d_" + stretch);
      if (!slope.empty())
        sum += std::abs(number(row.at("value")) * number(slope) / number(solved.at(stretch)));
    }
    largest = std::max(largest, 0x1p-53 * sum);
  }
  EXPECT_LE(largest, bound * (1.0 + 1e-6)) << path;
  EXPECT_GE(largest, at_least * bound) << path << ": a bound that is too wide is none";
}

TEST_P(SensitivityOf, ErrorBoundsHoldTheInputs) {
  expect_bound_of_inputs(shipped(std::string(GetParam().name) + ".toml"), 0.02);
}

/// Near a fold, so that the inputs are nearly all of the bound; and a tilted axis of a held volume.
TEST(Sensitivity, ErrorBoundsHoldTheInputsOfWholeBodies) {
  const TemporaryDirectory directory;
  expect_bound_of_inputs(
      directory.file("heavy.toml",
                     "[body]\nJ = [1.1226, 2.1184, 2.2052]\n[gravity]\ng = 0.49344\n[potential]\n"
                     "plane = { model = \"biot\", mu = 2.7508, lambda = 0.18576 }\n"
                     "thickness = { model = \"harmonic\", k = 1.4423, rest = 0.37303 }\n"
                     "[motion]\nbranch = \"i\"\nnu = 0.2333\n"),
      0.8);
  expect_bound_of_inputs(
      directory.file("tilted.toml",
                     "[body]\nJ = [0.6, 0.9, 1.1]\nvolume = 1\n[potential]\n"
                     "coupled = { expression = \"mu/2*(I1 + rho^2 - 3)\", mu = 1 }\n[motion]\n"
                     "branch = \"tilted\"\nplane = \"13\"\nnu = 0.97\n"),
      0.002);
}

const std::string neo_hookean_case =
    "[body]\nJ = [0.6, 0.9, 1.1]\nvolume = 1\n[potential]\n"
    "coupled = { expression = \"mu/2*(I1 + rho^2 - 3)\", mu = 1 }\n[motion]\nbranch = \"iii\"\n"
    "nu = 0.5\n[continuation]\nfrom = 0.3\nto = 1.0\n";

/// Axis 3 tilts at nu^2 = mu (1/J1 - 1/J3), whatever J2 and the volume are.
TEST(Sensitivity, OfATiltInClosedForm) {
  const TemporaryDirectory directory;
  const std::vector<Row> rows = slopes(directory.file("case.toml", neo_hookean_case), {"--events"});
  const double nu = std::sqrt(1.0 / 0.6 - 1.0 / 1.1);
  const std::vector<std::pair<std::string, double>> exact{{"body.J.0", -0.5 / (nu * 0.36)},
                                                          {"body.J.1", 0.0},
                                                          {"body.J.2", 0.5 / (nu * 1.21)},
                                                          {"potential.coupled.mu", 0.5 * nu},
                                                          {"body.volume", 0.0}};
  int compared = 0;
  for (const Row& row : rows) {
    if (row.at("of") != "tilt" || std::abs(number(row.at("at")) - nu) > 1e-6) continue;
    const auto expected =
        std::ranges::find(exact, row.at("number"), &std::pair<std::string, double>::first);
    ASSERT_NE(expected, exact.end()) << row.at("number");
    const double got = number(row.at("d_event"));
    EXPECT_NEAR(got, expected->second, 1e-11) << row.at("number");
    EXPECT_LE(std::abs(got - expected->second), number(row.at("error")) + 1e-15)
        << row.at("number");
    ++compared;
  }
  EXPECT_EQ(compared, 5);
}

/// A_k s_k^2 = (A1 A2 A3 C^2)^(1/3): d ln rho/d ln C = 1/3, and in nu.
TEST(Sensitivity, OfStretchesInClosedForm) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", neo_hookean_case);
  const Row solved = only_row(run_program({"solve", path, "-o", "-"}).out);
  const double rho = number(solved.at("rho"));
  // rho = (A1 A2)^(1/6), A = 1 - J nu^2.
  const double slope = rho / 6.0 * (-2.0 * 0.5) * (0.6 / (1.0 - 0.15) + 0.9 / (1.0 - 0.225));
  for (const Row& row : slopes(path)) {
    const double got = number(row.at("d_rho"));
    const double error = number(row.at("error")) + 1e-15;
    if (row.at("number") == "body.volume") {
      EXPECT_NEAR(got, rho / 3.0, 1e-12);
      EXPECT_LE(std::abs(got - rho / 3.0), error);
    }
    if (row.at("number") == "nu") {
      EXPECT_NEAR(got, slope, 1e-12);
      EXPECT_LE(std::abs(got - slope), error);
    }
  }
}

/// A pressure is small beside its terms, whose rounding is no corner; and an axis is the same half a turn
/// further.
TEST(Sensitivity, OfSmallPressuresAndOfAnAngleThatWraps) {
  const TemporaryDirectory directory;
  const auto slope = [&](const std::string& text, const std::string& column,
                         const std::string& of_number) {
    const Outcome outcome =
        run_program({"sensitivity", directory.file("x.toml", text), "--quiet", "-o", "-", "--set",
                     "output.columns=[\"" + column + "\"]"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const Row& row : rows_of(outcome.out))
      if (row.at("number") == of_number) return row.at("d_" + column);
    return std::string("none");
  };
  // By 50 digits.
  EXPECT_NEAR(number(slope(R"([body]
J = [0.4096, 1.792, 2.128]
volume = 0.7638
[potential]
plane     = { model = "saint-venant-kirchhoff", mu = 1.809, lambda = 0.939 }
thickness = { model = "harmonic", k = 1.894, rest = 1.107 }
[motion]
branch = "i"
nu = 0.7557
)",
                           "pressure", "body.volume")),
              -0.124809081230361, 1e-9);
  const std::string along = R"([body]
J = [1.0, 1.2, 0.6]
[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "harmonic", k = 1.0, rest = 1.0 }
fibre     = { k = 0.4, degrees = )";
  const std::string rest = " }\n[motion]\nbranch = \"iii\"\nnu = 0.5\n";
  const double beside = number(slope(along + "0.001" + rest, "angle", "potential.fibre.degrees"));
  EXPECT_NEAR(number(slope(along + "0.0" + rest, "angle", "potential.fibre.degrees")), beside,
              1e-6);
  EXPECT_GT(beside, 0.006);
}

TEST(Sensitivity, UncertaintiesAreCombined) {
  const TemporaryDirectory directory;
  const std::string told = "[output]\nuncertainty = { \"body.J.0\" = 0.01, \"nu\" = 0.002 }\n";
  const std::string path = directory.file("case.toml", neo_hookean_case + told);
  const std::vector<Row> rows = slopes(path);
  double sum = 0.0;
  for (const Row& row : rows) {
    if (row.at("uncertainty").empty()) continue;
    sum = std::hypot(sum, number(row.at("d_xi")) * number(row.at("uncertainty")));
  }
  ASSERT_EQ(rows.back().at("number"), "combined");
  EXPECT_GT(sum, 0.0);
  EXPECT_NEAR(number(rows.back().at("d_xi")), sum, 1e-15);
  const Outcome outcome = run_program({"sensitivity", path, "-o", directory / "x.csv"});
  EXPECT_THAT(outcome.out, HasSubstr("+-"));
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(schema_fault(metadata, nlohmann::json::parse(text_of(STATIONARY_SCHEMA))), "");
  EXPECT_EQ(metadata["command"], "sensitivity");
  EXPECT_EQ(metadata["case"]["output"]["uncertainty"]["body.J.0"], 0.01);
}

/// The same tilt along J3/J1, at J3/J1 = 1/(1 - J1 nu^2/mu): it moves with the J1 that the ratio is to.
TEST(Sensitivity, OfAnEventAlongARatio) {
  const TemporaryDirectory directory;
  std::string text = neo_hookean_case;
  text.replace(text.find("[continuation]"), std::string::npos,
               "[continuation]\nparameter = \"body.J.2/body.J.0\"\nfrom = 1.0\nto = 2.0\n"
               "[output]\nuncertainty = { \"body.J.0\" = 0.01 }\n");
  const double left = 1.0 - 0.6 * 0.25;
  double found = 0.0;
  double combined = 0.0;
  for (const Row& row : slopes(directory.file("case.toml", text), {"--events"})) {
    if (row.at("of") != "tilt" || std::abs(number(row.at("at")) - 1.0 / left) > 1e-6) continue;
    EXPECT_NE(row.at("number"), "body.J.2") << "it is the event's own";
    if (row.at("number") == "body.J.0") found = number(row.at("d_event"));
    if (row.at("number") == "combined") combined = number(row.at("d_event"));
  }
  EXPECT_NEAR(found, 0.25 / (left * left), 1e-10);
  EXPECT_NEAR(combined, 0.01 * found, 1e-13);
}

/// J1 of a circle breaks what its ellipses begin at; J2 likewise.
TEST(Sensitivity, WhatBreaksAnEventHasNoSlope) {
  int seen = 0;
  for (const Row& row : slopes(shipped("circle.toml"), {"--events"})) {
    if (row.at("of") != "ellipse") continue;
    const std::string& key = row.at("number");
    EXPECT_EQ(row.at("d_event").empty(), key == "body.J.0" || key == "body.J.1") << key;
    ++seen;
  }
  EXPECT_GE(seen, 5);
}

/// A circle leaves the angle of its ellipse's axis open, and J1 = 1.001 would tell one.
TEST(Sensitivity, TheAngleOfACircleHasNone) {
  int seen = 0;
  for (const Row& row : slopes(shipped("circle.toml"))) {
    EXPECT_EQ(row.at("d_angle"), "") << row.at("number");
    EXPECT_NE(row.at("d_xi"), "") << row.at("number");
    ++seen;
  }
  EXPECT_GE(seen, 5);
}

TEST(Sensitivity, RefusesColumnsWithoutSlopes) {
  const std::vector<std::string> asked{"sensitivity", shipped("disc.toml"),
                                       "-o",          "-",
                                       "--set",       "output.columns=[\"class\",\"negative\"]"};
  const Outcome outcome = run_program(asked);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("found no column that sensitivity computes"));
  EXPECT_THAT(outcome.err,
              HasSubstr("\"energy\", \"growth\", \"re1\""));  // none of those asked for
}

/// Nearly round a body may turn about many axes, and a solve beside it come to another of them.
TEST(Sensitivity, NeighboursAreOfTheSameMotion) {
  const TemporaryDirectory directory;
  for (const auto& [k, nu1, angle] : {std::tuple{"0.01", -1424.55657944, 83343.5660363},
                                      {"0.1", -159.338769253, 10426.1219769}}) {
    const std::string path =
        directory.file("case.toml",
                       "[body]\nJ = [1.0, 1.0, 0.6]\n[potential]\n"
                       "plane = { model = \"neo-hookean\", mu = 1.0, lambda = 2.0 }\n"
                       "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n"
                       "fibre = { k = " +
                           std::string(k) +
                           ", degrees = 30.0 }\n"
                           "[motion]\nbranch = \"oblique\"\naxis = \"1\"\nnu = 0.02\n");
    for (const Row& row : slopes(path)) {
      if (row.at("number") != "body.J.0") continue;
      for (const auto& [column, exact] : {std::pair{"d_nu1", nu1}, {"d_angle", angle}}) {
        ASSERT_NE(row.at(column), "") << k << column;
        EXPECT_LE(std::abs(number(row.at(column)) - exact), number(row.at("error")))
            << k << column << row.at(column);
      }
    }
  }
}

/// By J1 a pair that the symmetry of J1 = J2 holds at zero becomes a real one, +-sqrt(c dJ1): that has no slope, and
/// the pair above it keeps its own.
TEST(Sensitivity, ModesAreThoseBesideThem) {
  const TemporaryDirectory directory;
  const std::string path =
      directory.file("case.toml",
                     "[body]\nJ = [0.6661, 0.6661, 1.688]\n[potential]\n"
                     "plane = { model = \"hencky\", mu = 5.89, lambda = 0.5877 }\n"
                     "thickness = { model = \"reciprocal-quadratic\", a = 2.449, b = 0.6372 }\n"
                     "[motion]\nbranch = \"tilted\"\nnu = 0.72733\nplane = \"23\"\n"
                     "[solve]\nall = true\nbox = [0.02, 50.0]\n");
  int seen = 0;
  for (const Row& row : slopes(path)) {
    if (row.at("number") != "body.J.0" || row.at("sheet") != "2") continue;
    EXPECT_EQ(row.at("d_re1"), "");
    EXPECT_NEAR(number(row.at("d_re2")), -1.2829309, 1e-6);
    ++seen;
  }
  EXPECT_EQ(seen, 1);
}

/// A fibre turned away from an axis leaves no motion about axis 1, and about axis 3 none at alpha = 0,
/// where the ellipse turns away. A tilt is left, and is the same for either sense.
TEST(Sensitivity, OfEventsByTheAngleOfAFibreAlongAnAxis) {
  const std::vector<std::string> along{"--events",
                                       "--set",
                                       "potential.fibre.degrees=0",
                                       "--set",
                                       "continuation.from=0.1",
                                       "--set",
                                       "continuation.to=0.6"};
  const auto of_angle = [&](const std::string& branch, const std::string& event) {
    std::vector<std::string> command = along;
    command.insert(command.end(),
                   {"--set", "motion.branch=" + branch, "--set",
                    "potential.plane={ model = \"hencky\", mu = 1.0, lambda = 0.6 }"});
    std::vector<std::string> out;
    for (const Row& row : slopes(shipped("fibre.toml"), command))
      if (row.at("number") == "potential.fibre.degrees" && row.at("of") == event)
        out.push_back(row.at("d_event"));
    return out;
  };
  EXPECT_THAT(of_angle("i", "oblique"), ::testing::ElementsAre(""));
  EXPECT_THAT(of_angle("iii", "shear"), ::testing::ElementsAre(""));
  EXPECT_THAT(of_angle("iii", "tilt"), ::testing::ElementsAre("0"));
}

/// nu is a number like the others where another one is followed.
TEST(Sensitivity, OfEventsInNuWhereAnotherNumberIsFollowed) {
  const std::vector<std::string> along{"--set", "continuation.parameter=\"body.J.2\"",
                                       "--set", "continuation.from=0.3",
                                       "--set", "continuation.to=3"};
  constexpr double step = 1e-3;
  const auto events_at = [&](double nu) {
    std::vector<std::string> command{
        "continue", shipped("disc.toml"), "-o", "-", "--set", "motion.nu=" + std::to_string(nu)};
    command.insert(command.end(), along.begin(), along.end());
    std::map<std::string, Row> out;
    for (const Row& row : rows_of(run_program(command).out))
      if (!row.at("event").empty()) out[row.at("event")] = row;
    return out;
  };
  const auto below = events_at(0.5 - step);
  const auto above = events_at(0.5 + step);
  std::vector<std::string> command = along;
  command.insert(command.begin(), "--events");
  int seen = 0;
  for (const Row& row : slopes(shipped("disc.toml"), command)) {
    if (row.at("number") != "nu") continue;
    const auto quotient = [&](const std::string& column) {
      return (number(above.at(row.at("of")).at(column)) -
              number(below.at(row.at("of")).at(column))) /
             (2.0 * step);
    };
    EXPECT_NEAR(number(row.at("d_event")), quotient("body.J.2"), 1e-5) << row.at("of");
    EXPECT_NEAR(number(row.at("d_zeta")), quotient("zeta"), 1e-5) << row.at("of");
    EXPECT_NEAR(number(row.at("d_pi1")), quotient("pi1"), 1e-5) << row.at("of");
    EXPECT_GT(std::abs(number(row.at("d_event"))), 0.1);
    ++seen;
  }
  EXPECT_EQ(seen, 2);
}

/// (i), J1 = J2, unstable on one side alone: growth goes like a root of what J1 differs by.
TEST(Sensitivity, AGrowthThatBeginsHasNoSlope) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", R"(
[body]
J = [0.7816019908021316, 0.7816019908021316, 0.806796095503721]
[potential.plane]
expression = "mu/2*(I1 - 2*d) + k*(d - d1)^2*(d - d2)^2"
mu = 2.307978002860823
k = 0.6271797835009291
d1 = 0.9886209590617102
d2 = 1.4909901154836118
[potential.thickness]
expression = "k*((rho - r1)*(rho - r2))^2"
k = 2.78706405290476
r1 = 0.8
r2 = 1.1189223306885725
[motion]
branch = "ii"
nu = 1.237997033965165
[solve]
start = [0.0, 1.6671619383278435, 1.1562090972527976, 1.5281974928045003]
)");
  const auto growth = [&](const std::string& J) {
    return number(only_row(run_program({"solve", path, "-o", "-", "--set", "body.J.0=" + J}).out)
                      .at("growth"));
  };
  EXPECT_NEAR(growth("0.7815") / growth("0.78159"), std::sqrt(0.000101990802 / 0.000011990802),
              0.01);
  EXPECT_EQ(growth("0.7817"), 0.0);
  int seen = 0;
  for (const Row& row : slopes(path)) {
    const bool breaks = row.at("number") == "body.J.0" || row.at("number") == "body.J.1";
    if (breaks) {
      EXPECT_EQ(row.at("d_growth"), "") << row.at("number");
    }
    // The others are smooth, and so are the stretches.
    EXPECT_NE(row.at("d_xi"), "") << row.at("number");
    EXPECT_LE(number(row.at("error")), 1e-3) << row.at("number");
    if (breaks) ++seen;
  }
  EXPECT_EQ(seen, 2);
}

TEST(Sensitivity, WrongInputIsRefused) {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::string& output) {
    const Outcome outcome =
        run_program({"sensitivity",
                     directory.file("case.toml", neo_hookean_case + "[output]\n" + output + "\n")});
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused("uncertainty = { \"body.J.4\" = 0.1 }"), HasSubstr("body.J.4"));
  EXPECT_THAT(refused("uncertainty = { nu = -0.1 }"), HasSubstr("standard uncertainty > 0"));
  EXPECT_THAT(refused("uncertainty = { nu = \"much\" }"), HasSubstr("standard uncertainty > 0"));
  EXPECT_THAT(refused("uncertainty = 0.1"), HasSubstr("a table"));
  EXPECT_THAT(refused("uncertainty = { \"body.J.0/body.J.1\" = 0.1 }"), HasSubstr("ratio"));
  EXPECT_THAT(refused("uncertainty = { nu = 0.1, \"motion.nu\" = 0.2 }"),
              HasSubstr("each number once"));
  const Outcome fluid = run_program(
      {"sensitivity", directory.file("fluid.toml",
                                     "[body]\nJ = [1, 2, 3]\nvolume = 1\n[gravity]\ng = 4\n"
                                     "[motion]\nbranch = \"iii\"\nnu = 0.3\n")});
  EXPECT_EQ(fluid.code, 2);
  EXPECT_THAT(fluid.err, HasSubstr("fluid"));
}

TEST(Sensitivity, OfEventsSaysWhatItDoesNotFollow) {
  const Outcome cut = run_program({"sensitivity", shipped("fold.toml"), "--events", "-o", "-",
                                   "--set", "continuation.max_points=5"});
  EXPECT_EQ(cut.code, 0) << cut.err;
  EXPECT_THAT(cut.err, HasSubstr("stopped at continuation.max_points"));
  const Outcome row = run_program({"sensitivity", shipped("fold.toml"), "--events", "-o", "-",
                                   "--set", "continuation.start_row=\"a.csv:3\""});
  EXPECT_EQ(row.code, 2);
  EXPECT_THAT(row.err, HasSubstr("follows the case from its own start"));
}

}  // namespace
}  // namespace stationary::testing
