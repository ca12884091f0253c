// Dual2 against derivatives known in closed form, and what it is for: the sensitivity of a balance
// to its inputs, against differences of the same balance in 50 digits.
#include "lib/number/dual.hpp"

#include <gtest/gtest.h>

#include "lib/number/first_order_bound_functions.hpp"
#include "solver/newton/reduced_system.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using testing::Number50;

void expect_dual(const Dual2& actual, double value, double first, double second) {
  EXPECT_TRUE(support::agrees<double>("value", value, actual.value, 1e-15 * std::abs(value)));
  EXPECT_TRUE(support::agrees<double>("slope 0", first, actual.slope[0], 4e-15));
  EXPECT_TRUE(support::agrees<double>("slope 1", second, actual.slope[1], 4e-15));
}

TEST(Dual2, FieldOperations) {
  const Dual2 x(1.5, {1.0, 0.0});
  const Dual2 y(-0.75, {0.0, 1.0});
  expect_dual(x + y, 0.75, 1.0, 1.0);
  expect_dual(x - y, 2.25, 1.0, -1.0);
  expect_dual(-x, -1.5, -1.0, 0.0);
  expect_dual(x * y, -1.125, -0.75, 1.5);
  expect_dual(x / y, -2.0, 1.0 / -0.75, -1.5 / (0.75 * 0.75));
  expect_dual(x * x * y - x / (y * y), 1.5 * 1.5 * -0.75 - 1.5 / (0.75 * 0.75),
              2.0 * 1.5 * -0.75 - 1.0 / (0.75 * 0.75),
              1.5 * 1.5 + 2.0 * 1.5 / (-0.75 * 0.75 * 0.75));
}

TEST(Dual2, ConstantsHaveNoSlope) {
  const Dual2 x(1.5, {2.0, -3.0});
  expect_dual(2.0 * x + 1.0, 4.0, 4.0, -6.0);
  expect_dual(1.0 / x, 1.0 / 1.5, -2.0 / 2.25, 3.0 / 2.25);
  EXPECT_TRUE(x > 1.0);
  EXPECT_FALSE(x > 2.0);
  EXPECT_EQ(leading(x), 1.5);
}

/// Sum over inputs p of |p dG_i/dp| by central differences: coefficient 0, coefficient 1, J, nu.
template <std::size_t N, class F>
std::array<Number50, N> input_sensitivity_50(const F& residual) {
  const Number50 h("1e-16");
  std::array<Number50, N> sum;
  sum.fill(Number50(0));
  for (int input = 0; input < 4; ++input) {
    std::array<Number50, 2> factor{Number50(1), Number50(1)};
    Number50 rate = 1;
    const auto shifted = [&](const Number50& by) {
      if (input < 2) factor[static_cast<std::size_t>(input)] = 1 + by;
      if (input == 2) rate = 1 + by;
      if (input == 3) rate = (1 + by) * (1 + by);
      return residual(factor, rate);
    };
    const auto ahead = shifted(h);
    const auto behind = shifted(-h);
    for (std::size_t i = 0; i < N; ++i) sum[i] += abs((ahead[i] - behind[i]) / (2 * h));
  }
  return sum;
}

template <int N, class Wide>
void expect_sensitivity(const std::string& x, const Wide& expected,
                        const ReducedVector<N>& actual) {
  for (int i = 0; i < N; ++i) {
    const double e = expected[static_cast<std::size_t>(i)].template convert_to<double>();
    EXPECT_TRUE(support::agrees<double>(support::at(x, "equation", i), e, actual[i], 1e-11 * e));
  }
}

template <template <class> class Model>
Model<Number50> scaled(const Model<double>& model, const std::array<Number50, 2>& factor) {
  const auto p = model.coefficients();
  return {p[0] * factor[0], p[1] * factor[1]};
}

template <class Model>
class PlanarSensitivityTest : public ::testing::Test {};
TYPED_TEST_SUITE(PlanarSensitivityTest, support::BuiltInPlanarModels, support::ModelName);

TYPED_TEST(PlanarSensitivityTest, IsTheDifferenceIn50Digits) {
  support::Random random(21);
  for (int k = 0; k < 40; ++k) {
    const auto model = random.coefficients<TypeParam>();
    const CentrifugalRates<double> c{random.log_uniform(0.1, 2.0), random.log_uniform(0.1, 2.0), 0};
    const PlanarSystem<TypeParam> system{model, {c.xi, c.zeta, c.rho}};
    const ReducedVector<2> x(random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0));
    const auto expected = input_sensitivity_50<2>([&](const auto& factor, const Number50& rate) {
      const Number50 xi(x[0]);
      const Number50 zeta(x[1]);
      const auto w = scaled(model, factor).template evaluate<1>(planar_invariants(xi, zeta));
      const CentrifugalRates<Number50> pull{rate * c.xi, rate * c.zeta, 0};
      const auto b = planar_log_balance<1>(w, xi, zeta, pull);
      return std::array<Number50, 2>{b.g_xi, b.g_zeta};
    });
    expect_sensitivity<2>(support::at(support::text_of(model), x), expected,
                          system.input_sensitivity(x));
  }
}

template <class Model>
class ThicknessSensitivityTest : public ::testing::Test {};
TYPED_TEST_SUITE(ThicknessSensitivityTest, support::BuiltInThicknessModels, support::ModelName);

TYPED_TEST(ThicknessSensitivityTest, IsTheDifferenceIn50Digits) {
  support::Random random(22);
  for (int k = 0; k < 40; ++k) {
    const auto model = random.coefficients<TypeParam>();
    const double m = random.log_uniform(0.1, 2.0);
    const ReducedVector<1> x(random.log_uniform(0.3, 3.0));
    const auto expected = input_sensitivity_50<1>([&](const auto& factor, const Number50& rate) {
      const Number50 rho(x[0]);
      const auto v = scaled(model, factor).template evaluate<1>(rho);
      return std::array<Number50, 1>{v.v_r - rate * m * rho * rho};
    });
    expect_sensitivity<1>(support::at(support::text_of(model), x), expected,
                          ThicknessSystem<TypeParam>{model, m}.input_sensitivity(x));
  }
}

TEST(CoupledSensitivity, IsTheDifferenceIn50Digits) {
  support::Random random(23);
  for (int k = 0; k < 40; ++k) {
    const auto model = random.coefficients<NeoHookean3d<>>();
    const CentrifugalRates<double> c{random.log_uniform(0.1, 2.0), random.log_uniform(0.1, 2.0),
                                     random.log_uniform(0.1, 2.0)};
    const CoupledSystem<NeoHookean3d<>> system{model, {c.xi, c.zeta, c.rho}};
    const ReducedVector<3> x(random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0),
                             random.log_uniform(0.3, 3.0));
    const auto expected = input_sensitivity_50<3>([&](const auto& factor, const Number50& rate) {
      const Number50 xi(x[0]);
      const Number50 zeta(x[1]);
      const Number50 rho(x[2]);
      const auto w = scaled(model, factor).template evaluate<1>(planar_invariants(xi, zeta), rho);
      const CentrifugalRates<Number50> pull{rate * c.xi, rate * c.zeta, rate * c.rho};
      const auto b = coupled_log_balance<1>(w, xi, zeta, rho, pull);
      return std::array<Number50, 3>{b.g_xi, b.g_zeta, b.g_rho};
    });
    expect_sensitivity<3>(support::at(support::text_of(model), x), expected,
                          system.input_sensitivity(x));
  }
}

/// Roots and powers of what does not move have no slope, at 0 and below too.
TEST(Dual2, WhatDoesNotMoveHasNoSlope) {
  const Dual2 zero(0.0);
  const Dual2 negative(-2.0);
  EXPECT_EQ(sqrt(zero).slope[0], 0.0);
  EXPECT_EQ(pow(zero, Dual2(1.5)).value, 0.0);
  EXPECT_EQ(pow(zero, Dual2(1.5)).slope[1], 0.0);
  EXPECT_EQ(pow(negative, Dual2(3.0)).value, -8.0);
  EXPECT_EQ(pow(negative, Dual2(3.0)).slope[0], 0.0);
  const Conditioned none(0.0);
  EXPECT_EQ(pow(none, Conditioned(1.5)).condition, 0.0);
}

}  // namespace
}  // namespace stationary
