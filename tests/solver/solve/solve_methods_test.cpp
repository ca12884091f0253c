// Each method is a path of its own: where one fails another leads on, and the answer says which way
// it came and what is known of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/newton/newton.hpp"
#include "solver/solve/solve.hpp"
#include "tests/support/bodies/random_problem.hpp"

namespace stationary {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::Not;

Equilibrium solve_by(Method method, const Problem& problem, double nu,
                     std::optional<Stretch> start = std::nullopt) {
  SolveOptions options;
  options.method = method;
  options.start = start;
  return solve(problem, nu, options);
}

double distance(const Stretch& a, const Stretch& b) {
  return std::max({std::abs(std::log(a.xi / b.xi)), std::abs(std::log(a.zeta / b.zeta)),
                   std::abs(std::log(a.rho / b.rho))});
}

/// The rest sheet followed naively: many small equal steps in nu^2, plain Newton from the last
/// point. Nothing where a step is no small one.
std::optional<Stretch> followed(const Problem& problem, double nu) {
  const auto march = [&]<class System>(const System& system, auto x) -> std::optional<decltype(x)> {
    constexpr int count = 1500;
    for (int k = 1; k <= count; ++k) {
      const auto last = x;
      if (!newton(system.at_fraction(static_cast<double>(k) / count), x).converged)
        return std::nullopt;
      if ((x.array() / last.array()).log().abs().maxCoeff() > 0.03) return std::nullopt;
    }
    return x;
  };
  const auto rates = problem.rates(two_product(nu, nu));
  return problem.potential().visit_parts([&](const auto& model) -> std::optional<Stretch> {
    if constexpr (requires { model.plane; }) {
      using Plane = std::decay_t<decltype(model.plane)>;
      const double r = model.plane.rest_stretch();
      const auto x = march(PlanarSystem<Plane>{model.plane, rates}, ReducedVector<2>(r, r));
      if (!x) return std::nullopt;
      return Stretch{0.0, (*x)[0], (*x)[1], model.thickness.balanced(rates.rho)};
    } else {
      const auto x = march(CoupledSystem<std::decay_t<decltype(model)>>{model, rates},
                           ReducedVector<3>(diagonal(rest_stretch_of(model))));
      if (!x) return std::nullopt;
      return Stretch{0.0, (*x)[0], (*x)[1], (*x)[2]};
    }
  });
}

TEST(Automatic, RestMeansTheSheetThatSmallStepsFollow) {
  support::Random random(131);
  int followed_to_the_end = 0;
  for (int k = 0; k < 150; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Equilibrium answer = solve(posed.problem, posed.nu);
    if (answer.connection != Connection::rest) continue;
    const auto expected = followed(posed.problem, posed.nu);
    if (!expected) continue;
    ++followed_to_the_end;
    EXPECT_LE(distance(answer.q, *expected), 1e-6) << posed.text;
  }
  EXPECT_GT(followed_to_the_end, 80);
}

/// Found by a search of random cases, coefficients then rounded: Newton and Ceres both stop from
/// the rest state, the walk arrives.
struct HardCase {
  std::string_view model;
  std::array<double, 2> coefficients;
  Body body;
  Branch branch;
  double nu;

  Problem problem() const {
    return {body, make_potential(model, coefficients, "reciprocal-quadratic", {1.0, 300.0}),
            branch};
  }
};

TEST(Automatic, SolvesWhereNewtonAndCeresFromRestDoNot) {
  const HardCase cases[] = {
      {"biot-log", {0.89, 0.44}, {1.076, 0.575, 0.577}, Branch::ii, 1.263},
      {"saint-venant-kirchhoff", {1.817, 0.888}, {0.406, 1.844, 0.45}, Branch::iii, 1.234},
      {"biot", {0.806, 0.415}, {1.435, 1.435, 0.4545}, Branch::ii, 0.9844}};
  for (const HardCase& c : cases) {
    const Problem problem = c.problem();
    const Equilibrium by_newton = solve_by(Method::newton, problem, c.nu);
    EXPECT_EQ(by_newton.status, SolveStatus::failed) << c.model;
    EXPECT_THAT(by_newton.message, HasSubstr("auto"));
    EXPECT_TRUE(std::isnan(by_newton.q.xi) && std::isnan(by_newton.error_bound));
    const Equilibrium by_ceres = solve_by(Method::ceres, problem, c.nu);
    EXPECT_EQ(by_ceres.status, SolveStatus::failed) << c.model;
    EXPECT_THAT(by_ceres.message, HasSubstr("auto"));
    EXPECT_THAT(by_ceres.message,
                HasSubstr("after " + std::to_string(by_ceres.counts.ceres_iterations) +
                          " iterations where the balance does not hold"));
    const Equilibrium answer = solve(problem, c.nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << c.model;
    EXPECT_EQ(answer.connection, Connection::rest);
    const auto expected = followed(problem, c.nu);
    ASSERT_TRUE(expected.has_value()) << c.model;
    EXPECT_LE(distance(answer.q, *expected), 1e-6);
  }
}

TEST(Automatic, GivesTheRestSheetWhereNewtonAndCeresLandOnAnother) {
  const HardCase cases[] = {
      {"neo-hookean", {1.137, -0.379}, {2.3, 1.148, 0.377}, Branch::ii, -0.629},
      {"neo-hookean-3d", {1.84, -1.09}, {2.894, 1.25, 1.449}, Branch::i, 0.635}};
  for (const HardCase& c : cases) {
    const Problem problem = c.problem();
    const Equilibrium answer = solve(problem, c.nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << c.model;
    EXPECT_EQ(answer.connection, Connection::rest);
    const auto expected = followed(problem, c.nu);
    ASSERT_TRUE(expected.has_value()) << c.model;
    EXPECT_LE(distance(answer.q, *expected), 1e-6);
    for (const Method method : {Method::newton, Method::ceres}) {
      const Equilibrium other = solve_by(method, problem, c.nu);
      ASSERT_EQ(other.status, SolveStatus::solved) << c.model;
      EXPECT_GT(distance(answer.q, other.q), 0.1) << c.model;
      EXPECT_EQ(other.connection, Connection::unknown) << "no walk was made";
    }
  }
}

/// The disconnected pair of biot-log in (iii) at nu = 1.4.
Problem disconnected_pair() {
  return {Body(1.0, 1.7, 0.6), make_potential("biot-log", {1.0, 0.6}), Branch::iii};
}

TEST(Automatic, FindsADisconnectedSolutionAndSaysSo) {
  const Equilibrium answer = solve(disconnected_pair(), 1.4);
  ASSERT_EQ(answer.status, SolveStatus::solved) << answer.message;
  EXPECT_EQ(answer.connection, Connection::unknown);
  EXPECT_THAT(answer.message, HasSubstr("sheet of the rest state does not reach |nu| = 1.4"));
  EXPECT_THAT(answer.message, HasSubstr("proven to be all"));
  EXPECT_THAT(answer.message, HasSubstr("connected to the rest state is not known"));
  EXPECT_EQ(answer.counts.nlopt_evaluations, 0);
  EXPECT_GT(answer.counts.walk_steps, 0);
  EXPECT_NEAR(answer.q.xi, 48.91, 0.01);
  EXPECT_NEAR(answer.q.zeta, 0.722, 0.001);
  const Equilibrium searched = solve_by(Method::nlopt, disconnected_pair(), 1.4);
  EXPECT_EQ(searched.q.vector(), answer.q.vector());
  EXPECT_EQ(searched.counts.walk_steps, 0);
}

TEST(GivenStart, TheSolutionNearItIsReturned) {
  const Stretch pair[] = {{0.0, 48.91, 0.722, 0.69}, {0.0, 49.98, 0.0215, 0.69}};
  for (const Stretch& start : pair) {
    for (const Method method : {Method::automatic, Method::ceres, Method::newton}) {
      const Equilibrium answer = solve_by(method, disconnected_pair(), 1.4, start);
      ASSERT_EQ(answer.status, SolveStatus::solved) << answer.message;
      EXPECT_EQ(answer.connection, Connection::given_start);
      EXPECT_NEAR(answer.q.xi, start.xi, 0.01);
      EXPECT_NEAR(answer.q.zeta, start.zeta, 0.001);
      EXPECT_THAT(answer.message, HasSubstr("given start"));
      EXPECT_EQ(answer.counts.walk_steps, 0);
      EXPECT_EQ(answer.counts.nlopt_evaluations, 0);
    }
  }
}

TEST(GivenStart, UselessOneLeadsToTheSearch) {
  const Equilibrium answer =
      solve_by(Method::automatic, disconnected_pair(), 1.4, Stretch{0.0, 1e-3, 1e3, 1.0});
  if (answer.connection == Connection::given_start) GTEST_FAIL() << "pick a worse start";
  ASSERT_EQ(answer.status, SolveStatus::solved);
  EXPECT_EQ(answer.connection, Connection::unknown);
  EXPECT_THAT(answer.message, HasSubstr("No solution was reached from the given start"));
}

TEST(Automatic, NothingFoundIsNoProof) {
  const Equilibrium answer = solve(disconnected_pair(), 1.3);  // before the pair's fold at 1.3455
  EXPECT_EQ(answer.status, SolveStatus::not_found);
  EXPECT_THAT(answer.message, HasSubstr("proven that there is none"));
  EXPECT_THAT(answer.message, HasSubstr("no proof that none exists"));
  EXPECT_EQ(answer.counts.nlopt_evaluations, 0);
  EXPECT_TRUE(std::isnan(answer.q.xi) && std::isnan(answer.q.rho) && std::isnan(answer.residual));
}

/// (iii) of a nearly round plate, two sheets that almost touch at nu = 0.21.
Problem nearly_degenerate() {
  return {Body(1.046, 0.972, 0.234),
          make_potential("neo-hookean", {0.0525, 2.3792}, "reciprocal-quadratic", {0.591, 1.917}),
          Branch::iii};
}

TEST(Automatic, NearlyDegenerateSheetsAreKeptApart) {
  double last = 1.0;
  for (int k = 1; k <= 22403; k += 97) {
    const double nu = 1e-5 * k;
    const Equilibrium answer = solve(nearly_degenerate(), nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << nu;
    EXPECT_EQ(answer.connection, Connection::rest) << nu;
    EXPECT_GT(answer.q.xi, answer.q.zeta) << nu;
    EXPECT_GT(answer.q.xi, last) << nu;
    EXPECT_LT(answer.q.xi, 1.5 * last) << "continuous along nu; " << nu;
    last = answer.q.xi;
  }
  for (const double nu : {0.2, 0.22, 0.224, 0.22403}) {
    const Equilibrium answer = solve(nearly_degenerate(), nu);
    EXPECT_EQ(answer.connection, Connection::rest) << nu;
    EXPECT_GT(answer.q.xi, answer.q.zeta) << nu;
  }
}

TEST(Automatic, BeyondTheRestSheetTheOtherIsNotCalledConnected) {
  // Between J1 nu^2 = mu and J2 nu^2 = mu nothing exists at all.
  for (const double nu : {0.22404, 0.225, 0.2323})
    EXPECT_EQ(solve(nearly_degenerate(), nu).status, SolveStatus::none_exists) << nu;
  // Up to the other sheet's fold at 0.94931.
  for (const double nu : {0.25, 0.3, 0.35, 0.6, 0.9, 0.949}) {
    const Equilibrium answer = solve(nearly_degenerate(), nu);
    ASSERT_EQ(answer.status, SolveStatus::solved) << nu;
    EXPECT_EQ(answer.connection, Connection::unknown) << nu;
    EXPECT_THAT(answer.message, HasSubstr("it goes up to 0.224034 and on to unbounded")) << nu;
    EXPECT_LT(answer.q.xi, answer.q.zeta) << nu;
  }
  const Equilibrium beyond = solve(nearly_degenerate(), 0.95);
  EXPECT_EQ(beyond.status, SolveStatus::not_found);
  EXPECT_THAT(beyond.message, HasSubstr("it goes up to 0.224034"));
}

TEST(Methods, CountWhatTheyDid) {
  const Problem problem(Body(1.0, 1.7, 0.6), make_potential("biot-log", {1.0, 0.6}), Branch::iii);
  const Counts newton = solve_by(Method::newton, problem, 0.3).counts;
  EXPECT_GT(newton.newton_steps, 1);
  EXPECT_GT(newton.residuals, 1);
  EXPECT_GT(newton.extended_residuals, 0);
  EXPECT_EQ(newton.ceres_iterations + newton.nlopt_evaluations + newton.walk_steps, 0);
  const Counts ceres = solve_by(Method::ceres, problem, 0.3).counts;
  EXPECT_GT(ceres.ceres_iterations, 1);
  EXPECT_GT(ceres.jacobians, 1);
  EXPECT_GT(ceres.extended_residuals, 0);
  EXPECT_EQ(ceres.nlopt_evaluations + ceres.walk_steps, 0);
  const Counts automatic = solve(problem, 0.3).counts;
  EXPECT_GT(automatic.walk_steps, 0);
  EXPECT_GT(automatic.ceres_iterations, 0);
  EXPECT_EQ(automatic.nlopt_evaluations, 0);
  const Counts nlopt = solve_by(Method::nlopt, problem, 0.3).counts;
  EXPECT_GT(nlopt.nlopt_evaluations, 100);
  EXPECT_EQ(nlopt.ceres_iterations + nlopt.walk_steps, 0);
}

/// The message and the counts tell the same walk; its linearizations are among the Jacobians.
TEST(Methods, TellTheStepsOfTheWalk) {
  const Problem problem(Body(1.0, 1.7, 0.6), make_potential("neo-hookean", {1.0, 2.0}), Branch::i);
  const Equilibrium slow = solve(problem, 0.05);
  EXPECT_EQ(slow.counts.walk_steps, 1);
  EXPECT_THAT(slow.message, HasSubstr("walk from the rest state in 1 step, then"));
  const Equilibrium fast = solve(problem, 0.75);
  EXPECT_GT(fast.counts.walk_steps, 1);
  EXPECT_THAT(fast.message, HasSubstr("walk from the rest state in " +
                                      std::to_string(fast.counts.walk_steps) + " steps, then"));
  const Counts ceres = solve_by(Method::ceres, problem, 0.05).counts;
  EXPECT_GT(slow.counts.jacobians, slow.counts.ceres_iterations + slow.counts.walk_steps);
  EXPECT_EQ(ceres.walk_steps, 0);
}

/// Where the solution is unique, four ways lead to the same doubles.
TEST(Methods, AgreeToTheLastBit) {
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const Problem problem(Body(1.0, 1.7, 0.6), make_potential("reciprocal-determinant", {1.0, 2.0}),
                          branch);
    const Equilibrium expected = solve(problem, 0.7);
    ASSERT_EQ(expected.status, SolveStatus::solved);
    for (const Method method : {Method::newton, Method::ceres, Method::nlopt}) {
      const Equilibrium answer = solve_by(method, problem, 0.7);
      ASSERT_EQ(answer.status, SolveStatus::solved) << name(method);
      EXPECT_EQ(answer.q.vector(), expected.q.vector()) << name(method);
      EXPECT_EQ(answer.connection, Connection::unknown);
    }
  }
}

}  // namespace
}  // namespace stationary
