// One source, many number types: doubles against 50 digits within the rounding errors of their own
// terms, extended precision against 50 digits, Jets of wide numbers, decimal floats.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lib/balance/balance.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/running_error.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

template <class S>
std::array<S, 10> listed(const CoupledDerivatives<S>& v) {
  return {v.plane.w,    v.plane.w_t,  v.plane.w_l, v.w_r,  v.plane.w_tt,
          v.plane.w_tl, v.plane.w_ll, v.w_rr,      v.w_tr, v.w_lr};
}
constexpr std::array<const char*, 10> names{"w",    "w_t",  "w_l",  "w_r",  "w_tt",
                                            "w_tl", "w_ll", "w_rr", "w_tr", "w_lr"};

template <class S, class Model>
std::array<S, 10> evaluate(const Model& model, const BasicStretch<S>& q) {
  const auto v = model.template evaluate<2>(planar_invariants(q), q.rho);
  return listed(v);
}

template <class Model>
class PotentialPrecisionTest : public ::testing::Test {
 protected:
  static constexpr int trials = 120;

  /// From moderate to extreme: stretches within [1/ratio, ratio], ratio up to 1e4.
  static Stretch state(Random& random, int trial) {
    const double ratio = std::pow(10.0, 4.0 * (trial % 8 + 1) / 8.0);
    return trial % 3 == 0 ? random.stretch(std::min(ratio, 30.0)) : random.diagonal_stretch(ratio);
  }
};
TYPED_TEST_SUITE(PotentialPrecisionTest, WholeModels, ModelName);

TYPED_TEST(PotentialPrecisionTest, DoublesAreWithinTheRoundingOfTheirTerms) {
  Random random(701);
  for (int trial = 0; trial < this->trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Stretch q = this->state(random, trial);
    const auto actual = evaluate(model, q);
    const auto expected = evaluate(widen<Real50>(model), widen_stretch<Real50>(q));
    const auto bounds = evaluate(widen<BoundedDouble>(model), widen_stretch<BoundedDouble>(q));
    for (std::size_t k = 0; k < names.size(); ++k) {
      EXPECT_TRUE(agrees<Real50>(at(text_of(model), q, names[k]), expected[k], Real50(actual[k]),
                                 Real50(bounds[k].bound) * (0x1p-53 * (1.0 + 0x1p-20))));
    }
  }
}

/// How far each derivative moves when every input and coefficient moves by one relative unit: the
/// error no formula in doubles can avoid.
template <class Model>
std::array<Real50, 10> natural_scale(const Model& model, const Stretch& q) {
  const Real50 step("1e-25");
  const auto wide = widen<Real50>(model);
  const auto start = evaluate(wide, widen_stretch<Real50>(q));
  std::array<Real50, 10> out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = abs(start[k]);
  for (int input = 0; input < 4; ++input) {
    Vector4<Real50> x = widen_stretch<Real50>(q).vector();
    x[input] *= 1 + step;
    const auto moved = evaluate(wide, BasicStretch<Real50>::from(x));
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += abs(moved[k] - start[k]) / step;
  }
  return out;
}

TYPED_TEST(PotentialPrecisionTest, FirstDerivativesAreBackwardStable) {
  // What a solve uses: w_t and w_l (and w_r) are the exact derivatives of data a few units in the
  // last place away.
  Random random(702);
  for (int trial = 0; trial < this->trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Stretch q = random.diagonal_stretch(std::pow(10.0, 4.0 * (trial % 8 + 1) / 8.0));
    const auto actual = evaluate(model, q);
    const auto expected = evaluate(widen<Real50>(model), widen_stretch<Real50>(q));
    const auto scale = natural_scale(model, q);
    for (const std::size_t k : {1U, 2U, 3U}) {
      EXPECT_TRUE(agrees<Real50>(at(text_of(model), q, names[k]), expected[k], Real50(actual[k]),
                                 scale[k] * (16 * 0x1p-53)));
    }
  }
}

TYPED_TEST(PotentialPrecisionTest, ExtendedPrecisionIsGoodToItsLogarithm) {
  // Coefficients are doubles, as in a solve; sums of them must not round in double.
  Random random(703);
  for (int trial = 0; trial < this->trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Stretch q = this->state(random, trial);
    const auto x = planar_invariants(widen_stretch<DoubleDouble>(q));
    const auto actual = listed(model.template evaluate<1>(x, DoubleDouble(q.rho)));
    const auto expected = evaluate(widen<Real50>(model), widen_stretch<Real50>(q));
    const auto bounds = evaluate(widen<BoundedDouble>(model), widen_stretch<BoundedDouble>(q));
    for (const std::size_t k : {0U, 1U, 2U, 3U}) {
      EXPECT_TRUE(agrees<Real50>(at(text_of(model), q, names[k]), expected[k],
                                 exact<Real50>(actual[k]), Real50(bounds[k].bound) * 0x1p-80));
    }
  }
}

TYPED_TEST(PotentialPrecisionTest, BalanceInExtendedPrecision) {
  Random random(704);
  for (int trial = 0; trial < this->trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector3<double> nu = random.direction<3>();
    const auto actual = balance_residual(body, model, widen_stretch<DoubleDouble>(q),
                                         widen_vector<DoubleDouble>(nu));
    const auto expected = balance_residual(body, widen<Real50>(model), widen_stretch<Real50>(q),
                                           widen_vector<Real50>(nu));
    const auto bounds = balance_residual(body, model, widen_stretch<BoundedDouble>(q),
                                         widen_vector<BoundedDouble>(nu));
    for (int k = 0; k < 4; ++k) {
      EXPECT_TRUE(agrees<Real50>(at(text_of(model), body, q, nu, "row", k), expected[k],
                                 exact<Real50>(actual[k]), Real50(bounds[k].bound) * 0x1p-80));
    }
  }
}

TYPED_TEST(PotentialPrecisionTest, BinaryAndDecimalFloatsAgree) {
  Random random(705);
  for (int trial = 0; trial < 20; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Stretch q =
        trial % 4 == 0 ? Stretch{0.0, 1.25, 1.25 + 1e-9 * trial, 0.75} : this->state(random, trial);
    const auto binary = evaluate(widen<Real50>(model), widen_stretch<Real50>(q));
    const auto decimal = evaluate(widen<Decimal50>(model), widen_stretch<Decimal50>(q));
    const auto bounds = evaluate(widen<BoundedDouble>(model), widen_stretch<BoundedDouble>(q));
    for (std::size_t k = 0; k < names.size(); ++k) {
      EXPECT_TRUE(agrees<Real50>(at(text_of(model), q, names[k]), binary[k], Real50(decimal[k]),
                                 Real50(bounds[k].bound) * Real50("1e-47")));
    }
  }
}

}  // namespace
}  // namespace stationary
