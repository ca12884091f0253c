// Laws of solve() that hold whatever the model: symmetries, rest, misuse, interruption, poison.
#include "solver/solve/solve.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "solver/newton/reduced_system.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace testing;

void expect_same_q(const std::string& x, const Stretch& expected, const Stretch& actual,
                   double units) {
  const auto close = [&](double a, double b) {
    EXPECT_TRUE(support::agrees<double>(x, a, b, units * 0x1p-52 * std::abs(a)));
  };
  close(expected.xi, actual.xi);
  close(expected.zeta, actual.zeta);
  close(expected.rho, actual.rho);
}

/// f(posed, answer) for random cases; returns how many were solved.
template <class F>
int for_random_answers(std::uint64_t seed, int cases, F&& f) {
  support::Random random(seed);
  int solved = 0;
  for (int k = 0; k < cases; ++k) {
    const Posed posed = random_problem(random, k % 2 == 0 ? 1.0 : 4.0);
    const Equilibrium answer = solve(posed.problem, posed.nu);
    solved += answer.status == SolveStatus::solved ? 1 : 0;
    f(posed, answer);
  }
  return solved;
}

TEST(Solve, SenseOfRotationDoesNotMatter) {
  const int solved = for_random_answers(121, 200, [](const Posed& posed, const Equilibrium& a) {
    const Equilibrium b = solve(posed.problem, -posed.nu);
    ASSERT_EQ(a.status, b.status) << posed.text;
    EXPECT_EQ(a.connection, b.connection);
    EXPECT_EQ(b.nu, -a.nu);
    if (a.status != SolveStatus::solved) return;
    EXPECT_EQ(a.q.vector(), b.q.vector()) << posed.text;
    EXPECT_EQ(a.error_bound, b.error_bound);
  });
  EXPECT_GT(solved, 100);
}

TEST(Solve, TheSameEveryTime) {
  for_random_answers(122, 100, [](const Posed& posed, const Equilibrium& a) {
    const Equilibrium b = solve(posed.problem, posed.nu);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.message, b.message);
    if (a.status == SolveStatus::solved) {
      EXPECT_EQ(a.q.vector(), b.q.vector());
    }
  });
}

/// The same model with V times s; a power of two is exact.
Potential scaled(const Potential& potential, double s) {
  const auto times = [s](const auto& model, bool second) {
    auto c = model.coefficients();
    c[0] *= s;
    if (second) c[1] *= s;
    return c;
  };
  if (!potential.is_separable()) {
    return std::visit(
        [&](const auto& m) { return Potential(Potential::coupled(m.name, times(m, true))); },
        potential.coupled());
  }
  return {std::visit([&](const auto& m) { return Potential::planar(m.name, times(m, true)); },
                     potential.plane()),
          std::visit(
              [&](const auto& m) {
                // harmonic's second coefficient is a length.
                return Potential::thickness(m.name, times(m, m.name != Harmonic<>::name));
              },
              potential.thickness())};
}

TEST(Solve, UnitsOfMassDoNotMatter) {
  const int solved = for_random_answers(123, 200, [](const Posed& posed, const Equilibrium& a) {
    for (const double s : {0.125, 64.0, 3.0}) {
      const Body& J = posed.problem.body();
      const Problem heavier(Body(s * J.J1, s * J.J2, s * J.J3),
                            scaled(posed.problem.potential(), s), posed.problem.branch());
      const Equilibrium b = solve(heavier, posed.nu);
      if (s == 3.0 && a.error_bound > 1e-14) continue;  // inputs are rounded: not the same problem
      ASSERT_EQ(a.status, b.status) << posed.text << " times " << s;
      if (a.status != SolveStatus::solved) continue;
      const double units = s == 3.0 ? 2.0 * a.error_bound / 0x1p-52 : 0.0;
      expect_same_q(posed.text, a.q, b.q, units);
    }
  });
  EXPECT_GT(solved, 100);
}

TEST(Solve, ExchangeOfTheAxesInThePlane) {
  const int solved = for_random_answers(124, 200, [](const Posed& posed, const Equilibrium& a) {
    const Body& J = posed.problem.body();
    const Branch branch = posed.problem.branch();
    const Branch exchanged = branch == Branch::i    ? Branch::ii
                             : branch == Branch::ii ? Branch::i
                                                    : Branch::iii;
    const Problem other(Body(J.J2, J.J1, J.J3), posed.problem.potential(), exchanged);
    const Equilibrium b = solve(other, posed.nu);
    ASSERT_EQ(a.status, b.status) << posed.text;
    EXPECT_EQ(a.connection, b.connection);
    if (a.connection != Connection::rest) return;  // a search's choice has no such symmetry
    expect_same_q(posed.text, a.q, {0.0, b.q.zeta, b.q.xi, b.q.rho}, 1.0);
  });
  EXPECT_GT(solved, 100);
}

TEST(Solve, RestIsTheRestState) {
  support::Random random(125);
  for (int k = 0; k < 200; ++k) {
    const Posed posed = random_problem(random, 4.0);
    for (const double nu : {0.0, -0.0}) {
      const Equilibrium answer = solve(posed.problem, nu);
      ASSERT_EQ(answer.status, SolveStatus::solved) << posed.text << answer.message;
      EXPECT_EQ(answer.connection, Connection::rest);
      EXPECT_EQ(answer.q.xi, answer.q.zeta) << posed.text;
      const double expected = posed.problem.potential().visit_parts([](const auto& model) {
        if constexpr (requires { model.plane; })
          return model.plane.rest_stretch();
        else
          return rest_stretch_of(model).xi;
      });
      EXPECT_NEAR(answer.q.xi, expected, 0x1p-51 * expected) << posed.text;
    }
  }
}

/// reciprocal-determinant: xi and zeta grow with c^(1/4), and are no escape.
TEST(Solve, StretchesFarFromOneAreReached) {
  const auto at = [](double c, double nu) {
    return solve(Problem(plate, make_potential("reciprocal-determinant", {c, 2.0}), Branch::i), nu);
  };
  for (const double scale : {1e9, 1e-9}) {
    const Equilibrium plain = at(1.0, 0.9);
    const Equilibrium far = at(std::pow(scale, 4), 0.9);
    ASSERT_EQ(far.status, SolveStatus::solved) << far.message;
    EXPECT_EQ(far.connection, Connection::rest);
    EXPECT_NEAR(far.q.xi / (scale * plain.q.xi), 1.0, 1e-14);
    EXPECT_NEAR(far.q.zeta / (scale * plain.q.zeta), 1.0, 1e-14);
  }
}

TEST(Solve, RoundPlateAboutItsNormalStaysRound) {
  for (const char* model : {"biot-log", "hencky", "saint-venant-kirchhoff", "biot"}) {
    const Problem problem(Body(1.0, 1.0, 0.6), make_potential(model, {1.0, 4.0}), Branch::iii);
    // Past the ellipses' start (biot: J nu^2 = 2 mu), where two thirds of the sheet are circles.
    for (const double nu : {0.3, 0.8, 1.1}) {
      const Equilibrium answer = solve(problem, nu);
      if (answer.status != SolveStatus::solved || answer.connection != Connection::rest) continue;
      EXPECT_EQ(answer.q.xi, answer.q.zeta) << model << " " << nu;
    }
    EXPECT_EQ(solve(problem, 0.3).connection, Connection::rest) << model;
  }
}

TEST(Solve, MisuseThrows) {
  const Problem problem(plate, make_potential("biot", {1.0, 0.5}), Branch::i);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double nu : {nan, inf, -inf})
    EXPECT_THROW(solve(problem, nu), std::invalid_argument) << nu;
  const Stretch starts[] = {{0.0, -1.0, 1.0, 1.0}, {0.0, 1.0, 0.0, 1.0}, {0.0, 1.0, 1.0, -1.0},
                            {0.0, nan, 1.0, 1.0},  {0.0, 1.0, inf, 1.0}, {0.1, 1.0, 1.0, 1.0},
                            {2.0, 1.0, 1.0, 1.0}};
  for (const Stretch& start : starts) {
    for (const Method method : {Method::automatic, Method::ceres, Method::newton, Method::nlopt}) {
      SolveOptions options;
      options.method = method;
      options.start = start;
      EXPECT_THROW(solve(problem, 0.3, options), std::invalid_argument) << support::at(start);
    }
  }
  SolveOptions options;
  options.start = Stretch{0.0, 1.0, 1.0, 1.0};
  EXPECT_NO_THROW(solve(problem, 0.3, options));
}

/// Whenever it is told to stop, an answer is the whole search's or none: of a part of the solutions the
/// nearest need not be the nearest.
TEST(Solve, InterruptedSearchAnswersNothingElse) {
  const Body thin(1.12, 0.0133, 1.76);
  BodyModel<> model;
  model.elastic.plane = AnyPlane<>{PlanarPotential(SaintVenantKirchhoff<>{2.369, 1.172})};
  model.elastic.thickness = AnyThickness<>{ThicknessPotential(Harmonic<>{1.222, 2.593})};
  model.gravitates = true;
  model.g = 1.72;
  model.J = {thin.J1, thin.J2, thin.J3};
  const Problem problem(thin, Potential(model), Branch::iii);
  SolveOptions options;
  options.start = Stretch{0.0, 1.557, 1.534, 1.107};  // leads nowhere
  const auto begin = std::chrono::steady_clock::now();
  const Equilibrium whole = solve(problem, 0.8856, options);
  const auto time = std::chrono::steady_clock::now() - begin;
  ASSERT_EQ(whole.status, SolveStatus::solved);
  ASSERT_NE(whole.message.find("Exhaustive search"), std::string::npos);
  for (int part = 0; part < 12; ++part) {
    std::atomic<bool> stop = false;
    options.stop = &stop;
    std::thread clock([&] {
      std::this_thread::sleep_for(time * (0.4 + 0.055 * part));
      stop = true;
    });
    const Equilibrium answer = solve(problem, 0.8856, options);
    clock.join();
    if (answer.status == SolveStatus::interrupted) continue;
    ASSERT_EQ(answer.status, SolveStatus::solved);
    EXPECT_EQ(answer.message, whole.message);
    EXPECT_EQ(answer.q.vector(), whole.q.vector());
  }
}

TEST(Solve, StopInterrupts) {
  const std::atomic<bool> stop = true;
  SolveOptions options;
  options.stop = &stop;
  for (const Method method : {Method::automatic, Method::nlopt}) {
    options.method = method;
    for (const char* model : {"biot-log", "neo-hookean-3d"}) {
      const Problem problem(plate, make_potential(model, {1.0, 0.6}), Branch::iii);
      const Equilibrium answer = solve(problem, 0.5, options);
      EXPECT_EQ(answer.status, SolveStatus::interrupted) << model << " " << name(method);
      EXPECT_TRUE(std::isnan(answer.q.xi) && std::isnan(answer.residual));
      EXPECT_EQ(answer.connection, Connection::unknown);
    }
  }
  const std::atomic<bool> go = false;
  options.stop = &go;
  const Problem problem(plate, make_potential("biot-log", {1.0, 0.6}), Branch::iii);
  EXPECT_EQ(solve(problem, 0.5, options).status, SolveStatus::solved);
}

TEST(Equilibrium, StartsAsNotRunAndNaN) {
  const Equilibrium fresh;
  EXPECT_EQ(fresh.status, SolveStatus::not_run);
  EXPECT_EQ(fresh.connection, Connection::unknown);
  for (const double x :
       {fresh.q.alpha, fresh.q.xi, fresh.q.zeta, fresh.q.rho, fresh.nu[0], fresh.nu[1], fresh.nu[2],
        fresh.residual, fresh.compatibility, fresh.error_bound})
    EXPECT_TRUE(std::isnan(x));
  EXPECT_TRUE(fresh.message.empty());
  EXPECT_EQ(fresh.counts.residuals, 0);
}

TEST(Equilibrium, Names) {
  EXPECT_EQ(name(Method::automatic), "auto");
  EXPECT_EQ(name(Method::ceres), "ceres");
  EXPECT_EQ(name(Method::newton), "newton");
  EXPECT_EQ(name(Method::nlopt), "nlopt");
  EXPECT_EQ(name(Connection::rest), "rest");
  EXPECT_EQ(name(Connection::given_start), "given start");
  EXPECT_EQ(name(Connection::unknown), "unknown");
}

}  // namespace
}  // namespace stationary
