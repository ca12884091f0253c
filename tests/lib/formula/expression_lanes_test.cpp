// A written potential in all lanes of a pack at once is, lane by lane, that of doubles and of
// extended numbers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lib/number/simd_pack_functions.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using namespace support;
using V = Pack<16>;

double lane(const V& x, int i) { return i < V::half ? x.a[i] : x.b[i - V::half]; }

TEST(ExpressionLanes, AreThoseOfDoubles) {
  const std::vector<std::string> names{"p", "q"};
  Random random(441);
  for (const char* text :
       {"p/2*(I1 - 2 - 2*log(d)) + q/2*log(d)^2", "p*exp(-t) + sqrt(d)*sin(q*t)/cos(d/4)",
        "max(p, q)*tanh(t) + abs(q)*atan(d) + d^q + tan(pi*d/16)",
        "p*(lambda^q + mu_^q) + log(lambda)^2 + log(mu_)^2"}) {
    const auto model = written_plane(text, names, {1.25, 0.75});
    for (int trial = 0; trial < 10; ++trial) {
      std::array<double, V::lanes> xi{};
      std::array<double, V::lanes> zeta{};
      for (auto& x : xi) x = random.log_uniform(0.5, 2.0);
      for (auto& x : zeta) x = random.log_uniform(0.5, 2.0);
      const V x = V::load(xi.data());
      const V z = V::load(zeta.data());
      const auto w = model.evaluate<2>(planar_invariants(x, z));
      const auto pairs = model.evaluate<1>(planar_invariants(Pair<V>(x), Pair<V>(z)));
      const auto b = model.log_balance(x, z, V(0.25), V(0.5));
      for (int i = 0; i < V::lanes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const auto one = model.evaluate<2>(planar_invariants(xi[k], zeta[k]));
        const auto extended =
            model.evaluate<1>(planar_invariants(DoubleDouble(xi[k]), DoubleDouble(zeta[k])));
        const auto balance = model.log_balance(xi[k], zeta[k], 0.25, 0.5);
        EXPECT_NEAR(lane(w.w, i), one.w, 1e-13 * (1.0 + std::abs(one.w))) << text;
        EXPECT_NEAR(lane(w.w_t, i), one.w_t, 1e-13 * (1.0 + std::abs(one.w_t))) << text;
        EXPECT_NEAR(lane(w.w_ll, i), one.w_ll, 1e-13 * (1.0 + std::abs(one.w_ll))) << text;
        EXPECT_NEAR(lane(b.g_xi, i), balance.g_xi, 1e-13 * (1.0 + std::abs(balance.g_xi))) << text;
        const double w_l = double(extended.w_l);
        const double error =
            (lane(pairs.w_l.hi, i) - extended.w_l.hi) + (lane(pairs.w_l.lo, i) - extended.w_l.lo);
        EXPECT_LT(std::abs(error), 0x1p-66 * (1.0 + std::abs(w_l))) << text;
      }
    }
  }
}

}  // namespace
}  // namespace stationary
