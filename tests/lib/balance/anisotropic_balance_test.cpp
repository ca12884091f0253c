// The balance with alpha and the axis unknown, against lib's own in q and against the slopes of the
// one function it is the gradient of.
#include "lib/balance/anisotropic_balance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lib/balance/balance.hpp"
#include "tests/support/bodies/random_anisotropic.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using Point = std::array<DoubleDouble, 5>;

struct Setting {
  Inertia3<DoubleDouble> J;
  AnisotropicModel<DoubleDouble> model;
  double nu;

  OrientedStretch<DoubleDouble> stretch(const Point& x) const {
    return oriented_stretch(x[0], x[1], x[2], x[3]);
  }
  template <int order>
  OrientedBalance<DoubleDouble, order> balance(const Point& x) const {
    const auto axis = axis_angle(x[4]);
    auto out = oriented_balance<order>(
        J, model, stretch(x), in_plane_products(two_product(nu, nu), axis.cosine, axis.sine));
    add_axis<order>(J, stretch(x), two_product(nu, nu), axis, out);
    return out;
  }
  /// V - q^T C q/2
  DoubleDouble function(const Point& x) const {
    const auto axis = axis_angle(x[4]);
    const auto C =
        centrifugal_matrix(J, in_plane_products(two_product(nu, nu), axis.cosine, axis.sine));
    const auto q = stretch(x).q;
    DoubleDouble T(0.0);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) T += q.vector()[i] * C(i, j) * q.vector()[j];
    return potential_derivatives<0>(model, q).value - 0.5 * T;
  }
};

/// x e^h to first order, and back by the same.
Point moved_point(Point x, std::size_t k, double h) {
  x[k] = x[k] * (1.0 + DoubleDouble(h));
  return x;
}

Point random_point(support::Random& random) {
  return {random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0),
          random.log_uniform(0.4, 2.5), random.log_uniform(0.3, 3.0)};
}

template <class F>
void over_settings(std::uint64_t seed, const F& f) {
  support::Random random(seed);
  for (int k = 0; k < 32; ++k) {
    const auto of = support::random_anisotropic(random, k);
    const Body body = random.body();
    f(Setting{{body.J1, body.J2, body.J3}, of.V.model(AsExtended()), random.uniform(0.1, 2.0)},
      body, of.text, random);
  }
}

TEST(AnisotropicBalance, IsTheGradientOfOneFunctionAndItsSlopes) {
  over_settings(
      311, [](const Setting& at, const Body&, const std::string& text, support::Random& random) {
        const Point x = random_point(random);
        const auto b = at.balance<2>(x);
        double scale = 1.0;
        for (const auto& row : b.slope)
          for (const DoubleDouble& entry : row) scale = std::max(scale, std::abs(double(entry)));
        constexpr double h = 1e-8;
        for (std::size_t k = 0; k < 5; ++k) {
          const Point ahead = moved_point(x, k, h);
          const Point behind = moved_point(x, k, -h);
          const double slope = double(at.function(ahead) - at.function(behind)) / (2.0 * h);
          // phi's row is for |nu| = 1 and the angle itself.
          const double own = k == 4 ? at.nu * at.nu * double(axis_angle(x[4]).rate) : 1.0;
          EXPECT_NEAR(slope, own * double(b.g[k]), 1e-13 * scale) << text << ", row " << k;
          const auto b_ahead = at.balance<1>(ahead);
          const auto b_behind = at.balance<1>(behind);
          for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_NEAR(double(b_ahead.g[i] - b_behind.g[i]) / (2.0 * h), double(b.slope[i][k]),
                        1e-12 * scale)
                << text << ", row " << i << " column " << k;
          }
        }
      });
}

TEST(AnisotropicBalance, HoldsWhereTheBalanceInTheStretchesAndCompatibilityDo) {
  over_settings(312, [](const Setting& at, const Body& body, const std::string& text,
                        support::Random& random) {
    const Point x = random_point(random);
    const auto b = at.balance<1>(x);
    const auto axis = axis_angle(x[4]);
    const auto q = at.stretch(x).q;
    const Vector3<DoubleDouble> nu{at.nu * axis.cosine, at.nu * axis.sine, 0.0};
    const Vector4<DoubleDouble> F = balance_residual(body, at.model, q, nu);
    // The rows are the stretches' own times dq/dy.
    EXPECT_NEAR(double(b.g[0]), double(F[1] * q.xi + 0.5 * (F[0] * q.alpha)), 1e-13) << text;
    EXPECT_NEAR(double(b.g[1]), double(F[2] * q.zeta + 0.5 * (F[0] * q.alpha)), 1e-13) << text;
    EXPECT_NEAR(double(b.g[2]), double(F[3] * q.rho), 1e-13) << text;
    const DoubleDouble root = sqrt(q.xi * q.zeta);
    const DoubleDouble alpha_a = root * (1.0 - square(q.alpha / root));
    EXPECT_NEAR(double(b.g[3]), double(F[0] * alpha_a), 1e-13) << text;
    const auto K = compatibility_residual(body, q, nu);
    EXPECT_NEAR(double(b.g[4]) * at.nu * at.nu, double(K[2]), 1e-13) << text;
  });
}

/// Coefficients as intervals of no width.
struct AsBox {
  Interval operator()(double c) const { return c; }
  Direction<Interval> direction(double degrees) const { return direction_interval(degrees, 0.0); }
};

TEST(AnisotropicBalance, IntervalsHoldThePointValues) {
  support::Random random(313);
  for (int k = 0; k < 32; ++k) {
    const auto of = support::random_anisotropic(random, k);
    const auto model = of.V.model(AsBox());
    const Inertia3<Interval> J{1.3, 0.7, 0.5};
    const double nu = 0.8;
    const Setting at{{1.3, 0.7, 0.5}, of.V.model(AsExtended()), nu};
    const Point x = random_point(random);
    std::array<Interval, 5> box;
    const double width = random.log_uniform(1e-12, 0.3);
    for (std::size_t i = 0; i < 5; ++i)
      box[i] = {double(x[i]) * (1.0 - width), double(x[i]) * (1.0 + width)};
    const auto stretch = oriented_stretch(box[0], box[1], box[2], box[3]);
    const auto axis = axis_angle(box[4]);
    const Interval nu_squared = square(Interval(nu));
    auto over = oriented_balance<2>(J, model, stretch,
                                    in_plane_products(nu_squared, axis.cosine, axis.sine));
    add_axis<2>(J, stretch, nu_squared, axis, over);
    for (int trial = 0; trial < 4; ++trial) {
      Point inside = x;
      for (auto& each : inside) each = each * (1.0 + width * random.uniform(-0.999, 0.999));
      const auto point = at.balance<2>(inside);
      for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_TRUE(over.g[i].may_be(double(point.g[i]))) << of.text << ", row " << i;
        for (std::size_t j = 0; j < 5; ++j)
          EXPECT_TRUE(over.slope[i][j].may_be(double(point.slope[i][j])))
              << of.text << ", entry " << i << " " << j;
      }
    }
  }
}

/// The pull on rho with the force of the thickness: over boxes they hold the same, and say more.
TEST(AnisotropicBalance, AThicknessIsGatheredOverBoxes) {
  support::Random random(317);
  int narrower = 0;
  int compared = 0;
  for (int k = 0; k < 32; ++k) {
    const auto of = support::random_anisotropic(random, k);
    if (!of.V.is_separable()) continue;
    BodyTerms<double> terms;
    terms.volume = random.log_uniform(0.5, 2.0);
    const AnisotropicPotential V = of.V.with_body(terms);
    const auto model = V.model(AsBox());
    const Inertia3<Interval> J{1.3, 0.7, 0.5};
    const double nu = 0.8;
    const auto spin = [&](const auto& nu_squared) { return axis_products(Branch::i, nu_squared); };
    const Point x = random_point(random);
    const double width = random.log_uniform(1e-6, 0.3);
    std::array<Interval, 4> box;
    for (std::size_t i = 0; i < 4; ++i)
      box[i] = {double(x[i]) * (1.0 - width), double(x[i]) * (1.0 + width)};
    const auto stretch =
        at_volume(Interval(*model.body.volume), oriented_stretch(box[0], box[1], box[2], box[3]));
    const SpinProducts<Interval> n = spin(square(Interval(nu)));
    const auto over = eliminated_balance<2>(J, model, stretch, n);
    const auto apart = held<2>(
        oriented_balance<2>(J, model.evaluate<2>(stretch.invariants(), stretch.q), stretch, n),
        stretch);
    for (int trial = 0; trial < 4; ++trial) {
      Point inside = x;
      for (auto& each : inside) each = each * (1.0 + width * random.uniform(-0.999, 0.999));
      const auto point = eliminated_balance<2>(
          Inertia3<DoubleDouble>{1.3, 0.7, 0.5}, V.model(AsExtended()),
          oriented_stretch(inside[0], inside[1], inside[2], inside[3]), spin(two_product(nu, nu)));
      for (const std::size_t i : {oriented::u, oriented::v, oriented::a}) {
        EXPECT_TRUE(over.g[i].may_be(double(point.g[i]))) << of.text << ", row " << i;
        for (const std::size_t j : {oriented::u, oriented::v, oriented::a})
          EXPECT_TRUE(over.slope[i][j].may_be(double(point.slope[i][j])))
              << of.text << ", entry " << i << " " << j;
      }
    }
    ++compared;
    narrower += over.g[oriented::u].width() < 0.999 * apart.g[oriented::u].width();
    EXPECT_LE(over.g[oriented::u].width(), 1.001 * apart.g[oriented::u].width()) << of.text;
  }
  EXPECT_GT(compared, 15);
  EXPECT_GT(narrower, compared / 2);
}

TEST(AnisotropicBalance, HyperbolicFunctionsOverIntervals) {
  support::Random random(318);
  const auto at = [](double x) {
    const support::Real50 wide(x);
    const support::Real50 sum = wide * wide + 1;
    return std::pair(support::Real50((wide - 1) * (wide + 1) / sum),
                     support::Real50(2 * wide / sum));
  };
  const auto holds = [](const Interval& x, const support::Real50& exact) {
    return support::Real50(x.lo) <= exact && exact <= support::Real50(x.hi);
  };
  for (int k = 0; k < 4000; ++k) {
    const double first = k % 4 == 0   ? 1.0 + random.sign() * random.log_uniform(1e-16, 1e-2)
                         : k % 4 == 1 ? random.log_uniform(1e-140, 1e140)
                                      : random.log_uniform(0.01, 100.0);
    const double last = k % 3 == 0 ? first : first * (1.0 + random.log_uniform(1e-16, 10.0));
    const Hyperbolic<Interval> over = hyperbolic(Interval(first, last));
    for (const double x : {first, std::sqrt(first) * std::sqrt(last), last}) {
      const double inside = std::clamp(x, first, last);
      const auto [tanh, sech] = at(inside);
      EXPECT_TRUE(holds(over.tanh, tanh)) << first << " " << last;
      EXPECT_TRUE(holds(over.sech, sech)) << first << " " << last;
    }
    if (first == last) {
      EXPECT_LE(over.tanh.hi - over.tanh.lo, 0x1p-48 * std::abs(over.tanh.mid())) << first;
      EXPECT_LE(over.sech.hi - over.sech.lo, 0x1p-48 * over.sech.mid()) << first;
    }
  }
  EXPECT_FALSE(hyperbolic(Interval(0.0, 1.0)).tanh.bounded());
  EXPECT_FALSE(hyperbolic(Interval(1.0, 1e300)).sech.bounded());
}

TEST(AnisotropicBalance, CoordinatesComeBack) {
  support::Random random(314);
  for (int k = 0; k < 100; ++k) {
    const Stretch q = random.stretch();
    const Stretch back = oriented_stretch(q.xi, q.zeta, q.rho, shear_coordinate(q)).q;
    EXPECT_NEAR(back.alpha, q.alpha, 4e-16 * std::sqrt(q.xi * q.zeta));
    const double phi = random.uniform(-3.1, 3.1);
    const auto axis = axis_angle(axis_coordinate(phi));
    EXPECT_NEAR(axis.cosine, std::cos(phi), 1e-13);
    EXPECT_NEAR(axis.sine, std::sin(phi), 1e-13);
  }
}

}  // namespace
}  // namespace stationary
