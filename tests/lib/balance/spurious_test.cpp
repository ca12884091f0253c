// Balance without compatibility has more solutions, and they are not stationary motions.
//
// biot-log with mu = 1, lambda = 0.6, J = (1, 3, 0.6), branch (ii): beyond nu = 1.0968259061 the
// balance alone has a solution with alpha != 0. It must be told apart by (b).
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "lib/balance/balance.hpp"
#include "lib/balance/balance_in_momenta.hpp"
#include "lib/body/motion.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace support;

const Body body(1.0, 3.0, 0.6);
const Separable<BiotLog<>, ReciprocalQuadratic<>> model{{1.0, 0.6}, {1.0, 3.0}};
const Potential potential(model.plane, model.thickness);
constexpr double pitchfork = 1.0968259061;

/// Newton on (a) from a guess; the caller judges the result.
Stretch solve_balance_alone(Stretch q, double nu) {
  for (int step = 0; step < 60; ++step) {
    const Vector3<double> spin = angular_velocity(Branch::ii, nu);
    const Vector4<double> F = balance_residual(body, model, q, spin);
    const Vector4<double> change = balance_jacobian(body, model, q, spin).fullPivLu().solve(F);
    double damping = 1.0;
    Stretch next = Stretch::from(q.vector() - change);
    while (violated_inequality(next) != nullptr && damping > 1e-6) {
      damping *= 0.5;
      next = Stretch::from(q.vector() - damping * change);
    }
    q = next;
  }
  return q;
}

Stretch start(double alpha) { return {alpha, 1.6, 0.8, 0.75}; }

/// The sheared solution of (a), closed but for d: alpha != 0 leaves W_d = -J2 nu^2/2, and then the
/// rows in xi and zeta give zeta = xi/3 and xi (8/3 - 3 nu^2/2) = 2 for these numbers.
Stretch sheared_guess(double nu) {
  const double n = nu * nu;
  const double xi = 2.0 / (8.0 / 3.0 - 1.5 * n);
  double d = 1.0;  // 0.6 ln d / d = 2 - 3 n/2, the root below e, by Newton's method
  for (int step = 0; step < 30; ++step) {
    const double f = 0.6 * std::log(d) / d - (2.0 - 1.5 * n);
    d -= f * d * d / (0.6 * (1.0 - std::log(d)));
  }
  return {std::sqrt(xi * xi / 3.0 - d), xi, xi / 3.0, std::cbrt(1.0 / (3.0 - 0.6 * n))};
}

TEST(Spurious, BalanceAloneHasASolutionWithShearAndCompatibilityRejectsIt) {
  for (const double nu : {1.0969, 1.10, 1.12, 1.15}) {
    const Vector3<double> spin = angular_velocity(Branch::ii, nu);
    const Stretch spurious = solve_balance_alone(sheared_guess(nu), nu);
    ASSERT_EQ(violated_inequality(spurious), nullptr);
    ASSERT_GT(spurious.alpha, 0.01) << at("nu", nu, spurious);
    const auto verdict = check_balance(body, potential, spurious, spin);
    EXPECT_LT(verdict.residual, 1e-14) << at("nu", nu, spurious);
    EXPECT_GT(verdict.compatibility, 0.01) << at("nu", nu, spurious);
    EXPECT_GT(compatibility_residual(body, spurious, spin).norm(), 0.1);
    const auto momenta = steady_momenta(body, spurious, spin);
    EXPECT_GT(std::abs(momentum_compatibility(body, spurious, momenta[0], momenta[1])), 0.1);
    // The paper's equations (91)-(94) alone accept it just as well.
    EXPECT_LT(momentum_balance_residual(body, model, spurious, momenta).norm(), 1e-13);

    const Stretch straight = solve_balance_alone(start(0.0), nu);
    const auto true_verdict = check_balance(body, potential, straight, spin);
    EXPECT_EQ(straight.alpha, 0.0);
    EXPECT_LT(true_verdict.residual, 1e-14);
    EXPECT_EQ(true_verdict.compatibility, 0.0);
  }
}

TEST(Spurious, ThePitchforkIsWhereTheBalanceIsSingularInShear) {
  // At alpha = 0 the Jacobian of (a) has the row (F_alpha,alpha, 0, 0, 0), which changes sign there
  // although no stationary motion branches off.
  const auto stiffness = [](double nu) {
    const Stretch q = solve_balance_alone(start(0.0), nu);
    return balance_jacobian(body, model, q, angular_velocity(Branch::ii, nu))(0, 0);
  };
  EXPECT_GT(stiffness(pitchfork - 1e-9), 0.0);
  EXPECT_LT(stiffness(pitchfork + 1e-9), 0.0);
}

TEST(Spurious, ReciprocalDeterminantHasAWholeLineOfThem) {
  // W_d = -J2 nu^2/2 fixes d, zeta = xi/3 as above, and at nu^2 = 8 k/9 the rest holds for every
  // xi.
  const double k = 2.0;
  const double nu = 4.0 / 3.0;
  const double d = std::sqrt(1.5);
  const Potential held(ReciprocalDeterminant<>{1.0, k}, model.thickness);
  const Vector3<double> spin = angular_velocity(Branch::ii, nu);
  for (const double xi : {2.0, 2.5, 3.0, 5.0}) {
    const Stretch q{std::sqrt(xi * xi / 3.0 - d), xi, xi / 3.0,
                    std::cbrt(1.0 / (3.0 - 0.6 * nu * nu))};
    const auto verdict = check_balance(body, held, q, spin);
    EXPECT_LT(verdict.residual, 1e-14) << at(q);
    EXPECT_GT(verdict.compatibility, 0.1) << at(q);
  }
}

}  // namespace
}  // namespace stationary
