// A pack is its lanes: every operation rounds as that of double does, products are exact pairs,
// logarithms keep their bounds.
#include "lib/number/simd_pack.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/batch/term_magnitude.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using P = Pack<16>;

double lane(const P& x, int k) { return k < P::half ? x.a[k] : x.b[k - P::half]; }

P random_pack(support::Random& random, double ratio) {
  double values[P::lanes];
  for (double& each : values) each = random.log_uniform(1.0 / ratio, ratio);
  return P::load(values);
}

TEST(Pack, OperationsAreThoseOfItsLanes) {
  support::Random random(701);
  for (int trial = 0; trial < 200; ++trial) {
    const P x = random_pack(random, 1e8);
    const P y = random_pack(random, 1e8);
    const Pair<P> product = two_product(x, -y);
    const Pair<P> sum = two_sum(x, -y);
    for (int k = 0; k < P::lanes; ++k) {
      const double a = lane(x, k);
      const double b = lane(y, k);
      EXPECT_EQ(lane(x + y, k), a + b);
      EXPECT_EQ(lane(x - 2.0 * y, k), a - 2.0 * b);
      EXPECT_EQ(lane(x / y, k), a / b);
      EXPECT_EQ(lane(abs(x - y), k), std::abs(a - b));
      EXPECT_EQ(lane(larger(x, y), k), std::max(a, b));
      EXPECT_EQ(lane(select(x < y, x, y), k), std::min(a, b));
      EXPECT_EQ(lane(product.hi, k), -(a * b));
      EXPECT_EQ(lane(product.lo, k), std::fma(a, -b, a * b));
      const DoubleDouble exact = two_sum(a, -b);
      EXPECT_EQ(lane(sum.lo, k), exact.lo);
    }
    EXPECT_EQ(any(x < y), any(~(y <= x)));
  }
}

TEST(Pack, RootsAndQuotientsOfPairs) {
  support::Random random(703);
  for (int trial = 0; trial < 400; ++trial) {
    const Pair<P> x(random_pack(random, 1e8), random_pack(random, 2.0) * 0x1p-80);
    const Pair<P> y(random_pack(random, 1e8), random_pack(random, 2.0) * 0x1p-80);
    const Pair<P> root = sqrt(x);
    const Pair<P> none = sqrt(-x);
    const Pair<P> quotient = x / y;
    const Pair<P> chosen = select(x.hi < y.hi, x, y);
    for (int k = 0; k < P::lanes; ++k) {
      const DoubleDouble a(lane(x.hi, k), lane(x.lo, k));
      const DoubleDouble b(lane(y.hi, k), lane(y.lo, k));
      EXPECT_EQ(lane(sqrt(x.hi), k), std::sqrt(a.hi));
      const DoubleDouble r(lane(root.hi, k), lane(root.lo, k));
      EXPECT_LE(std::abs(double(r * r - a)), 0x1p-98 * a.hi);
      EXPECT_EQ(lane(none.hi, k), 0.0);
      const DoubleDouble q(lane(quotient.hi, k), lane(quotient.lo, k));
      EXPECT_LE(std::abs(double(q * b - a)), 0x1p-98 * a.hi);
      EXPECT_EQ(lane(chosen.lo, k), a.hi < b.hi ? a.lo : b.lo);
    }
  }
}

TEST(Pack, LogarithmsKeepTheirBounds) {
  support::Random random(702);
  for (int trial = 0; trial < 4000; ++trial) {
    const P x = random_pack(random, trial % 2 == 0 ? 1.5 : 1e200);
    const P tail = x * 0x1p-54 * random.uniform(-1.0, 1.0);
    const P plain = log(x);
    const Pair<P> extended = log(Pair<P>(x, tail));
    for (int k = 0; k < P::lanes; ++k) {
      const DoubleDouble expected = log(DoubleDouble(lane(x, k), lane(tail, k)));
      const double size = 1.0 + std::abs(expected.hi);
      EXPECT_LE(std::abs(lane(plain, k) - std::log(lane(x, k))), 0x1p-51 * size) << lane(x, k);
      const DoubleDouble found(lane(extended.hi, k), lane(extended.lo, k));
      EXPECT_LE(std::abs(double(found - expected)), 0x1p-70 * size) << lane(x, k);
    }
  }
  EXPECT_EQ(lane(log(P(1.0)), 0), 0.0);
}

TEST(TermSize, AddsWhatSumsCancel) {
  using T = TermSize<double>;
  EXPECT_EQ((T(3.0) - T(3.0) * T(2.0)).value, 9.0);
  EXPECT_EQ((-1.0 * T(3.0) / T(2.0)).value, 1.5);
  EXPECT_EQ(log(T(0.5)).value, std::log(2.0));
}

}  // namespace
}  // namespace stationary
