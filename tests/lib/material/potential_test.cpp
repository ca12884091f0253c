// Laws every potential obeys, over every model of the variants: derivatives are slopes, automatic
// differentiation gives the same, rotations of the plane change nothing, the rest state is at rest.
#include "lib/material/potential.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int potential_trials = 25;

PlanarInvariants<Real50> invariants(const Real50& t, const Real50& l) {
  const Real50 d = exp(l);
  return {t, d, t * t - 4 * d};
}

/// (t, l) of a random state away from e = 0, which (t, l) cannot parameterize.
Vector3<Real50> random_trl(Random& random) {
  for (;;) {
    const Stretch q = random.stretch(8.0);
    const auto x = planar_invariants(widen_stretch<Real50>(q));
    if (x.e > x.t * x.t / 1000) return {x.t, Real50(log(x.d)), Real50(log(Real50(q.rho)))};
  }
}

template <class Model>
class PlanarModelTest : public ::testing::Test {};
TYPED_TEST_SUITE(PlanarModelTest, BuiltInPlanarModels, ModelName);

TYPED_TEST(PlanarModelTest, DerivativesAreSlopes) {
  Random random(101);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = random.coefficients<TypeParam>();
    const auto wide = widen<Real50>(model);
    const Vector3<Real50> x = random_trl(random);
    const Vector3<Real50> w = widen_vector<Real50>(random.direction<3>());
    const Real50 t_step = w[0] * x[0];
    const Real50 l_step = w[1];
    const auto along = [&](const Real50& h) {
      const auto v = wide.template evaluate<2>(invariants(x[0] + h * t_step, x[1] + h * l_step));
      return Vector3<Real50>{v.w, v.w_t, v.w_l};
    };
    const auto v = wide.template evaluate<2>(invariants(x[0], x[1]));
    const Vector3<Real50> slope{v.w_t * t_step + v.w_l * l_step, v.w_tt * t_step + v.w_tl * l_step,
                                v.w_tl * t_step + v.w_ll * l_step};
    EXPECT_TRUE(is_slope(at(text_of(model), "t l", x), along, slope));
  }
}

TYPED_TEST(PlanarModelTest, WhatIsNotAskedForIsNaN) {
  Random random(102);
  const auto model = random.coefficients<TypeParam>();
  const auto x = planar_invariants(1.3, 0.8);
  const auto value = model.template evaluate<0>(x);
  const auto first = model.template evaluate<1>(x);
  const auto second = model.template evaluate<2>(x);
  EXPECT_TRUE(std::isnan(value.w_t) && std::isnan(value.w_l) && std::isnan(value.w_tt));
  EXPECT_TRUE(std::isnan(first.w_tt) && std::isnan(first.w_tl) && std::isnan(first.w_ll));
  EXPECT_EQ(value.w, second.w);
  EXPECT_EQ(first.w_t, second.w_t);
  EXPECT_EQ(first.w_l, second.w_l);
}

TYPED_TEST(PlanarModelTest, IsAtRestAtItsRestStretch) {
  Random random(103);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = random.coefficients<TypeParam>();
    const double s = model.rest_stretch();
    const auto v = model.template evaluate<2>(planar_invariants(s, s));
    // G = xi W_t + W_l; one rounding of s moves it by its derivative in ln xi = ln zeta.
    const double term = std::abs(v.w_tt) * s * s + std::abs(v.w_tl) * s + std::abs(v.w_ll) +
                        std::abs(v.w_t) * s + std::abs(v.w_l);
    EXPECT_TRUE(agrees(at(text_of(model)), 0.0, s * v.w_t + v.w_l, 8 * 0x1p-53 * term));
  }
}

TYPED_TEST(PlanarModelTest, ItsRestStateIsAMinimum) {
  Random random(104);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = random.coefficients<TypeParam>();
    const double s = model.rest_stretch();
    const auto v = potential_derivatives<2>(Separable<TypeParam, Harmonic<>>{model, {1.0, 1.0}},
                                            Stretch{0.0, s, s, 1.0});
    const double shear = v.hessian(1, 1) - v.hessian(1, 2);
    const double area = v.hessian(1, 1) + v.hessian(1, 2);
    EXPECT_GT(v.hessian(0, 0), 0.0) << text_of(model);
    EXPECT_GT(shear, 0.0) << text_of(model);
    EXPECT_GT(area, 0.0) << text_of(model);
    EXPECT_GT(v.hessian(3, 3), 0.0) << text_of(model);
    // An isotropic plane has one shear stiffness: V_alpha,alpha = 2 (V_xi,xi - V_xi,zeta).
    EXPECT_TRUE(agrees(at(text_of(model)), 2.0 * shear, v.hessian(0, 0),
                       64 * 0x1p-53 * std::abs(v.hessian(1, 1))));
  }
}

template <class Model>
class ThicknessModelTest : public ::testing::Test {};
TYPED_TEST_SUITE(ThicknessModelTest, BuiltInThicknessModels, ModelName);

TYPED_TEST(ThicknessModelTest, DerivativesAreSlopes) {
  Random random(111);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = random.coefficients<TypeParam>();
    const auto wide = widen<Real50>(model);
    const Real50 r = random.uniform(-2.0, 2.0);
    const auto along = [&](const Real50& h) {
      const auto v = wide.template evaluate<2>(Real50(exp(r + h)));
      return Eigen::Matrix<Real50, 2, 1>{v.v, v.v_r};
    };
    const auto v = wide.template evaluate<2>(Real50(exp(r)));
    EXPECT_TRUE(
        is_slope(at(text_of(model), "r", r), along, Eigen::Matrix<Real50, 2, 1>{v.v_r, v.v_rr}));
  }
}

TYPED_TEST(ThicknessModelTest, BalancedThicknessBalances) {
  Random random(112);
  int solved = 0;
  for (int trial = 0; trial < 4 * potential_trials; ++trial) {
    const auto model = random.coefficients<TypeParam>();
    const double m = trial % 4 == 0 ? 0.0 : random.uniform(0.0, 2.0);
    const double rho = model.balanced(m);
    if (std::isnan(rho)) continue;  // no solution: the next test says when
    ++solved;
    const auto v = model.template evaluate<2>(rho);
    const double pull = m * rho * rho;
    const double term = std::abs(v.v_rr) + 2.0 * pull;
    EXPECT_TRUE(agrees(at(text_of(model), "m", m), v.v_r, pull, 8 * 0x1p-53 * term));
  }
  EXPECT_GT(solved, potential_trials);
}

TYPED_TEST(ThicknessModelTest, HasNoBalancedThicknessFromTheStiffnessOn) {
  Random random(113);
  const auto model = random.coefficients<TypeParam>();
  // The stiffness named in `existence` is a quadratic coefficient: V' / rho at rho -> infinity.
  const double stiffness = model.template evaluate<2>(0x1p400).v_rr * 0x1p-801;
  EXPECT_GT(stiffness, 0.0);
  EXPECT_TRUE(std::isnan(model.balanced(stiffness)));
  EXPECT_TRUE(std::isnan(model.balanced(2.0 * stiffness)));
  EXPECT_GT(model.balanced(stiffness * (1.0 - 0x1p-50)), 0.0);
  // A deficit below the last place of a double is still one.
  EXPECT_GT(model.balanced(DoubleDouble(stiffness, -stiffness * 0x1p-60)), 0.0);
}

template <class Model>
class CoupledModelTest : public ::testing::Test {};
TYPED_TEST_SUITE(CoupledModelTest, BuiltInCoupledModels, ModelName);

TYPED_TEST(CoupledModelTest, DerivativesAreSlopes) {
  Random random(121);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = random.coefficients<TypeParam>();
    const auto wide = widen<Real50>(model);
    const Vector3<Real50> x = random_trl(random);
    Vector3<Real50> w = widen_vector<Real50>(random.direction<3>());
    w[0] *= x[0];
    const auto evaluate = [&](const Vector3<Real50>& y) {
      return wide.template evaluate<2>(invariants(y[0], y[1]), Real50(exp(y[2])));
    };
    const auto along = [&](const Real50& h) {
      const auto v = evaluate(x + w * h);
      return Vector4<Real50>{v.plane.w, v.plane.w_t, v.plane.w_l, v.w_r};
    };
    const auto v = evaluate(x);
    const auto& p = v.plane;
    EXPECT_TRUE(is_slope(at(text_of(model), "t l r", x), along,
                         Vector4<Real50>{p.w_t * w[0] + p.w_l * w[1] + v.w_r * w[2],
                                         p.w_tt * w[0] + p.w_tl * w[1] + v.w_tr * w[2],
                                         p.w_tl * w[0] + p.w_ll * w[1] + v.w_lr * w[2],
                                         v.w_tr * w[0] + v.w_lr * w[1] + v.w_rr * w[2]}));
  }
}

TYPED_TEST(CoupledModelTest, IsAtRestAtItsRestStretch) {
  Random random(122);
  const auto model = random.coefficients<TypeParam>();
  const double s = model.rest_stretch();
  const auto v = potential_derivatives<1>(model, Stretch{0.0, s, s, model.rest_thickness()});
  EXPECT_LT(v.gradient.norm(), 1e-15) << text_of(model);
}

template <class Model>
class WholeModelTest : public ::testing::Test {};
TYPED_TEST_SUITE(WholeModelTest, WholeModels, ModelName);

TYPED_TEST(WholeModelTest, GradientAndHessianAreSlopes) {
  Random random(131);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const auto q = widen_stretch<Real50>(random.stretch());
    const Vector4<Real50> w = widen_vector<Real50>(random.direction<4>());
    const auto derivatives = [&](const Real50& h) {
      return potential_derivatives<2>(wide, BasicStretch<Real50>::from(q.vector() + w * h));
    };
    const auto v = derivatives(0);
    const std::string x = at(text_of(model), q);
    EXPECT_TRUE(is_slope(
        x, [&](const Real50& h) { return derivatives(h).value; }, Real50(v.gradient.dot(w))));
    EXPECT_TRUE(is_slope(
        x, [&](const Real50& h) { return derivatives(h).gradient; },
        Vector4<Real50>(v.hessian * w)));
    EXPECT_EQ(v.hessian, v.hessian.transpose().eval());
  }
}

TYPED_TEST(WholeModelTest, AutomaticDifferentiationAgrees) {
  using Jet = ceres::Jet<double, 4>;
  Random random(132);
  for (int trial = 0; trial < 4 * potential_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Stretch q = trial % 2 == 0 ? random.stretch() : random.diagonal_stretch();
    const BasicStretch<Jet> jets{Jet(q.alpha, 0), Jet(q.xi, 1), Jet(q.zeta, 2), Jet(q.rho, 3)};
    const auto v = potential_derivatives<2>(model, q);
    const auto value = potential_derivatives<0>(model, jets).value;
    const auto gradient = potential_derivatives<1>(model, jets).gradient;
    const std::string x = at(text_of(model), q);
    const double inverse_d = 1.0 / planar_invariants(q).d;
    const double scale = (1.0 + v.hessian.cwiseAbs().maxCoeff()) * (1.0 + inverse_d * inverse_d);
    EXPECT_TRUE(agrees(x, v.value, value.a, 1e-15 * scale));
    EXPECT_TRUE(all_agree<Vector4<double>>(x, v.gradient, value.v, 2e-14 * scale));
    for (int k = 0; k < 4; ++k)
      EXPECT_TRUE(all_agree<Vector4<double>>(x, v.hessian.col(k), gradient[k].v, 2e-13 * scale));
  }
}

TYPED_TEST(WholeModelTest, RotationsOfThePlaneChangeNothing) {
  Random random(133);
  for (int trial = 0; trial < potential_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const auto q = widen_stretch<Real50>(random.stretch());
    const Real50 angle = random.uniform(-3.0, 3.0);
    const Real50 c = cos(angle);
    const Real50 s = sin(angle);
    // R S R^T
    const BasicStretch<Real50> turned{(q.xi - q.zeta) * s * c + q.alpha * (c * c - s * s),
                                      q.xi * c * c - 2 * q.alpha * s * c + q.zeta * s * s,
                                      q.xi * s * s + 2 * q.alpha * s * c + q.zeta * c * c, q.rho};
    const auto here = potential_derivatives<1>(wide, q);
    const auto there = potential_derivatives<1>(wide, turned);
    const std::string x = at(text_of(model), q, "angle", angle);
    EXPECT_TRUE(agrees<Real50>(x, here.value, there.value, 1e-40 * (1 + abs(here.value))));
    // and so the gradient has no part along the orbit.
    const Vector4<Real50> orbit{q.xi - q.zeta, -2 * q.alpha, 2 * q.alpha, 0};
    EXPECT_TRUE(agrees<Real50>(x, 0, here.gradient.dot(orbit),
                               1e-40 * here.gradient.norm() * orbit.norm()));
  }
}

TYPED_TEST(WholeModelTest, RunTimeClassGivesTheSameNumbers) {
  Random random(134);
  const auto model = draw<TypeParam>(random);
  const Potential potential = as_potential(model);
  const Stretch q = random.stretch();
  const auto expected = potential_derivatives<2>(model, q);
  const auto actual = potential.derivatives(q);
  EXPECT_EQ(actual.value, expected.value);
  EXPECT_EQ(actual.gradient, expected.gradient);
  EXPECT_EQ(actual.hessian, expected.hessian);
  // In extended precision: what is lost in a difference of its terms is not lost there.
  EXPECT_NEAR(potential.value(q), expected.value, 1e-14 * (1.0 + std::abs(expected.value)));
}

}  // namespace
}  // namespace stationary
