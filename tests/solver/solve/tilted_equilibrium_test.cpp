// Tilted motions one at a time: against 25 digits, from rest, and where there is none.
#include "solver/solve/tilted_equilibrium.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using support::ReferenceRow;

TEST(TiltedTable, EveryRowFromANearStart) {
  int rows = 0;
  for (const ReferenceRow& row : support::reference_table("tilted.csv")) {
    ++rows;
    const Stretch q = row.stretch<double>();
    const Vector3<double> nu = row.nu<double>();
    const TiltedRotation motion{TiltPlane::one_three, std::hypot(nu[0], nu[2])};
    const Stretch start{0.0, 1.03 * q.xi, 0.98 * q.zeta, 1.1 * q.rho};
    const Equilibrium found = solve_tilted(row.body(), row.potential(), motion, {.start = start});
    ASSERT_EQ(found.status, SolveStatus::solved) << row.where() << found.message;
    EXPECT_EQ(found.connection, Connection::given_start);
    // |nu| and J to their doubles cost an ulp, which the family's own conditioning magnifies.
    constexpr double tolerance = 1e-13;
    EXPECT_NEAR(found.q.xi, q.xi, tolerance) << row.where();
    EXPECT_NEAR(found.q.zeta, q.zeta, tolerance) << row.where();
    EXPECT_NEAR(found.q.rho, q.rho, tolerance) << row.where();
    EXPECT_NEAR(found.nu[0], nu[0], tolerance) << row.where();
    EXPECT_EQ(found.nu[1], 0.0);
    EXPECT_NEAR(found.nu[2], nu[2], tolerance) << row.where();
    EXPECT_LE(found.residual, 1e-15) << row.where();
    EXPECT_LE(found.compatibility, 1e-15) << row.where();
    EXPECT_LE(found.error_bound, tolerance) << row.where();
    const auto spectrum = tilted_stability(row.body(), row.potential(), motion, found);
    ASSERT_TRUE(spectrum);
    ASSERT_EQ(spectrum->modes, 5);
    for (std::size_t k = 0; k < 5; ++k) {
      const std::string at = std::to_string(k + 1);
      EXPECT_NEAR(spectrum->mode[k].re, row.number<double>("re" + at), 1e-10) << row.where() << at;
      EXPECT_NEAR(spectrum->mode[k].im, row.number<double>("im" + at), 1e-10) << row.where() << at;
    }
  }
  EXPECT_EQ(rows, 5);
}

class FromRest : public ::testing::Test {
 protected:
  FromRest() {
    const double plane[] = {1.0, 2.0};
    const double axial[] = {1.0, 3.0};
    potential.emplace(Potential::planar("reciprocal-determinant", plane),
                      Potential::thickness("reciprocal-quadratic", axial));
  }
  const Body body{1.0, 1.7, 0.6};
  std::optional<Potential> potential;
};

TEST_F(FromRest, WalksToTheTiltAndAlongTheFamily) {
  const TiltedRotation motion{TiltPlane::one_three, 1.07};
  const Equilibrium found = solve_tilted(body, *potential, motion);
  ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
  EXPECT_EQ(found.connection, Connection::rest);
  EXPECT_NEAR(found.q.xi, 0.57054735, 5e-9);
  EXPECT_NEAR(found.q.zeta, 3.1963837, 5e-8);
  EXPECT_NEAR(found.q.rho, 0.73657346, 5e-9);
  EXPECT_NEAR(std::atan2(found.nu[2], found.nu[0]), 0.5526723959, 5e-11);
  const auto spectrum = tilted_stability(body, *potential, motion, found);
  ASSERT_TRUE(spectrum);
  EXPECT_EQ(spectrum->verdict, StabilityClass::unstable);
  const double frequencies[] = {0.0, 1.4593532, 2.1498288, 2.5872379, 3.5557546};
  EXPECT_NEAR(spectrum->mode[0].re, 0.20382668, 5e-9);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(spectrum->mode[k].im, frequencies[k], 6e-8) << k;
}

TEST_F(FromRest, BeyondTheFamilysEndsNothingIsFound) {
  for (const double nu : {0.3, 1.2}) {
    const Equilibrium found = solve_tilted(body, *potential, {TiltPlane::one_three, nu});
    EXPECT_EQ(found.status, SolveStatus::not_found) << nu;
    EXPECT_NE(found.message.find("tilt"), std::string::npos) << found.message;
  }
}

/// The balance without the tilt goes on beyond the end: with a negative square.
TEST_F(FromRest, ASquareBelowZeroIsNoMotion) {
  const Equilibrium found = solve_tilted(body, *potential, {TiltPlane::one_three, 0.9},
                                         {.start = Stretch{0.0, 0.7, 1.5, 0.8}});
  EXPECT_EQ(found.status, SolveStatus::not_found);
  EXPECT_NE(found.message.find("< 0"), std::string::npos) << found.message;
}

TEST_F(FromRest, RefusesWhatIsNoMotion) {
  for (const double nu : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(solve_tilted(body, *potential, {TiltPlane::one_three, nu}), std::invalid_argument);
  EXPECT_THROW(solve_tilted(body, *potential, {TiltPlane::one_three, 1.0},
                            {.start = Stretch{0.1, 1.0, 1.0, 1.0}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace stationary
