// rho of a separable potential: against its closed forms in 50 digits, up to where the stiffness
// left all but vanishes.
#include "solver/newton/thickness_balance.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary {
namespace {

using testing::Number50;

Number50 exact_rho(const ReciprocalQuadratic<>& v, const DoubleDouble& m) {
  return cbrt(Number50(v.a) / (Number50(v.b) - Number50(m.hi) - Number50(m.lo)));
}
Number50 exact_rho(const Harmonic<>& v, const DoubleDouble& m) {
  return Number50(v.k) * Number50(v.rest) / (Number50(v.k) - Number50(m.hi) - Number50(m.lo));
}

template <class Thickness>
void expect_thickness_rounded(const Thickness& model, const DoubleDouble& m) {
  const ThicknessBalance balance = balanced_thickness(model, m);
  ASSERT_TRUE(balance.refined.converged) << double(m);
  const Number50 exact = exact_rho(model, m);
  const double error = abs((balance.rho - exact) / exact).convert_to<double>();
  EXPECT_LE(error, 0x1p-53 * 1.001) << double(m);
  EXPECT_LE(error, balance.refined.error_bound) << double(m);
}

template <class Thickness>
class ThicknessBalanceTest : public ::testing::Test {};
using Models = ::testing::Types<ReciprocalQuadratic<>, Harmonic<>>;
TYPED_TEST_SUITE(ThicknessBalanceTest, Models);

template <class Thickness>
double stiffness(const Thickness& model) {
  if constexpr (requires { model.b; })
    return model.b;
  else
    return model.k;
}

TYPED_TEST(ThicknessBalanceTest, RoundsCorrectly) {
  support::Random random(41);
  for (int k = 0; k < 1000; ++k) {
    const TypeParam model{random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3)};
    expect_thickness_rounded(model, stiffness(model) * random.uniform(0.0, 1.0));
  }
}

TYPED_TEST(ThicknessBalanceTest, RoundsCorrectlyJustBelowTheEnd) {
  support::Random random(42);
  for (int k = 0; k < 200; ++k) {
    const TypeParam model{random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3)};
    const double gap = random.log_uniform(1e-15, 1e-2);
    // m is a product with an error term of its own, as J3 nu^2 is.
    const double nu = std::sqrt(stiffness(model) * (1.0 - gap));
    const DoubleDouble m = two_product(nu, nu);
    if (double(stiffness(model) - m) > 0.0) expect_thickness_rounded(model, m);
  }
}

TYPED_TEST(ThicknessBalanceTest, NoneFromTheEndOn) {
  const TypeParam model{2.0, 3.0};
  const double end = stiffness(model);
  for (const double m : {end, end * (1.0 + 0x1p-52), 2.0 * end}) {
    const ThicknessBalance balance = balanced_thickness(model, m);
    EXPECT_FALSE(balance.refined.converged) << m;
    EXPECT_TRUE(std::isnan(balance.rho)) << m;
    EXPECT_TRUE(std::isnan(balance.refined.error_bound)) << m;
  }
}

TYPED_TEST(ThicknessBalanceTest, WithoutBoundTheSameRho) {
  const TypeParam model{2.0, 3.0};
  const ThicknessBalance with = balanced_thickness<true>(model, 0.7);
  const ThicknessBalance without = balanced_thickness<false>(model, 0.7);
  EXPECT_EQ(with.rho, without.rho);
  EXPECT_TRUE(without.refined.converged);
  EXPECT_TRUE(std::isnan(without.refined.error_bound));
  EXPECT_GT(with.refined.error_bound, 0.0);
}

}  // namespace
}  // namespace stationary
