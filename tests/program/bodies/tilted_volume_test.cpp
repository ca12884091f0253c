// Tilted motions of a body whose volume is held, from outside: the closed form of the neo-Hookean
// body, V = (mu/2)(tr S^2 - 3), along the whole family, its ends, its proofs, the atlas that enters it.
//
//   A_k s_k^2 = (A_1 A_2 A_3 C^2)^(1/3),  A_k = mu - c_k,  nu3^2 - nu1^2 = mu (1/J1 - 1/J3)
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

constexpr double tilted_J[3] = {0.6, 0.9, 1.1};

std::string neo_hookean_case(const std::string& motion, const std::string& rest = "") {
  return "[body]\nJ = [0.6, 0.9, 1.1]\nvolume = 1\n[potential]\n"
         "coupled = { expression = \"mu/2*(I1 + rho^2 - 3)\", mu = 1 }\n[motion]\n" +
         motion + rest;
}
std::string tilted_motion(double nu) {
  return "branch = \"tilted\"\nplane = \"13\"\nnu = " + std::to_string(nu) + "\n";
}

/// S in closed form, from the components of nu.
struct Stretches {
  double xi, zeta, rho;
};
Stretches stretches(double nu1, double nu3) {
  const double A[3] = {1.0 - tilted_J[0] * nu3 * nu3, 1.0 - tilted_J[1] * (nu1 * nu1 + nu3 * nu3),
                       1.0 - tilted_J[2] * nu1 * nu1};
  const double both = std::cbrt(A[0] * A[1] * A[2]);
  return {std::sqrt(both / A[0]), std::sqrt(both / A[1]), std::sqrt(both / A[2])};
}

std::vector<Row> rows_of_run(const std::string& path, const std::string& verb,
                             const std::vector<std::string>& more = {}) {
  const TemporaryDirectory directory;
  std::vector<std::string> command{verb, path, "-o", directory / "table.csv"};
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.code == 0 ? rows_of(text_of(directory / "table.csv")) : std::vector<Row>();
}

TEST(TiltedVolume, TheClosedFormAlongTheFamily) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      neo_hookean_case(tilted_motion(0.97),
                       "[continuation]\nfrom = 0.5\nto = 1.0\n[output]\ncertificate = true\n"));
  const std::vector<Row> rows = rows_of_run(path, "continue");
  ASSERT_GE(rows.size(), 20u);
  const double apart = 1.0 / tilted_J[0] - 1.0 / tilted_J[2];
  for (const Row& row : rows) {
    const double nu1 = number(row.at("nu1"));
    const double nu3 = number(row.at("nu3"));
    EXPECT_NEAR(nu3 * nu3 - nu1 * nu1, apart, 1e-14);
    const Stretches exact = stretches(nu1, nu3);
    const double bound = 4e-15 + number(row.at("error_bound"));
    EXPECT_NEAR(number(row.at("xi")) / exact.xi, 1.0, bound);
    EXPECT_NEAR(number(row.at("zeta")) / exact.zeta, 1.0, bound);
    EXPECT_NEAR(number(row.at("rho")) / exact.rho, 1.0, bound);
    EXPECT_EQ(row.at("certified"), "yes");
    EXPECT_EQ(row.at("re5"), "") << "one mode less than of a compressible body";
  }
  // It begins where axis 3 tilts: nu1 = 0.
  const auto end =
      std::ranges::find(rows, std::string("tilt"), [](const Row& r) { return r.at("event"); });
  ASSERT_NE(end, rows.end());
  EXPECT_NEAR(number(end->at("nu3")), std::sqrt(apart), 1e-14);
  EXPECT_EQ(number(end->at("nu1")), 0.0);
}

TEST(TiltedVolume, AllOfThemAreProven) {
  const TemporaryDirectory directory;
  for (const auto& [nu, count] : {std::pair{0.97, 1}, std::pair{0.8, 0}}) {
    const std::string path =
        directory.file("case.toml", neo_hookean_case(tilted_motion(nu), "[solve]\nall = true\n"));
    const Outcome outcome = run_program({"solve", path, "-o", "-"});
    ASSERT_EQ(outcome.code, count == 0 ? 3 : 0) << outcome.err;
    if (count == 0) {
      EXPECT_THAT(outcome.err, HasSubstr("proven that there is none"));
      continue;
    }
    const Row row = only_row(outcome.out);
    const Stretches exact = stretches(number(row.at("nu1")), number(row.at("nu3")));
    EXPECT_NEAR(number(row.at("zeta")) / exact.zeta, 1.0, 4e-15 + number(row.at("error_bound")));
  }
}

TEST(TiltedVolume, TheAtlasEntersThem) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      neo_hookean_case("branch = \"iii\"\nnu = 0.5\n", "[continuation]\nfrom = 0.5\nto = 1.0\n"));
  const std::vector<Row> rows = rows_of_run(path, "atlas");
  const auto count = [&](const char* branch) {
    return std::ranges::count(rows, std::string(branch),
                              [](const Row& r) { return r.at("branch"); });
  };
  EXPECT_GE(count("tilted"), 20);
  EXPECT_GE(count("iii"), 20);
}

/// A cell as a solve of its own.
/// biot: t = (2 mu + 2 lambda)/(2 mu + lambda), all else by d = C/rho; both ends at alpha = 0, where
/// the tilted families of either plane have the event too.
TEST(TiltedVolume, AxesInNoPlane) {
  const TemporaryDirectory directory;
  const auto text = [](const std::string& plane, const std::string& rest) {
    return "[body]\nJ = [1.0, 1.7, 0.6]\nvolume = 1.0\n[potential]\n"
           "plane = { model = \"biot\", mu = 1.0, lambda = 8.0 }\n"
           "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n[motion]\n"
           "branch = \"tilted\"\nplane = \"" +
           plane + "\"\nnu = 2.41\n[continuation]\nfrom = 0.1\nto = 6.0\n" + rest;
  };
  const std::vector<Row> rows = rows_of_run(
      directory.file("all.toml", text("123", "[output]\ncertificate = true\n")), "continue");
  ASSERT_GE(rows.size(), 50u);
  std::vector<double> ends;
  int proven = 0;
  for (const Row& row : rows) {
    const double rho = number(row.at("rho"));
    const double d = 1.0 / rho;
    const double tau = 0.6 * rho * rho;
    const double sigma = 1.7 * d * d / tau;
    const double t = 1.8;
    const double m = (tau + sigma + 2.7 * d) / t;
    const double xi = (1.7 * t - m) / 0.7;
    const double allowed = 1e-13 + 4.0 * number(row.at("error_bound"));
    EXPECT_NEAR(number(row.at("xi")), xi, allowed * 30.0);
    EXPECT_NEAR(number(row.at("zeta")), t - xi, allowed * 30.0);
    const double nu =
        std::hypot(number(row.at("nu1")), number(row.at("nu2")), number(row.at("nu3")));
    EXPECT_NEAR(number(row.at("nu3")), std::sqrt(sigma / tau) * nu, 1e-11);
    const double force = 3.0 * rho * rho - 1.0 / rho + 2.0 * d;
    EXPECT_NEAR((tau - 2.0 * sigma) * nu * nu, force, 1e-11 * force);
    proven += row.at("certified") == "yes";
    EXPECT_FALSE(row.at("pressure").empty());
    if (row.at("event") == "shear") ends.push_back(nu);
  }
  EXPECT_GE(proven, static_cast<int>(rows.size()) - 4);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(rows.front().at("event"), "shear");
  EXPECT_EQ(rows.back().at("event"), "shear");
  EXPECT_EQ(rows.front().at("nu1"), "0");
  EXPECT_EQ(rows.back().at("nu2"), "0");
  const std::pair<const char*, const char*> planes[] = {{"23", "0.0, 0.246, 1.554, 2.6157"},
                                                        {"13", "0.0, 1.411, 0.389, 1.8214"}};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<Row> tilted_rows = rows_of_run(
        directory.file("plane.toml", text(planes[k].first, std::string("[solve]\nstart = [") +
                                                               planes[k].second + "]\n")),
        "continue", {"--set", "motion.nu=" + std::to_string(ends[k])});
    const auto at = std::ranges::find_if(tilted_rows,
                                         [](const Row& row) { return row.at("event") == "shear"; });
    ASSERT_NE(at, tilted_rows.end()) << planes[k].first;
    const double nu =
        std::hypot(number(at->at("nu1")), number(at->at("nu2")), number(at->at("nu3")));
    EXPECT_NEAR(nu, ends[k], 1e-13) << planes[k].first;
  }
}

TEST(TiltedVolume, AxesInNoPlaneAreFoundAndTold) {
  const TemporaryDirectory directory;
  const auto solve = [&](const std::string& body, double nu) {
    return run_program(
        {"solve",
         directory.file("case.toml", "[body]\n" + body +
                                         "[potential]\nplane = { model = \"biot\", mu = "
                                         "1.0, lambda = 8.0 }\nthickness = { model = "
                                         "\"reciprocal-quadratic\", a = 1.0, b = 3.0 "
                                         "}\n[motion]\nbranch = \"tilted\"\nplane = "
                                         "\"123\"\nnu = " +
                                         std::to_string(nu) + "\n[solve]\nall = true\n"),
         "-o", "-"});
  };
  const std::string held = "J = [1.0, 1.7, 0.6]\nvolume = 1.0\n";
  const Outcome one = solve(held, 2.4);
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(rows_of(one.out).size(), 1u) << one.out;
  const Outcome none = solve(held, 1.0);
  EXPECT_EQ(none.code, 3) << none.err;
  const Outcome round = solve("J = [1.0, 1.0, 0.6]\nvolume = 1.0\n", 2.4);
  EXPECT_EQ(round.code, 3);
  EXPECT_THAT(round.err, HasSubstr("J1 = J2"));
  // W_t = 0 asks for d W_d = |nu|^2 sigma > 0, and W_d of this one is -2 mu.
  const Outcome compressible = solve("J = [1.0, 1.7, 0.6]\n", 2.4);
  EXPECT_EQ(compressible.code, 3);
  EXPECT_THAT(compressible.err, HasSubstr("proven that there is none"));
}

TEST(TiltedVolume, Maps) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      neo_hookean_case(tilted_motion(0.97),
                       "[map]\nx = { parameter = \"nu\", from = 0.96, to = 0.98, count = 3 }\n"
                       "y = { parameter = \"body.volume\", from = 0.9, to = 1.1, count = 3 }\n"));
  const std::vector<Row> rows = rows_of_run(path, "map");
  ASSERT_EQ(rows.size(), 9u);
  int compared = 0;
  for (const Row& row : rows) {
    if (row.at("status") != "solved") continue;
    EXPECT_NEAR(number(row.at("xi")) * number(row.at("zeta")) * number(row.at("rho")),
                number(row.at("body.volume")), 1e-14);
    ++compared;
  }
  EXPECT_EQ(compared, 9);
}

}  // namespace
}  // namespace stationary::testing
