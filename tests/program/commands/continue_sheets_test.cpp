// continue from outside: where sheets end, which events stand on them, and that rows are in their order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_motion.hpp"
#include "tests/program/continued.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::IsEmpty;

/// At rest no axis is turned about: where two locked inertias change their order nothing changes its count.
TEST(ContinueAtRest, NothingIsUnexplained) {
  for (const char* const branch : {"i", "ii", "iii"}) {
    for (const char* const parameter :
         {"body.J.0", "body.J.1", "body.J.2", "potential.thickness.a"}) {
      const Outcome outcome = run_program(
          {"continue", shipped("disc.toml"), "-o", "-", "--set", "motion.nu=0", "--set",
           std::string("motion.branch=") + branch, "--set",
           std::string("continuation={parameter=\"") + parameter + "\",from=0.5,to=3.0}"});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      for (const Row& row : rows_of(outcome.out)) {
        EXPECT_NE(row.at("event"), "unexplained") << branch << " " << parameter;
        EXPECT_EQ(row.at("negative"), "0");
      }
    }
  }
}

/// Every shipped case with an axis of spin (a tilted one ends where its tilt does), from rest to
/// its end or nu = 3.
TEST(Continue, EveryCaseIsFollowedFromEndToEnd) {
  for (const auto& entry : std::filesystem::directory_iterator(STATIONARY_CASES)) {
    const Case input = read_case(entry.path().string());
    if (has_rates(input.motion)) continue;
    const bool own = input.continuation.has_value();
    const Outcome outcome =
        continued(entry.path().string(), own ? std::vector<std::string>() : along_nu("0", "3"));
    ASSERT_EQ(outcome.code, 0) << entry.path() << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty()) << entry.path();
    const auto rows = rows_of(outcome.out);
    ASSERT_GE(rows.size(), 2U);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool at_end = k == 0 || k + 1 == rows.size();
      const std::string& event = rows[k].at("event");
      // Tilted sheets end where they are no longer tilted, those in no plane where they come to one,
      // ellipses on their circle, sheared ones where alpha has come to 0.
      const bool meets_another =
          (input.branch_name() == tilted_name && event == "tilt") ||
          (std::holds_alternative<SpatialRotation>(input.motion) && event == "shear") ||
          (input.solve.start && input.solve.start->alpha != 0.0 && event == "shear" &&
           rows[k].at("alpha") == "0") ||
          (event == "ellipse" && rows[k].at("xi") == rows[k].at("zeta") && at_end);
      EXPECT_EQ(is_end_name(event) || meets_another, at_end) << entry.path() << " row " << k;
      EXPECT_EQ(rows[k].at("branch"), input.branch_name());
      EXPECT_EQ(rows[k].at("sheet"), "1");
      EXPECT_EQ(rows[k].at("point"), std::to_string(k));
      EXPECT_LE(number(rows[k], "residual"), 1e-14) << entry.path() << " row " << k;
    }
    EXPECT_EQ(names_of_events(rows).find("unexplained"), std::string::npos) << entry.path();
  }
}

/// alpha != 0: xi and zeta stay of order one where mu vanishes, and grow to less than the bound where lambda has
/// passed it.
TEST(Continue, EndsAreToldByThePrincipalStretches) {
  const TemporaryDirectory directory;
  const auto last_row = [&](const std::string& text) {
    const std::string table = directory / "x.csv";
    const Outcome outcome =
        run_program({"continue", directory.file("case.toml", text), "-o", table});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<Row> rows = rows_of(text_of(table));
    return rows.empty() ? Row() : rows.back();
  };
  const Row collapsed = last_row(R"(
[body]
J = [1.6887554198187398, 1.6887554198187398, 0.39551336257487735]
[potential]
plane = { model = "biot", mu = 1.066861928836281, lambda = 0.5376592289982426 }
thickness = { model = "harmonic", k = 2.783228126971786, rest = 0.6501720171305491 }
fibre = { k = 1.062417554432834, degrees = 34.09338152955395 }
[motion]
branch = "oblique"
axis = "1"
nu = 0.5902645172156106
[solve]
start = [-0.07102295145736529, 0.9547302116760132, 1.2832505192372745, 0.6840398258406629]
[continuation]
parameter = "body.J.1"
from = 1.0
to = 8.4437770990937
tolerance = 1e-6
)");
  EXPECT_EQ(collapsed.at("event"), "collapse");
  EXPECT_LT(number(collapsed.at("mu")), 1e-6);
  EXPECT_GT(number(collapsed.at("xi")), 0.1);
  EXPECT_GT(number(collapsed.at("zeta")), 0.1);
  const Row escaped = last_row(R"(
[body]
J = [0.3507057627197812, 2.019078390966385, 0.9846620337937597]
[potential]
coupled = { model = "neo-hookean-3d", mu = 1.6066784829389542, lambda = 1.5476772072114435 }
fibre = { k = 0.1964545671450376, degrees = 40.779368341947915 }
[motion]
branch = "iii"
nu = 0.5845913578161445
[solve]
start = [-0.013602526147513063, 0.9685723799891488, 1.2306873763127555, 0.9423958175979597]
[continuation]
from = 0.0
to = 1.7537740734484335
tolerance = 1e-6
)");
  EXPECT_EQ(escaped.at("event"), "escape");
  EXPECT_GT(number(escaped.at("lambda")), 1e6);
}

TEST(Continue, EndsAtTheLimitsAsked) {
  const auto rows = rows_of(continued(shipped("disc.toml"), along_nu("-0.625", "0.75")).out);
  EXPECT_EQ(rows.front().at("event"), "limit");
  EXPECT_EQ(rows.front().at("nu1"), "-0.625");
  EXPECT_EQ(rows.back().at("event"), "limit");
  EXPECT_EQ(rows.back().at("nu1"), "0.75");
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_LT(number(rows[k - 1], "nu1"), number(rows[k], "nu1"));
}

/// cases/fold.toml
double greatest_spin_of_fold() {
  constexpr double mu = 1.1;
  constexpr double lambda = 0.8;
  return std::sqrt(2.0 * mu * (mu + lambda) / ((2.0 * mu + lambda) * std::numbers::e * 1.7));
}

/// Beside a turn of nu: a sheet that comes back to where it began, and a limit within 1e-12 of the turn.
TEST(Continue, EndsAtTheLimitBesideATurn) {
  struct Asked {
    const char* start;
    const char* from;
    const char* to;
    const char* step;
    const char* end;
  };
  for (const Asked& each : {Asked{"0.5491", "0.5491", "3", "0.1", "0.5491"},
                            Asked{"0.549105", "0.549105", "3", "0.1", "0.549105"},
                            Asked{"0.549", "0.549", "1", "0.5", "0.549"},
                            Asked{"0.3", "0", "0.5491055229307", "0.1", "0.5491055229307"},
                            Asked{"0.3", "0", "0.54910552293", "0.1", "0.54910552293"}}) {
    SCOPED_TRACE(each.start + std::string(" to ") + each.to);
    const auto text = [](const char* key, const char* value) {
      return std::string(key) + "=" + value;
    };
    const auto rows =
        rows_of(continued(shipped("fold.toml"),
                          {text("motion.nu", each.start), text("continuation.from", each.from),
                           text("continuation.to", each.to), text("continuation.step", each.step)})
                    .out);
    ASSERT_GT(rows.size(), 2U);
    EXPECT_EQ(rows.front().at("event"), "limit");
    EXPECT_EQ(rows.front().at("nu1"), each.from);
    EXPECT_EQ(rows.back().at("event"), "limit");
    EXPECT_EQ(rows.back().at("nu1"), each.end);
    // ln(zeta)/zeta^2 is as nu^2, and 1/(2 e) at the fold.
    const double zeta = number(rows.back(), "zeta");
    const double share = number(rows.back(), "nu1") / greatest_spin_of_fold();
    EXPECT_NEAR(std::log(zeta) / (zeta * zeta), share * share / (2.0 * std::numbers::e), 1e-15);
  }
}

/// The fold by its closed form (cases/fold.toml), and nu at rest on either side of it.
TEST(Continue, AFoldStandsWhereTheSpinIsGreatest) {
  const auto rows = rows_of(continued(shipped("fold.toml"), along_nu("0", "3")).out);
  EXPECT_EQ(names_of_events(rows), "limit fold-nu tilt escape");
  const std::size_t fold = index_of(rows, "fold-nu");
  EXPECT_NEAR(number(rows[fold], "nu1"), greatest_spin_of_fold(), 1e-15);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double step = number(rows[k], "nu1") - number(rows[k - 1], "nu1");
    EXPECT_GE(k <= fold ? step : -step, 0.0) << k;
    EXPECT_LT(number(rows[k - 1], "zeta"), number(rows[k], "zeta")) << k;
  }
  EXPECT_GT(number(rows.back(), "zeta"), 9e5);
}

/// I1 = I3 at a tilt of (i): the class changes there and nowhere else.
TEST(Continue, ATiltStandsWhereTwoInertiasAreEqual) {
  const auto rows = rows_of(continued(shipped("neo_hookean.toml"), along_nu("0", "0.766")).out);
  EXPECT_EQ(names_of_events(rows), "limit tilt limit");
  const std::size_t tilt = index_of(rows, "tilt");
  const double xi = number(rows[tilt], "xi");
  const double rho = number(rows[tilt], "rho");
  EXPECT_NEAR(xi * xi, 0.6 * rho * rho, 1e-13);
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_EQ(rows[k].at("class"), k < tilt ? "unstable" : k > tilt ? "stable" : "marginal") << k;
}

/// As nu -> 0 the disc flattens without end: |pi| = 0.5657 + 1.2 nu along it, which turns nowhere, and
/// the share of nu in the tangent is rounding.
TEST(Continue, NoFoldOfTheMomentumByAnAsymptote) {
  const TemporaryDirectory directory;
  for (
      const char* plane :
      {R"({ model = "saint-venant-kirchhoff", mu = 1.0, lambda = 0.5 })",
       R"({ model = "saint-venant-kirchhoff", mu = 1.0, lambda = 3.0 })",
       R"({ model = "orthotropic-saint-venant-kirchhoff", c11 = 0.79, c22 = 2.55, c12 = 1.16, c66 = 0.3 })"}) {
    const std::string flat =
        directory.file("flat.toml", std::string("[body]\nJ = [1.0, 1.0, 0.5]\nvolume = 0.8\n"
                                                "[potential]\nplane = ") +
                                        plane +
                                        "\n[motion]\nbranch = \"i\"\nnu = 0.3\n[continuation]\n"
                                        "from = 0.0\nto = 3.0\n");
    for (const char* tolerance : {"1e-4", "1e-5", "1e-7"}) {
      const Outcome outcome = continued(flat, {std::string("continuation.tolerance=") + tolerance});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      int beside = 0;
      for (const Row& row : rows_of(outcome.out)) {
        if (std::abs(number(row.at("nu1"))) > 1e-5) continue;
        ++beside;
        EXPECT_NE(row.at("event"), "fold-momentum") << plane << row.at("nu1");
      }
      EXPECT_GT(beside, 10) << plane;
    }
  }
}

/// mu turns a thousand times here, near one value: the row of a turn is between its neighbours, and not
/// another turn's.
TEST(Continue, AmongManyTurnsEachHasItsOwnRow) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", R"case(
[body]
J = [2.3522, 0.27121, 0.15753]
[potential]
plane = { expression = "mu*(t-2)^2+k*(d-1)^2+c*cos(t)", mu = 1.3222, k = 2.8604, c = 0.33514 }
thickness = { model = "harmonic", k = 8.436, rest = 1.3676 }
[motion]
branch = "iii"
nu = 0.93309
[continuation]
parameter = "potential.plane.mu"
from = 1.0245
to = 3.9666
tolerance = 1e-05
)case");
  const Outcome outcome = continued(file, {"output.spectrum=false"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  int turns = 0;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    if (rows[k].at("event") != "fold-parameter") continue;
    const auto xi = [&](std::size_t row) { return number(rows[row].at("xi")); };
    EXPECT_GT((xi(k) - xi(k - 1)) * (xi(k + 1) - xi(k)), 0.0) << "row " << k;
    ++turns;
  }
  EXPECT_GE(turns, 1000);
}

}  // namespace
}  // namespace stationary::testing
