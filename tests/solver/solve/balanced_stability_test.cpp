// What the balanced blocks add to the block spectrum: digits where entries cancel, and the same
// digits in any units.
#include <gtest/gtest.h>

#include "solver/solve/stability.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/bodies/random_problem.hpp"

namespace stationary {
namespace {

using namespace testing;

Equilibrium known(const Problem& problem, Stretch q, double nu, double error_bound) {
  Equilibrium out;
  out.status = SolveStatus::solved;
  out.q = q;
  out.nu = angular_velocity(problem.branch(), nu);
  out.error_bound = error_bound;
  return out;
}

struct OddPair {
  double small;
  double large;
};

/// Of the axis, near a state of rest that is no circle: V_aa is next to nothing, a difference of
/// terms of order one from V, and a quotient from the balance. Exact: in 60 digits.
void expect_odd(const Problem& problem, const Equilibrium& at, const OddPair& exact) {
  const Spectrum spectrum = stability(problem, at);
  int found = 0;
  for (const Mode& mode : modes(spectrum)) {
    if (mode.block != Block::odd) continue;
    ++found;
    const double expected = mode.lambda_re > 0.0 ? exact.small : exact.large;
    EXPECT_NEAR(mode.lambda_re, expected, mode.lambda_error) << spectrum;
    EXPECT_NEAR(mode.lambda_re, expected, 2e-14 * std::abs(expected)) << spectrum;
    EXPECT_LT(mode.lambda_error, 1e-9 * std::abs(expected)) << spectrum;
  }
  EXPECT_EQ(found, 2);
}

TEST(BalancedStability, KeepsDigitsWhereEntriesCancel) {
  const PotentialName biot_log{"biot-log", "reciprocal-quadratic"};
  const Problem second(Body(0.0047243963264668124, 0.0047245481213650702, 3958.9136122313384),
                       named_potential(biot_log, {0.27277113833566025, -0.094133145392371873},
                                       {5.0080133522360422, 4.7129476717994674}),
                       Branch::ii);
  expect_odd(second,
             known(second, {0.0, 0.57970880405915171, 0.42029119594114989, 1.0204481800256295},
                   4.0643540111263592e-06, 2.22e-15),
             {3.4788570528345036718e-16, -5.3126322796490906533e-11});
}

/// Powers of two: nothing is rounded.
TEST(BalancedStability, IsTheSameInOtherUnits) {
  support::Random random(77);
  const auto scaled = [](const std::array<double, 2>& c, int energy) {
    return std::array<double, 2>{std::ldexp(c[0], energy), std::ldexp(c[1], energy)};
  };
  for (const std::string_view model : {"neo-hookean", "biot", "reciprocal-determinant"}) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const std::array<double, 2> plane{random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
      const std::array<double, 2> axial{random.uniform(0.5, 2.0), random.uniform(2.0, 4.0)};
      const PotentialName potential{model, "reciprocal-quadratic"};
      const Body body(1.0, random.uniform(0.5, 2.0), random.uniform(0.3, 2.0));
      const double nu = random.uniform(0.05, 0.3);
      const Problem problem(body, named_potential(potential, plane, axial), branch);
      const Equilibrium at = solve(problem, nu);
      ASSERT_EQ(at.status, SolveStatus::solved);
      const Spectrum plain = stability(problem, known(problem, at.q, nu, at.error_bound));
      for (const auto& [inertia, energy] :
           {std::pair{40, 0}, {0, -60}, {-200, 0}, {0, 200}, {-100, 100}, {180, 180}}) {
        const Problem other(
            Body(std::ldexp(body.J1, inertia), std::ldexp(body.J2, inertia),
                 std::ldexp(body.J3, inertia)),
            named_potential(potential, scaled(plane, energy), scaled(axial, energy)), branch);
        const int rate = (energy - inertia) / 2;
        const Spectrum spectrum =
            stability(other, known(other, at.q, std::ldexp(nu, rate), at.error_bound));
        EXPECT_EQ(spectrum.verdict, plain.verdict);
        EXPECT_EQ(spectrum.negative, plain.negative);
        for (std::size_t k = 0; k < 5; ++k) {
          EXPECT_EQ(spectrum.mode[k].lambda_re, std::ldexp(plain.mode[k].lambda_re, 2 * rate));
          EXPECT_EQ(spectrum.mode[k].lambda_error,
                    std::ldexp(plain.mode[k].lambda_error, 2 * rate));
          EXPECT_EQ(spectrum.mode[k].re, std::ldexp(plain.mode[k].re, rate));
          EXPECT_EQ(spectrum.mode[k].im, std::ldexp(plain.mode[k].im, rate));
          EXPECT_EQ(spectrum.mode[k].krein, plain.mode[k].krein);
        }
      }
    }
  }
}

/// The unrounded q, as the solve has told it, is what another correction would find, and is not
/// asked once q is another.
TEST(BalancedStability, TakesTheSolvesUnroundedStretches) {
  support::Random random(78);
  int told = 0;
  for (int k = 0; k < 300; ++k) {
    const Posed posed = random_problem(random, 2.0);
    const Equilibrium at = solve(posed.problem, posed.nu);
    if (at.status != SolveStatus::solved || !at.unrounded) continue;
    ++told;
    Equilibrium without = known(posed.problem, at.q, posed.nu, at.error_bound);
    const Spectrum again = stability(posed.problem, without);
    const Spectrum spectrum = stability(posed.problem, at);
    EXPECT_EQ(spectrum.verdict, again.verdict) << posed.text;
    EXPECT_EQ(spectrum.negative, again.negative) << posed.text;
    for (std::size_t i = 0; i < 5; ++i) {
      const Mode& one = spectrum.mode[i];
      const Mode& other = again.mode[i];
      EXPECT_NEAR(one.lambda_re, other.lambda_re,
                  0x1p-51 * std::abs(other.lambda_re) + 1e-3 * other.lambda_error)
          << posed.text;
      EXPECT_EQ(one.krein, other.krein) << posed.text;
    }
    without.unrounded = at.unrounded;
    without.unrounded->zeta = at.unrounded->xi;
    if (at.q.zeta == at.q.xi) continue;
    const Spectrum kept = stability(posed.problem, without);
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_EQ(kept.mode[i].lambda_re, again.mode[i].lambda_re) << posed.text;
  }
  EXPECT_GT(told, 150);
}

/// J1 = J2 near rest: xi - zeta is below its error, and the sign of the energy is not asked of it.
TEST(BalancedStability, SymmetryWhereTheStretchesAreOne) {
  const Problem problem(
      Body(0.00022897432419329702, 0.00022897432419329702, 9305.6808231726955),
      named_potential({"saint-venant-kirchhoff", "reciprocal-quadratic"}, {0.5, 1.0}), Branch::ii);
  const Spectrum spectrum = stability(problem, solve(problem, 1.1409227856270139e-06));
  EXPECT_EQ(spectrum.verdict, StabilityClass::stable) << spectrum;
  EXPECT_EQ(spectrum.negative, 0);
  int odd = 0;
  for (const Mode& mode : modes(spectrum))
    if (mode.block == Block::odd && !mode.forced_zero) odd += mode.krein;
  EXPECT_EQ(odd, 1) << spectrum;
}

/// A bound is u times a condition number, to first order, and what the answer itself is rounded by.
TEST(BalancedStability, BoundsHoldTheRoundingBesideTheInputs) {
  support::Random random(79);
  int compared = 0;
  for (const PotentialName& name : potential_names()) {
    if (name.thickness.empty()) continue;
    for (const Branch branch : branches) {
      const SolvedMotion motion = random_motion(random, name, branch, false);
      const auto at_uncertainty = [&](double u) {
        return stability(motion.problem, known(motion.problem, motion.at.q, motion.nu(), u));
      };
      const Spectrum once = at_uncertainty(0x1p-50);
      const Spectrum twice = at_uncertainty(0x1p-49);
      for (std::size_t k = 0; k < 5; ++k) {
        const double half_a_unit = 0x1p-53 * std::abs(once.mode[k].lambda_re);
        const double rounding = 2.0 * once.mode[k].lambda_error - twice.mode[k].lambda_error;
        if (once.mode[k].lambda_im != 0.0 || once.mode[k].forced_zero) continue;
        ++compared;
        EXPECT_GE(rounding, 0.99 * half_a_unit) << motion.text << once;
      }
    }
  }
  EXPECT_GE(compared, 80);
}

/// Where all inertias are equal Lambda of pi1, pi2 is a product of two zeros, and all of its error of second
/// order: on a circle and off it.
TEST(BalancedStability, EqualInertiasAreBoundedToSecondOrder) {
  for (const auto& J : {std::array{1.0, 1.0, 1.0}, std::array{1.0, 1.21, 0.64}}) {
    const Problem problem(Body(J[0], J[1], J[2]),
                          named_potential({"hencky", "harmonic"}, {0.5, 0.5}, {3.0, 1.0}),
                          Branch::iii);
    const std::array<double, 3> x{1.1 / std::sqrt(J[0]), 1.1 / std::sqrt(J[1]),
                                  1.1 / std::sqrt(J[2])};
    constexpr double nu = 0.6;
    for (const double off : {1e-9, 1e-12}) {
      const Spectrum spectrum =
          stability(problem, known(problem, {0.0, x[0], x[1], x[2]}, nu, off));
      // rho off by that: I3 - I1 and I3 - I2 are 2 off of what I1 and I2 are twice of.
      const double moved = nu * nu * off * off;
      int found = 0;
      for (const Mode& mode : modes(spectrum)) {
        if (mode.block != Block::odd) continue;
        ++found;
        EXPECT_GE(mode.lambda_error + std::abs(mode.lambda_re), 0.99 * moved) << spectrum;
      }
      EXPECT_EQ(found, 1);
    }
  }
}

}  // namespace
}  // namespace stationary
