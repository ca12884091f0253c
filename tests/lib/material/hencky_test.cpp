// Hencky's potential keeps full precision where textbook formulas do not: at the circle lambda =
// mu, as near to it as doubles go, and on both sides of the points where it changes formula.
#include "lib/material/models/hencky.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lib/number/dual.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

/// B(x) = sum x^k/(2 k + 1), B' and B'', from so many terms.
std::array<Real50, 3> ratio_series(const Real50& x, int terms) {
  std::array<Real50, 3> out{0, 0, 0};
  Real50 power = 1;
  for (int k = 0; k < terms; ++k) {
    out[0] += power / (2 * k + 1);
    out[1] += power * (k + 1) / (2 * k + 3);
    out[2] += power * (k + 1) * (k + 2) / (2 * k + 5);
    power *= x;
  }
  return out;
}

/// B(x) = atanh(sqrt x)/sqrt x and B' from stretches, by formulas of their own: 2 atanh(sqrt x) =
/// log(a/b); near the circle from the series in 50 digits.
AtanhRatio<Real50> reference_ratio(const Real50& a, const Real50& b) {
  const Real50 difference = a - b;
  const Real50 root = abs(difference) / (a + b);
  const Real50 x = root * root;
  if (x < Real50("1e-6")) {
    const auto [value, slope, curvature] = ratio_series(x, 12);
    return {value, slope};
  }
  const Real50 value = abs(log(a / b)) / (2 * root);
  return {value, (1 / (1 - x) - value) / (2 * x)};
}

/// All derivatives from B, B', and the terms they are sums of.
struct Reference {
  PlanarDerivatives<Real50> derivatives;
  PlanarDerivatives<Real50> terms;
};

Reference reference(double mu, double lambda, double xi, double zeta) {
  const Real50 a = xi;
  const Real50 b = zeta;
  const auto ratio = reference_ratio(a, b);
  const Real50 t = a + b;
  const Real50 l = log(Real50(a * b));
  const Real50 x = (a - b) * (a - b) / (t * t);
  const Real50 bulk = Real50(mu) + lambda;
  const Real50 shear = 2 * mu * ratio.b;
  const Real50 slope = 2 * mu * (1 - x) * ratio.b_x;
  // One rounding of d moves its logarithm by eps, however small it is.
  const Real50 l_size = std::max<Real50>(abs(l), 1);
  Reference out;
  out.derivatives = {bulk * l * l / 2 + 2 * mu * x * ratio.b * ratio.b,
                     2 * shear / t,
                     bulk * l - shear,
                     (4 * slope - 2 * shear) / (t * t),
                     -2 * slope / t,
                     bulk + slope};
  out.terms = {bulk * abs(l) * l_size / 2 + 2 * mu * x * ratio.b * ratio.b,
               2 * shear / t,
               bulk * l_size + shear,
               (4 * slope + 2 * shear) / (t * t),
               2 * slope / t,
               bulk + slope};
  return out;
}

struct Entry {
  const char* name;
  Real50 PlanarDerivatives<Real50>::*wide;
  double PlanarDerivatives<double>::*narrow;
};
const Entry entries[] = {
    {"w", &PlanarDerivatives<Real50>::w, &PlanarDerivatives<double>::w},
    {"w_t", &PlanarDerivatives<Real50>::w_t, &PlanarDerivatives<double>::w_t},
    {"w_l", &PlanarDerivatives<Real50>::w_l, &PlanarDerivatives<double>::w_l},
    {"w_tt", &PlanarDerivatives<Real50>::w_tt, &PlanarDerivatives<double>::w_tt},
    {"w_tl", &PlanarDerivatives<Real50>::w_tl, &PlanarDerivatives<double>::w_tl},
    {"w_ll", &PlanarDerivatives<Real50>::w_ll, &PlanarDerivatives<double>::w_ll},
};

/// Every derivative within `units` rounding units of its terms.
::testing::AssertionResult full_precision(double mu, double lambda, double xi, double zeta,
                                          double units) {
  const auto actual = Hencky<>{mu, lambda}.evaluate<2>(planar_invariants(xi, zeta));
  const Reference expected = reference(mu, lambda, xi, zeta);
  for (const Entry& entry : entries) {
    const auto result = agrees<Real50>(
        at("hencky", mu, lambda, "xi zeta", xi, zeta, entry.name), expected.derivatives.*entry.wide,
        Real50(actual.*entry.narrow), units * unit_roundoff * expected.terms.*entry.wide);
    if (!result) return result;
  }
  return ::testing::AssertionSuccess();
}

TEST(Hencky, AtTheCircle) {
  for (const double s : {1.0, 0.3, 1.7, 1e-4, 1e4}) {
    EXPECT_TRUE(full_precision(1.1, 0.8, s, s, 12));
    const auto v = Hencky<>{1.1, 0.8}.evaluate<2>(planar_invariants(s, s));
    EXPECT_TRUE(std::isfinite(v.w_tt) && std::isfinite(v.w_tl) && std::isfinite(v.w_ll));
  }
}

TEST(Hencky, NearTheCircle) {
  Random random(601);
  for (double exponent = -16.0; exponent <= -1.0; exponent += 0.125) {
    const double offset = std::pow(10.0, exponent);
    const double s = random.log_uniform(0.2, 5.0);
    const double lambda = random.uniform(-0.3, 3.0);
    EXPECT_TRUE(full_precision(1.1, lambda, s * (1.0 + offset), s, 12));
    EXPECT_TRUE(full_precision(1.1, lambda, s, s * (1.0 + offset), 12));
  }
}

TEST(Hencky, OneUnitInTheLastPlaceFromTheCircle) {
  for (const double s : {1.0, 1.7, 0.4}) {
    EXPECT_TRUE(full_precision(1.1, 0.8, std::nextafter(s, 2.0 * s), s, 12));
    EXPECT_TRUE(full_precision(1.1, 0.8, s, std::nextafter(s, 0.0), 12));
  }
}

/// Stretch ratios whose x = e/t^2 lies about `x`, on both sides.
std::vector<double> ratios_about(double x) {
  const double root = std::sqrt(x);
  const double ratio = (1.0 + root) / (1.0 - root);
  std::vector<double> out{ratio};
  double next = ratio;
  double last = ratio;
  for (int k = 0; k < 20; ++k) {
    out.push_back(next = std::nextafter(next, 2.0 * ratio));
    out.push_back(last = std::nextafter(last, 1.0));
  }
  for (double offset = 1e-14; offset < 0.1; offset *= 3.0) {
    out.push_back(ratio * (1.0 + offset));
    out.push_back(ratio * (1.0 - offset));
  }
  return out;
}

TEST(Hencky, AboutItsSwitchPoints) {
  Random random(602);
  for (const double x : {0.25, 0x1p-16}) {
    for (const double ratio : ratios_about(x)) {
      const double s = random.log_uniform(0.2, 5.0);
      EXPECT_TRUE(full_precision(1.1, 0.8, ratio * s, s, 30));
      EXPECT_TRUE(full_precision(1.1, 0.8, s, ratio * s, 30));
    }
  }
}

TEST(Hencky, AboutTheLengthsOfItsSeries) {
  // The number of terms changes where x passes a power of two.
  for (int k = 3; k <= 60; ++k) {
    for (const double ratio : ratios_about(std::ldexp(1.0, -k)))
      EXPECT_TRUE(full_precision(1.1, 0.8, 1.3 * ratio, 1.3, 12));
  }
}

TEST(Hencky, FarFromTheCircle) {
  Random random(603);
  for (double ratio = 2.0; ratio < 1e12; ratio *= 1.3) {
    const double s = random.log_uniform(0.2, 5.0) / std::sqrt(ratio);
    EXPECT_TRUE(full_precision(1.1, 0.8, ratio * s, s, 30));
  }
}

TEST(Hencky, ItsRatioIsTheAnalyticFunction) {
  // B solves 2 x B' = 1/(1 - x) - B; the series and the logarithm give one function, in 50 digits.
  for (const char* text :
       {"1e-40", "1e-12", "0x1p-16", "1e-3", "0.2", "0.2499999", "0.2500001", "0.7", "0.999"}) {
    const std::string name = text;
    const Real50 x = name == "0x1p-16" ? ldexp(Real50(1), -16) : Real50(name);
    const Real50 root = sqrt(x);
    const PlanarInvariants<Real50> q{2, 1 - x, 4 * x};  // stretches 1 + root, 1 - root
    const auto ratio = atanh_ratio<2>(q, x, Real50(1 - x));
    const auto value_only = atanh_ratio<1>(q, x, Real50(1 - x));
    const Real50 expected = x < Real50("1e-9")
                                ? Real50(1 + x / 3 + x * x / 5 + x * x * x / 7 + x * x * x * x / 9)
                                : Real50(log((1 + root) / (1 - root)) / (2 * root));
    EXPECT_TRUE(agrees<Real50>(at("x", x), expected, ratio.b, Real50("1e-44")));
    EXPECT_TRUE(agrees<Real50>(at("x", x), expected, value_only.b, Real50("1e-44")));
    EXPECT_TRUE(
        agrees<Real50>(at("x", x), 1 / (1 - x) - ratio.b, 2 * x * ratio.b_x, Real50("1e-43")));
  }
}

TEST(Hencky, ExtendedPrecisionAcrossItsSwitch) {
  Random random(604);
  for (double exponent = -15.0; exponent <= 2.0; exponent += 0.05) {
    const double s = random.log_uniform(0.3, 3.0);
    const double xi = s * (1.0 + std::pow(10.0, exponent));
    const Hencky<> model{random.uniform(0.5, 2.0), random.uniform(-0.3, 2.0)};
    const auto actual = model.evaluate<1>(extended_invariants(xi, s));
    const Reference expected = reference(model.mu, model.lambda, xi, s);
    const std::string x = at(text_of(model), "xi zeta", xi, s);
    EXPECT_TRUE(agrees<Real50>(x, expected.derivatives.w_t, exact<Real50>(actual.w_t),
                               ldexp(expected.terms.w_t, -80)));
    EXPECT_TRUE(agrees<Real50>(x, expected.derivatives.w_l, exact<Real50>(actual.w_l),
                               ldexp(expected.terms.w_l, -80)));
  }
}

TEST(Hencky, IsTheSquareOfLogarithmicStrain) {
  // mu tr (ln S)^2 + (lambda/2) ln^2 d, from the principal stretches.
  Random random(605);
  for (int trial = 0; trial < 100; ++trial) {
    const auto model = widen<Real50>(random.coefficients<Hencky<>>());
    const Real50 xi = random.log_uniform(0.1, 10.0);
    const Real50 zeta = random.log_uniform(0.1, 10.0);
    const Real50 a = log(xi);
    const Real50 b = log(zeta);
    const Real50 expected = model.mu * (a * a + b * b) + model.lambda * (a + b) * (a + b) / 2;
    const auto v = model.evaluate<0>(planar_invariants(xi, zeta));
    EXPECT_TRUE(agrees<Real50>(at("xi zeta", xi, zeta), expected, v.w, Real50("1e-44")));
  }
}

/// B' in pairs of doubles too where its formula by the logarithm would cancel.
TEST(Hencky, SlopesInPairsOfDoublesKeepTheirDigits) {
  for (double difference = 0x1p-12; difference < 1.5; difference *= 1.5) {
    const double xi = 1.0 + difference;
    const double zeta = 1.0 / xi;
    const PlanarInvariants<DoubleDouble> q = extended_invariants(xi, zeta);
    const DoubleDouble t2 = q.t * q.t;
    const DoubleDouble x = q.e / t2;
    const AtanhRatio<DoubleDouble> ratio = atanh_ratio<2>(q, x, DoubleDouble(4.0 * q.d / t2));
    const AtanhRatio<Real50> exact = reference_ratio(xi, zeta);
    const auto error = [](const DoubleDouble& found, const Real50& wanted) {
      const Real50 wide = Real50(found.hi) + found.lo;
      return abs(wide / wanted - 1);
    };
    EXPECT_LE(error(ratio.b, exact.b), 0x1p-94) << difference;
    EXPECT_LE(error(ratio.b_x, exact.b_x), 0x1p-94) << difference;
  }
}

/// Where the stretches may be equal, too: derivatives over an interval hold those at every point of it.
TEST(HenckyRatio, DerivativesOverIntervalsHoldThoseOfTheirPoints) {
  using Over = Dual<Interval, 1>;
  for (const auto& [lo, hi] :
       {std::pair{-1e-5, 2.77e-3}, std::pair{-1e-300, 1e-300}, std::pair{0.0, 0.1},
        std::pair{0.2, 0.2499}, std::pair{1e-3, 1e-3}, std::pair{0.24, 0.3}}) {
    Over x(Interval(lo, hi));
    x.slope[0] = Interval(1.0);
    const Over rest = Over(1.0) - x;
    PlanarInvariants<Over> q;  // t = 1
    q.t = Over(1.0);
    q.d = 0.25 * rest;
    q.e = x;
    const AtanhRatio<Over> found = atanh_ratio<2>(q, x, rest);
    for (const double at : {std::max(lo, 0.0), 0.5 * (std::max(lo, 0.0) + hi), hi}) {
      const auto [b, b_x, b_xx] = ratio_series(Real50(at), 200);
      const auto holds = [](const Interval& x, const Real50& y) {
        return Real50(x.lo) <= y && y <= Real50(x.hi);
      };
      EXPECT_TRUE(holds(found.b.value, b)) << lo << " " << hi << " at " << at;
      EXPECT_TRUE(holds(found.b.slope[0], b_x)) << lo << " " << hi << " at " << at;
      EXPECT_TRUE(holds(found.b_x.value, b_x)) << lo << " " << hi << " at " << at;
      EXPECT_TRUE(holds(found.b_x.slope[0], b_xx)) << lo << " " << hi << " at " << at;
    }
    if (hi < 0.25) {
      EXPECT_LE(found.b_x.slope[0].width(), 8.0 * (hi - lo) + 1e-12) << lo;
    }
  }
}

}  // namespace
}  // namespace stationary
