// Two-polar motions of bodies with gravity, followed in the moment of inertia J3, from outside:
// against their closed form,
//
//   omega^2 + theta_dot^2 = mu/J - 2 g F_T,
//   2 omega theta_dot = -(mu/J) rho^2/d - 2 g J d F_D + 2 g (J3/J) (rho^2/d) F_z,
//
// of an isochoric neo-Hookean body, J = J1 = J2, F = R_F by Boost.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <string>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

constexpr double round_J = 1.25;
constexpr double g = 4.0;

struct Rates {
  double sum;      ///< omega^2 + theta_dot^2
  double product;  ///< 2 omega theta_dot
};

/// y1 F_T etc. from R_D: F_1 = F_T + y2 F_D, F_2 = F_T + y1 F_D for y1 != y2.
Rates closed_form(double mu, double lambda, double other, double rho, double J3) {
  const double y1 = round_J * lambda * lambda;
  const double y2 = round_J * other * other;
  const double z = J3 * rho * rho;
  const double F_1 = -boost::math::ellint_rd(y2, z, y1) / 6.0;
  const double F_2 = -boost::math::ellint_rd(y1, z, y2) / 6.0;
  const double F_z = -boost::math::ellint_rd(y1, y2, z) / 6.0;
  const double F_D = (F_1 - F_2) / (y2 - y1);
  const double F_T = F_1 - y2 * F_D;
  const double d = lambda * other;
  const double thick = rho * rho / d;
  return {mu / round_J - 2.0 * g * F_T, -mu / round_J * thick - 2.0 * g * round_J * d * F_D +
                                            2.0 * g * (J3 / round_J) * thick * F_z};
}

std::string body(const std::string& mu) {
  return "[body]\nJ = [1.25, 1.25, 1.0]\nvolume = 0.9\n[gravity]\ng = 4\n[potential]\ncoupled = { "
         "expression = \"p/2*(I1 + rho^2 - 3)\", p = " +
         mu + " }\n";
}

/// Follows the motions in J3 from J3 = 1 on; the row nearest to there.
Row followed_in_J3(const std::string& mu, const std::string& motion) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml", body(mu) + "[motion]\nbranch = \"two-polar\"\n" + motion +
                       "[continuation]\nparameter = \"body.J.2\"\nfrom = 0.4\nto = 1.6\n");
  const Outcome outcome = run_program({"continue", path, "-o", directory / "table.csv"});
  EXPECT_EQ(outcome.code, 0) << mu << motion << outcome.err;
  if (outcome.code != 0) return {};
  const auto rows = rows_of(text_of(directory / "table.csv"));
  int compared = 0;
  const Row* nearest = &rows.front();
  for (const Row& row : rows) {
    const double lambda = number(row.at("lambda"));
    const double other = number(row.at("mu"));
    const double J3 = number(row.at("body.J.2"));
    if (lambda < 1.001 * other) continue;  // R_D of nearly equal axes cancels
    const Rates expected = closed_form(std::stod(mu), lambda, other, number(row.at("rho")), J3);
    const double omega = number(row.at("omega"));
    const double own = number(row.at("theta_dot"));
    EXPECT_NEAR(omega * omega + own * own, expected.sum, 1e-11) << mu << motion;
    EXPECT_NEAR(2.0 * omega * own, expected.product, 1e-11) << mu << motion;
    EXPECT_NEAR(lambda * other * number(row.at("rho")), 0.9, 1e-14);
    if (std::abs(J3 - 1.0) < std::abs(number(nearest->at("body.J.2")) - 1.0)) nearest = &row;
    ++compared;
  }
  EXPECT_GE(compared, 20) << mu << motion;
  // Another row is what solve finds there.
  const Row& row = rows[rows.size() / 3];
  const std::string start =
      "solve.start=[0.0," + row.at("xi") + ',' + row.at("zeta") + ',' + row.at("rho") + ']';
  const Outcome again = run_program(
      {"solve", path, "-o", "-", "--set", "body.J.2=" + row.at("body.J.2"), "--set", start});
  EXPECT_EQ(again.code, 0) << again.err;
  if (again.code == 0) {
    const Row solved = only_row(again.out);
    for (const std::string column : {"lambda", "mu", "rho", "energy", "pressure"})
      EXPECT_NEAR(number(solved.at(column)) / number(row.at(column)), 1.0, 1e-12)
          << mu << motion << column;
    EXPECT_EQ(solved.at("class"), row.at("class")) << mu << motion;
  }
  return *nearest;
}

TEST(RiemannFigure, FollowsInertiasAtMomentaAndAtRates) {
  for (const std::string mu : {"0.0", "0.05", "1.0"}) {
    const Row at = followed_in_J3(mu, "s3 = 2.9\np_theta = 2.5\n");
    ASSERT_FALSE(at.empty());
    (void)followed_in_J3(mu, "omega = " + at.at("omega") + "\ntheta_dot = " + at.at("theta_dot") +
                                 "\n[solve]\nstart = [0.0, " + at.at("xi") + ", " + at.at("zeta") +
                                 ", " + at.at("rho") + "]\n");
  }
}

}  // namespace
}  // namespace stationary::testing
