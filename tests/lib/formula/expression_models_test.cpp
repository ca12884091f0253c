// A potential written out is the built-in one: to rounding in doubles and extended numbers, by
// enclosure in intervals, by its bounds in conditioned numbers. What only written potentials have:
// slopes in their parameters, rest states that are looked for.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/material/models/coefficients.hpp"
#include "lib/material/potential.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/first_order_bound.hpp"
#include "lib/number/interval.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/bodies/written_potential.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

template <class S>
std::array<S, 6> numbers(const PlanarDerivatives<S>& w) {
  return {w.w, w.w_t, w.w_l, w.w_tt, w.w_tl, w.w_ll};
}
template <class S>
std::array<S, 3> numbers(const ThicknessDerivatives<S>& v) {
  return {v.v, v.v_r, v.v_rr};
}
template <class S>
std::array<S, 10> numbers(const CoupledDerivatives<S>& w) {
  return {w.plane.w,    w.plane.w_t, w.plane.w_l, w.plane.w_tt, w.plane.w_tl,
          w.plane.w_ll, w.w_r,       w.w_rr,      w.w_tr,       w.w_lr};
}
template <class S>
std::array<S, 9> numbers(const LogBalance<S>& b) {
  return {b.g_xi, b.g_zeta, b.g_rho, b.uu, b.uv, b.vv, b.uw, b.vw, b.ww};
}

/// Every derivative of the models' order, at a state of any number type: three functions of one
/// argument so that what follows serves all three kinds.
struct AtPlane {
  template <class Model, class S>
  auto operator()(const Model& model, const std::array<S, 6>& x) const {
    return numbers(model.template evaluate<2>(planar_invariants(x[0], x[1])));
  }
};
struct AtThickness {
  template <class Model, class S>
  auto operator()(const Model& model, const std::array<S, 6>& x) const {
    return numbers(model.template evaluate<2>(x[2]));
  }
};
struct AtBoth {
  template <class Model, class S>
  auto operator()(const Model& model, const std::array<S, 6>& x) const {
    return numbers(model.template evaluate<2>(planar_invariants(x[0], x[1]), x[2]));
  }
};
struct PlaneBalance {
  template <class Model, class S>
  auto operator()(const Model& model, const std::array<S, 6>& x) const {
    return numbers(model.log_balance(x[0], x[1], x[3], x[4]));
  }
};
struct ThicknessBalance {
  template <class Model, class S>
  auto operator()(const Model& model, const std::array<S, 6>& x) const {
    return numbers(model.log_balance(x[2], x[5]));
  }
};
struct BothBalance {
  template <class Model, class S>
  auto operator()(const Model& model, const std::array<S, 6>& x) const {
    return numbers(model.log_balance(x[0], x[1], x[2], x[3], x[4], x[5]));
  }
};

template <class T>
std::array<T, 6> state_in(const std::array<double, 6>& x) {
  std::array<T, 6> out;
  for (std::size_t k = 0; k < 6; ++k) out[k] = T(x[k]);
  return out;
}

/// The written model against the built-in one in 50 digits.
template <class At, class Written, class BuiltIn>
void expect_as_built_in(const Written& written, const BuiltIn& built_in, const std::string& text) {
  const At at;
  const auto wide = with_coefficients(built_in, [](double c) { return Real50(c); });
  const auto conditioned = with_coefficients(written, Conditioned::input);
  const auto of_built_in = with_coefficients(built_in, Conditioned::input);
  const auto intervals = with_coefficients(written, [](double c) { return Interval(c); });
  Random random(417);
  for (int trial = 0; trial < 40; ++trial) {
    std::array<double, 6> x;
    for (double& each : x) each = random.log_uniform(0.2, 5.0);
    if (trial == 0) x[1] = x[0];
    const auto expected = at(wide, state_in<Real50>(x));
    const std::array<double, 2> shift{random.uniform(-1e-9, 1e-9), random.uniform(-1e-9, 1e-9)};
    const auto moved = at(
        with_indexed_coefficients(
            built_in, [&](double c, std::size_t k) { return Real50(c) * (1 + Real50(shift[k])); }),
        state_in<Real50>(x));
    const auto plain = at(written, x);
    const auto extended = at(written, state_in<DoubleDouble>(x));
    const auto enclosed = at(intervals, state_in<Interval>(x));
    const auto bound = at(conditioned, state_in<Conditioned>(x));
    const auto inputs = at(of_built_in, state_in<Conditioned>(x));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const double value = nearest(expected[k]);
      if (std::isnan(value)) {
        EXPECT_TRUE(std::isnan(plain[k])) << text << " number " << k;
        continue;
      }
      // What a change of coefficients (and of states, were they inputs) by 2^-53 does.
      const double terms = bound[k].condition + inputs[k].condition + std::abs(value);
      const std::string place =
          text + ", number " + std::to_string(k) + ", " + support::at(x[0], x[1], x[2]);
      ASSERT_TRUE(agrees(place, value, plain[k], 30 * 0x1p-53 * terms));
      ASSERT_TRUE(agrees(place, expected[k], exact<Real50>(extended[k]), Real50(0x1p-78 * terms)));
      ASSERT_TRUE(Real50(enclosed[k].lo) <= expected[k] && expected[k] <= Real50(enclosed[k].hi))
          << place << " not in " << enclosed[k].lo << ", " << enclosed[k].hi;
      ASSERT_LE(enclosed[k].width(), 0x1p-38 * terms + 1e-285) << place;
      // The condition bounds what a change of the coefficients does, and not wildly.
      const double change = std::abs(nearest(Real50(moved[k] - expected[k])));
      ASSERT_LE(change, 1e-9 * bound[k].condition * (1.0 + 1e-6) + 1e-25) << place;
      ASSERT_LE(bound[k].condition, 200.0 * (inputs[k].condition + std::abs(value)) + 1e-12)
          << place;
    }
  }
}

template <class BuiltIn>
void expect_same_plane(const std::string& text, const BuiltIn& built_in) {
  const auto c = built_in.coefficients();
  const auto written = written_plane(text, p_and_q, {c[0], c[1]});
  expect_as_built_in<AtPlane>(written, built_in, text);
  expect_as_built_in<PlaneBalance>(written, built_in, text + ", balance");
}

TEST(ExpressionModels, BuiltInPlanesWrittenOut) {
  expect_same_plane("p/d + q/2*(t^2 - 2*d)", ReciprocalDeterminant<>{1.3, 0.7});
  expect_same_plane("p*((I1^2 - 2*d^2) - 2*I1 + 2)/4 + q/8*(I1 - 2)^2",
                    SaintVenantKirchhoff<>{1.3, 0.7});
  expect_same_plane("p*(I1 - 2*t + 2) + q/2*(t - 2)^2", Biot<>{1.3, 0.7});
  expect_same_plane("p*(I1 - 2*t + 2) + q/2*log(d)^2", BiotLog<>{1.3, 0.7});
  expect_same_plane("p/2*(I1 - 2 - 2*log(d)) + q/2*log(d)^2", NeoHookean<>{1.3, 0.7});
}

TEST(ExpressionModels, BuiltInPlanesWrittenInTheStretches) {
  expect_same_plane("p*(log(lambda)^2 + log(mu_)^2) + q/2*log(lambda*mu_)^2", Hencky<>{1.3, 0.7});
  expect_same_plane("p*((lambda - 1)^2 + (mu_ - 1)^2) + q/2*(lambda + mu_ - 2)^2",
                    Biot<>{1.3, 0.7});
  expect_same_plane("p*((xi - 1)^2 + (zeta - 1)^2 + 2*alpha^2) + q/2*(xi + zeta - 2)^2",
                    Biot<>{1.3, 0.7});
  expect_same_plane("p/2*(lambda^2 + mu_^2 - 2 - 2*log(lambda*mu_)) + q/2*log(xi*zeta - alpha^2)^2",
                    NeoHookean<>{1.3, 0.7});
}

TEST(ExpressionModels, BuiltInThicknessesWrittenOut) {
  const ReciprocalQuadratic<> reciprocal{1.3, 0.7};
  const Harmonic<> harmonic{1.3, 0.7};
  const auto first = written_thickness("p/rho + q/2*rho^2", p_and_q, {1.3, 0.7});
  const auto second = written_thickness("p/2*(rho - q)^2", p_and_q, {1.3, 0.7});
  expect_as_built_in<AtThickness>(first, reciprocal, "reciprocal-quadratic");
  expect_as_built_in<ThicknessBalance>(first, reciprocal, "reciprocal-quadratic, balance");
  expect_as_built_in<AtThickness>(second, harmonic, "harmonic");
  expect_as_built_in<ThicknessBalance>(second, harmonic, "harmonic, balance");
  for (const double m : {0.0, 0.1, 0.5, 0.69}) {
    EXPECT_NEAR(first.balanced(m), reciprocal.balanced(m), 1e-14 * reciprocal.balanced(m));
    EXPECT_NEAR(second.balanced(m), harmonic.balanced(m), 1e-14 * harmonic.balanced(m));
  }
  EXPECT_TRUE(std::isnan(first.balanced(0.7)));
}

TEST(ExpressionModels, BuiltInCoupledWrittenOut) {
  const NeoHookean3d<> built_in{1.3, 0.7};
  const auto written = written_coupled("p/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + q/2*log(d*rho)^2",
                                       p_and_q, {1.3, 0.7});
  expect_as_built_in<AtBoth>(written, built_in, "neo-hookean-3d");
  expect_as_built_in<BothBalance>(written, built_in, "neo-hookean-3d, balance");
  EXPECT_EQ(written.rest_stretch(), 1.0);
  EXPECT_EQ(written.rest_thickness(), 1.0);
}

const std::vector<const char*> planes{
    "p*(exp(t - 2) - t) + q*log(d)^2",
    "p*tanh(t)*sqrt(1 + d) + q/(t + d)",
    "p*sin(t) + q*cos(d)*atan(t*d)",
    "p*t^1.5*d^q + d^-0.25",
    "q*(lambda^p + mu_^p) + 1/d",
    "p*exp(lambda*mu_/2) + q*(sqrt(lambda) + sqrt(mu_))",
    "(log(lambda)^2 + log(mu_)^2)^2 + q*(lambda^3 + mu_^3)/(lambda + mu_)^2"};

/// W(t + h a, l + h b) and its gradient: each derivative is the slope of the one before.
TEST(ExpressionModels, DerivativesAreSlopes) {
  Random random(418);
  for (const char* text : planes) {
    const auto model = written_plane(text, p_and_q, {1.25, 0.75});
    for (int trial = 0; trial < 3; ++trial) {
      const Real50 xi(random.log_uniform(0.4, 2.5));
      const Real50 zeta(random.log_uniform(0.4, 2.5));
      const double a = random.uniform(-1.0, 1.0);
      const double b = random.uniform(-1.0, 1.0);
      const auto at = [&](const Real50& h) {
        const Real50 t = xi + zeta + h * a;
        const Real50 d = xi * zeta * exp(Real50(h * b));
        return model.evaluate<2>(PlanarInvariants<Real50>{t, d, t * t - 4 * d});
      };
      using Three = Eigen::Matrix<Real50, 3, 1>;
      const auto w = at(Real50(0));
      const Three slope{w.w_t * a + w.w_l * b, w.w_tt * a + w.w_tl * b, w.w_tl * a + w.w_ll * b};
      EXPECT_TRUE(is_slope(
          text,
          [&](const Real50& h) {
            const auto moved = at(h);
            return Three{moved.w, moved.w_t, moved.w_l};
          },
          slope));
    }
  }
}

/// The balance in the stretches themselves is that of the derivatives in t and l.
TEST(ExpressionModels, BalanceIsThatOfTheDerivatives) {
  Random random(419);
  for (const char* text : planes) {
    const auto model = written_plane(text, p_and_q, {1.25, 0.75});
    for (int trial = 0; trial < 5; ++trial) {
      const Real50 xi(random.log_uniform(0.4, 2.5));
      const Real50 zeta(random.log_uniform(0.4, 2.5));
      const CentrifugalRates<Real50> c{Real50(0.25), Real50(0.5), Real50(0)};
      const auto expected =
          planar_log_balance<2>(model.evaluate<2>(planar_invariants(xi, zeta)), xi, zeta, c);
      const auto actual = model.log_balance(xi, zeta, c.xi, c.zeta);
      const auto alone = model.residual(xi, zeta, c.xi, c.zeta);
      EXPECT_EQ(alone.g_xi, actual.g_xi);
      EXPECT_EQ(alone.g_zeta, actual.g_zeta);
      const auto x = numbers(expected);
      const auto y = numbers(actual);
      for (const std::size_t k : {0U, 1U, 3U, 4U, 5U})
        EXPECT_TRUE(
            agrees(std::string(text) + " " + std::to_string(k), x[k], y[k], Real50("1e-40")));
    }
  }
}

/// Dual coefficients take a program of their own; the general way is through another state type.
TEST(ExpressionModels, SlopesInTheParameters) {
  Random random(420);
  using Dual8 = Dual<double, 8>;
  for (const char* text : planes) {
    const std::array<double, 2> values{1.25, 0.75};
    const auto model = written_plane(text, p_and_q, {values[0], values[1]});
    const auto dual = with_indexed_coefficients(model, [](double c, std::size_t k) {
      Dual8 out(c);
      out.slope[k + 1] = 2.0;
      return out;
    });
    const double xi = random.log_uniform(0.4, 2.5);
    const double zeta = random.log_uniform(0.4, 2.5);
    const auto w = dual.evaluate<1>(planar_invariants(xi, zeta));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto shifted = [&](const char* h) {
        return with_indexed_coefficients(
                   model,
                   [&](double c, std::size_t j) { return Real50(c) + (j == k ? Real50(h) : 0); })
            .evaluate<1>(planar_invariants(Real50(xi), Real50(zeta)));
      };
      const auto above = shifted("1e-20");
      const auto below = shifted("-1e-20");
      const auto slope = [](const Real50& a, const Real50& b) {
        return nearest(Real50((a - b) / Real50("1e-20")));
      };
      EXPECT_NEAR(w.w.slope[k + 1], slope(above.w, below.w), 1e-12) << text;
      EXPECT_NEAR(w.w_t.slope[k + 1], slope(above.w_t, below.w_t), 1e-12) << text;
      EXPECT_NEAR(w.w_l.slope[k + 1], slope(above.w_l, below.w_l), 1e-12) << text;
      EXPECT_EQ(w.w_t.slope[0], 0.0);
    }
    const auto by_residual = model.residual_sensitivity(xi, zeta);
    ASSERT_TRUE(by_residual.has_value()) << text;
    for (std::size_t i = 0; i < 2; ++i) {
      double sum = 0.0;
      const double x = i == 0 ? xi : zeta;
      for (std::size_t k = 0; k < 2; ++k)
        sum += 0.5 * std::abs(values[k] * (x * w.w_t.slope[k + 1] + w.w_l.slope[k + 1]));
      EXPECT_NEAR((*by_residual)[i], sum, 1e-12 * (1.0 + sum)) << text;
    }
    const auto plain = model.evaluate<1>(planar_invariants(xi, zeta));
    EXPECT_NEAR(w.w_t.value, plain.w_t, 1e-14 * (1.0 + std::abs(plain.w_t))) << text;
    EXPECT_NEAR(w.w_l.value, plain.w_l, 1e-14 * (1.0 + std::abs(plain.w_l))) << text;
  }
}

TEST(ExpressionModels, IntervalsHoldThePointsOfBoxes) {
  Random random(421);
  for (const char* text : planes) {
    const auto model = written_plane(text, p_and_q, {1.25, 0.75});
    const auto intervals = with_coefficients(model, [](double c) { return Interval(c); });
    for (int trial = 0; trial < 40; ++trial) {
      const double width = std::exp2(random.uniform(-30.0, -1.0));
      const double u = random.log_uniform(0.4, 2.0);
      const double v = random.integer(0, 3) == 0 ? u : random.log_uniform(0.4, 2.0);
      const Interval xi(u, u * (1.0 + width));
      const Interval zeta(v, v * (1.0 + width));
      const auto box = numbers(intervals.evaluate<2>(planar_invariants(xi, zeta)));
      const auto balance = numbers(intervals.log_balance(xi, zeta, Interval(0.25), Interval(0.5)));
      for (int inside = 0; inside < 3; ++inside) {
        const DoubleDouble x(random.uniform(xi.lo, xi.hi));
        const DoubleDouble z(random.uniform(zeta.lo, zeta.hi));
        const auto point = numbers(model.evaluate<2>(planar_invariants(x, z)));
        const auto forces = numbers(model.log_balance(x, z, DoubleDouble(0.25), DoubleDouble(0.5)));
        for (std::size_t k = 0; k < point.size(); ++k)
          ASSERT_TRUE(box[k].may_be(double(point[k])))
              << text << " number " << k << " " << at(u, v, width);
        for (const std::size_t k : {0U, 1U, 3U, 4U, 5U})
          ASSERT_TRUE(balance[k].may_be(double(forces[k]))) << text << " balance " << k;
      }
    }
  }
}

/// States that carry slopes, over doubles and over intervals: Hessians of the balance, and proofs
/// that need slopes over a box.
TEST(ExpressionModels, DualStates) {
  Random random(422);
  using DualBox = Dual<Interval, 2>;
  for (const char* text : planes) {
    const auto model = written_plane(text, p_and_q, {1.25, 0.75});
    const auto intervals = with_coefficients(model, [](double c) { return Interval(c); });
    for (int trial = 0; trial < 5; ++trial) {
      const double xi = random.log_uniform(0.4, 2.5);
      const double zeta = trial == 0 ? xi : random.log_uniform(0.4, 2.5);
      const auto b = model.log_balance(xi, zeta, 0.25, 0.5);
      const auto box = intervals.evaluate<1>(planar_invariants(
          DualBox::logarithmic(Interval(xi), 0), DualBox::logarithmic(Interval(zeta), 1)));
      const auto point = model.evaluate<1>(
          planar_invariants(Dual2::logarithmic(xi, 0), Dual2::logarithmic(zeta, 1)));
      const Dual2 g = Dual2::logarithmic(xi, 0) * point.w_t + point.w_l;
      const DualBox G = DualBox::logarithmic(Interval(xi), 0) * box.w_t + box.w_l;
      const std::array<double, 2> expected{b.uu + 2.0 * 0.25 * xi * xi, b.uv};
      for (std::size_t k = 0; k < 2; ++k) {
        const double size = 1.0 + std::abs(expected[k]);
        EXPECT_NEAR(g.slope[k], expected[k], 1e-12 * size) << text;
        EXPECT_LE(G.slope[k].lo, expected[k] + 1e-13 * size) << text;
        EXPECT_GE(G.slope[k].hi, expected[k] - 1e-13 * size) << text;
        EXPECT_LE(G.slope[k].width(), 1e-8 * size) << text;
      }
    }
  }
}

/// A decimal number that no double is: as intervals, both are held.
TEST(ExpressionModels, DecimalNumbers) {
  const auto model = written_plane("0.1*t + 0.25*d", {}, {});
  const auto intervals = with_coefficients(model, [](double c) { return Interval(c); });
  const auto w = intervals.evaluate<2>(planar_invariants(Interval(1.0), Interval(1.0)));
  EXPECT_LT(w.w_t.lo, 0.1);
  EXPECT_GT(w.w_t.hi, 0.1);
  EXPECT_TRUE(w.w_l.may_be(0.25));
  EXPECT_LT(w.w_l.width(), 1e-15);
  EXPECT_EQ(model.evaluate<1>(extended_invariants(1.0, 1.0)).w_t.lo, 0.0);
}

/// (c x)^n where c^n overflows, or is nothing, and (c x)^n is of order one.
TEST(ExpressionModels, LargePowersOfScaledStretches) {
  struct Power {
    const char* text;
    double scale;
    int n;
  };
  for (const auto& [text, scale, n] :
       {Power{"mu*(t/20)^243", 20.0, 243}, Power{"mu/(t/20)^243", 20.0, -243},
        Power{"mu*(100*t)^(-400)", 0.01, -400}}) {
    const auto model = written_plane(text, {"mu"}, {3.0});
    const double t = 0.999 * scale;
    const auto w = model.evaluate<2>(planar_invariants(0.5 * t, 0.5 * t));
    const double exact = 3.0 * std::pow(0.999, n);
    EXPECT_NEAR(w.w, exact, 1e-12 * exact) << text;
    EXPECT_NEAR(w.w_t * t, n * exact, 1e-11 * std::abs(n) * exact) << text;
  }
}

TEST(ExpressionModels, RestStates) {
  EXPECT_EQ(
      written_plane("p/2*(I1 - 2 - 2*log(d)) + q/2*log(d)^2", p_and_q, {1.0, 2.0}).rest_stretch(),
      1.0);
  // Minima in d at 0.25 and 2.25, r = 0.5 and 1.5: the second is the nearer one, in its logarithm.
  EXPECT_NEAR(written_plane("(d - 0.25)^2*(d - 2.25)^2", {}, {}).rest_stretch(), 1.5, 1e-14);
  EXPECT_TRUE(std::isnan(written_plane("t^2", {}, {}).rest_stretch()));
  EXPECT_TRUE(std::isnan(written_plane("-log(d)^2", {}, {}).rest_stretch()));
  EXPECT_NEAR(written_plane("p*d + 1/d", p_and_q, {1e-8, 0.0}).rest_stretch(), 100.0, 1e-11);

  const auto wells = written_thickness("(rho - 0.8)^2*(rho - 3)^2", {}, {});
  EXPECT_NEAR(wells.rest_thickness(), 0.8, 1e-15);
  // From the first well outward V' = m rho until it turns at a fold; the other well is not reached.
  const double below = wells.balanced(0.5);
  EXPECT_GT(below, 0.8);
  EXPECT_LT(below, 1.2);
  EXPECT_NEAR(wells.evaluate<1>(below).v_r, 0.5 * below * below, 1e-13);
  EXPECT_TRUE(std::isnan(wells.balanced(5.0)));
  EXPECT_TRUE(std::isnan(written_thickness("rho", {}, {}).rest_thickness()));

  const auto coupled = written_coupled("(d - 4)^2 + (rho*t - 6)^2 + (rho - 1.5)^2", {}, {});
  EXPECT_NEAR(coupled.rest_stretch(), 2.0, 1e-12);
  EXPECT_NEAR(coupled.rest_thickness(), 1.5, 1e-12);
  EXPECT_TRUE(std::isnan(written_coupled("d*rho", {}, {}).rest_stretch()));
}

/// At a pole or a kink the slope of V turns from - to + as it does at a minimum, and so may the
/// rounding error of a slope that is 0.
TEST(ExpressionModels, RestIsAMinimumAndNoPoleOrNoise) {
  const double r = written_plane("log((d-1.5)^2) + 3*(d-4)^2 + t^2/d", {}, {}).rest_stretch();
  EXPECT_NEAR(1.0 / (r * r - 1.5) + 3.0 * (r * r - 4.0), 0.0, 1e-12);
  EXPECT_GT(r, 1.9);
  const double rho =
      written_thickness("log((rho - 1.5)^2) + 3*(rho - 4)^2", {}, {}).rest_thickness();
  EXPECT_NEAR(1.0 / (rho - 1.5) + 3.0 * (rho - 4.0), 0.0, 1e-12);
  EXPECT_GT(rho, 3.0);
  // A kink nearer to 1 than the minimum.
  EXPECT_NEAR(written_thickness("sqrt((rho - 1.1)^2) + (1 - rho)*exp(-9*(rho - 1.5)^2)", {}, {})
                  .rest_thickness(),
              1.5, 0.3);
  for (const char* text : {"t^2/d", "(t^2 - 4*d)*p", "log(t^2/d)*q", "exp(t/sqrt(d))"})
    EXPECT_TRUE(std::isnan(written_plane(text, p_and_q, {0.1, 0.7}).rest_stretch())) << text;
  EXPECT_TRUE(
      std::isnan(written_thickness("log(p*rho^3) - log(q*rho) - 2*log(rho)", p_and_q, {0.1, 0.7})
                     .rest_thickness()));
  // A flat minimum is one.
  EXPECT_NEAR(written_thickness("(rho - 1.3)^4", {}, {}).rest_thickness(), 1.3, 1e-12);
}

/// Of two minima that Newton finds the nearer one, whichever is found first.
TEST(ExpressionModels, CoupledRestIsTheNearestMinimum) {
  const auto in_plane =
      written_coupled("(d - 0.25)^2*(d - 2.25)^2 + (rho - 1)^2 + 0*t*rho", {}, {});
  EXPECT_NEAR(in_plane.rest_stretch(), 1.5, 1e-12);
  EXPECT_NEAR(in_plane.rest_thickness(), 1.0, 1e-12);
  const auto across = written_coupled("(d - 1)^2 + (rho - 0.4)^2*(rho - 2)^2", {}, {});
  EXPECT_NEAR(across.rest_stretch(), 1.0, 1e-12);
  EXPECT_NEAR(across.rest_thickness(), 2.0, 1e-12);
}

TEST(ExpressionModels, CoefficientsAreCounted) {
  const auto parsed = parse_expression("p*d", p_and_q, ExpressionSlot::plane);
  const std::vector<double> one{1.0};
  EXPECT_THROW(
      PlanarExpression<>(expression::planar_tape(parsed.expression), coefficient_list(one)),
      std::invalid_argument);
  EXPECT_NO_THROW(coefficient_list(std::vector<double>(32, 1.0)));
  EXPECT_THROW(coefficient_list(std::vector<double>(33, 1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace stationary
