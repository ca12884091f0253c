// The paper's momentum form (91)-(98): it agrees with the nu-form when the momenta are those of the
// steady rotation, and its right sides are -dT/dq at any fixed momenta.
#include "lib/balance/balance_in_momenta.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <vector>

#include "lib/body/motion.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/running_error.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int momenta_trials = 50;

/// Each branch, and any direction.
std::vector<Vector3<double>> spins(Random& random) {
  return {angular_velocity(Branch::i, random.uniform(-1.5, 1.5)),
          angular_velocity(Branch::ii, random.uniform(-1.5, 1.5)),
          angular_velocity(Branch::iii, random.uniform(-1.5, 1.5)),
          {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0},
          random.direction<3>()};
}

template <class Model>
class MomentumFormTest : public ::testing::Test {};
TYPED_TEST_SUITE(MomentumFormTest, WholeModels, ModelName);

TYPED_TEST(MomentumFormTest, AgreesWithTheNuForm) {
  Random random(401);
  for (int trial = 0; trial < momenta_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const Body body = random.body();
    const Stretch narrow = trial % 2 == 0 ? random.stretch() : random.diagonal_stretch();
    const auto q = widen_stretch<Real50>(narrow);
    for (const auto& spin : spins(random)) {
      const Vector3<Real50> nu = widen_vector<Real50>(spin);
      const auto F = balance_residual(body, wide, q, nu);
      const auto N = momentum_balance_residual(body, wide, q, steady_momenta(body, q, nu));
      EXPECT_TRUE(all_agree<Vector4<Real50>>(at(text_of(model), body, q, nu), F, N,
                                             1e-43 * (1 + F.norm())));
    }
  }
}

TYPED_TEST(MomentumFormTest, AgreesInDoublesToTheRoundingOfItsTerms) {
  Random random(402);
  for (int trial = 0; trial < momenta_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Body body = random.body();
    const Stretch narrow = trial % 2 == 0 ? random.stretch() : random.diagonal_stretch();
    const BasicStretch<BoundedDouble> q{narrow.alpha, narrow.xi, narrow.zeta, narrow.rho};
    for (const auto& spin : spins(random)) {
      const Vector3<BoundedDouble> nu{spin[0], spin[1], spin[2]};
      const auto F = balance_residual(body, model, q, nu);
      const auto N = momentum_balance_residual(body, model, q, steady_momenta(body, q, nu));
      for (int k = 0; k < 4; ++k) {
        EXPECT_TRUE(agrees(at(text_of(model), body, narrow, spin, "row", k), F[k].value, N[k].value,
                           0x1p-53 * (F[k].bound + N[k].bound)));
      }
    }
  }
}

/// T at fixed momenta as a Jet in q, in doubles.
Vector4<double> minus_energy_slope(const Body& body, const Stretch& q, const Vector7<double>& m) {
  using Jet = ceres::Jet<double, 4>;
  const BasicStretch<Jet> jets{Jet(q.alpha, 0), Jet(q.xi, 1), Jet(q.zeta, 2), Jet(q.rho, 3)};
  Vector7<Jet> momenta;
  for (int k = 0; k < 7; ++k) momenta[k] = Jet(m[k]);
  return -kinetic_energy(body, jets, momenta).v;
}

TEST(MomentumForm, ForcesAreMinusTheSlopeOfTheKineticEnergy) {
  Random random(403);
  for (int trial = 0; trial < 4 * momenta_trials; ++trial) {
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector7<double> m = random.direction<7>();
    const Vector4<double> actual =
        in_plane_force(body, q, m[0], m[1]) + axial_force<double>(body, q, m[2], m.segment<3>(3));
    const Vector4<double> expected = minus_energy_slope(body, q, m);
    const double scale = 1.0 + expected.norm();
    EXPECT_TRUE(all_agree(at(body, q, m), expected, actual, 1e-12 * scale));
  }
}

TEST(MomentumForm, EachPartIsTheSlopeOfItsOwnEnergy) {
  Random random(404);
  for (int trial = 0; trial < momenta_trials; ++trial) {
    const Body body = random.body();
    const Stretch q = random.stretch();
    Vector7<double> in_plane = Vector7<double>::Zero();
    in_plane.head<2>() = random.direction<2>();
    Vector7<double> axial = random.direction<7>();
    axial.head<2>().setZero();
    const Vector4<double> plane = minus_energy_slope(body, q, in_plane);
    const Vector4<double> axis = minus_energy_slope(body, q, axial);
    EXPECT_TRUE(all_agree(at(body, q, in_plane), plane,
                          in_plane_force(body, q, in_plane[0], in_plane[1]),
                          1e-12 * (1.0 + plane.norm())));
    EXPECT_TRUE(all_agree(at(body, q, axial), axis,
                          axial_force<double>(body, q, axial[2], axial.segment<3>(3)),
                          1e-12 * (1.0 + axis.norm())));
  }
}

TEST(MomentumForm, InertiaDeterminantIsTheDeterminant) {
  Random random(405);
  for (int trial = 0; trial < momenta_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const auto I = locked_inertia(body, q);
    const Real50 expected = I(0, 0) * I(1, 1) - I(0, 1) * I(0, 1);
    EXPECT_TRUE(agrees<Real50>(at(body, q), expected, inertia_determinant(body, q),
                               1e-44 * I(0, 0) * I(1, 1)));
  }
}

TEST(MomentumForm, CompatibilityIsPlusOnBranchOneAndMinusOnBranchTwo) {
  Random random(406);
  for (int trial = 0; trial < momenta_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Real50 nu = random.uniform(0.2, 2.0);
    const Real50 size =
        (body.J1 * q.xi + body.J2 * q.zeta) * q.alpha * inertia_determinant(body, q) * (nu * nu);
    for (const Branch branch : {Branch::i, Branch::ii}) {
      const Vector3<Real50> pi = locked_inertia(body, q) * angular_velocity(branch, nu);
      const Real50 expected = branch == Branch::i ? size : Real50(-size);
      EXPECT_NE(expected, 0);
      EXPECT_TRUE(agrees<Real50>(at(body, q, "branch", name(branch), "nu", nu), expected,
                                 momentum_compatibility(body, q, pi[0], pi[1]),
                                 1e-42 * abs(expected)));
    }
  }
}

TEST(MomentumForm, CompatibilityIsTheDeterminantTimesTheNuForm) {
  // For any in-plane nu: with pi = I nu, the paper's left side is Xi times a component of nu x pi
  // up to sign, since both are quadratic forms with the same kernel.
  Random random(407);
  for (int trial = 0; trial < momenta_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector3<Real50> nu{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0};
    const Vector3<Real50> pi = locked_inertia(body, q) * nu;
    const Real50 expected = inertia_determinant(body, q) * compatibility_residual(body, q, nu)[2];
    const Real50 scale = inertia_determinant(body, q) * pi.norm() * nu.norm();
    EXPECT_TRUE(agrees<Real50>(at(body, q, nu), expected,
                               momentum_compatibility(body, q, pi[0], pi[1]), 1e-42 * scale));
  }
}

}  // namespace
}  // namespace stationary
