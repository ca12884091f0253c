// Laws of the kinetic energy: T = v^T M v / 2 is positive, its rotational part is q^T C q / 2, and
// the closed-form inverse Legendre transform is the inverse.
#include "lib/body/inertia.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "lib/balance/balance_in_momenta.hpp"
#include "lib/body/motion.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int inertia_trials = 100;

/// T of a motion from its definition: T = tr(Phi' diag(J) Phi'^T)/2 with Phi = L S, and so
/// tr((N S + S') diag(J) (N S + S')^T)/2 with N = L^-1 L'.
template <class S>
S kinetic_energy_from_definition(const Body& body, const BasicStretch<S>& q, const Vector7<S>& v) {
  Matrix3<S> N;
  N << S(0), v[2], -v[1], -v[2], S(0), v[0], v[1], -v[0], S(0);
  Matrix3<S> stretch;
  stretch << q.xi, q.alpha, S(0), q.alpha, q.zeta, S(0), S(0), S(0), q.rho;
  Matrix3<S> rate;
  rate << v[4], v[3], S(0), v[3], v[5], S(0), S(0), S(0), v[6];
  const Matrix3<S> A = N * stretch + rate;
  const double J[3] = {body.J1, body.J2, body.J3};
  S sum = S(0);
  for (int column = 0; column < 3; ++column) sum += J[column] * A.col(column).squaredNorm();
  return sum / 2;
}

TEST(Inertia, MassMatrixIsTheKineticEnergy) {
  Random random(201);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector7<Real50> v = widen_vector<Real50>(random.direction<7>());
    const Real50 expected = kinetic_energy_from_definition(body, q, v);
    EXPECT_TRUE(agrees<Real50>(at(body, q, v), expected, v.dot(mass_matrix(body, q) * v) / 2,
                               1e-45 * expected));
  }
}

TEST(Inertia, KineticEnergyInTheMomentaIsTheSame) {
  Random random(202);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector7<Real50> v = widen_vector<Real50>(random.direction<7>());
    const Real50 expected = v.dot(mass_matrix(body, q) * v) / 2;
    EXPECT_TRUE(agrees<Real50>(at(body, q, v), expected,
                               kinetic_energy(body, q, legendre(body, q, v)), 1e-44 * expected));
  }
}

TEST(Inertia, InverseLegendreIsTheInverse) {
  Random random(203);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector7<Real50> v = widen_vector<Real50>(random.direction<7>());
    const std::string x = at(body, q, v);
    EXPECT_TRUE(all_agree<Vector7<Real50>>(x, v, inverse_legendre(body, q, legendre(body, q, v)),
                                           Real50("1e-43")));
    EXPECT_TRUE(all_agree<Vector7<Real50>>(x, v, legendre(body, q, inverse_legendre(body, q, v)),
                                           Real50("1e-43")));
  }
}

TEST(Inertia, MassMatrixIsSymmetricPositiveDefinite) {
  Random random(204);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body(100.0);
    const auto M = mass_matrix(body, widen_stretch<Real50>(random.stretch(100.0)));
    EXPECT_EQ(M, M.transpose().eval());
    const Eigen::LDLT<Matrix7<Real50>> factors(M);
    EXPECT_GT(factors.vectorD().minCoeff(), 0) << at(body);
  }
}

TEST(Inertia, RotationalEnergyInBothForms) {
  Random random(205);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector3<Real50> nu = widen_vector<Real50>(random.direction<3>());
    const Real50 expected = nu.dot(locked_inertia(body, q) * nu);
    const Vector4<Real50> x = q.vector();
    EXPECT_TRUE(agrees<Real50>(at(body, q, nu), expected, x.dot(centrifugal_matrix(body, nu) * x),
                               1e-45 * expected));
  }
}

TEST(Inertia, CentrifugalRatesAreTheDiagonal) {
  Random random(206);
  const Body body = random.body();
  const Vector3<double> nu = random.direction<3>();
  const auto C = centrifugal_matrix(body, nu);
  const auto rates = centrifugal_rates(body, nu[0] * nu[0], nu[1] * nu[1], nu[2] * nu[2]);
  EXPECT_EQ(C(1, 1), rates.xi);
  EXPECT_EQ(C(2, 2), rates.zeta);
  EXPECT_EQ(C(3, 3), rates.rho);
  EXPECT_EQ(C, C.transpose().eval());
}

TEST(Inertia, SteadyMomentaAreThoseOfARotationAlone) {
  Random random(207);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector3<double> nu = random.direction<3>();
    const auto m = steady_momenta(body, q, nu);
    const Vector3<double> pi = locked_inertia(body, q) * nu;
    const Vector3<double> p = gyroscopic_coupling(body, q) * nu[2];
    const double scale = 4 * 0x1p-53 * locked_inertia(body, q).norm();
    EXPECT_TRUE(all_agree<Vector3<double>>(at(body, q, nu), pi, m.head<3>(), scale));
    EXPECT_TRUE(all_agree<Vector3<double>>(at(body, q, nu), p, m.segment<3>(3), scale));
    EXPECT_EQ(m[6], 0.0);
  }
}

TEST(Inertia, SteadyMomentaJacobianIsASlope) {
  Random random(208);
  for (int trial = 0; trial < inertia_trials; ++trial) {
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector3<Real50> nu = widen_vector<Real50>(random.direction<3>());
    const Vector4<Real50> w = widen_vector<Real50>(random.direction<4>());
    EXPECT_TRUE(is_slope(
        at(body, q, nu),
        [&](const Real50& h) {
          return steady_momenta(body, BasicStretch<Real50>::from(q.vector() + w * h), nu);
        },
        Vector7<Real50>(steady_momenta_jacobian(body, q, nu) * w)));
  }
}

TEST(Motion, BranchesAreNamedAndAlongTheirAxes) {
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    EXPECT_EQ(branch_from_name(name(branch)), branch);
    const auto nu = angular_velocity(branch, -0.7);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(nu[k], k == axis(branch) ? -0.7 : 0.0);
  }
  EXPECT_EQ(name(Branch::i), "i");
  EXPECT_EQ(name(Branch::ii), "ii");
  EXPECT_EQ(name(Branch::iii), "iii");
  EXPECT_EQ(branch_from_name("iv"), std::nullopt);
  EXPECT_EQ(branch_from_name(""), std::nullopt);
  EXPECT_EQ(branch_from_name("I"), std::nullopt);
}

}  // namespace
}  // namespace stationary
