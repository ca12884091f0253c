// Fluids whose J are not equal, from outside: J is a choice of material coordinates, so that with
// pi G rho = 1 they are the classical figures, S being S' sqrt(s/J), s^3 = J1 J2 J3.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

constexpr std::array<double, 3> fluid_J{1.0, 1.7, 0.6};
const double s = std::cbrt(1.0 * 1.7 * 0.6);
const double unit[3] = {std::sqrt(s / fluid_J[0]), std::sqrt(s / fluid_J[1]),
                        std::sqrt(s / fluid_J[2])};

std::string start(double xi, double zeta, double rho) {
  std::ostringstream out;
  out.precision(17);
  out << "[solve]\nstart = [0.0, " << xi * unit[0] << ", " << zeta * unit[1] << ", "
      << rho * unit[2] << "]\n";
  return out.str();
}

std::string fluid_case(const std::string& motion) {
  return "[body]\nJ = [1.0, 1.7, 0.6]\nvolume = 1\n[gravity]\npi_G_rho = 1\n[motion]\n" + motion;
}

class Fluid : public ::testing::Test {
 protected:
  Row solved(const std::string& text) {
    const Outcome outcome = run_program({"solve", directory_.file("case.toml", text), "-o", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err << text;
    return outcome.code == 0 ? only_row(outcome.out) : Row();
  }
  std::vector<Row> continued(const std::string& text, const std::vector<std::string>& more = {},
                             const std::string& name = "table.csv") {
    std::vector<std::string> command{"continue", directory_.file("case.toml", text), "-o",
                                     directory_ / name};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err << text;
    return outcome.code == 0 ? rows_of(text_of(directory_ / name)) : std::vector<Row>();
  }
  TemporaryDirectory directory_;
};

Row event(const std::vector<Row>& rows, const std::string& name) {
  const auto at =
      std::ranges::find_if(rows, [&](const Row& row) { return row.at("event") == name; });
  EXPECT_NE(at, rows.end()) << name;
  return at == rows.end() ? Row() : *at;
}

TEST_F(Fluid, JacobisEllipsoidIsStableWhateverItsCoordinates) {
  const double axes[3] = {1.49911080661478416932038, 0.9744220242996097100582471,
                          0.684572065801018726801909};
  const Row row = solved(fluid_case("branch = \"iii\"\nnu = 0.5895180264839983585672417\n") +
                         start(1.4991, 0.97442, 0.68457));
  ASSERT_FALSE(row.empty());
  const char* const columns[3] = {"xi", "zeta", "rho"};
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(number(row.at(columns[k])), axes[k] * unit[k], 1e-14) << columns[k];
  EXPECT_EQ(row.at("class"), "stable");
  EXPECT_EQ(row.at("re1"), "0");  // of the symmetry
  EXPECT_EQ(row.at("im1"), "0");
  // Momentum and energy are those of the same motion, in units of s.
  const double inertia = s * (axes[0] * axes[0] + axes[1] * axes[1]);
  EXPECT_NEAR(number(row.at("pi3")), 0.5895180264839983585672417 * inertia, 1e-13);
}

TEST_F(Fluid, SpheroidsBreakAndTurnWhereTheyDo) {
  const std::string range = "[continuation]\nfrom = 0.1\nto = 0.68\n";
  struct Known {
    const char* branch;
    const char* event;
    const char* nu;
    int first;
    int second;
  };
  for (const Known& at :
       {Known{"iii", "ellipse", "nu3", 0, 1}, Known{"i", "ellipse-23", "nu1", 1, 2},
        Known{"ii", "ellipse-13", "nu2", 0, 2}}) {
    const auto rows =
        continued(fluid_case(std::string("branch = \"") + at.branch + "\"\nnu = 0.3\n") + range);
    ASSERT_FALSE(rows.empty());
    const Row broken = event(rows, at.event);
    ASSERT_FALSE(broken.empty()) << at.branch;
    EXPECT_NEAR(number(broken.at(at.nu)), 0.6117431444537777853246, 1e-14) << at.branch;
    const char* const columns[3] = {"xi", "zeta", "rho"};
    for (const int k : {at.first, at.second})
      EXPECT_NEAR(number(broken.at(columns[k])), 1.197233858067355676666887 * unit[k], 1e-14);
    const double turn = number(event(rows, "fold-nu").at(at.nu));
    EXPECT_NEAR(turn * turn, 0.4493314121239138543595, 1e-14) << at.branch;
  }
}

/// Rows are read in the coordinates they were written in.
TEST_F(Fluid, GoesOnFromARow) {
  const std::string text =
      fluid_case("branch = \"iii\"\nnu = 0.3\n") + "[continuation]\nfrom = 0.1\nto = 0.5\n";
  const auto rows = continued(text);
  ASSERT_GE(rows.size(), 3U);
  const auto again = continued(
      text, {"--from", (directory_ / "table.csv") + ":2", "--set", "continuation.to=0.55"},
      "again.csv");
  ASSERT_FALSE(again.empty());
  const auto same = std::ranges::find_if(
      again, [&](const Row& row) { return row.at("nu3") == rows[1].at("nu3"); });
  ASSERT_NE(same, again.end());
  for (const std::string column : {"xi", "zeta", "rho", "energy", "pressure"})
    EXPECT_NEAR(number(same->at(column)) / number(rows[1].at(column)), 1.0, 1e-14) << column;
  EXPECT_NEAR(number(rows[1].at("xi")) / unit[0], number(rows[1].at("zeta")) / unit[1], 1e-14);
}

/// Classes and events of a polytrope, which a formula writes, are a fluid's too.
TEST_F(Fluid, MayBeCompressible) {
  std::ostringstream K;
  K.precision(17);
  K << 4.0 * s / 3.0;
  const auto rows = continued(
      "[body]\nJ = [1.0, 1.7, 0.6]\n[gravity]\npi_G_rho = 1\n[potential]\ncoupled = { expression = "
      "\"K*(d*rho)^(-1/n)\", K = " +
      K.str() +
      ", n = 1 }\n[motion]\nbranch = \"iii\"\nnu = 0.43\n[continuation]\nfrom = 0.4\nto = 0.48\n");
  ASSERT_FALSE(rows.empty());
  EXPECT_NEAR(number(event(rows, "ellipse").at("nu3")), 0.4716075899603202722504669, 1e-12);
}

TEST_F(Fluid, AllFiguresAndMaps) {
  const Outcome outcome = run_program(
      {"solve",
       directory_.file("case.toml", fluid_case("branch = \"iii\"\nnu = 0.5477225575051661\n") +
                                        "[solve]\nall = true\n"),
       "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  EXPECT_EQ(rows.size(), 4U);
  for (const Row& row : rows)
    EXPECT_NEAR(number(row.at("xi")) * number(row.at("zeta")) * number(row.at("rho")), 1.0, 1e-14);
  const Outcome map = run_program(
      {"map",
       directory_.file("map.toml", fluid_case("branch = \"iii\"\nnu = 0.3\n") +
                                       "[map]\nx = { parameter = \"nu\", from = 0.1, to = 0.5, "
                                       "count = 3 }\n"),
       "-o", "-"});
  ASSERT_EQ(map.code, 0) << map.err;
  for (const Row& row : rows_of(map.out)) {
    ASSERT_EQ(row.at("status"), "solved");
    EXPECT_NEAR(number(row.at("xi")) / unit[0], number(row.at("zeta")) / unit[1], 1e-14);
    EXPECT_EQ(row.at("class"), "stable");
  }
}

TEST_F(Fluid, TheCaseIsToldAsItIs) {
  const std::string path = directory_.file("case.toml", fluid_case("branch = \"iii\"\nnu = 0.3\n"));
  const Outcome outcome = run_program({"check", path});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("J = (1, 1.7, 0.6)"));
  EXPECT_THAT(outcome.out, HasSubstr("S is told in those of its own"));
  ASSERT_EQ(run_program({"solve", path, "-o", directory_ / "row.csv"}).code, 0);
  EXPECT_THAT(text_of(directory_ / "row.meta.json"), HasSubstr("1.7"));
  const Outcome followed = run_program(
      {"check", directory_.file("J.toml", fluid_case("branch = \"iii\"\nnu = 0.3\n") +
                                              "[continuation]\nparameter = \"body.J.2\"\nfrom = "
                                              "0.5\nto = 1.0\n")});
  EXPECT_EQ(followed.code, 2);
  EXPECT_THAT(followed.err, HasSubstr("J1 = J2 of a fluid whose J is followed"));
}

TEST_F(Fluid, ItsStartAndBoxAreToldAsTheyAre) {
  const std::string path = directory_.file(
      "case.toml", fluid_case("branch = \"iii\"\nnu = 0.3\n") +
                       "[solve]\nall = true\nbox = [[0.5, 2.0], [0.4, 3.0], [0.5, 2.0]]\n");
  const Outcome checked = run_program({"check", path});
  ASSERT_EQ(checked.code, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("xi in [0.5, 2], zeta in [0.4, 3], rho in [0.5, 2]"));
  ASSERT_EQ(run_program({"solve", path, "--set", "solve.all=false", "--set",
                         "solve.start=[0.0, 1.1, 1.1, 0.83]", "-o", directory_ / "row.csv"})
                .code,
            0);
  const auto solve = nlohmann::json::parse(text_of(directory_ / "row.meta.json"))["case"]["solve"];
  EXPECT_EQ(solve["start"], nlohmann::json({0.0, 1.1, 1.1, 0.83}));
  EXPECT_EQ(solve["box"], nlohmann::json({{0.5, 2.0}, {0.4, 3.0}, {0.5, 2.0}}));
}

/// A body that is a fluid by the case's own coefficient alone has its own J where that varies.
TEST_F(Fluid, ACoefficientThatMakesItElasticLeavesItsJ) {
  const std::string text =
      "[body]\nJ = [1.0, 1.7, 0.6]\nvolume = 1.0\n[gravity]\ng = 4.0\n[potential]\ncoupled = { "
      "expression = \"mu/2*(I1 + rho^2)\", mu = 0.0 }\n[motion]\nbranch = \"iii\"\nnu = 0.3\n";
  const Outcome map = run_program(
      {"map",
       directory_.file("map.toml",
                       text + "[map]\nx = { parameter = \"potential.coupled.mu\", from = 0.0, to = "
                              "1.0, count = 3 }\n"),
       "-o", "-"});
  ASSERT_EQ(map.code, 0) << map.err;
  const auto cells = rows_of(map.out);
  ASSERT_EQ(cells.size(), 3U);
  const auto continued_rows = continued(
      text + "[continuation]\nparameter = \"potential.coupled.mu\"\nfrom = 0.5\nto = 1.0\n",
      {"--set", "potential.coupled.mu=0.5"});
  ASSERT_FALSE(continued_rows.empty());
  for (const std::string mu : {"0.0", "0.5", "1.0"}) {
    const Outcome solved = run_program({"solve", directory_.file("one.toml", text), "--set",
                                        "potential.coupled.mu=" + mu, "-o", "-"});
    ASSERT_EQ(solved.code, 0) << solved.err;
    const Row own = only_row(solved.out);
    const Row& cell = cells[static_cast<std::size_t>(2.0 * std::stod(mu))];
    for (const std::string column : {"xi", "zeta", "rho", "energy"}) {
      EXPECT_NEAR(number(cell.at(column)), number(own.at(column)), 1e-13) << column << " " << mu;
      if (mu == "1.0") {
        EXPECT_NEAR(number(continued_rows.back().at(column)), number(own.at(column)), 1e-13);
      }
    }
  }
}

}  // namespace
}  // namespace stationary::testing
