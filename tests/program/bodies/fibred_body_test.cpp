// Gravity and a held volume beside potentials with directions of their own, from outside: an
// orthotropic plane with isotropic coefficients is saint-venant-kirchhoff's, whatever is asked, and
// what is written with a fibre has the proofs that other bodies have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

constexpr const char* isotropic =
    "plane = { model = \"saint-venant-kirchhoff\", mu = 1.0, lambda = 0.6 }\n";
constexpr const char* orthotropic =
    "plane = { model = \"orthotropic-saint-venant-kirchhoff\", c11 = 2.6, c22 = 2.6, c12 = 0.6, "
    "c66 "
    "= 1.0 }\n";
constexpr const char* thickness =
    "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n";
constexpr const char* held = "volume = 1.1\n";
constexpr const char* heavy = "[gravity]\ng = 0.4\n";

std::string text(const std::string& body, const std::string& plane, const std::string& rest,
                 const char* J = "[1.0, 1.7, 0.6]") {
  return std::string("[body]\nJ = ") + J + "\n" + body + "[potential]\n" + plane + thickness + rest;
}
std::string spin_text(const std::string& branch, const std::string& nu) {
  return "[motion]\nbranch = \"" + branch + "\"\nnu = " + nu + "\n";
}

std::vector<Row> rows_from(const std::string& verb, const std::string& content) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({verb, directory.file("case.toml", content), "-o", directory / "table.csv"});
  EXPECT_EQ(outcome.code, 0) << outcome.err << content;
  return outcome.code == 0 ? rows_of(text_of(directory / "table.csv")) : std::vector<Row>();
}

void expect_alike(const Row& a, const Row& b, const std::string& where) {
  for (const char* column : {"nu1", "nu2", "nu3", "alpha", "xi", "zeta", "rho", "energy"})
    EXPECT_NEAR(number(a.at(column)), number(b.at(column)),
                2e-14 * (1.0 + std::abs(number(b.at(column)))))
        << where << column;
  EXPECT_EQ(a.contains("pressure"), b.contains("pressure"));
  if (b.contains("pressure")) {
    EXPECT_NEAR(number(a.at("pressure")), number(b.at("pressure")), 1e-13) << where;
  }
  EXPECT_EQ(a.at("class"), b.at("class")) << where;
  EXPECT_EQ(a.at("negative"), b.at("negative")) << where;
  for (int k = 1; k <= 5; ++k) {
    for (const std::string part : {"re", "im"}) {
      const std::string column = part + std::to_string(k);
      ASSERT_EQ(a.at(column).empty(), b.at(column).empty()) << where << column;
      if (!b.at(column).empty()) {
        EXPECT_NEAR(number(a.at(column)), number(b.at(column)), 1e-12) << where << column;
      }
    }
  }
}

const std::vector<std::string> bodies{held, std::string(held) + heavy, heavy};

TEST(FibredBody, IsotropicCoefficientsAreIsotropic) {
  for (const std::string& body : bodies) {
    for (const std::string branch : {"i", "ii", "iii"}) {
      for (const char* nu : {"0.0", "0.5"}) {
        const std::string where = body + branch + " " + nu + " ";
        const auto a = rows_from("solve", text(body, orthotropic, spin_text(branch, nu)));
        const auto b = rows_from("solve", text(body, isotropic, spin_text(branch, nu)));
        ASSERT_EQ(a.size(), 1u) << where;
        expect_alike(a[0], b[0], where);
      }
    }
  }
}

TEST(FibredBody, MapsAreThoseOfTheIsotropicBody) {
  const std::string map = spin_text("iii", "0.5") +
                          "[map]\nx = { parameter = \"nu\", from = 0.0, to = 0.6, count = 4 }\n"
                          "y = { parameter = \"gravity.g\", from = 0.1, to = 0.5, count = 3 }\n";
  const auto a = rows_from("map", text(bodies[1], orthotropic, map));
  const auto b = rows_from("map", text(bodies[1], isotropic, map));
  ASSERT_EQ(a.size(), 12u);
  ASSERT_EQ(b.size(), 12u);
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (const char* column : {"xi", "zeta", "rho", "pressure"})
      EXPECT_NEAR(number(a[k].at(column)), number(b[k].at(column)), 1e-13) << k;
    EXPECT_EQ(a[k].at("class"), b[k].at("class")) << k;
  }
}

/// Every number of the body that may vary ends where solving there comes to.
TEST(FibredBody, AnyNumberIsFollowed) {
  const std::string fibre = "fibre = { k = 0.4, degrees = 30.0 }\n";
  for (const char* number_key : {"gravity.g", "body.volume", "body.J.1", "body.J.2",
                                 "potential.fibre.k", "potential.fibre.degrees", "nu"}) {
    const bool angle = std::string(number_key) == "potential.fibre.degrees";
    const double from = angle ? 25.0 : 0.5;
    const double to = angle ? 40.0 : 0.8;
    const std::string range = std::string("[continuation]\nparameter = \"") + number_key +
                              "\"\nfrom = " + std::to_string(from) +
                              "\nto = " + std::to_string(to) + "\n";
    std::string content = text(bodies[1], std::string(isotropic) + fibre, spin_text("iii", "0.5"));
    const TemporaryDirectory directory;
    const std::string start = std::string(number_key) == "nu" ? "motion.nu" : number_key;
    const std::string path = directory.file("case.toml", content + range);
    const Outcome outcome = run_program({"continue", path, "-o", directory / "table.csv", "--set",
                                         start + "=" + std::to_string(from)});
    ASSERT_EQ(outcome.code, 0) << number_key << outcome.err;
    const std::vector<Row> rows = rows_of(text_of(directory / "table.csv"));
    for (const auto& [row, value] : {std::pair{rows.front(), from}, std::pair{rows.back(), to}}) {
      const Outcome single =
          run_program({"solve", path, "-o", "-", "--set", start + "=" + std::to_string(value)});
      ASSERT_EQ(single.code, 0) << number_key << single.err;
      expect_alike(only_row(single.out), row, std::string(number_key) + " ");
    }
  }
}

/// Found by branch and prune, proven, and the class with it.
TEST(FibredBody, AllOfThemAreProven) {
  const std::string fibre = "fibre = { k = 0.4, degrees = 30.0 }\n";
  const std::string all = "[solve]\nall = true\n[output]\ncertificate = true\n";
  const std::pair<std::string, std::size_t> motions[] = {{spin_text("iii", "0.5"), 1},
                                                         {spin_text("oblique", "0.4"), 2}};
  for (const auto& [motion, count] : motions) {
    const auto rows = rows_from("solve", text(held, std::string(isotropic) + fibre, motion + all));
    ASSERT_EQ(rows.size(), count) << motion;
    for (const Row& row : rows) {
      EXPECT_EQ(row.at("certified"), "yes") << motion;
      EXPECT_EQ(row.at("class_certified"), "yes") << motion;
    }
  }
  const auto rows = rows_from(
      "solve", text(bodies[1], std::string(isotropic) + fibre, spin_text("iii", "0.5") + all));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at("certified"), "yes");
  EXPECT_EQ(rows[0].at("class_certified"), "yes");
}

/// With the volume held a thickness may be left out.
TEST(FibredBody, TheThicknessMayBeLeftOut) {
  const TemporaryDirectory directory;
  const std::string plane = std::string(isotropic) + "fibre = { k = 0.4, degrees = 0.0 }\n";
  const auto without = [&](const std::string& body) {
    return run_program(
        {"solve",
         directory.file("case.toml", "[body]\nJ = [1.0, 1.7, 0.6]\n" + body + "[potential]\n" +
                                         plane + spin_text("i", "0.4")),
         "-o", "-"});
  };
  EXPECT_EQ(without(held).code, 0);
  EXPECT_EQ(without("").code, 2);
}

}  // namespace
}  // namespace stationary::testing
