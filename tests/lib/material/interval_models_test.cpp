// The models and their balance over intervals hold every point value (one wrong entry of a Jacobian
// loses solutions without a word), and the two ways to the balance at alpha = 0 are the same.
#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "lib/balance/balance.hpp"
#include "lib/material/models/model_coefficients.hpp"
#include "lib/number/interval.hpp"
#include "lib/stability/linearization.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr int interval_trials = 400;

/// A stretch box from very narrow to wide, some of them across the circle, and a point in it.
struct Sample {
  Interval x[3];
  Real50 at[3];
};

Sample draw_sample(Random& random) {
  Sample out;
  const double width = random.log_uniform(1e-15, 3.0);
  const double shared = random.log_uniform(1e-2, 1e2);
  for (int i = 0; i < 3; ++i) {
    const double base = random.integer(0, 2) == 0 ? shared : random.log_uniform(1e-2, 1e2);
    out.x[i] = {base, base * (1.0 + width * random.uniform(0.1, 1.0))};
    const double where = random.integer(0, 4) == 0 ? 0.0 : random.uniform(0.0, 1.0);
    out.at[i] = Real50(out.x[i].lo) + (Real50(out.x[i].hi) - Real50(out.x[i].lo)) * where;
  }
  return out;
}

::testing::AssertionResult is_held(const Interval& x, const Real50& exact, const char* what) {
  if (!x.bounded()) return ::testing::AssertionFailure() << what << " is not bounded";
  if (Real50(x.lo) <= exact && exact <= Real50(x.hi)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << what << " = " << exact.str(20) << " not in [" << x.lo << ", " << x.hi << "]";
}

template <class T>
auto named_members(const PlanarDerivatives<T>& w) {
  return std::array<std::pair<const char*, T>, 5>{
      {{"w_t", w.w_t}, {"w_l", w.w_l}, {"w_tt", w.w_tt}, {"w_tl", w.w_tl}, {"w_ll", w.w_ll}}};
}
template <class T>
auto named_members(const LogBalance<T>& b, bool coupled) {
  std::vector<std::pair<const char*, T>> out{
      {"g_xi", b.g_xi}, {"g_zeta", b.g_zeta}, {"uu", b.uu}, {"uv", b.uv}, {"vv", b.vv}};
  if (coupled) {
    for (const auto& more :
         {std::pair<const char*, T>{"g_rho", b.g_rho}, {"uw", b.uw}, {"vw", b.vw}, {"ww", b.ww}})
      out.push_back(more);
  }
  return out;
}

template <class Point, class Over>
void expect_held(const Over& over, const Point& point) {
  for (std::size_t k = 0; k < point.size(); ++k)
    EXPECT_TRUE(is_held(over[k].second, point[k].second, point[k].first));
}

template <class T>
CentrifugalRates<T> rates(const double (&c)[3]) {
  return {T(c[0]), T(c[1]), T(c[2])};
}

struct Rates {
  double c[3];
  explicit Rates(Random& random) {
    for (double& each : c) each = random.integer(0, 4) == 0 ? 0.0 : random.log_uniform(1e-2, 10.0);
  }
};

template <class Model>
class PlanarIntervalTest : public ::testing::Test {};
TYPED_TEST_SUITE(PlanarIntervalTest, BuiltInPlanarModels, ModelName);

TYPED_TEST(PlanarIntervalTest, DerivativesHoldEveryPointValue) {
  Random random(911);
  for (int trial = 0; trial < interval_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Sample s = draw_sample(random);
    const auto over = with_coefficients(model, Interval::decimal)
                          .template evaluate<2>(planar_invariants(s.x[0], s.x[1]));
    const auto point =
        widen<Real50>(model).template evaluate<2>(planar_invariants(s.at[0], s.at[1]));
    // Far from its middle a wide box may leave a formula without a bound; a narrow one may not.
    if (!over.w_t.bounded() && s.x[0].hi > 1.5 * s.x[0].lo) continue;
    expect_held(named_members(over), named_members(point));
    EXPECT_TRUE(is_held(over.w, point.w, "w")) << text_of(model);
  }
}

TYPED_TEST(PlanarIntervalTest, BalanceHoldsEveryPointValue) {
  Random random(912);
  for (int trial = 0; trial < interval_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Sample s = draw_sample(random);
    const Rates c(random);
    const auto over = with_coefficients(model, Interval::decimal)
                          .log_balance(s.x[0], s.x[1], Interval(c.c[0]), Interval(c.c[1]));
    const auto wide = widen<Real50>(model);
    const auto point = wide.log_balance(s.at[0], s.at[1], Real50(c.c[0]), Real50(c.c[1]));
    expect_held(named_members(over, false), named_members(point, false));
  }
}

TYPED_TEST(PlanarIntervalTest, BothWaysToTheBalanceAgree) {
  Random random(913);
  for (int trial = 0; trial < 50; ++trial) {
    const auto model = widen<Real50>(draw<TypeParam>(random));
    const Sample s = draw_sample(random);
    const Rates c(random);
    const auto direct = model.log_balance(s.at[0], s.at[1], Real50(c.c[0]), Real50(c.c[1]));
    const auto w = model.template evaluate<2>(planar_invariants(s.at[0], s.at[1]));
    const auto through = planar_log_balance<2>(w, s.at[0], s.at[1], rates<Real50>(c.c));
    const auto a = named_members(direct, false);
    const auto b = named_members(through, false);
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_LE(abs(a[k].second - b[k].second), Real50("1e-34") * (1 + abs(a[k].second)))
          << a[k].first;
    }
  }
}

template <class Model>
class CoupledIntervalTest : public ::testing::Test {};
TYPED_TEST_SUITE(CoupledIntervalTest, BuiltInCoupledModels, ModelName);

TYPED_TEST(CoupledIntervalTest, BalanceHoldsEveryPointValueAndBothWaysAgree) {
  Random random(914);
  for (int trial = 0; trial < interval_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Sample s = draw_sample(random);
    const Rates c(random);
    const auto over = with_coefficients(model, Interval::decimal)
                          .log_balance(s.x[0], s.x[1], s.x[2], Interval(c.c[0]), Interval(c.c[1]),
                                       Interval(c.c[2]));
    const auto wide = widen<Real50>(model);
    const auto point =
        wide.log_balance(s.at[0], s.at[1], s.at[2], Real50(c.c[0]), Real50(c.c[1]), Real50(c.c[2]));
    expect_held(named_members(over, true), named_members(point, true));
    const auto w = wide.template evaluate<2>(planar_invariants(s.at[0], s.at[1]), s.at[2]);
    const auto through = coupled_log_balance<2>(w, s.at[0], s.at[1], s.at[2], rates<Real50>(c.c));
    const auto a = named_members(point, true);
    const auto b = named_members(through, true);
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_LE(abs(a[k].second - b[k].second), Real50("1e-40") * (1 + abs(a[k].second)))
          << a[k].first;
    }
  }
}

template <class Model>
class ThicknessIntervalTest : public ::testing::Test {};
TYPED_TEST_SUITE(ThicknessIntervalTest, BuiltInThicknessModels, ModelName);

TYPED_TEST(ThicknessIntervalTest, DerivativesHoldEveryPointValue) {
  Random random(915);
  for (int trial = 0; trial < interval_trials; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Sample s = draw_sample(random);
    const auto over = with_coefficients(model, Interval::decimal).template evaluate<2>(s.x[0]);
    const auto point = widen<Real50>(model).template evaluate<2>(s.at[0]);
    EXPECT_TRUE(is_held(over.v, point.v, "v"));
    EXPECT_TRUE(is_held(over.v_r, point.v_r, "v_r"));
    EXPECT_TRUE(is_held(over.v_rr, point.v_rr, "v_rr"));
    const double m = random.log_uniform(1e-2, 10.0);
    const auto balance =
        with_coefficients(model, Interval::decimal).log_balance(s.x[0], Interval(m));
    const Real50 g = point.v_r - m * s.at[0] * s.at[0];
    const Real50 slope = point.v_rr - 2 * m * s.at[0] * s.at[0];
    EXPECT_TRUE(is_held(balance.g_rho, g, "g_rho"));
    EXPECT_TRUE(is_held(balance.ww, slope, "ww"));
    const auto direct = widen<Real50>(model).log_balance(s.at[0], Real50(m));
    EXPECT_LE(abs(direct.g_rho - g), Real50("1e-40") * (1 + abs(g)));
    EXPECT_LE(abs(direct.ww - slope), Real50("1e-40") * (1 + abs(slope)));
  }
}

/// hencky takes a series near the circle and a logarithm away from it: intervals that lie on the
/// switch, on the circle, and at large ratios.
TEST(HenckyInterval, AcrossItsFormulas) {
  Random random(916);
  for (int trial = 0; trial < 2000; ++trial) {
    const double ratio = trial % 3 == 0 ? 3.0 : trial % 3 == 1 ? 1.0 : random.log_uniform(1.0, 1e3);
    const double width = random.log_uniform(1e-16, 0.5);
    const Interval xi(ratio, ratio * (1.0 + width));
    const Interval zeta(1.0, 1.0 + random.uniform(0.0, 1.0) * width);
    const Hencky<> model{1.3, 0.4};
    const auto over = with_coefficients(model, [](double c) {
                        return Interval(c);
                      }).evaluate<2>(planar_invariants(xi, zeta));
    const Real50 x = Real50(xi.lo) + (Real50(xi.hi) - Real50(xi.lo)) * random.uniform(0.0, 1.0);
    const Real50 z =
        Real50(zeta.lo) + (Real50(zeta.hi) - Real50(zeta.lo)) * random.uniform(0.0, 1.0);
    const auto point = widen<Real50>(model).evaluate<2>(planar_invariants(x, z));
    expect_held(named_members(over), named_members(point));
    if (width < 1e-10) {
      EXPECT_LE(over.w_ll.width(), 1e-7);
    }
  }
}

template <class Model>
class StateIntervalTest : public ::testing::Test {};
TYPED_TEST_SUITE(StateIntervalTest, WholeModels, ModelName);

TYPED_TEST(StateIntervalTest, LinearizationHoldsEveryPointValue) {
  Random random(917);
  for (int trial = 0; trial < 200; ++trial) {
    const auto model = draw<TypeParam>(random);
    const Body body = random.body();
    const Stretch q = random.diagonal_stretch();
    const double nu = random.uniform(-2.0, 2.0);
    const auto over = straight_state<Interval>(
        {body.J1, body.J2, body.J3}, with_coefficients(model, Interval::decimal), Interval(q.xi),
        Interval(q.zeta), Interval(q.rho), Interval(nu));
    const auto point = straight_state<Real50>({Real50(body.J1), Real50(body.J2), Real50(body.J3)},
                                              widen<Real50>(model), Real50(q.xi), Real50(q.zeta),
                                              Real50(q.rho), Real50(nu));
    EXPECT_TRUE(is_held(over.V_aa, point.V_aa, "V_aa"));
    EXPECT_TRUE(is_held(over.V_xx, point.V_xx, "V_xx"));
    EXPECT_TRUE(is_held(over.V_xz, point.V_xz, "V_xz"));
    EXPECT_TRUE(is_held(over.V_zz, point.V_zz, "V_zz"));
    EXPECT_TRUE(is_held(over.V_rr, point.V_rr, "V_rr"));
    const auto even = even_pencil_i(over).characteristic();
    const auto even_at = even_pencil_i(point).characteristic();
    const auto odd = odd_forms_i(over).characteristic();
    const auto odd_at = odd_forms_i(point).characteristic();
    const auto third = even_block_iii(over).characteristic_coupled();
    const auto third_at = even_block_iii(point).characteristic_coupled();
    for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(is_held(even.c[k], even_at.c[k], "even (i)"));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(is_held(odd.c[k], odd_at.c[k], "odd (i)"));
    for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(is_held(third.c[k], third_at.c[k], "(iii)"));
    EXPECT_TRUE(is_held(odd_lambda_iii(over), odd_lambda_iii(point), "odd (iii)"));
  }
}

/// Tensors of lib evaluated in intervals at alpha != 0.
TEST(BalanceInterval, ResidualAndCompatibilityHoldEveryPointValue) {
  Random random(918);
  const Separable<NeoHookean<>, ReciprocalQuadratic<>> model{{0.7, 1.9}, {1.0, 3.0}};
  for (int trial = 0; trial < 200; ++trial) {
    const Body body = random.body();
    const Stretch q = random.stretch();
    const Vector3<double> nu = random.direction<3>();
    const auto over = [&](const auto& f) { return f.template operator()<Interval>(); };
    const auto exactly = [&](const auto& f) { return f.template operator()<Real50>(); };
    const auto residual = [&]<class T>() {
      return Vector4<T>(balance_residual(body, model,
                                         BasicStretch<T>{T(q.alpha), T(q.xi), T(q.zeta), T(q.rho)},
                                         Vector3<T>(T(nu[0]), T(nu[1]), T(nu[2]))));
    };
    const auto compatibility = [&]<class T>() {
      return Vector3<T>(
          compatibility_residual(body, BasicStretch<T>{T(q.alpha), T(q.xi), T(q.zeta), T(q.rho)},
                                 Vector3<T>(T(nu[0]), T(nu[1]), T(nu[2]))));
    };
    for (int i = 0; i < 4; ++i)
      EXPECT_TRUE(is_held(over(residual)[i], exactly(residual)[i], "balance"));
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(is_held(over(compatibility)[i], exactly(compatibility)[i], "compatibility"));
  }
}

}  // namespace
}  // namespace stationary
