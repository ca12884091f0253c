// Cases known by name: forced zeros, the traps they set for a bare eigenvalue solver, limits, and
// what stability() refuses.
#include "solver/solve/stability.hpp"

#include <gtest/gtest.h>

#include "solver/batch/sweep.hpp"
#include "tests/support/bodies/motions.hpp"

namespace stationary {
namespace {

using namespace testing;

const PotentialName biot_log{"biot-log", "reciprocal-quadratic"};

TEST(Stability, NeedsASolvedEquilibrium) {
  const Problem problem(Body(1.0, 1.7, 0.6), named_potential(biot_log, {1.0, 0.6}), Branch::i);
  EXPECT_THROW(stability(problem, Equilibrium{}), std::invalid_argument);
  EXPECT_THROW(stability(problem, solve(problem, 100.0)), std::invalid_argument);
}

TEST(Stability, NamesOfClasses) {
  EXPECT_EQ(name(StabilityClass::stable), "stable");
  EXPECT_EQ(name(StabilityClass::elliptic), "elliptic");
  EXPECT_EQ(name(StabilityClass::unstable), "unstable");
  EXPECT_EQ(name(StabilityClass::oscillatory), "oscillatory");
  EXPECT_EQ(name(StabilityClass::marginal), "marginal");
}

TEST(Stability, ModesAreSortedAndRepresentTheirLambdas) {
  support::Random random(601);
  for (const PotentialName& potential : potential_names()) {
    for (const Branch branch : branches) {
      for (int k = 0; k < 20; ++k) {
        const SolvedMotion motion = random_motion(random, potential, branch, k % 2 == 0);
        const Spectrum spectrum = motion.blocks();
        const auto all = modes(spectrum);
        ASSERT_EQ(all.size(), 5U);
        double growth = 0.0;
        for (std::size_t j = 0; j < all.size(); ++j) {
          const Mode& m = all[j];
          EXPECT_GE(m.re, 0.0);
          EXPECT_GE(m.im, 0.0);
          EXPECT_GE(m.lambda_im, 0.0);
          const double size = 4e-16 * (std::abs(m.lambda_re) + m.lambda_im);
          EXPECT_NEAR(m.re * m.re - m.im * m.im, m.lambda_re, size) << motion.text;
          EXPECT_NEAR(2.0 * m.re * m.im, m.lambda_im, size) << motion.text;
          if (m.forced_zero) {
            EXPECT_EQ(m.lambda_error, 0.0);
            EXPECT_EQ(m.re + m.im, 0.0);
            EXPECT_EQ(m.krein, 0);
          } else {
            EXPECT_GT(m.lambda_error, 0.0) << motion.text << spectrum;
          }
          if (j > 0) {
            EXPECT_GE(m.im, all[j - 1].im);
          }
          growth = std::max(growth, m.re);
        }
        const bool grows = spectrum.verdict == StabilityClass::unstable ||
                           spectrum.verdict == StabilityClass::oscillatory;
        EXPECT_EQ(spectrum.growth, grows ? growth : 0.0) << motion.text << spectrum;
      }
    }
  }
}

/// J1 = J2: one exact zero pair, but on the circle of (iii).
TEST(Stability, MaterialSymmetryForcesExactlyOneZero) {
  support::Random random(602);
  for (const PotentialName& potential : potential_names()) {
    for (const Branch branch : branches) {
      for (int k = 0; k < 20; ++k) {
        const SolvedMotion motion = random_motion(random, potential, branch, true);
        const Spectrum spectrum = motion.blocks();
        int forced = 0;
        for (const Mode& m : modes(spectrum)) forced += m.forced_zero;
        const bool circle = branch == Branch::iii && motion.at.q.xi == motion.at.q.zeta;
        EXPECT_EQ(forced, circle ? 0 : 1) << motion.text << spectrum;
        const SolvedMotion generic = random_motion(random, potential, branch, false);
        for (const Mode& m : modes(generic.blocks())) EXPECT_FALSE(m.forced_zero);
      }
    }
  }
}

/// A QR algorithm on the whole matrix splits the exact double zero here into +-1e-7 and reports
/// growth.
TEST(Stability, NoGrowthOutOfAForcedZero) {
  for (const double lambda : {0.6, 1.0}) {
    const Problem problem(Body(1.0, 1.0, 0.2), named_potential(biot_log, {1.0, lambda}), Branch::i);
    const Equilibrium start = solve(problem, 1.2);
    ASSERT_EQ(start.status, SolveStatus::solved);
    constexpr int count = 10000;
    std::vector<double> nu(count);
    for (int k = 0; k < count; ++k)
      nu[static_cast<std::size_t>(k)] = 1.2 + (1.404 - 1.2) * k / (count - 1);
    std::vector<SweepPoint> points(count);
    Sweep(problem, start).run(nu, points);
    int solved = 0;
    for (const SweepPoint& point : points) {
      if (point.status != SolveStatus::solved) continue;
      ++solved;
      Equilibrium at;
      at.status = SolveStatus::solved;
      at.q = {0.0, point.xi, point.zeta, point.rho};
      at.nu = angular_velocity(Branch::i, point.nu);
      at.error_bound = point.error_bound;
      const Spectrum spectrum = stability(problem, at);
      ASSERT_EQ(spectrum.verdict, StabilityClass::stable) << point.nu << "\n" << spectrum;
      ASSERT_EQ(spectrum.growth, 0.0) << point.nu;
    }
    EXPECT_EQ(solved, count) << lambda;
  }
}

/// One negative direction of ten and none of the eight that count.
TEST(Stability, MeaninglessNegativeDirection) {
  const SolvedMotion m = motion(Body(0.9293, 0.9293, 0.5442), {"biot", "reciprocal-quadratic"},
                                {1.0, 1.0}, {1.0, 3.0}, Branch::ii, 0.0671);
  const Spectrum spectrum = m.blocks();
  EXPECT_EQ(spectrum.verdict, StabilityClass::stable) << spectrum;
  EXPECT_EQ(spectrum.negative, 1) << spectrum;
}

TEST(Stability, CircleStableByItsSecondInvariant) {
  SolveOptions options;
  options.method = Method::newton;
  options.start = Stretch{0.0, 1.3, 1.3, 0.7};
  const SolvedMotion m =
      motion(Body(1.0, 1.0, 0.6), biot_log, {1.0, 4.0}, {1.0, 3.0}, Branch::iii, 1.1, options);
  ASSERT_EQ(m.at.q.xi, m.at.q.zeta);
  const Spectrum spectrum = m.blocks();
  EXPECT_EQ(spectrum.verdict, StabilityClass::stable) << spectrum;
  EXPECT_EQ(spectrum.negative, 2) << spectrum;
}

/// All coefficients times 10^6: one pair stays finite, the rigid body's.
TEST(Stability, StiffBodyIsTheRigidBody) {
  support::Random random(603);
  for (const PotentialName& potential : potential_names()) {
    if (potential.thickness == "harmonic") continue;  // b is a length there
    for (int k = 0; k < 6; ++k) {
      const Body body = random.body();
      for (const Branch branch : branches) {
        const double nu = 0.3;
        const SolvedMotion m = motion(body, potential, {1e6, 2e6}, {1e6, 1e6}, branch, nu);
        const Spectrum spectrum = m.blocks();
        // At rest the stretch is s (1, 1, r).
        const Stretch& q = m.at.q;
        const double I[3] = {body.J2 * q.zeta * q.zeta + body.J3 * q.rho * q.rho,
                             body.J1 * q.xi * q.xi + body.J3 * q.rho * q.rho,
                             body.J1 * q.xi * q.xi + body.J2 * q.zeta * q.zeta};
        const double a = I[axis(branch)];
        const double b = I[(axis(branch) + 1) % 3];
        const double c = I[(axis(branch) + 2) % 3];
        const double lambda = -nu * nu * (a - b) * (a - c) / (b * c);
        int finite = 0;
        for (const Mode& mode : modes(spectrum)) {
          if (std::hypot(mode.lambda_re, mode.lambda_im) > 1e3) {
            EXPECT_LT(mode.lambda_re, 0.0) << m.text;
            continue;
          }
          ++finite;
          EXPECT_NEAR(mode.lambda_re, lambda, 1e-4 * nu * nu * (1.0 + a * a / (b * c)))
              << m.text << spectrum;
        }
        EXPECT_EQ(finite, 1) << m.text << spectrum;
        if (std::abs(lambda) > 1e-4) {
          // About the least inertia E'' is not definite: elliptic at best.
          const StabilityClass expected = lambda > 0.0     ? StabilityClass::unstable
                                          : a > b && a > c ? StabilityClass::stable
                                                           : StabilityClass::elliptic;
          EXPECT_EQ(name(spectrum.verdict), name(expected)) << m.text << spectrum;
        }
      }
    }
  }
}

/// (iii): the wobble is the rigid body's at any stiffness, the thickness vibrates alone.
TEST(Stability, ClosedFormsOfBranchThree) {
  support::Random random(604);
  for (const PotentialName& potential : potential_names()) {
    for (int k = 0; k < 20; ++k) {
      const SolvedMotion m = random_motion(random, potential, Branch::iii, k % 2 == 0);
      const Body& body = m.problem.body();
      const Stretch& q = m.at.q;
      const double I1 = body.J2 * q.zeta * q.zeta + body.J3 * q.rho * q.rho;
      const double I2 = body.J1 * q.xi * q.xi + body.J3 * q.rho * q.rho;
      const double I3 = body.J1 * q.xi * q.xi + body.J2 * q.zeta * q.zeta;
      const double n2 = m.nu() * m.nu();
      const Spectrum spectrum = m.blocks();
      const auto nearest = [&](double lambda) {
        double out = INFINITY;
        for (const Mode& mode : modes(spectrum))
          if (mode.lambda_im == 0.0) out = std::min(out, std::abs(mode.lambda_re - lambda));
        return out;
      };
      EXPECT_LE(nearest(-n2 * (I3 - I1) * (I3 - I2) / (I1 * I2)),
                1e-14 * n2 * I3 * (I3 + I1 + I2) / (I1 * I2))
          << m.text << spectrum;
      if (potential.thickness.empty()) continue;
      m.problem.potential().visit_parts([&](const auto& model) {
        if constexpr (requires { model.thickness; }) {
          // reciprocal-quadratic: V'' = 2 a/rho^3 + b = 3 b; harmonic: k.
          const auto c = model.thickness.coefficients();
          const double stiffness = potential.thickness == "harmonic" ? c[0] : 3.0 * c[1];
          EXPECT_LE(nearest(-stiffness / body.J3), 1e-14 * stiffness / body.J3)
              << m.text << spectrum;
        }
      });
    }
  }
}

}  // namespace
}  // namespace stationary
