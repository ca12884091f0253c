// solve() against independently computed digits, and against 50-digit solutions of random families.
#include <gtest/gtest.h>

#include "solver/solve/solve.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using namespace testing;

class SolveTableTest : public ::testing::TestWithParam<const char*> {};

TEST_P(SolveTableTest, EveryRowFromItsInputsAlone) {
  const auto rows = support::reference_table(GetParam());
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) {
    const Problem problem(row.body(), row.potential(), row.branch());
    const Equilibrium answer = solve(problem, row.number<double>("nu"));
    ASSERT_EQ(answer.status, SolveStatus::solved) << row.where() << " " << answer.message;
    EXPECT_EQ(answer.connection, Connection::rest) << row.where();
    EXPECT_EQ(answer.q.alpha, 0.0);
    const auto q = row.stretch<support::Real50>();
    const double error = relative_error(answer.q, {q.xi, q.zeta, q.rho});
    EXPECT_LE(error, half_unit) << row.where();
    EXPECT_LE(error, answer.error_bound) << row.where();
    EXPECT_LE(answer.error_bound, 1e-13) << row.where();
    EXPECT_LE(answer.residual, 1e-15) << row.where();
    EXPECT_EQ(answer.compatibility, 0.0) << row.where();
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, SolveTableTest,
                         ::testing::Values("equilibria.csv", "equilibria_extreme.csv"),
                         [](const auto& info) {
                           const std::string name = info.param;
                           return name.substr(0, name.find('.'));
                         });

/// Everything a solved answer promises.
void expect_promises_kept(const Posed& posed, const Equilibrium& answer) {
  ASSERT_TRUE(std::isfinite(answer.q.xi) && std::isfinite(answer.q.zeta) &&
              std::isfinite(answer.q.rho) && std::isfinite(answer.error_bound) &&
              std::isfinite(answer.residual) && std::isfinite(answer.compatibility))
      << posed.text;
  EXPECT_EQ(violated_inequality(answer.q), nullptr) << posed.text;
  EXPECT_FALSE(answer.message.empty());
  EXPECT_EQ(answer.nu, angular_velocity(posed.problem.branch(), posed.nu));
  std::array<Number50, 3> exact;
  ASSERT_NO_THROW(exact = reference_solution(posed.problem, posed.nu, answer.q)) << posed.text;
  const double error = relative_error(answer.q, exact);
  EXPECT_LE(error, half_unit) << posed.text;
  EXPECT_LE(error, answer.error_bound) << posed.text;
  if (!answer.unrounded) return;
  const auto& [alpha, xi, zeta, rho] = *answer.unrounded;
  EXPECT_EQ(double(alpha), 0.0);
  EXPECT_EQ(xi.hi, answer.q.xi);
  EXPECT_EQ(zeta.hi, answer.q.zeta);
  EXPECT_EQ(rho.hi, answer.q.rho);
  for (const auto& [x, exactly] : {std::pair{xi, exact[0]}, {zeta, exact[1]}, {rho, exact[2]}}) {
    const Number50 unrounded = Number50(x.hi) + x.lo;
    EXPECT_LE(abs(unrounded / exactly - 1), 0x1p-80) << posed.text;
  }
}

/// What any other answer must not pretend.
void expect_nothing_claimed(const Posed& posed, const Equilibrium& answer) {
  EXPECT_TRUE(answer.status == SolveStatus::none_exists || answer.status == SolveStatus::not_found)
      << posed.text << ": " << answer.message;
  EXPECT_TRUE(std::isnan(answer.q.xi) && std::isnan(answer.q.zeta)) << posed.text;
  EXPECT_TRUE(std::isnan(answer.residual)) << posed.text;
  EXPECT_EQ(answer.connection, Connection::unknown);
  EXPECT_FALSE(answer.message.empty());
}

class RandomFamiliesTest : public ::testing::TestWithParam<double> {};

TEST_P(RandomFamiliesTest, RoundCorrectlyWithinTheirBound) {
  support::Random random(101);
  int solved = 0;
  int unrounded = 0;
  for (int k = 0; k < 1000; ++k) {
    const Posed posed = random_problem(random, GetParam());
    const Equilibrium answer = solve(posed.problem, posed.nu);
    if (answer.status == SolveStatus::solved) {
      ++solved;
      unrounded += answer.unrounded.has_value();
      expect_promises_kept(posed, answer);
    } else {
      expect_nothing_claimed(posed, answer);
    }
  }
  EXPECT_GT(solved, 600);
  EXPECT_GT(unrounded, solved / 2);
}

INSTANTIATE_TEST_SUITE_P(Orders, RandomFamiliesTest, ::testing::Values(1.0, 6.0),
                         [](const auto& info) {
                           return "Over" + std::to_string(static_cast<int>(info.param));
                         });

/// Slow: the error bound must not depend on a large correction having been made.
TEST(RandomFamilies, SlowRotationsAreTheRestStateNearly) {
  support::Random random(102);
  for (int k = 0; k < 200; ++k) {
    Posed posed = random_problem(random, 2.0);
    posed.nu *= 1e-9;
    const Equilibrium answer = solve(posed.problem, posed.nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << posed.text;
    EXPECT_EQ(answer.connection, Connection::rest);
    expect_promises_kept(posed, answer);
  }
}

}  // namespace
}  // namespace stationary
