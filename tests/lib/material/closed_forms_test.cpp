// Closed-form stationary motions satisfy the balance and the compatibility: the library and the
// oracles check each other.
#include "tests/support/closed_forms.hpp"

#include <gtest/gtest.h>

#include "lib/balance/balance.hpp"
#include "lib/balance/balance_in_momenta.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr Branch branches[] = {Branch::i, Branch::ii, Branch::iii};

template <class T>
void expect_stationary(const Body& body, const ReciprocalDeterminant<T>& plane,
                       const ReciprocalQuadratic<T>& thickness, const SteadyMotion<T>& motion,
                       const T& allowed) {
  const Separable<ReciprocalDeterminant<T>, ReciprocalQuadratic<T>> model{plane, thickness};
  const auto F = balance_residual(body, model, motion.q, motion.nu);
  const auto v = potential_derivatives<2>(model, motion.q);
  const T scale = (v.hessian * motion.q.vector().asDiagonal()).cwiseAbs().maxCoeff();
  const std::string x = at(body, motion.q, motion.nu);
  EXPECT_TRUE(all_agree<Vector4<T>>(x, Vector4<T>::Zero(), F, allowed * scale));
  const auto K = compatibility_residual(body, motion.q, motion.nu);
  const T pi = (locked_inertia(body, motion.q) * motion.nu).norm() * motion.nu.norm();
  EXPECT_TRUE(all_agree<Vector3<T>>(x, Vector3<T>::Zero(), K, allowed * pi));
}

TEST(ReciprocalDeterminantSolution, IsStationaryOnEveryBranchUpToItsLimit) {
  Random random(801);
  for (int trial = 0; trial < 30; ++trial) {
    const Body body = random.body();
    const auto plane = random.coefficients<ReciprocalDeterminant<>>();
    const auto thickness = random.coefficients<ReciprocalQuadratic<>>();
    const ReciprocalDeterminantSolution<Real50> solution(body, widen<Real50>(plane),
                                                         widen<Real50>(thickness));
    for (const Branch branch : branches) {
      const Real50 limit = solution.limit(branch);
      for (const char* fraction : {"0", "0.1", "-0.5", "0.9", "0.999999"}) {
        const auto motion = solution.on(branch, Real50(limit * Real50(fraction)));
        ASSERT_TRUE(motion);
        expect_stationary<Real50>(body, widen<Real50>(plane), widen<Real50>(thickness), *motion,
                                  Real50("1e-40"));
      }
      EXPECT_FALSE(solution.on(branch, Real50(limit * Real50("1.000001"))));
    }
  }
}

TEST(ReciprocalDeterminantSolution, IsStationaryInDoubles) {
  Random random(802);
  for (int trial = 0; trial < 50; ++trial) {
    const Body body = random.body();
    const auto plane = random.coefficients<ReciprocalDeterminant<>>();
    const auto thickness = random.coefficients<ReciprocalQuadratic<>>();
    const ReciprocalDeterminantSolution<double> solution(body, plane, thickness);
    const Potential potential(plane, thickness);
    for (const Branch branch : branches) {
      const double nu = random.uniform(0.0, 0.95) * solution.limit(branch);
      const auto motion = solution.on(branch, nu);
      ASSERT_TRUE(motion);
      const auto check = check_balance(body, potential, motion->q, motion->nu);
      EXPECT_LT(check.residual, 32 * 0x1p-53) << at(body, motion->q, motion->nu);
      EXPECT_EQ(check.compatibility, 0.0);
    }
  }
}

TEST(ReciprocalDeterminantSolution, IsAtTheRestStretchWithoutRotation) {
  const Body body(1.0, 1.7, 0.6);
  const ReciprocalDeterminant<> plane{0.7, 2.0};
  const ReciprocalDeterminantSolution<double> solution(body, plane, {1.0, 3.0});
  for (const Branch branch : branches) {
    const auto motion = solution.on(branch, 0.0);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->q.xi, plane.rest_stretch(), 4e-16);
    EXPECT_NEAR(motion->q.zeta, plane.rest_stretch(), 4e-16);
  }
}

TEST(ReciprocalDeterminantSolution, TiltsWhereTwoInertiasAreEqual) {
  // Joins (i) to (iii) for these numbers.
  const Body body(1.0, 1.7, 0.6);
  const ReciprocalDeterminant<Real50> plane{1, 2};
  const ReciprocalQuadratic<Real50> thickness{1, 3};
  const ReciprocalDeterminantSolution<Real50> solution(body, plane, thickness);
  int found = 0;
  for (int step = 1; step < 40; ++step) {
    const Real50 nu3 = Real50(step) / 40;
    const auto motion = solution.tilted(nu3);
    if (!motion) continue;
    ++found;
    expect_stationary<Real50>(body, plane, thickness, *motion, Real50("1e-40"));
    const auto I = locked_inertia(body, motion->q);
    EXPECT_TRUE(agrees<Real50>(at("nu3", nu3), I(0, 0), I(2, 2), Real50("1e-40")));
    EXPECT_GT(motion->nu[0], 0);
    EXPECT_EQ(motion->nu[2], nu3);
  }
  EXPECT_GT(found, 5);
}

TEST(ReciprocalDeterminantSolution, IsStationaryInTheMomentumFormToo) {
  const Body body(1.3, 0.8, 0.5);
  const ReciprocalDeterminant<Real50> plane{1, 2};
  const ReciprocalQuadratic<Real50> thickness{1, 3};
  const Separable<ReciprocalDeterminant<Real50>, ReciprocalQuadratic<Real50>> model{plane,
                                                                                    thickness};
  const ReciprocalDeterminantSolution<Real50> solution(body, plane, thickness);
  for (const Branch branch : branches) {
    const auto motion = solution.on(branch, Real50("0.8"));
    ASSERT_TRUE(motion);
    const auto momenta = steady_momenta(body, motion->q, motion->nu);
    const auto N = momentum_balance_residual(body, model, motion->q, momenta);
    EXPECT_TRUE(all_agree<Vector4<Real50>>(at(body, motion->q), Vector4<Real50>::Zero(), N,
                                           Real50("1e-44")));
    EXPECT_EQ(momentum_compatibility(body, motion->q, momenta[0], momenta[1]), 0);
  }
}

TEST(HenckyFold, IsABalanceWithASingularJacobian) {
  Random random(803);
  for (int trial = 0; trial < 30; ++trial) {
    const Body body = random.body();
    const auto narrow = random.coefficients<Hencky<>>();
    const auto model = widen<Real50>(narrow);
    const HenckyFold<Real50> fold(body.J2, model.mu, model.lambda);
    const auto w = model.evaluate<2>(planar_invariants(fold.xi, fold.zeta));
    const auto rates = centrifugal_rates<Real50>(body, fold.nu_squared, Real50(0), Real50(0));
    const auto G = planar_log_balance<2>(w, fold.xi, fold.zeta, rates);
    const Real50 scale = 10 * (model.mu + abs(model.lambda));
    const std::string x = at(text_of(narrow), body);
    EXPECT_TRUE(agrees<Real50>(x, 0, G.g_xi, 1e-44 * scale));
    EXPECT_TRUE(agrees<Real50>(x, 0, G.g_zeta, 1e-44 * scale));
    EXPECT_TRUE(agrees<Real50>(x, 0, G.uu * G.vv - G.uv * G.uv, 1e-42 * scale * scale));
    // A fold and not a second zero of the whole matrix.
    EXPECT_GT(G.uu, 0);
  }
}

}  // namespace
}  // namespace stationary
