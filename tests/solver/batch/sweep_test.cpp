// A sweep gives at every nu what a solve would, cheaply; it stays on its sheet and says where that
// ends.
#include "solver/batch/sweep.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/model_and_branch.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/numbers/evenly.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary {
namespace {

using namespace testing;

std::vector<SweepPoint> swept(const Problem& problem, const std::vector<double>& nu,
                              const SweepOptions& options = {}) {
  const Equilibrium start = solve(problem, nu.front());
  EXPECT_EQ(start.status, SolveStatus::solved) << start.message;
  std::vector<SweepPoint> out(nu.size());
  Sweep(problem, start, options).run(nu, out);
  return out;
}

Stretch stretch(const SweepPoint& point) { return {0.0, point.xi, point.zeta, point.rho}; }

void expect_rounded(const Problem& problem, const SweepPoint& point, const std::string& x) {
  ASSERT_EQ(point.status, SolveStatus::solved) << x;
  const auto exact = reference_solution(problem, point.nu, stretch(point));
  const double error = relative_error(stretch(point), exact);
  EXPECT_LE(error, refined_half_unit) << x << " " << point.nu;
  EXPECT_LE(error, point.error_bound) << x << " " << point.nu;
}

void expect_poison(const SweepPoint& point, double nu) {
  EXPECT_EQ(point.nu, nu);
  EXPECT_TRUE(std::isnan(point.xi) && std::isnan(point.zeta) && std::isnan(point.rho) &&
              std::isnan(point.error_bound))
      << nu;
}

class SweepEveryModelTest : public ::testing::TestWithParam<support::ModelAndBranch> {};

TEST_P(SweepEveryModelTest, TenThousandPoints) {
  const auto [model, branch] = GetParam();
  const Problem problem(plate, make_potential(model, {1.0, 2.0}), branch);
  const auto nu = evenly(0.0, 0.55, 10000);
  const Equilibrium start = solve(problem, 0.0);
  ASSERT_EQ(start.status, SolveStatus::solved);
  std::vector<SweepPoint> points(nu.size());
  Sweep sweep(problem, start);
  sweep.run(nu, points);
  long steps = 0;
  for (std::size_t k = 0; k < nu.size(); ++k) {
    ASSERT_EQ(points[k].status, SolveStatus::solved) << nu[k];
    ASSERT_EQ(points[k].nu, nu[k]);
    ASSERT_GE(points[k].steps, 1);
    ASSERT_LE(points[k].steps, 3) << nu[k];
    steps += points[k].steps;
  }
  EXPECT_LE(steps, 10500);
  for (std::size_t k = 0; k < nu.size(); k += 499)
    expect_rounded(problem, points[k], std::string(model));
  for (std::size_t k = 0; k < nu.size(); k += 1999) {
    const Equilibrium cold = solve(problem, nu[k]);
    EXPECT_EQ(cold.connection, Connection::rest);
    EXPECT_EQ(cold.q.vector(), stretch(points[k]).vector()) << nu[k];
  }
  const long solves = sweep.thickness_solves();
  if (problem.thickness_rule() == ThicknessRule::constant) {
    EXPECT_EQ(solves, 1);
  }
  if (problem.thickness_rule() == ThicknessRule::closed_form) {
    EXPECT_EQ(solves, 10000);
  }
  if (problem.thickness_rule() == ThicknessRule::coupled) {
    EXPECT_EQ(solves, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SweepEveryModelTest,
                         ::testing::Combine(::testing::ValuesIn(all_models()),
                                            ::testing::Values(Branch::i, Branch::ii, Branch::iii)),
                         support::model_and_branch);

/// hencky (i) up to within 1e-12 of its fold.
TEST(Sweep, BoundHoldsCloseBelowAFold) {
  const Problem problem(plate, make_potential("hencky", {1.1, 0.8}), Branch::i);
  const double end = std::sqrt(support::HenckyFold<double>(plate.J2, 1.1, 0.8).nu_squared);
  std::vector<double> nu;
  for (double gap = 0.9; gap > 1e-12; gap *= 0.8) nu.push_back(end * (1.0 - gap));
  const auto points = swept(problem, nu);
  double last = 0.0;
  for (const SweepPoint& point : points) {
    expect_rounded(problem, point, "towards the fold");
    EXPECT_GT(point.zeta, last);
    EXPECT_LT(point.zeta, std::sqrt(std::exp(1.0)));
    last = point.zeta;
  }
  EXPECT_GT(points.back().error_bound, 1e-12) << "the fold is felt";
}

TEST(Sweep, BeyondAFoldNotFoundAndBackAgain) {
  const Problem problem(plate, make_potential("hencky", {1.1, 0.8}), Branch::i);
  const double end = std::sqrt(support::HenckyFold<double>(plate.J2, 1.1, 0.8).nu_squared);
  std::vector<double> nu = evenly(0.0, 1.2 * end, 240);
  for (int k = 238; k >= 0; --k) nu.push_back(nu[static_cast<std::size_t>(k)]);
  const auto points = swept(problem, nu);
  for (std::size_t k = 0; k < nu.size(); ++k) {
    if (nu[k] > end) {
      EXPECT_EQ(points[k].status, SolveStatus::not_found);
      expect_poison(points[k], nu[k]);
    } else {
      ASSERT_EQ(points[k].status, SolveStatus::solved) << nu[k];
      EXPECT_LT(points[k].zeta, std::sqrt(std::exp(1.0))) << "the part from rest";
      EXPECT_EQ(points[k].zeta, points[nu.size() - 1 - k].zeta) << "the same way back";
    }
  }
}

TEST(Sweep, AnyOrderGivesTheSameNumbers) {
  const Problem problem(plate, make_potential("neo-hookean", {1.0, 2.0}), Branch::iii);
  const auto up = evenly(0.0, 0.7, 300);
  const auto expected = swept(problem, up);
  const auto expect_same = [&](const std::vector<std::size_t>& order) {
    std::vector<double> nu;
    for (const std::size_t k : order) nu.push_back(up[k]);
    const auto points = swept(problem, nu);
    for (std::size_t i = 0; i < order.size(); ++i) {
      ASSERT_EQ(points[i].status, SolveStatus::solved) << nu[i];
      EXPECT_EQ(stretch(points[i]).vector(), stretch(expected[order[i]]).vector()) << nu[i];
    }
  };
  std::vector<std::size_t> down;
  std::vector<std::size_t> repeated;
  std::vector<std::size_t> jumping;
  support::Random random(141);
  for (std::size_t k = 0; k < up.size(); ++k) {
    down.push_back(up.size() - 1 - k);
    repeated.insert(repeated.end(), {k, k, k});
    jumping.push_back(static_cast<std::size_t>(random.integer(0, 299)));
  }
  expect_same(down);
  expect_same(repeated);
  expect_same(jumping);
}

TEST(Sweep, ThroughRestToTheOtherSense) {
  const Problem problem(plate, make_potential("biot-log", {1.0, 0.6}), Branch::i);
  const auto points = swept(problem, evenly(-0.5, 0.5, 201));
  for (std::size_t k = 0; k < points.size(); ++k) {
    ASSERT_EQ(points[k].status, SolveStatus::solved);
    EXPECT_NEAR(points[k].xi, points[200 - k].xi, 0x1p-51);
  }
}

/// The same random cases a solve is put through: from rest to nu in 30 steps of nu. Reaching an end
/// is allowed, another sheet is not.
TEST(Sweep, RandomFamiliesStayOnTheRestSheet) {
  support::Random random(142);
  int solved = 0;
  for (int k = 0; k < 150; ++k) {
    const Posed posed = random_problem(random, 2.0);
    const auto points = swept(posed.problem, evenly(0.0, posed.nu, 31));
    for (std::size_t i = 1; i < points.size(); i += 6) {
      if (points[i].status != SolveStatus::solved) {
        expect_poison(points[i], points[i].nu);
        continue;
      }
      ++solved;
      const Equilibrium cold = solve(posed.problem, points[i].nu);
      ASSERT_EQ(cold.status, SolveStatus::solved) << posed.text << " at " << points[i].nu;
      EXPECT_EQ(cold.connection, Connection::rest) << posed.text << " at " << points[i].nu;
      EXPECT_NEAR(cold.q.xi, points[i].xi, 0x1p-51 * cold.q.xi) << posed.text;
      EXPECT_NEAR(cold.q.zeta, points[i].zeta, 0x1p-51 * cold.q.zeta) << posed.text;
      EXPECT_NEAR(cold.q.rho, points[i].rho, 0x1p-51 * cold.q.rho) << posed.text;
    }
  }
  EXPECT_GT(solved, 300);
}

/// Two sheets that almost touch at nu = 0.21; the one through rest ends at 0.22403394.
TEST(Sweep, DoesNotJumpToANearbySheet) {
  const Body body(1.046, 0.972, 0.234);
  const Problem problem(
      body, make_potential("neo-hookean", {0.0525, 2.3792}, "reciprocal-quadratic", {0.591, 1.917}),
      Branch::iii);
  for (const double from : {0.0, 0.05, 0.15, 0.2}) {
    for (const double step : {0.0005, 0.003, 0.01, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3}) {
      std::vector<double> nu;
      for (double x = from; x < 0.95; x += step) nu.push_back(x);
      const auto points = swept(problem, nu);
      for (const SweepPoint& point : points) {
        if (point.nu < 0.22403) {
          ASSERT_EQ(point.status, SolveStatus::solved) << point.nu << " step " << step;
          if (point.nu > 0.0) {
            EXPECT_GT(point.xi, point.zeta) << point.nu << " step " << step;
          }
        } else {
          EXPECT_EQ(point.status, SolveStatus::not_found) << point.nu << " step " << step;
          expect_poison(point, point.nu);
        }
      }
    }
  }
}

/// Nearly round plates: the ellipses branch off the circle across a gap as small as the difference
/// of J1 and J2. Whatever the steps, what is called solved is on the rest sheet.
TEST(Sweep, DoesNotCrossTheGapOfABrokenBifurcation) {
  const struct {
    std::string_view model;
    std::array<double, 2> coefficients;
    double to;
  } cases[] = {{"neo-hookean", {0.0525, 2.3792}, 0.9},
               {"biot-log", {1.0, 4.0}, 1.5},
               {"hencky", {1.0, 4.0}, 1.3},
               {"biot", {1.0, 2.0}, 1.6}};
  for (const auto& c : cases) {
    for (const double difference : {5e-2, 1e-2, 1e-3, 1e-4}) {
      const Problem problem(Body(1.0 + difference, 1.0, 0.3),
                            make_potential(c.model, c.coefficients), Branch::iii);
      for (const int count : {30, 300, 3000}) {
        const auto points = swept(problem, evenly(0.0, c.to, count));
        for (std::size_t k = 1; k < points.size(); k += static_cast<std::size_t>(count) / 30) {
          if (points[k].status != SolveStatus::solved) continue;
          const Equilibrium cold = solve(problem, points[k].nu);
          EXPECT_EQ(cold.connection, Connection::rest)
              << c.model << " " << difference << " of " << count << " at " << points[k].nu;
          EXPECT_NEAR(cold.q.xi, points[k].xi, 1e-13 * cold.q.xi);
        }
      }
    }
  }
}

/// Nearly a circle: both sides of its broken pitchfork lie within a step, that with xi > zeta, where J1 > J2, being the
/// rest sheet's.
TEST(Sweep, StaysOnItsSideOfAPitchforkThatIsHardlyBroken) {
  int compared = 0;
  for (const double apart : {1e-12, 1e-8, 1e-6, 1e-5}) {
    for (int k = 0; k < 12; ++k) {
      const Body body(1.0, 1.0 - (k % 2 == 0 ? apart : -apart), 0.6);
      const Problem problem(body, make_potential("biot-log", {1.0, 3.0 + 0.25 * k}), Branch::iii);
      for (const SweepPoint& point : swept(problem, evenly(0.0, 1.3, 14))) {
        if (point.status != SolveStatus::solved || point.nu == 0.0) continue;
        EXPECT_GE((point.xi - point.zeta) * (body.J1 - body.J2), -1e-12 * apart)
            << apart << " " << k << " " << point.nu;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 300);
}

/// With gravity a figure is shorter along the axis of the greater J at rest, and longer at fast spins.
TEST(Sweep, PassesACircleThatGravityLetsItPass) {
  BodyModel<> heavy;
  heavy.elastic.coupled = NeoHookean3d<>{1.0, 2.0};
  heavy.gravitates = true;
  heavy.g = 1.0;
  for (const double J2 : {0.995, 0.99999, 0.5}) {
    const Body body(1.0, J2, 0.6);
    heavy.J = {body.J1, body.J2, body.J3};
    const Problem problem(body, Potential(heavy), Branch::iii);
    const auto points = swept(problem, evenly(0.0, 0.8, 17));
    for (const SweepPoint& point : points) {
      ASSERT_EQ(point.status, SolveStatus::solved) << J2 << " " << point.nu;
      EXPECT_NEAR(solve(problem, point.nu).q.xi / point.xi, 1.0, 1e-14);
    }
    EXPECT_LT(points.front().xi, points.front().zeta);
    if (J2 > 0.9) {
      EXPECT_GT(points.back().xi, points.back().zeta);
    }
  }
}

/// Up and down again: a slope is of points at different nu.
TEST(Sweep, BackOverTheSamePoints) {
  const Problem problem(plate, make_potential("neo-hookean", {1.0, 2.0}), Branch::i);
  std::vector<double> nu = evenly(0.0, 0.33, 101);
  for (std::size_t k = 100; k-- > 0;) nu.push_back(nu[k]);
  for (const SweepPoint& point : swept(problem, nu))
    EXPECT_EQ(point.status, SolveStatus::solved) << point.nu;
}

TEST(Sweep, CircleIsFollowedThroughItsBifurcation) {
  const Problem problem(Body(1.0, 1.0, 0.6), make_potential("biot-log", {1.0, 4.0}), Branch::iii);
  for (const SweepPoint& point : swept(problem, evenly(0.0, 1.4, 141))) {
    ASSERT_EQ(point.status, SolveStatus::solved) << point.nu;
    EXPECT_EQ(point.xi, point.zeta) << point.nu;
  }
}

/// Points that cannot be reached, put in between, change nothing for the others.
TEST(Sweep, PointNotFoundLeavesNoTrace) {
  const Problem problem(plate, make_potential("hencky", {1.1, 0.8}), Branch::i);
  const double end = std::sqrt(support::HenckyFold<double>(plate.J2, 1.1, 0.8).nu_squared);
  const auto plain = evenly(0.0, 0.999 * end, 50);
  std::vector<double> mixed;
  support::Random random(143);
  for (const double nu : plain) {
    mixed.push_back(nu);
    mixed.push_back(end * (1.0 + random.log_uniform(1e-6, 1.0)));
  }
  const auto expected = swept(problem, plain);
  const auto points = swept(problem, mixed);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    EXPECT_EQ(stretch(points[2 * k]).vector(), stretch(expected[k]).vector());
    EXPECT_EQ(points[2 * k].steps, expected[k].steps);
    EXPECT_EQ(points[2 * k + 1].status, SolveStatus::not_found);
  }
}

TEST(Sweep, WithoutBoundTheSameNumbersAndNaN) {
  for (const std::string_view model : {"biot-log", "neo-hookean-3d"}) {
    const Problem problem(plate, make_potential(model, {1.0, 0.6}), Branch::i);
    const auto nu = evenly(0.1, 0.6, 100);
    const auto with = swept(problem, nu);
    const auto without = swept(problem, nu, {.error_bound = false});
    for (std::size_t k = 0; k < nu.size(); ++k) {
      EXPECT_EQ(stretch(with[k]).vector(), stretch(without[k]).vector());
      EXPECT_EQ(with[k].steps, without[k].steps);
      EXPECT_GT(with[k].error_bound, 0.0);
      EXPECT_TRUE(std::isnan(without[k].error_bound));
    }
  }
}

TEST(Sweep, RunsContinueWhereTheLastEnded) {
  const Problem problem(plate, make_potential("biot-log", {1.0, 0.6}), Branch::iii);
  const auto nu = evenly(0.0, 0.6, 100);
  const auto expected = swept(problem, nu);
  Sweep sweep(problem, solve(problem, 0.0));
  std::vector<SweepPoint> points(nu.size());
  const std::span<const double> all(nu);
  const std::span<SweepPoint> out(points);
  sweep.run(all.first(37), out.first(37));
  sweep.run(all.subspan(37), out.subspan(37));
  sweep.run({}, {});
  for (std::size_t k = 0; k < nu.size(); ++k) {
    EXPECT_EQ(stretch(points[k]).vector(), stretch(expected[k]).vector());
    EXPECT_EQ(points[k].steps, expected[k].steps);
  }
  EXPECT_EQ(sweep.thickness_solves(), 1);
}

TEST(Sweep, MisuseThrows) {
  const Problem problem(plate, make_potential("biot-log", {1.0, 0.6}), Branch::iii);
  EXPECT_THROW(Sweep(problem, Equilibrium{}), std::invalid_argument);
  const Equilibrium missing = solve(problem, 1.3);
  ASSERT_EQ(missing.status, SolveStatus::not_found);
  EXPECT_THROW(Sweep(problem, missing), std::invalid_argument);
  Sweep sweep(problem, solve(problem, 0.3));
  const std::vector<double> nu(3, 0.3);
  std::vector<SweepPoint> points(2);
  EXPECT_THROW(sweep.run(nu, points), std::invalid_argument);
  EXPECT_EQ(points[0].status, SolveStatus::not_run);
}

TEST(Sweep, NotFiniteNuIsNotFoundAndDoesNoHarm) {
  const Problem problem(plate, make_potential("biot-log", {1.0, 0.6}), Branch::iii);
  Sweep sweep(problem, solve(problem, 0.3));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> nu{0.3, nan, inf, 1e200, 0.31};
  std::vector<SweepPoint> points(nu.size());
  sweep.run(nu, points);
  for (const std::size_t k : {1u, 2u, 3u}) {
    EXPECT_EQ(points[k].status, SolveStatus::not_found) << nu[k];
    EXPECT_TRUE(std::isnan(points[k].xi)) << nu[k];
  }
  EXPECT_EQ(points[4].status, SolveStatus::solved);
  EXPECT_EQ(stretch(points[4]).vector(), solve(problem, 0.31).q.vector());
}

TEST(SweepPoint, StartsAsNotRunAndNaN) {
  const SweepPoint fresh;
  EXPECT_EQ(fresh.status, SolveStatus::not_run);
  EXPECT_EQ(fresh.steps, 0);
  expect_poison(SweepPoint{.nu = 1.0}, 1.0);
  EXPECT_TRUE(std::isnan(fresh.nu));
}

}  // namespace
}  // namespace stationary
