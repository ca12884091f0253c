// Special points and ends of curves of events, against what is known otherwise: a cusp is where two folds
// meet, potentials without folds have no double points with folds, a vertical branch has no sides.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;

class CurveSpecialPoints : public ::testing::Test {
 protected:
  /// The metadata of the curves.
  json curves(const std::string& text, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"curve", directory_.file("case.toml", text), "-o", out_,
                                       "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(text_of(directory_ / "x.meta.json")).at("curves");
  }
  /// Of the only one.
  json curve(const std::string& text, const std::vector<std::string>& more = {}) {
    const json all = curves(text, more);
    EXPECT_EQ(all.size(), 1U);
    return all.at(0);
  }
  static std::vector<json> of(const json& curve, const std::string& special,
                              const std::string& other = "") {
    std::vector<json> out;
    for (const json& each : curve.value("special", json::array()))
      if (each.at("special") == special && (other.empty() || each.value("other", "") == other))
        out.push_back(each);
    return out;
  }

  TemporaryDirectory directory_;
  std::string out_ = directory_ / "x.csv";
};

/// About axis 1 a body with J2 = J3 has circles zeta = rho, and the folds of a family in J3 meet at one of
/// them: J3 is p across the cusp's tangent, and keeps its direction there.
const char* const folds_about_a_circle = R"(
[body]
J = [1.0, 1.2, 1.15]
[potential.coupled]
expression = "c1*(I1 + rho^2 - 3) + c2*(I2 - 3) - 2*(c1 + 2*c2)*log(d*rho) + k/2*log(d*rho)^2"
c1 = 0.45
c2 = 1.15
k = 1.7
[motion]
branch = "i"
nu = 1.36
[solve]
start = [0.0, 0.81, 1.5, 1.0]
[continuation]
parameter = "body.J.2"
from = 0.7
to = 2.4
[curve]
event = "fold-parameter"
parameters = ["body.J.2", "nu"]
from = [0.7, 0.5]
to = [2.4, 2.2]
tolerance = 1e-6
)";

TEST_F(CurveSpecialPoints, CuspWhereOneParameterKeepsItsDirection) {
  const std::vector<json> found = of(curve(folds_about_a_circle), "cusp");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at("at").at(0).get<double>(), 1.2, 1e-9);
  const double nu = found[0].at("at").at(1).get<double>();
  EXPECT_NEAR(nu, 1.421244992884, 1e-9);
  // Below it the family has both folds, above it neither.
  for (const double change : {-0.01, 0.01}) {
    const std::string table = directory_ / "family.csv";
    const Outcome outcome = run_program({"continue", directory_ / "case.toml", "--set",
                                         "motion.nu=" + std::to_string(nu + change), "-o", table});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    int folds = 0;
    for (const Row& row : rows_of(text_of(table)))
      if (row.at("event") == "fold-parameter") ++folds;
    EXPECT_EQ(folds, change < 0.0 ? 2 : 0) << nu + change;
  }
}

TEST_F(CurveSpecialPoints, CuspInEitherOrderOfTheParameters) {
  const std::vector<json> found =
      of(curve(folds_about_a_circle,
               {"--set", "continuation.parameter=\"nu\"", "--set", "continuation.from=1.0", "--set",
                "continuation.to=2.0", "--set", "motion.nu=1.36", "--set", "body.J.2=1.15", "--set",
                "curve.event=\"fold-nu\"", "--set", "curve.parameters=[\"nu\",\"body.J.2\"]",
                "--set", "curve.from=[0.5,0.7]", "--set", "curve.to=[2.2,2.4]"}),
         "cusp");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at("at").at(0).get<double>(), 1.421244992884, 1e-9);
  EXPECT_NEAR(found[0].at("at").at(1).get<double>(), 1.2, 1e-9);
}

/// Where J1 = J2 the equations of frequencies that meet are singular: the point itself is not had, and the
/// points around it tell of it, whatever J2 the curve is met at first.
TEST_F(CurveSpecialPoints, EqualInertiasWhereFrequenciesMeet) {
  for (const char* J2 : {"0.195488", "0.1949", "0.21"}) {
    int found = 0;
    for (const json& each : curves(R"(
[body]
J = [0.1948, 0.195488, 41.69]
[potential]
plane     = { model = "biot", mu = 0.05032, lambda = 2.197 }
thickness = { model = "reciprocal-quadratic", a = 2.493, b = 0.2608 }
[motion]
branch = "iii"
nu = 0.3
[continuation]
from = 0.0
to = 3.0
[curve]
event = "krein-pass"
parameters = ["nu", "body.J.1"]
from = [0.0449, 0.0489]
to = [1.4378, 0.78195]
tolerance = 1e-5
)",
                                   {"--set", std::string("body.J.1=") + J2})) {
      for (const json& point : of(each, "double", "inertia-exchange")) {
        ++found;
        EXPECT_NEAR(point.at("at").at(1).get<double>(), 0.1948, 1e-14) << J2;
        const double nu = point.at("at").at(0).get<double>();
        EXPECT_NEAR(nu, nu < 0.2 ? 0.137278025404561 : 0.359762786947225, 1e-12) << J2;
      }
    }
    EXPECT_EQ(found, 2) << J2;
  }
}

/// J1 = J2 and this plane: the ellipses are at the one nu, all along the curve.
TEST_F(CurveSpecialPoints, AVerticalBranchHasNoSidesToExchange) {
  const json found = curve(R"(
[body]
J = [0.84, 0.84, 0.81]
[potential]
plane     = { model = "neo-hookean", mu = 1.25, lambda = 2.4 }
thickness = { model = "reciprocal-quadratic", a = 0.55, b = 0.62 }
[motion]
branch = "iii"
nu = 0.25
[continuation]
from = 0.0
to = 2.48
[curve]
event = "ellipse"
parameters = ["nu", "potential.plane.mu"]
from = [0.0, 0.52]
to = [2.48, 3.24]
tolerance = 1e-6
)");
  EXPECT_GE(found.at("points").get<int>(), 20);
  EXPECT_TRUE(of(found, "degenerate-pitchfork").empty()) << found;
}

/// Of these models every motion is a closed form that is one for each nu: the determinant that a fold makes zero
/// is rounding where zeta grows to 1e6.
TEST_F(CurveSpecialPoints, NoFoldsFarOutOfABodyThatHasNone) {
  const json found = curve(R"(
[body]
J = [0.4631778492846876, 1.1493390276905322, 0.7932596749293357]
[potential]
plane     = { model = "reciprocal-determinant", c = 1.6778105324818966, k = 0.6350420955724755 }
thickness = { model = "reciprocal-quadratic", a = 0.9963998645621959, b = 3.122794315705116 }
[motion]
branch = "iii"
nu = 0.1486644662480992
[continuation]
from = 0.0
to = 1.486644662480992
[curve]
event = "tilt"
parameters = ["nu", "body.J.1"]
from = [0.0, 0.4597356110762129]
to = [1.486644662480992, 2.8733475692263304]
tolerance = 1e-6
)");
  double largest = 0.0;
  for (const Row& row : rows_of(text_of(out_))) largest = std::max(largest, number(row.at("zeta")));
  EXPECT_GT(largest, 1e5);
  EXPECT_TRUE(of(found, "double", "fold-nu").empty()) << found;
}

/// The determinant of fold-momentum is 1.5e-6 at this one's far end, by 60 digits, and has no zero there.
TEST_F(CurveSpecialPoints, NoDoublePointByAnAsymptote) {
  const json found = curve(R"(
[body]
J = [2.3368630860608284, 2.3368630860608284, 1.1653844324698102]
[potential]
plane     = { model = "hencky", mu = 3.329704534822247, lambda = 2.139665497006515 }
thickness = { model = "reciprocal-quadratic", a = 2.238020499274223, b = 1.6986724441936327 }
[motion]
branch = "i"
nu = 0.2387350639864236
[continuation]
from = 0.0
to = 2.387350639864236
[curve]
event = "fold-nu"
parameters = ["nu", "body.J.2"]
from = [0.0, 0.4661537729879241]
to = [2.387350639864236, 2.9134610811745256]
tolerance = 1e-6
)");
  EXPECT_EQ(of(found, "double", "tilt").size(), 1U);
  EXPECT_EQ(of(found, "double", "inertia-exchange").size(), 1U);
  EXPECT_TRUE(of(found, "double", "fold-momentum").empty()) << found;
}

/// xi = zeta = rho = 1 at rest: the tilt of (i) comes to nu = 0 at J1 = J3.
TEST_F(CurveSpecialPoints, EndsBesideZero) {
  const json found = curve(R"(
[body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "harmonic", k = 3.0, rest = 1.0 }
[motion]
branch = "i"
nu = 0.3
[continuation]
from = 0.0
to = 1.0
[curve]
event = "tilt"
parameters = ["nu", "body.J.2"]
from = [0.0, 0.3]
to = [1.0, 3.0]
)");
  EXPECT_EQ(found.at("first_end").at("event"), "limit");
  EXPECT_EQ(found.at("last_end").at("event"), "limit");
  EXPECT_EQ(found.at("last_end").at("reason"),
            "the range asked for, but for a ten-thousandth of it at 0");
  const std::vector<Row> rows = rows_of(text_of(out_));
  EXPECT_LE(number(rows.back().at("nu")), 1e-4);
  EXPECT_NEAR(number(rows.back().at("body.J.2")), 1.0, 1e-7);
}

}  // namespace
}  // namespace stationary::testing
