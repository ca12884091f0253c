// Where curves of events end: with the family whose events they are, at numbers they do not pass;
// and families that start at a row of one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class CurveEnds : public ::testing::Test {
 protected:
  /// By the command, of this case.
  Outcome run(const std::string& command, const std::string& text,
              std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{command, directory_.file("case.toml", text), "-o",
                                       directory_ / (command + ".csv")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  std::vector<Row> rows(const std::string& command) const {
    return rows_of(text_of(directory_ / (command + ".csv")));
  }
  json metadata(const std::string& command) const {
    return json::parse(text_of(directory_ / (command + ".meta.json")));
  }
  std::string row_name(const std::string& command, std::size_t row) const {
    return (directory_ / (command + ".csv")) + ":" + std::to_string(row + 1);
  }

  TemporaryDirectory directory_;
};

/// V_xi = J1 xi nu3^2 and V_rho = J3 rho nu1^2 hold with nu1^2 or nu3^2 < 0 beyond the ends of a
/// tilted family, and so do the equations of its events.
TEST_F(CurveEnds, OfATiltedFamilyEndWithIt) {
  struct Asked {
    const char* event;
    const char* first_end;  ///< what the axis comes to
    const char* body;
    const char* range;
  };
  for (const Asked& each :
       {Asked{"inertia-exchange", "the axis has come to the plane of axes 1 and 2",
              R"([body]
J = [1.282, 0.942, 1.423]
[potential]
coupled = { model = "neo-hookean-3d", mu = 0.999, lambda = 1.586 }
)",
              R"(parameters = ["nu", "body.J.2"]
from = [0.138936, 0.7115]
to = [3.9, 2.2768]
)"},
        {"fold-nu", "the axis has come to axis 3, on branch (iii)",
         R"([body]
J = [1.433, 0.807, 0.97]
[potential]
plane = { model = "neo-hookean", mu = 0.912, lambda = 1.568 }
thickness = { model = "harmonic", k = 1.849, rest = 0.615 }
)",
         R"(parameters = ["nu", "potential.plane.mu"]
from = [0.1, 0.2]
to = [3.9, 3.0]
)"}}) {
    SCOPED_TRACE(each.event);
    const std::string text = std::string(each.body) + R"([motion]
branch = "tilted"
plane = "13"
nu = 1.0
[continuation]
from = 0.02
to = 4.0
[curve]
event = ")" + each.event + "\"\n" +
                             each.range;
    const Outcome outcome = run("curve", text, {"--certify"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<Row> found = rows("curve");
    ASSERT_GT(found.size(), 50U);
    for (const Row& row : found) {
      EXPECT_FALSE(row.at("nu1").empty() || row.at("nu3").empty()) << row.at("point");
      // At the end a component is 0, and not proven to be real.
      if (&row != &found.front()) {
        EXPECT_EQ(row.at("certified"), "yes") << row.at("point");
      }
    }
    EXPECT_EQ(found.front().at("special"), "double");
    EXPECT_LT(std::abs(number(found.front().at("nu1")) * number(found.front().at("nu3"))), 1e-4);
    const json curve = metadata("curve").at("curves").at(0);
    EXPECT_EQ(curve.at("first_end").at("event"), "tilt");
    EXPECT_EQ(curve.at("first_end").at("reason"), each.first_end);
    EXPECT_EQ(curve.at("last_end").at("event"), "limit");
  }
}

/// The row beside one of a curve is another body's.
TEST_F(CurveEnds, ARowOfACurveStartsItsOwnFamily) {
  const std::string circle = R"([body]
J = [1.0, 1.0, 0.6]
[potential]
plane = { model = "biot-log", mu = 1.0, lambda = 4.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "iii"
nu = 0.5
[continuation]
from = 0.0
to = 1.5
[curve]
event = "ellipse"
parameters = ["nu", "potential.plane.lambda"]
from = [0.1, 1.0]
to = [1.5, 8.0]
)";
  const std::string fold = text_of(STATIONARY_CASES "/fold.toml") + R"(
[curve]
event = "fold-nu"
parameters = ["nu", "body.J.1"]
from = [0.1, 0.5]
to = [1.2, 3.0]
)";
  for (const auto& [event, text] : {std::pair("ellipse", circle), {"fold-nu", fold}}) {
    SCOPED_TRACE(event);
    ASSERT_EQ(run("curve", text).code, 0);
    const std::vector<Row> curve = rows("curve");
    ASSERT_GT(curve.size(), 12U);
    for (const std::size_t k : {std::size_t{3}, curve.size() / 2}) {
      const Outcome outcome =
          run("continue", text, {"--from", row_name("curve", k), "--set", "continuation.to=1.5"});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      double nearest = 1.0;
      for (const Row& row : rows("continue"))
        if (row.at("event") == event)
          nearest = std::min(nearest, std::abs(number(row.at("nu1")) + number(row.at("nu3")) -
                                               number(curve[k].at("nu"))));
      EXPECT_LE(nearest, 1e-12) << k;
    }
  }
}

const std::string soft_disc = R"([body]
J = [1.186, 1.186, 0.579]
[potential]
plane = { model = "biot-log", mu = 1.434, lambda = -0.361 }
thickness = { model = "harmonic", k = 0.721, rest = 0.971 }
[motion]
branch = "two-polar"
omega = 1.363
theta_dot = 0.173
[continuation]
parameter = "motion.omega"
from = -3.0
to = 3.0
[curve]
parameters = ["motion.omega", "motion.theta_dot"]
)";

/// A rate is not nu: its turn is a fold in another number, and its curve the same by either name.
TEST_F(CurveEnds, ARateOfATwoPolarFamilyTurns) {
  const std::string asked = soft_disc + "from = [-2.0, 0.1]\nto = [1.8, 0.25]\n";
  ASSERT_EQ(run("continue", asked + "event = \"fold-nu\"\n").code, 0);
  double omega = 0.0;
  for (const Row& row : rows("continue")) {
    EXPECT_NE(row.at("event"), "fold-nu");
    if (row.at("event") == "fold-parameter") omega = number(row.at("omega"));
  }
  EXPECT_NEAR(omega, -1.41765686853226, 1e-12);
  for (const char* name : {"fold-nu", "fold-parameter"}) {
    const Outcome outcome = run("curve", asked + "event = \"" + name + "\"\n");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    double nearest = 1.0;
    for (const Row& row : rows("curve"))
      if (std::abs(number(row.at("motion.theta_dot")) - 0.173) < 1e-12)
        nearest = std::min(nearest, std::abs(number(row.at("motion.omega")) - omega));
    EXPECT_LE(nearest, 1e-12) << name;
  }
}

/// And its proof is that of the fold, whichever name it was asked by.
TEST_F(CurveEnds, AFoldInAnotherNumberIsProvenByEitherName) {
  const std::string asked = text_of(STATIONARY_CASES "/fold.toml") +
                            "[curve]\nparameters = [\"body.J.1\", \"nu\"]\n"
                            "from = [1.0, 0.5]\nto = [2.5, 0.58]\n";
  for (const char* name : {"fold-nu", "fold-parameter"}) {
    SCOPED_TRACE(name);
    const Outcome outcome =
        run("curve", asked + "event = \"" + name + "\"\n",
            {"--certify", "--set", "potential.fibre={ k = 0.01, degrees = 0 }"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<Row> curve = rows("curve");
    ASSERT_GT(curve.size(), 12U);
    for (const Row& row : curve) EXPECT_EQ(row.at("certified"), "yes");
  }
}

/// s3 = 0 where both rates come to 0: the logarithm of the first does not pass it.
TEST_F(CurveEnds, WhereTheFirstNumberComesToZero) {
  const std::string asked =
      soft_disc + "event = \"zero-momentum\"\nfrom = [-1.0, -0.5]\nto = [1.8, 0.5]\n";
  const Outcome outcome = run("curve", asked);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json curve = metadata("curve").at("curves").at(0);
  const auto at_zero = [](const json& end) {
    return end.at("event") == "stalled" &&
           end.at("reason").get<std::string>().starts_with("the first number comes to 0");
  };
  EXPECT_TRUE(at_zero(curve.at("first_end")) || at_zero(curve.at("last_end"))) << curve;
  for (const Row& row : rows("curve"))
    EXPECT_GT(std::abs(number(row.at("motion.omega"))), 1e-6) << row.at("point");
}

/// The sheet through rest turns before the case's own nu, which `continue` does not ask about.
/// Where the stretches run off at one nu, a double of it no longer tells them apart.
TEST_F(CurveEnds, WhereTheStretchesRunOff) {
  const Outcome outcome = run("curve", R"([body]
J = [1.438, 1.438, 0.3853]
[gravity]
g = 1.479
[potential]
plane = { model = "reciprocal-determinant", c = 0.449, k = 0.3722 }
thickness = { model = "reciprocal-quadratic", a = 0.3536, b = 1.675 }
[motion]
branch = "i"
nu = 0.3
[curve]
event = "fold-nu"
parameters = ["nu", "gravity.g"]
from = [0.0, 0.37]
to = [4.0, 5.92]
)");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto table = rows("curve");
  EXPECT_LT(table.size(), 700U);
  ASSERT_GT(table.size(), 100U);
  double largest = 0.0;
  for (const Row& row : table) largest = std::max(largest, number(row.at("zeta")));
  EXPECT_GT(largest, 1e3);
  EXPECT_THAT(metadata("curve").dump(), HasSubstr("does not resolve the stretches"));
}

TEST_F(CurveEnds, AFamilyThroughRestNeedNotReachTheCasesNu) {
  const std::string text = R"([body]
J = [1.63, 1.75, 0.425]
[potential]
plane = { model = "neo-hookean", mu = 0.749, lambda = 1.0 }
thickness = { model = "reciprocal-quadratic", a = 1.787, b = 2.393 }
fibre = { k = 0.053, degrees = -64.616 }
[motion]
branch = "iii"
nu = 0.733
[continuation]
from = 0.0
to = 2.0
[curve]
event = "tilt"
parameters = ["nu", "body.J.2"]
from = [0.05, 0.255]
to = [2.0, 0.6375]
)";
  ASSERT_EQ(run("continue", text).code, 0);
  double tilt = 0.0;
  for (const Row& row : rows("continue"))
    if (row.at("event") == "tilt") tilt = number(row.at("nu3"));
  ASSERT_NEAR(tilt, 0.670172776523, 1e-11);
  const Outcome outcome = run("curve", text);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  double nearest = 1.0;
  for (const Row& row : rows("curve"))
    if (std::abs(number(row.at("body.J.2")) - 0.425) < 1e-12)
      nearest = std::min(nearest, std::abs(number(row.at("nu")) - tilt));
  EXPECT_LE(nearest, 1e-12);
}

/// Far out the second number hardly changes along the curve: a row's bound is that of S at the
/// row's own numbers.
TEST_F(CurveEnds, BoundsAreOfTheRowsOwnNumbers) {
  const std::string text = R"~([body]
J = [1.178, 0.975, 1.049]
[potential]
coupled = { expression = "c1*(I1 + rho^2 - 3) + c2*(d^2 + rho^2*I1 - 3) - 2*(c1 + 2*c2)*log(d*rho) + k/2*log(d*rho)^2", c1 = 0.456, c2 = 0.174, k = 2.172 }
[motion]
branch = "tilted"
plane = "13"
nu = 1.0
[continuation]
from = 0.02
to = 4.0
[curve]
event = "tilt"
parameters = ["nu", "body.J.2"]
from = [0.1826, 0.5245]
to = [3.9, 1.6784]
)~";
  ASSERT_EQ(run("curve", text).code, 0);
  const std::vector<Row> curve = rows("curve");
  ASSERT_GT(curve.size(), 100U);
  // Half a unit of J3 is so much of its distance from J1.
  const Row& far = curve.front();
  const double apart = std::abs(number(far.at("body.J.2")) / 1.178 - 1.0);
  ASSERT_LT(apart, 1e-8);
  EXPECT_GT(number(far.at("error_bound")), 0x1p-54 / apart);
  EXPECT_LT(number(curve[curve.size() / 2].at("error_bound")), 1e-12);
}

/// One ellipse of given momenta, in a box that the search leaves undecided.
TEST_F(CurveEnds, EllipsesOfGivenMomentaInUndecidedBoxes) {
  const std::string text = R"~([body]
J = [1.0, 1.0, 1.056]
[potential]
plane = { expression = "mu/2*(I1-2-2*log(d)) + k/2*(exp(b*(I1-2)^2)-1)", mu = 0.3, k = 0.318, b = 0.677 }
thickness = { model = "harmonic", k = 2.955, rest = 1.453 }
[motion]
branch = "two-polar"
s3 = 1.38
p_theta = 2.458
[map]
x = { parameter = "motion.s3", from = 0.2, to = 2.0, count = 10 }
)~";
  const Outcome solved = run("solve", text);
  ASSERT_EQ(solved.code, 0) << solved.err;
  EXPECT_NEAR(number(rows("solve").at(0).at("lambda")), 1.586641826186868, 1e-12);
  ASSERT_EQ(run("map", text).code, 0);
  for (const Row& cell : rows("map")) EXPECT_EQ(cell.at("status"), "solved") << cell.at("s3");
}

}  // namespace
}  // namespace stationary::testing
