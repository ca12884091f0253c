// solve() against closed forms over their whole range of existence, up to close below its end, and
// what it says just beyond.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/solve/solve.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using Closed = support::ReciprocalDeterminantSolution<Number50>;

struct Case {
  Body body;
  std::array<double, 2> plane;
  std::array<double, 2> thickness;

  Problem problem(Branch branch) const {
    return {body,
            make_potential("reciprocal-determinant", plane, "reciprocal-quadratic", thickness),
            branch};
  }
  /// Inputs times 1 + factor[k].
  Closed closed(const std::array<Number50, 4>& factor = {1, 1, 1, 1}) const {
    return {body,
            {plane[0] * factor[0], plane[1] * factor[1]},
            {thickness[0] * factor[2], thickness[1] * factor[3]}};
  }
};

double error_against(const Equilibrium& answer, const support::SteadyMotion<Number50>& motion) {
  return relative_error(answer.q, {motion.q.xi, motion.q.zeta, motion.q.rho});
}

const Case cases[] = {{{1.0, 1.7, 0.6}, {1.0, 2.0}, {1.0, 3.0}},
                      {{1.7, 1.0, 0.6}, {0.3, 1.1}, {2.0, 0.7}},
                      {{1.0, 1.0, 2.5}, {5.0, 0.2}, {0.4, 0.9}},
                      {{30.0, 0.02, 1.0}, {1.3, 7.0}, {0.01, 40.0}},
                      {{0.01, 0.3, 200.0}, {1e-3, 1e3}, {1e2, 1e-2}}};

void expect_closed_form(const Case& c, Branch branch, double nu) {
  const auto motion = c.closed().on(branch, Number50(nu));
  if (!motion) return;  // nu may have been rounded past the end
  const Equilibrium answer = solve(c.problem(branch), nu);
  ASSERT_EQ(answer.status, SolveStatus::solved) << name(branch) << nu << answer.message;
  EXPECT_EQ(answer.connection, Connection::rest);
  const double error = error_against(answer, *motion);
  EXPECT_LE(error, half_unit) << name(branch) << " " << nu;
  EXPECT_LE(error, answer.error_bound) << name(branch) << " " << nu;
}

TEST(ReciprocalDeterminant, OverTheWholeRange) {
  for (const Case& c : cases)
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const double end = support::nearest(c.closed().limit(branch));
      for (int k = -19; k <= 19; ++k) expect_closed_form(c, branch, end * 0.05 * k);
    }
}

TEST(ReciprocalDeterminant, CloseBelowItsEnd) {
  for (const Case& c : cases)
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const double end = support::nearest(c.closed().limit(branch));
      for (int k = 2; k <= 8; ++k) expect_closed_form(c, branch, end * (1.0 - std::pow(10.0, -k)));
    }
}

TEST(ReciprocalDeterminant, NoneExistsBeyondItsEnd) {
  for (const Case& c : cases)
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const double end = support::nearest(c.closed().limit(branch));
      for (const double gap : {1.0, 1e-3, 1e-8, 1e-13}) {
        const Equilibrium answer = solve(c.problem(branch), end * (1.0 + gap));
        EXPECT_EQ(answer.status, SolveStatus::none_exists) << name(branch) << " " << gap;
        EXPECT_THAT(answer.message, HasSubstr("no solution"));
        EXPECT_TRUE(std::isnan(answer.q.xi) && std::isnan(answer.error_bound));
        EXPECT_EQ(answer.counts.residuals, 0) << "nothing needs to be computed";
      }
    }
}

/// The bound is against the solution for decimal inputs, each within half a unit of its double.
TEST(ReciprocalDeterminant, BoundHoldsForEveryInputWithinHalfAUnit) {
  support::Random random(111);
  double tightest = 1e300;
  for (int k = 0; k < 400; ++k) {
    const Case& c = cases[static_cast<std::size_t>(random.integer(0, 4))];
    const auto branch = static_cast<Branch>(random.integer(0, 2));
    const double end = support::nearest(c.closed().limit(branch));
    const double gap = random.log_uniform(1e-11, 1.0);
    const double nu = end * (1.0 - gap);
    if (!(nu > 0.0)) continue;
    const Equilibrium answer = solve(c.problem(branch), nu);
    if (gap < 1e-8 && answer.status == SolveStatus::not_found) continue;  // stretches too large
    ASSERT_EQ(answer.status, SolveStatus::solved);
    // Half a unit is at least 2^-54 and at most 2^-53 of a number.
    const auto factor = [&](double x) {
      const double unit = std::nextafter(x, 2.0 * x) - x;
      return Number50(1) + Number50(random.sign()) * 0.5 * unit / x;
    };
    const std::array<Number50, 4> factors{factor(c.plane[0]), factor(c.plane[1]),
                                          factor(c.thickness[0]), factor(c.thickness[1])};
    const auto motion = c.closed(factors).on(branch, Number50(nu) * factor(nu));
    ASSERT_TRUE(motion.has_value());
    const double error = error_against(answer, *motion);
    EXPECT_LE(error, answer.error_bound) << name(branch) << " " << nu;
    tightest = std::min(tightest, answer.error_bound / error);
  }
  EXPECT_LT(tightest, 20.0) << "a bound of no use";
}

TEST(Hencky, CloseBelowItsFold) {
  const Body body(1.0, 1.7, 0.6);
  const Problem problem(body, make_potential("hencky", {1.1, 0.8}), Branch::i);
  const support::HenckyFold<Number50> fold(body.J2, Number50(1.1), Number50(0.8));
  const double end = support::nearest(Number50(sqrt(fold.nu_squared)));
  double last = 0.0;
  for (int k = 1; k <= 14; ++k) {
    const double nu = end * (1.0 - std::pow(10.0, -k));
    const Equilibrium answer = solve(problem, nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << k << answer.message;
    EXPECT_EQ(answer.connection, Connection::rest) << k;
    EXPECT_LT(answer.q.zeta, support::nearest(fold.zeta)) << "the part from rest";
    EXPECT_GT(answer.q.zeta, last);
    last = answer.q.zeta;
    const double error = relative_error(answer.q, reference_solution(problem, nu, answer.q));
    EXPECT_LE(error, half_unit) << k;
    EXPECT_LE(error, answer.error_bound) << k;
    EXPECT_LE(answer.error_bound, 1e-14 * std::pow(10.0, 0.5 * k)) << k;
  }
}

/// The same with the inputs half a unit off: near the fold the answer moves as a square root.
TEST(Hencky, BoundHoldsForANuWithinHalfAUnit) {
  const Body body(1.0, 1.7, 0.6);
  const Problem problem(body, make_potential("hencky", {1.1, 0.8}), Branch::i);
  const support::HenckyFold<double> fold(body.J2, 1.1, 0.8);
  for (int k = 1; k <= 14; ++k) {
    const double nu = std::sqrt(fold.nu_squared) * (1.0 - std::pow(10.0, -k));
    const Equilibrium answer = solve(problem, nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << k;
    for (const double next : {std::nextafter(nu, 0.0), std::nextafter(nu, 1.0)}) {
      // The neighbouring double is a whole unit away; the answer at half of it is nearer.
      const auto here = reference_solution(problem, nu, answer.q);
      const auto there = reference_solution(problem, next, answer.q);
      for (std::size_t i = 0; i < 2; ++i) {
        const double half_move = abs((there[i] - here[i]) / here[i]).convert_to<double>() / 2;
        EXPECT_LE(half_move, answer.error_bound) << k;
      }
    }
  }
}

TEST(Hencky, BeyondItsFoldNoneExists) {
  const Problem problem(Body(1.0, 1.7, 0.6), make_potential("hencky", {1.1, 0.8}), Branch::i);
  const double end = std::sqrt(support::HenckyFold<double>(1.7, 1.1, 0.8).nu_squared);
  for (int k = 1; k <= 13; ++k) {
    const Equilibrium answer = solve(problem, end * (1.0 + std::pow(10.0, -k)));
    EXPECT_EQ(answer.status, SolveStatus::none_exists) << k;
    EXPECT_THAT(answer.message, HasSubstr("fold"));
  }
}

/// harmonic: rho = k rest/(k - J3 nu^2).
TEST(Harmonic, OverTheWholeRange) {
  const Body body(1.0, 1.7, 0.6);
  const Problem problem(body, make_potential("biot-log", {40.0, 25.0}, "harmonic", {2.0, 0.8}),
                        Branch::i);
  const double end = std::sqrt(2.0 / 0.6);
  for (const double gap : {1.0, 0.7, 0.3, 0.1, 1e-2, 1e-4, 1e-8}) {
    const double nu = end * (1.0 - gap);
    const Equilibrium answer = solve(problem, nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << gap;
    const Number50 left = Number50(2.0) - Number50(0.6) * Number50(nu) * Number50(nu);
    const Number50 exact = Number50(2.0) * Number50(0.8) / left;
    EXPECT_LE(abs((answer.q.rho - exact) / exact), half_unit) << gap;
  }
  EXPECT_EQ(solve(problem, end * (1.0 + 1e-13)).status, SolveStatus::none_exists);
}

}  // namespace
}  // namespace stationary
