// The balance in logarithmic coordinates: each row times its stretch, and a symmetric Jacobian
// whose entries are slopes.
#include <gtest/gtest.h>

#include "lib/balance/balance.hpp"
#include "lib/number/double_double_functions.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int log_balance_trials = 25;

CentrifugalRates<Real50> rates_of(const Body& body, const Vector3<Real50>& nu) {
  return centrifugal_rates<Real50>(body, nu[0] * nu[0], nu[1] * nu[1], nu[2] * nu[2]);
}

template <class Model>
class LogBalanceTest : public ::testing::Test {};
TYPED_TEST_SUITE(LogBalanceTest, WholeModels, ModelName);

TYPED_TEST(LogBalanceTest, IsTheBalanceTimesTheStretches) {
  Random random(321);
  for (int trial = 0; trial < log_balance_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.diagonal_stretch());
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const auto nu = angular_velocity<Real50>(branch, random.uniform(-1.0, 1.0));
      const auto F = balance_residual(body, model, q, nu);
      const auto w = model.template evaluate<2>(planar_invariants(q.xi, q.zeta), q.rho);
      const auto G = coupled_log_balance<2, Real50>(w, q.xi, q.zeta, q.rho, rates_of(body, nu));
      const auto planar = planar_log_balance<2>(w.plane, q.xi, q.zeta, rates_of(body, nu));
      const Real50 allowed = 1e-44 * (1 + F.norm());
      const std::string x = at(body, q, nu);
      EXPECT_TRUE(agrees<Real50>(x, q.xi * F[1], G.g_xi, allowed));
      EXPECT_TRUE(agrees<Real50>(x, q.zeta * F[2], G.g_zeta, allowed));
      EXPECT_TRUE(agrees<Real50>(x, q.rho * F[3], G.g_rho, allowed));
      EXPECT_EQ(planar.g_xi, G.g_xi);
      EXPECT_EQ(planar.g_zeta, G.g_zeta);
      EXPECT_EQ(planar.uu, G.uu);
      EXPECT_EQ(planar.uv, G.uv);
      EXPECT_EQ(planar.vv, G.vv);
      EXPECT_FALSE(planar.g_rho == planar.g_rho) << "a planar balance has no third row";
    }
  }
}

TYPED_TEST(LogBalanceTest, JacobianIsASlope) {
  Random random(322);
  for (int trial = 0; trial < log_balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const Body body = random.body();
    const auto q = widen_stretch<Real50>(random.diagonal_stretch());
    const Vector3<Real50> nu = widen_vector<Real50>(random.direction<3>());
    const auto c = rates_of(body, nu);
    const Vector3<Real50> w = widen_vector<Real50>(random.direction<3>());
    const auto balance = [&](const Real50& h) {
      const Real50 xi = q.xi * exp(h * w[0]);
      const Real50 zeta = q.zeta * exp(h * w[1]);
      const Real50 rho = q.rho * exp(h * w[2]);
      const auto v = wide.template evaluate<2>(planar_invariants(xi, zeta), rho);
      return coupled_log_balance<2, Real50>(v, xi, zeta, rho, c);
    };
    const auto G = balance(0);
    Matrix3<Real50> J;
    J << G.uu, G.uv, G.uw, G.uv, G.vv, G.vw, G.uw, G.vw, G.ww;
    EXPECT_TRUE(is_slope(
        at(text_of(model), body, q, nu),
        [&](const Real50& h) {
          const auto there = balance(h);
          return Vector3<Real50>{there.g_xi, there.g_zeta, there.g_rho};
        },
        Vector3<Real50>(J * w)));
  }
}

/// A model's own balance in pairs of doubles has all their digits though its coefficients are
/// doubles: what is made of these alone is not rounded to one.
TYPED_TEST(LogBalanceTest, IsAsPreciseAsItsStretches) {
  Random random(323);
  for (int trial = 0; trial < log_balance_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const Stretch q = random.diagonal_stretch();
    const double c[3] = {random.uniform(0.0, 1.0), random.uniform(0.0, 1.0),
                         random.uniform(0.0, 1.0)};
    const auto got =
        model.log_balance(DoubleDouble(q.xi), DoubleDouble(q.zeta), DoubleDouble(q.rho),
                          DoubleDouble(c[0]), DoubleDouble(c[1]), DoubleDouble(c[2]));
    const auto exact = wide.log_balance(Real50(q.xi), Real50(q.zeta), Real50(q.rho), Real50(c[0]),
                                        Real50(c[1]), Real50(c[2]));
    const auto value = [](const DoubleDouble& x) { return Real50(x.hi) + Real50(x.lo); };
    const Real50 size = abs(exact.uu) + abs(exact.vv) + abs(exact.ww) + abs(exact.uv) +
                        abs(exact.g_xi) + abs(exact.g_zeta) + abs(exact.g_rho);
    for (const auto& [ours, theirs] :
         {std::pair{got.g_xi, exact.g_xi}, std::pair{got.g_zeta, exact.g_zeta},
          std::pair{got.g_rho, exact.g_rho}, std::pair{got.uu, exact.uu},
          std::pair{got.uv, exact.uv}, std::pair{got.vv, exact.vv}, std::pair{got.ww, exact.ww}})
      EXPECT_LE(abs(value(ours) - theirs), Real50(1e-29) * size) << text_of(model);
  }
}

TEST(LogBalance, SecondOrderIsNaNUnlessAskedFor) {
  const Biot<> model{1.0, 0.5};
  const auto w = model.evaluate<1>(planar_invariants(1.2, 0.9));
  const auto G = planar_log_balance<1>(w, 1.2, 0.9, CentrifugalRates<double>{0.1, 0.2, 0.3});
  EXPECT_FALSE(std::isnan(G.g_xi) || std::isnan(G.g_zeta));
  EXPECT_TRUE(std::isnan(G.uu) && std::isnan(G.uv) && std::isnan(G.vv) && std::isnan(G.ww));
}

}  // namespace
}  // namespace stationary
