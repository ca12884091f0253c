// Laws of the balance in nu-form, over every potential: it is the gradient of V - nu^T I nu / 2,
// its Jacobians are slopes, and it has the symmetries of the problem.
#include "lib/balance/balance.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int balance_trials = 25;

/// A model times a number.
template <class Model>
struct Scaled {
  Model model;
  double factor;

  template <int order, class S>
  auto evaluate(const PlanarInvariants<S>& x, const S& rho) const {
    auto out = model.template evaluate<order>(x, rho);
    for (auto* value :
         {&out.plane.w, &out.plane.w_t, &out.plane.w_l, &out.plane.w_tt, &out.plane.w_tl,
          &out.plane.w_ll, &out.w_r, &out.w_rr, &out.w_tr, &out.w_lr})
      *value *= factor;
    return out;
  }
};

template <class Model>
class BalanceTest : public ::testing::Test {};
TYPED_TEST_SUITE(BalanceTest, WholeModels, ModelName);

TYPED_TEST(BalanceTest, ResidualIsTheGradientOfTheAmendedPotential) {
  Random random(301);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector3<Real50> nu = widen_vector<Real50>(random.direction<3>());
    const Vector4<Real50> w = widen_vector<Real50>(random.direction<4>());
    const auto amended = [&](const Real50& h) {
      const auto x = BasicStretch<Real50>::from(q.vector() + w * h);
      return Real50(potential_derivatives<0>(wide, x).value -
                    nu.dot(locked_inertia(body, x) * nu) / 2);
    };
    EXPECT_TRUE(is_slope(at(text_of(model), body, q, nu), amended,
                         Real50(balance_residual(body, wide, q, nu).dot(w))));
  }
}

TYPED_TEST(BalanceTest, JacobiansAreSlopes) {
  Random random(302);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector3<Real50> nu = widen_vector<Real50>(random.direction<3>());
    const Vector4<Real50> w = widen_vector<Real50>(random.direction<4>());
    const Vector3<Real50> turn = widen_vector<Real50>(random.direction<3>());
    const std::string x = at(text_of(model), body, q, nu);
    EXPECT_TRUE(is_slope(
        x,
        [&](const Real50& h) {
          return balance_residual(body, wide, BasicStretch<Real50>::from(q.vector() + w * h), nu);
        },
        Vector4<Real50>(balance_jacobian(body, wide, q, nu) * w)));
    EXPECT_TRUE(is_slope(
        x,
        [&](const Real50& h) {
          return balance_residual(body, wide, q, Vector3<Real50>(nu + turn * h));
        },
        Vector4<Real50>(balance_jacobian_nu(body, q, nu) * turn)));
  }
}

TYPED_TEST(BalanceTest, ScalesWithInertiaAndPotentialTogether) {
  Random random(303);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector3<double> nu = random.direction<3>();
    const auto base = balance_residual(body, model, q, nu);
    // Powers of two: every number on the way scales exactly.
    const double s = std::ldexp(1.0, random.integer(-40, 40));
    const Body scaled(s * body.J1, s * body.J2, s * body.J3);
    EXPECT_EQ(balance_residual(scaled, Scaled<TypeParam>{model, s}, q, nu), (s * base).eval());
    // Time in units of s: nu -> nu/s, V -> V/s^2.
    const Vector3<double> slow = nu / s;
    EXPECT_EQ(balance_residual(body, Scaled<TypeParam>{model, 1.0 / (s * s)}, q, slow),
              (base / (s * s)).eval());
  }
}

TYPED_TEST(BalanceTest, DoesNotSeeTheSignOfNu) {
  Random random(304);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector3<double> nu = random.direction<3>();
    const Vector3<double> back = -nu;
    EXPECT_EQ(balance_residual(body, model, q, nu), balance_residual(body, model, q, back));
    EXPECT_EQ(compatibility_residual(body, q, nu), compatibility_residual(body, q, back));
  }
}

TYPED_TEST(BalanceTest, TheStraightCheckIsTheWholeOne) {
  Random random(306);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Body body = random.body();
    Stretch q = random.stretch();
    q.alpha = 0.0;
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const double nu = random.uniform(-1.0, 1.0);
      const BalanceCheck whole =
          check_balance(body, potential_derivatives<2>(model, q), q, angular_velocity(branch, nu));
      const BalanceCheck straight = check_straight_balance(
          axis_rates(body, branch, nu * nu), potential_derivatives<2, 1>(model, q), q);
      EXPECT_EQ(straight.residual, whole.residual);
      EXPECT_EQ(whole.compatibility, 0.0);
      EXPECT_EQ(straight.compatibility, 0.0);
    }
  }
}

TYPED_TEST(BalanceTest, ExchangeOfAxesOneAndTwo) {
  Random random(305);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const Body body = random.body();
    const Body exchanged(body.J2, body.J1, body.J3);
    const auto q = widen_stretch<Real50>(random.stretch());
    const BasicStretch<Real50> p{q.alpha, q.zeta, q.xi, q.rho};
    const Vector3<Real50> nu = widen_vector<Real50>(random.direction<3>());
    const Vector3<Real50> mu{nu[1], nu[0], nu[2]};
    const auto F = balance_residual(body, model, q, nu);
    const auto G = balance_residual(exchanged, model, p, mu);
    const Real50 allowed = 1e-44 * (F.norm() + 1);
    EXPECT_TRUE(all_agree<Vector4<Real50>>(at(body, q, nu), {F[0], F[2], F[1], F[3]}, G, allowed));
    // An exchange is a reflection, under which a cross product changes sign.
    const auto K = compatibility_residual(body, q, nu);
    EXPECT_TRUE(all_agree<Vector3<Real50>>(at(body, q, nu), {-K[1], -K[0], -K[2]},
                                           compatibility_residual(exchanged, p, mu), allowed));
  }
}

TYPED_TEST(BalanceTest, MaterialRotationsCarryResidualsAlongWhereTheBodyIsSymmetric) {
  Random random(306);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const Body body = random.symmetric_body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector3<Real50> nu{0, 0, random.uniform(-1.0, 1.0)};
    // The orbit's direction at q is in the kernel of nothing in general, but the residual has no
    // part along it.
    const Vector4<Real50> orbit{q.xi - q.zeta, -2 * q.alpha, 2 * q.alpha, 0};
    const auto F = balance_residual(body, model, q, nu);
    EXPECT_TRUE(agrees<Real50>(at(body, q, nu), 0, F.dot(orbit), 1e-44 * (F.norm() + 1)));
  }
}

TEST(Compatibility, VanishesForAPrincipalAxisAndOnlyThere) {
  Random random(311);
  for (int trial = 0; trial < balance_trials; ++trial) {
    const Body body = random.body();
    const Stretch straight = random.diagonal_stretch();
    const Stretch sheared = random.stretch();
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const auto nu = angular_velocity(branch, random.uniform(0.5, 1.5));
      EXPECT_EQ(compatibility_residual(body, straight, nu).norm(), 0.0);
      const double sheared_residual = compatibility_residual(body, sheared, nu).norm();
      if (branch == Branch::iii) {
        EXPECT_EQ(sheared_residual, 0.0);
      } else {
        EXPECT_GT(sheared_residual, 0.0) << at(body, sheared, nu);
      }
    }
  }
}

TEST(CheckBalance, PoisonIsReportedAndZeroIsZero) {
  const Body body(1.0, 1.7, 0.6);
  const Potential potential(Biot<>{1.0, 0.5}, Harmonic<>{1.0, 1.0});
  const Vector3<double> rest = Vector3<double>::Zero();
  const auto at_rest = check_balance(body, potential, {0.0, 1.0, 1.0, 1.0}, rest);
  EXPECT_EQ(at_rest.residual, 0.0);
  EXPECT_EQ(at_rest.compatibility, 0.0);
  const BalanceCheck not_run;
  EXPECT_TRUE(std::isnan(not_run.residual) && std::isnan(not_run.compatibility));
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(check_balance(body, potential, {0.0, nan, 1.0, 1.0}, rest).residual));
  const Vector3<double> bad{nan, 0.0, 0.0};
  const auto poisoned = check_balance(body, potential, {0.0, 1.0, 1.0, 1.0}, bad);
  EXPECT_TRUE(std::isnan(poisoned.residual));
  EXPECT_FALSE(poisoned.compatibility <= 1.0);
}

TEST(CheckBalance, CompatibilityIsRelativeToItsOwnProducts) {
  // An axis a hundred-millionth off a principal one fails as plainly as any: the products in K are
  // small together, and energy about the main axis is none of them.
  const Body body(1.0, 1.7, 0.6);
  const Potential potential(Biot<>{1.0, 0.5}, Harmonic<>{1.0, 1.0});
  const Stretch q{0.0, 1.2, 0.9, 1.0};
  const auto I = locked_inertia(body, q);
  for (const double off : {1e-2, 1e-8, 1e-14}) {
    const Vector3<double> nu{1.0, off, 0.0};
    const double expected = std::abs(I(0, 0) - I(1, 1)) / std::max(I(0, 0), I(1, 1));
    EXPECT_TRUE(agrees(at("off", off), expected,
                       check_balance(body, potential, q, nu).compatibility, 8 * 0x1p-53));
  }
}

TEST(CheckBalance, MeasuresTheDistanceFromABalance) {
  // A relative change of one stretch by delta leaves a relative residual of its order.
  const Body body(1.0, 1.7, 0.6);
  const Potential potential(ReciprocalDeterminant<>{1.0, 2.0}, ReciprocalQuadratic<>{1.0, 3.0});
  const double s = std::pow(0.5, 0.25);
  const Vector3<double> rest = Vector3<double>::Zero();
  for (const double delta : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Stretch q{0.0, s * (1.0 + delta), s, std::cbrt(1.0 / 3.0)};
    const double residual = check_balance(body, potential, q, rest).residual;
    EXPECT_GT(residual, 0.1 * delta);
    EXPECT_LT(residual, 10.0 * delta);
  }
}

TEST(Energy, IsConservedByTheLegendreTransform) {
  Random random(312);
  const Potential potential(BiotLog<>{1.0, 0.6}, ReciprocalQuadratic<>{1.0, 3.0});
  for (int trial = 0; trial < balance_trials; ++trial) {
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector3<double> nu = random.direction<3>();
    const Vector3<double> none = Vector3<double>::Zero();
    const double rotation = 0.5 * nu.dot(locked_inertia(body, q) * nu);
    const double value = potential.value(q);
    EXPECT_EQ(energy(body, potential, q, none), value);
    EXPECT_EQ(energy(body, potential, q, nu), rotation + value);
  }
}

}  // namespace
}  // namespace stationary
