// The stretch: positive definiteness names the inequality it lacks, and the two-polar form and back
// are accurate to the last places, at any ratio and on the circle.
#include "lib/body/stretch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// lambda, mu, theta in 50 digits from the exact doubles of q.
struct ReferencePolar {
  Real50 lambda;
  Real50 mu;
  Real50 theta;

  explicit ReferencePolar(const Stretch& narrow) {
    const auto q = widen_stretch<Real50>(narrow);
    const auto x = planar_invariants(q);
    lambda = (x.t + sqrt(x.e)) / 2;
    mu = x.d / lambda;
    theta = atan2(Real50(2 * q.alpha), Real50(q.xi - q.zeta)) / 2;
  }
};

TEST(PrincipalStretches, AreAccurateAtAnyRatio) {
  Random random(901);
  for (const double ratio : {1.5, 30.0, 1e4}) {
    for (int trial = 0; trial < 100; ++trial) {
      const Stretch q = random.stretch(ratio);
      const ReferencePolar expected(q);
      const auto actual = principal_stretches(q);
      EXPECT_TRUE(agrees<Real50>(at(q, "lambda"), expected.lambda, Real50(actual.lambda),
                                 8 * unit_roundoff * expected.lambda));
      EXPECT_TRUE(agrees<Real50>(at(q, "mu"), expected.mu, Real50(actual.mu),
                                 8 * unit_roundoff * expected.mu));
      ASSERT_TRUE(actual.theta);
      // theta inherits the rounding of xi - zeta, relative to the larger of the two legs.
      EXPECT_TRUE(
          agrees<Real50>(at(q, "theta"), expected.theta, Real50(*actual.theta),
                         Real50(4 * unit_roundoff * std::max(1.0, std::abs(*actual.theta)))));
      EXPECT_GE(actual.lambda, actual.mu);
    }
  }
}

TEST(PrincipalStretches, KeepASmallOneNextToAHugeOne) {
  // mu = d / lambda; the difference of the textbook formula would have no digit left.
  for (const double ratio : {1e4, 1e8, 1e12}) {
    const double alpha = std::nextafter(std::sqrt(ratio) * 0.6, 0.0);
    const Stretch q{alpha, ratio, 1.0, 1.0};
    ASSERT_EQ(violated_inequality(q), nullptr);
    const ReferencePolar expected(q);
    const auto actual = principal_stretches(q);
    EXPECT_TRUE(agrees<Real50>(at(q, "mu"), expected.mu, Real50(actual.mu),
                               8 * unit_roundoff * expected.mu));
    EXPECT_TRUE(agrees<Real50>(at(q, "lambda"), expected.lambda, Real50(actual.lambda),
                               8 * unit_roundoff * expected.lambda));
  }
}

TEST(PrincipalStretches, NearTheEdgeOfPositiveDefiniteness) {
  // d one rounding above zero: alpha^2 and xi zeta cancel to their last digits.
  Random random(902);
  int compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double xi = random.log_uniform(0.1, 10.0);
    const double zeta = random.log_uniform(0.1, 10.0);
    const double alpha = std::sqrt(xi * zeta) * (1.0 - random.log_uniform(1e-15, 1e-3));
    const Stretch q{alpha, xi, zeta, 1.0};
    if (violated_inequality(q) != nullptr) continue;
    const ReferencePolar expected(q);
    EXPECT_TRUE(agrees<Real50>(at(q, "mu"), expected.mu, Real50(principal_stretches(q).mu),
                               8 * unit_roundoff * expected.mu));
    ++compared;
  }
  EXPECT_GE(compared, 150);
}

TEST(PrincipalStretches, AreXiAndZetaWithoutShear) {
  const auto upright = principal_stretches({0.0, 2.0, 0.5, 1.0});
  EXPECT_EQ(upright.lambda, 2.0);
  EXPECT_EQ(upright.mu, 0.5);
  EXPECT_EQ(upright.theta, 0.0);
  const auto lying = principal_stretches({0.0, 0.5, 2.0, 1.0});
  EXPECT_EQ(lying.lambda, 2.0);
  EXPECT_EQ(lying.mu, 0.5);
  EXPECT_EQ(lying.theta, 0.5 * std::numbers::pi);
}

TEST(PrincipalStretches, HaveNoAngleOnTheCircle) {
  const auto circle = principal_stretches({0.0, 1.3, 1.3, 1.0});
  EXPECT_EQ(circle.lambda, 1.3);
  EXPECT_EQ(circle.mu, 1.3);
  EXPECT_EQ(circle.theta, std::nullopt);
  EXPECT_TRUE(principal_stretches({1e-300, 1.3, 1.3, 1.0}).theta);
}

TEST(PrincipalStretches, RoundTrip) {
  Random random(903);
  for (const double ratio : {1.01, 3.0, 1e4, 1e8}) {
    for (int trial = 0; trial < 50; ++trial) {
      const double mu = random.log_uniform(0.1, 1.0);
      const PrincipalStretches planar{mu * ratio, mu,
                                      random.uniform(-0.499, 0.5) * std::numbers::pi};
      const Stretch q = stretch_from_principal(planar, 0.7);
      EXPECT_EQ(q.rho, 0.7);
      // An entry carries the larger stretch's rounding, which mu sees divided by mu.
      EXPECT_TRUE(agrees(at(q, "trace"), planar.lambda + planar.mu, q.xi + q.zeta,
                         8 * unit_roundoff * planar.lambda));
      if (ratio > 1e4) continue;  // beyond, the rounded entries may not be positive definite
      ASSERT_EQ(violated_inequality(q), nullptr);
      const auto back = principal_stretches(q);
      EXPECT_TRUE(
          agrees(at(q, "lambda"), planar.lambda, back.lambda, 16 * unit_roundoff * planar.lambda));
      EXPECT_TRUE(agrees(at(q, "mu"), planar.mu, back.mu, 16 * unit_roundoff * planar.lambda));
      const double angle_scale = planar.lambda / (planar.lambda - planar.mu);
      EXPECT_TRUE(
          agrees(at(q, "theta"), *planar.theta, *back.theta, 16 * unit_roundoff * angle_scale));
    }
  }
}

TEST(PrincipalStretches, FromPrincipalIsTheRotatedDiagonal) {
  Random random(904);
  for (int trial = 0; trial < 100; ++trial) {
    const PrincipalStretches planar{random.log_uniform(1.0, 1e8), random.log_uniform(1e-8, 1.0),
                                    random.uniform(-1.5, 1.5)};
    const Stretch q = stretch_from_principal(planar, 1.0);
    const Real50 c = cos(Real50(*planar.theta));
    const Real50 s = sin(Real50(*planar.theta));
    const Real50 allowed = 8 * unit_roundoff * planar.lambda;
    const std::string x = at(planar.lambda, planar.mu, *planar.theta);
    EXPECT_TRUE(agrees<Real50>(x, planar.lambda * c * c + planar.mu * s * s, q.xi, allowed));
    EXPECT_TRUE(agrees<Real50>(x, planar.lambda * s * s + planar.mu * c * c, q.zeta, allowed));
    EXPECT_TRUE(agrees<Real50>(x, (Real50(planar.lambda) - planar.mu) * s * c, q.alpha, allowed));
  }
  const Stretch circle = stretch_from_principal({1.3, 1.3, std::nullopt}, 0.5);
  EXPECT_EQ(circle.vector(), (Stretch{0.0, 1.3, 1.3, 0.5}.vector()));
}

TEST(PlanarInvariants, AgreeWithTheirDefinitions) {
  Random random(905);
  for (int trial = 0; trial < 100; ++trial) {
    const Stretch q = random.diagonal_stretch(100.0);
    const auto full = planar_invariants(q);
    const auto diagonal = planar_invariants(q.xi, q.zeta);
    EXPECT_EQ(full.t, diagonal.t);
    EXPECT_EQ(full.d, diagonal.d);
    EXPECT_EQ(full.e, diagonal.e);
    const auto extended = extended_invariants(q.xi, q.zeta);
    EXPECT_EQ(exact<Real100>(extended.t), Real100(q.xi) + Real100(q.zeta));
    EXPECT_EQ(exact<Real100>(extended.d), Real100(q.xi) * Real100(q.zeta));
    const Real100 difference = Real100(q.xi) - Real100(q.zeta);
    EXPECT_TRUE(agrees<Real100>(at(q), difference * difference, exact<Real100>(extended.e),
                                ldexp(Real100(difference * difference), -101)));
  }
  const auto sheared = planar_invariants(widen_stretch<Real50>(Stretch{0.25, 1.5, 0.75, 1.0}));
  EXPECT_EQ(sheared.e, sheared.t * sheared.t - 4 * sheared.d);
}

struct Violation {
  Stretch q;
  const char* inequality;
};

TEST(Stretch, NamesTheViolatedInequality) {
  const double nan = std::nan("");
  const Violation violations[] = {
      {{0.0, 0.0, 1.0, 1.0}, "xi > 0"},
      {{0.0, -0.0, 1.0, 1.0}, "xi > 0"},
      {{0.0, -1.0, 1.0, 1.0}, "xi > 0"},
      {{0.0, -1.0, -1.0, 1.0}, "xi > 0"},
      {{0.0, 1.0, 0.0, 1.0}, "zeta > 0"},
      {{0.0, 1.0, -2.0, 1.0}, "zeta > 0"},
      {{0.0, 1.0, 1.0, 0.0}, "rho > 0"},
      {{0.0, 1.0, 1.0, -3.0}, "rho > 0"},
      {{1.0, 1.0, 1.0, 1.0}, "xi zeta - alpha^2 > 0"},
      {{-2.0, 1.0, 1.0, 1.0}, "xi zeta - alpha^2 > 0"},
      // (1 + 2^-52)^2 > 1 + 2^-51, by less than a double shows.
      {{1.0 + 0x1p-52, 1.0 + 0x1p-51, 1.0, 1.0}, "xi zeta - alpha^2 > 0"},
      {{nan, 1.0, 1.0, 1.0}, "alpha, xi, zeta, rho finite"},
      {{0.0, nan, 1.0, 1.0}, "alpha, xi, zeta, rho finite"},
      {{0.0, 1.0, infinity, 1.0}, "alpha, xi, zeta, rho finite"},
      {{0.0, 1.0, 1.0, -infinity}, "alpha, xi, zeta, rho finite"},
  };
  for (const Violation& violation : violations) {
    EXPECT_STREQ(violated_inequality(violation.q), violation.inequality) << at(violation.q);
    try {
      require_positive_definite(violation.q);
      ADD_FAILURE() << at(violation.q) << "passes, but " << violation.inequality;
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(), violation.inequality);
    }
  }
}

TEST(Stretch, SeesTheSignOfTheDeterminantWhereADoubleDoesNot) {
  Random random(906);
  int unseen = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double xi = random.uniform(0.5, 2.0);
    const double zeta = random.uniform(0.5, 2.0);
    const Stretch q{std::sqrt(xi * zeta), xi, zeta, 1.0};
    const Real100 d = Real100(xi) * zeta - Real100(q.alpha) * q.alpha;
    ASSERT_EQ(violated_inequality(q) == nullptr, d > 0) << at(q);
    if (d > 0 && !(xi * zeta - q.alpha * q.alpha > 0.0)) ++unseen;
  }
  EXPECT_GT(unseen, 10);
}

TEST(Stretch, AcceptsTheWholeDomain) {
  const double smallest = std::numeric_limits<double>::min();
  for (const Stretch& q : {Stretch{0.0, 1.0, 1.0, 1.0}, Stretch{0.0, smallest, 1.0, smallest},
                           Stretch{-0.999, 1.0, 1.0, 1.0}, Stretch{0.0, 1e150, 1e150, 1e300},
                           // a determinant of 2^-104 is positive
                           Stretch{1.0, 1.0 + 0x1p-52, 1.0, 1.0}}) {
    EXPECT_EQ(violated_inequality(q), nullptr) << at(q);
    EXPECT_NO_THROW(require_positive_definite(q));
  }
}

}  // namespace
}  // namespace stationary
