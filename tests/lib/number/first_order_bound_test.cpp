// |f(inputs perturbed by u) - f(inputs)| <= u condition to first order: against 50-digit
// evaluations of the same templates at randomly perturbed inputs.
#include "lib/number/first_order_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/linearization.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr double shake = 1e-9;
/// Second order in it, generously, and the rounding of the Conditioned value itself.
constexpr double slack = 1.0 + 1e-5;

/// x (1 + s shake), s = -1, 1 or between.
Real50 perturbed(Random& random, double x) {
  const double s = random.integer(0, 2) == 0 ? random.uniform(-1.0, 1.0) : random.sign();
  return Real50(x) * (1 + Real50(s) * shake);
}

/// f(vector of inputs) in any type; returns the largest |change|/(shake condition) seen.
template <class F>
double worst_ratio(Random& random, const std::vector<double>& inputs, const F& f) {
  std::vector<Conditioned> c;
  std::vector<Real50> x;
  for (const double input : inputs) {
    c.push_back(Conditioned::input(input));
    x.emplace_back(input);
  }
  const Conditioned bound = f(c);
  const Real50 value = f(x);
  EXPECT_LE(std::abs(bound.value - nearest(value)), 64 * 0x1p-53 * bound.condition + 1e-300);
  double worst = 0.0;
  for (int k = 0; k < 40; ++k) {
    std::vector<Real50> y;
    for (const double input : inputs) y.push_back(perturbed(random, input));
    const double change = nearest(Real50(abs(Real50(f(y) - value))));
    EXPECT_LE(change, slack * shake * bound.condition);
    if (bound.condition > 0.0) worst = std::max(worst, change / (shake * bound.condition));
  }
  return worst;
}

TEST(Conditioned, EveryOperationIsBoundedAndTheBoundIsMet) {
  Random random(201);
  const auto sweep = [&](const auto& f, double least) {
    double worst = 0.0;
    for (int k = 0; k < 200; ++k) {
      const std::vector<double> x{random.log_uniform(0.1, 10.0), random.log_uniform(0.1, 10.0)};
      worst = std::max(worst, worst_ratio(random, x, f));
    }
    EXPECT_GE(worst, least);  // no bound that is merely large
  };
  sweep([](const auto& x) { return x[0] + x[1]; }, 0.9999);
  sweep([](const auto& x) { return x[0] - x[1]; }, 0.9999);
  sweep([](const auto& x) { return x[0] * x[1]; }, 0.9999);
  sweep([](const auto& x) { return x[0] / x[1]; }, 0.9999);
  sweep([](const auto& x) { return -x[0]; }, 0.9999);
  sweep([](const auto& x) { return sqrt(x[0]); }, 0.9999);
  sweep([](const auto& x) { return log(x[0]); }, 0.9999);
  sweep([](const auto& x) { return sqrt(x[0] * x[1]) - log(x[0] / x[1]) * x[1]; }, 0.3);
}

TEST(Conditioned, CancellationIsSeen) {
  Random random(202);
  for (const double gap : {1e-2, 1e-5, 1e-8}) {
    // a - b of two inputs that nearly agree: the relative bound is 2/gap.
    const double x = 1.0 + gap;
    const Conditioned d = Conditioned::input(x) - Conditioned::input(1.0);
    EXPECT_NEAR(d.condition / d.value, 2.0 / gap, 3.0 / gap * 1e-2 + 2.0);
    worst_ratio(random, {x, 1.0}, [](const auto& v) { return v[0] - v[1]; });
    worst_ratio(random, {x, 1.0}, [](const auto& v) {
      return (v[0] * v[0] - v[1] * v[1]) / (v[0] - v[1]) - (v[0] + v[1]) * 0.5;
    });
    // log near 1.
    const Conditioned l = log(Conditioned::input(x));
    EXPECT_NEAR(l.condition, 1.0, 1e-12);
  }
}

TEST(Conditioned, ADoubleFactorIsAnInputATermIsNot) {
  const Conditioned x = Conditioned::input(3.0);
  EXPECT_EQ((2.0 * x).condition, 12.0);
  EXPECT_EQ((x * 2.0).condition, 12.0);
  EXPECT_EQ((x / 2.0).condition, 3.0);
  EXPECT_EQ((2.0 / x).condition, 4.0 / 3.0);
  EXPECT_EQ((x + 2.0).condition, 3.0);
  EXPECT_EQ((x - 2.0).condition, 3.0);
  EXPECT_EQ(sqrt(Conditioned(0.0)).condition, 0.0);
}

TEST(Conditioned, SumsInPlace) {
  Conditioned x = Conditioned::input(3.0);
  x += Conditioned::input(-1.0);
  x -= Conditioned::input(0.5);
  EXPECT_EQ(x.value, 1.5);
  EXPECT_EQ(x.condition, 4.5);
}

TEST(WithCurvature, SolvesItsEquation) {
  Random random(203);
  for (int k = 0; k < 1000; ++k) {
    const double kappa = random.log_uniform(1e-6, 1e6);
    const double b = random.uniform(0.0, 0.25) / kappa;
    const double e = with_curvature(b, kappa);
    EXPECT_NEAR(e, b + kappa * e * e, 1e-14 * e);
    EXPECT_LE(e, 2.0 * b * (1.0 + 1e-15));  // the smaller root
  }
  EXPECT_EQ(with_curvature(0.3, 0.0), 0.3);
  // Past the fold: at least the distance to it.
  EXPECT_GE(with_curvature(1.0, 1.0), 0.5);
}

template <class Model>
class ConditionedModelTest : public ::testing::Test {};
TYPED_TEST_SUITE(ConditionedModelTest, WholeModels, ModelName);

/// The second derivatives that enter the spectra.
template <class S>
std::vector<S> stiffnesses(const StraightState<S>& s) {
  return {s.V_aa, s.V_xx, s.V_xz, s.V_zz, s.V_xr, s.V_zr, s.V_rr};
}

template <class T, template <class> class Model>
Model<T> shaken(Random& random, const Model<double>& model) {
  const auto c = model.coefficients();
  return {perturbed(random, c[0]), perturbed(random, c[1])};
}
template <class T, class Plane, class Thickness>
auto shaken(Random& random, const Separable<Plane, Thickness>& model) {
  const auto plane = shaken<T>(random, model.plane);
  const auto thickness = shaken<T>(random, model.thickness);
  return Separable<std::remove_cv_t<decltype(plane)>, std::remove_cv_t<decltype(thickness)>>{
      plane, thickness};
}

TYPED_TEST(ConditionedModelTest, BoundsTheSpectrumsCoefficients) {
  Random random(204);
  const auto expect_bounded = [](const auto& c, const auto& at_x, const auto& at_y,
                                 const std::string& where) {
    for (std::size_t k = 0; k < c.size(); ++k) {
      const double change = nearest(Real50(abs(Real50(at_y[k] - at_x[k]))));
      EXPECT_LE(change, slack * shake * c[k].condition) << where << " entry " << k;
      EXPECT_LE(std::abs(c[k].value - nearest(at_x[k])), 1e3 * 0x1p-53 * c[k].condition)
          << where << " entry " << k;
    }
  };
  for (int k = 0; k < 60; ++k) {
    const TypeParam model = draw<TypeParam>(random);
    const auto wide = widen<Real50>(model);
    const Body body = random.body();
    const Stretch q = random.diagonal_stretch();
    const double omega = random.log_uniform(0.1, 2.0);
    const auto input = [](double x) { return Conditioned::input(x); };
    const StraightState<Conditioned> c =
        straight_state({input(body.J1), input(body.J2), input(body.J3)}, conditioned_model(model),
                       input(q.xi), input(q.zeta), input(q.rho), input(omega));
    const StraightState<Real50> x =
        straight_state({Real50(body.J1), Real50(body.J2), Real50(body.J3)}, wide, Real50(q.xi),
                       Real50(q.zeta), Real50(q.rho), Real50(omega));
    const std::string where = at(text_of(model), body, q, "omega", omega);
    for (int trial = 0; trial < 10; ++trial) {
      const auto jolted = shaken<Real50>(random, model);
      const auto jolt = [&](double value) { return perturbed(random, value); };
      const StraightState<Real50> y =
          straight_state({jolt(body.J1), jolt(body.J2), jolt(body.J3)}, jolted, jolt(q.xi),
                         jolt(q.zeta), jolt(q.rho), jolt(omega));
      expect_bounded(stiffnesses(c), stiffnesses(x), stiffnesses(y), where + "V");
      expect_bounded(even_pencil_i(c).characteristic().c, even_pencil_i(x).characteristic().c,
                     even_pencil_i(y).characteristic().c, where + "(i) even");
      expect_bounded(odd_forms_i(c).characteristic().c, odd_forms_i(x).characteristic().c,
                     odd_forms_i(y).characteristic().c, where + "(i) odd");
      expect_bounded(even_block_iii(c).characteristic_coupled().c,
                     even_block_iii(x).characteristic_coupled().c,
                     even_block_iii(y).characteristic_coupled().c, where + "(iii) even");
      expect_bounded(std::array{odd_lambda_iii(c)}, std::array{odd_lambda_iii(x)},
                     std::array{odd_lambda_iii(y)}, where + "(iii) odd");
    }
  }
}

}  // namespace
}  // namespace stationary
