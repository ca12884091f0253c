// Laws of the two-polar family, over every potential: its Jacobian is a slope, rates and momenta
// state one balance, Jacobi's duality, and without internal rotation it is branch (iii).
#include "lib/balance/two_polar.hpp"

#include <gtest/gtest.h>

#include "lib/balance/balance.hpp"
#include "lib/body/motion.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int two_polar_trials = 40;

struct State {
  double J;
  Vector3<Real50> x;
  Real50 omega;
  Real50 theta_dot;

  explicit State(Random& random)
      : J(random.log_uniform(0.25, 4.0)),
        x(widen_stretch<Real50>(random.diagonal_stretch()).vector().template tail<3>()),
        omega(random.uniform(-1.5, 1.5)),
        theta_dot(random.uniform(-1.5, 1.5)) {}

  std::string text() const { return at("J", J, x, "omega", omega, "theta'", theta_dot); }
};

template <class Model>
class TwoPolarTest : public ::testing::Test {};
TYPED_TEST_SUITE(TwoPolarTest, WholeModels, ModelName);

TYPED_TEST(TwoPolarTest, JacobianIsASlope) {
  Random random(1001);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const State s(random);
    const Vector3<Real50> w = widen_vector<Real50>(random.direction<3>());
    const Matrix3<Real50> jacobian = two_polar_jacobian(s.J, model, s.x, s.omega, s.theta_dot);
    EXPECT_EQ(jacobian, jacobian.transpose().eval());
    EXPECT_TRUE(is_slope(
        s.text(),
        [&](const Real50& h) {
          return two_polar_residual(s.J, model, Vector3<Real50>(s.x + w * h), s.omega, s.theta_dot);
        },
        Vector3<Real50>(jacobian * w)));
  }
}

TYPED_TEST(TwoPolarTest, RatesAndMomentaStateOneBalance) {
  Random random(1002);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const State s(random);
    const auto in_rates = two_polar_residual(s.J, model, s.x, s.omega, s.theta_dot);
    const auto in_momenta = two_polar_momentum_residual(
        s.J, model, s.x, two_polar_momenta(s.J, s.x, s.omega, s.theta_dot));
    EXPECT_TRUE(
        all_agree<Vector3<Real50>>(s.text(), in_rates, in_momenta, 1e-40 * (1 + in_rates.norm())));
  }
}

TYPED_TEST(TwoPolarTest, MomentumBalanceIsTheSlopeOfTheEnergy) {
  // V + T at fixed momenta, T from its definition.
  Random random(1003);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const State s(random);
    const auto momenta = two_polar_momenta(s.J, s.x, s.omega, s.theta_dot);
    const Vector3<Real50> w = widen_vector<Real50>(random.direction<3>());
    const auto energy = [&](const Real50& h) {
      const Vector3<Real50> x = s.x + w * h;
      const Real50 sum = x[0] + x[1];
      const Real50 difference = x[0] - x[1];
      const Real50 plus = momenta.s3 + momenta.p_theta;
      const Real50 minus = momenta.s3 - momenta.p_theta;
      const Real50 v =
          potential_derivatives<0>(model, BasicStretch<Real50>{Real50(0), x[0], x[1], x[2]}).value;
      return Real50(v + plus * plus / (4 * s.J * sum * sum) +
                    minus * minus / (4 * s.J * difference * difference));
    };
    const auto residual = two_polar_momentum_residual(s.J, model, s.x, momenta);
    EXPECT_TRUE(is_slope(s.text(), energy, Real50(residual.dot(w))));
  }
}

TYPED_TEST(TwoPolarTest, ExchangeOfTheRatesKeepsTheBalance) {
  Random random(1004);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const double J = random.log_uniform(0.25, 4.0);
    const Vector3<double> x = random.diagonal_stretch().vector().tail<3>();
    const double omega = random.uniform(-1.5, 1.5);
    const double theta_dot = random.uniform(-1.5, 1.5);
    EXPECT_EQ(two_polar_residual(J, model, x, omega, theta_dot),
              two_polar_residual(J, model, x, theta_dot, omega));
    const auto there = two_polar_momenta(J, x, omega, theta_dot);
    const auto back = two_polar_momenta(J, x, theta_dot, omega);
    EXPECT_EQ(there.s3, back.p_theta);
    EXPECT_EQ(there.p_theta, back.s3);
  }
}

TYPED_TEST(TwoPolarTest, ExchangeOfTheStretchesExchangesTheRows) {
  Random random(1005);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const State s(random);
    const auto r = two_polar_residual(s.J, model, s.x, s.omega, s.theta_dot);
    const auto exchanged = two_polar_residual(s.J, model, Vector3<Real50>{s.x[1], s.x[0], s.x[2]},
                                              s.omega, s.theta_dot);
    EXPECT_TRUE(all_agree<Vector3<Real50>>(s.text(), {r[1], r[0], r[2]}, exchanged,
                                           1e-44 * (1 + r.norm())));
  }
}

TYPED_TEST(TwoPolarTest, IsTheBalanceInTheInvariants) {
  // R_lambda = W_t + mu W_d - ..., so off the circle the rows combine to
  //   W_t = J t (omega^2 + theta'^2),  W_d = -J (omega - theta')^2.
  Random random(1006);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const State s(random);
    const auto x = planar_invariants(s.x[0], s.x[1]);
    const auto w = model.template evaluate<1>(x, s.x[2]).plane;
    const auto r = two_polar_residual(s.J, model, s.x, s.omega, s.theta_dot);
    const Real50 squares = s.omega * s.omega + s.theta_dot * s.theta_dot;
    const Real50 difference = s.omega - s.theta_dot;
    const Real50 in_t = w.w_t - s.J * x.t * squares;
    const Real50 in_d = w.w_l / x.d + s.J * (difference * difference);
    const Real50 gap = s.x[0] - s.x[1];
    const Real50 allowed = 1e-43 * (1 + r.norm());
    EXPECT_TRUE(agrees<Real50>(s.text(), gap * in_d, r[1] - r[0], allowed));
    EXPECT_TRUE(agrees<Real50>(s.text(), gap * in_t, s.x[0] * r[0] - s.x[1] * r[1], allowed));
  }
}

TEST(TwoPolar, RatesAreTheInverseOfTheMomenta) {
  Random random(1009);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const State s(random);
    const auto rates = two_polar_rates(s.J, s.x, two_polar_momenta(s.J, s.x, s.omega, s.theta_dot));
    EXPECT_TRUE(agrees<Real50>(s.text(), s.omega, rates.omega, Real50("1e-40")));
    EXPECT_TRUE(agrees<Real50>(s.text(), s.theta_dot, rates.theta_dot, Real50("1e-40")));
  }
}

TEST(TwoPolar, KineticEnergyIsHalfTheMomentaTimesTheRates) {
  Random random(1011);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    State s(random);
    if (trial % 4 == 0) s.x[1] = s.x[0];  // the circle, which has rates but no formula in momenta
    const auto m = two_polar_momenta(s.J, s.x, s.omega, s.theta_dot);
    const Real50 expected = (m.s3 * s.omega + m.p_theta * s.theta_dot) / 2;
    EXPECT_TRUE(agrees<Real50>(
        s.text(), expected,
        two_polar_kinetic_energy(s.J, s.x, TwoPolarRates<Real50>{s.omega, s.theta_dot}),
        Real50("1e-44")));
  }
}

/// The pull's second derivatives as slopes in the logarithms, its rows against `force`.
template <class Motion>
void expect_pull(const State& s, const Motion& motion, const Vector3<Real50>& force,
                 const Vector3<Real50>& w) {
  const auto pull = [&](const Real50& h) {
    return two_polar_pull(s.J, Real50(s.x[0] * exp(h * w[0])), Real50(s.x[1] * exp(h * w[1])),
                          motion);
  };
  const auto here = pull(0);
  const Real50 allowed = 1e-42 * (1 + force.norm());
  EXPECT_TRUE(agrees<Real50>(s.text(), s.x[0] * force[0], here.lambda, allowed));
  EXPECT_TRUE(agrees<Real50>(s.text(), s.x[1] * force[1], here.mu, allowed));
  EXPECT_TRUE(is_slope(
      s.text(),
      [&](const Real50& h) {
        const auto there = pull(h);
        return Eigen::Matrix<Real50, 2, 1>{there.lambda, there.mu};
      },
      Eigen::Matrix<Real50, 2, 1>{here.ll * w[0] + here.lm * w[1],
                                  here.lm * w[0] + here.mm * w[1]}));
}

TEST(TwoPolar, PullIsTheForceAndItsSlope) {
  Random random(1010);
  const Separable<Biot<Real50>, Harmonic<Real50>> model{{1, 0.5}, {1, 1}};
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const State s(random);
    const auto momenta = two_polar_momenta(s.J, s.x, s.omega, s.theta_dot);
    const Vector3<Real50> w = widen_vector<Real50>(random.direction<3>());
    const auto elastic = two_polar_residual(s.J, model, s.x, Real50(0), Real50(0));
    expect_pull(
        s, TwoPolarRates<Real50>{s.omega, s.theta_dot},
        Vector3<Real50>(elastic - two_polar_residual(s.J, model, s.x, s.omega, s.theta_dot)), w);
    expect_pull(s, momenta,
                Vector3<Real50>(elastic - two_polar_momentum_residual(s.J, model, s.x, momenta)),
                w);
    const TwoPolarMomenta<Real50> equal{momenta.s3, momenta.s3};
    expect_pull(s, TwoPolarEqualMomenta<Real50>{momenta.s3},
                Vector3<Real50>(elastic - two_polar_momentum_residual(s.J, model, s.x, equal)), w);
  }
}

TYPED_TEST(TwoPolarTest, IsBranchThreeWithoutInternalRotation) {
  Random random(1007);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const State s(random);
    const Body body(s.J, s.J, random.log_uniform(0.25, 4.0));
    const auto F =
        balance_residual(body, model, BasicStretch<Real50>{Real50(0), s.x[0], s.x[1], s.x[2]},
                         angular_velocity(Branch::iii, s.omega));
    const auto r = two_polar_residual(s.J, model, s.x, s.omega, Real50(0));
    EXPECT_TRUE(
        all_agree<Vector3<Real50>>(s.text(), F.template tail<3>(), r, 1e-44 * (1 + F.norm())));
    EXPECT_EQ(F[0], 0);
    // and its momenta are those of the body: s3 = I3 nu3, p_theta from the coupling of nu3.
    const auto momenta = two_polar_momenta(s.J, s.x, s.omega, Real50(0));
    const BasicStretch<Real50> q{Real50(0), s.x[0], s.x[1], s.x[2]};
    EXPECT_TRUE(agrees<Real50>(s.text(), locked_inertia(body, q)(2, 2) * s.omega, momenta.s3,
                               Real50("1e-43")));
  }
}

TYPED_TEST(TwoPolarTest, OnTheCircleOnlyTheSumOfTheRatesIsSeen) {
  Random random(1008);
  for (int trial = 0; trial < two_polar_trials; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    State s(random);
    s.x[1] = s.x[0];
    const Real50 shift = random.uniform(-1.0, 1.0);
    const auto here = two_polar_residual(s.J, model, s.x, s.omega, s.theta_dot);
    const auto there =
        two_polar_residual(s.J, model, s.x, Real50(s.omega + shift), Real50(s.theta_dot - shift));
    EXPECT_TRUE(all_agree<Vector3<Real50>>(s.text(), here, there, 1e-44 * (1 + here.norm())));
    EXPECT_TRUE(agrees<Real50>(s.text(), here[0], here[1], 1e-44 * (1 + here.norm())));
  }
}

}  // namespace
}  // namespace stationary
