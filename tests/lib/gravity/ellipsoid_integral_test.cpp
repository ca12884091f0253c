// F(T, D, z) = R_F(y1, y2, z) and its derivatives in every number type, against Carlson's functions
// in 50 digits (Boost), over axis ratios^2 of 1e10 with equal axes among them.
#include "lib/gravity/ellipsoid_integral.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "lib/number/simd_pack.hpp"

namespace stationary {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

struct Axes {
  double y1;
  double y2;
  double z;

  double T() const { return y1 + y2; }
  double D() const { return y1 * y2; }
};

/// Semi-axes squared within 1e10 of each other: all apart, y1 = y2 exactly or nearly, y2 = z.
std::vector<Axes> all_axes(int count) {
  std::mt19937 random(20240607);
  std::uniform_real_distribution<double> logarithm(-11.5, 11.5);
  std::vector<Axes> out;
  for (int k = 0; k < count; ++k) {
    const double y1 = std::exp(logarithm(random));
    const double other = std::exp(logarithm(random));
    const double z = std::exp(logarithm(random));
    out.push_back(k % 4 == 0   ? Axes{y1, y1, z}
                  : k % 4 == 1 ? Axes{y1, y1 * (1.0 + 1e-10 * logarithm(random)), z}
                  : k % 4 == 2 ? Axes{y1, z, z}
                               : Axes{y1, other, z});
  }
  return out;
}

/// The series in 50 digits, at the doubles T, D, z.
template <int order>
PowerSeries<Wide, order> wide(const Axes& at) {
  return ellipsoid_integral<order>(Wide(at.T()), Wide(at.D()), Wide(at.z));
}

/// What a coefficient's error is measured against: F_Tz and F_Dz enter as z F_Tz beside F_T.
template <int order>
Wide size_of(const PowerSeries<Wide, order>& exact, const Powers& p, double z) {
  using List = Monomials<order>;
  const Wide own = abs(exact.c[List::place(p)]);
  if (p == Powers{1, 0, 1}) return abs(exact.c[List::place({1, 0, 0})]) / z + own;
  if (p == Powers{0, 1, 1}) return abs(exact.c[List::place({0, 1, 0})]) / z + own;
  return own;
}

TEST(EllipsoidIntegral, In50DigitsIsCarlsons) {
  int apart = 0;
  for (const Axes& at : all_axes(80)) {
    const Wide y1(at.y1);
    const Wide y2(at.y2);
    const Wide z(at.z);
    const auto F = ellipsoid_integral<2>(Wide(y1 + y2), Wide(y1 * y2), z);
    const Wide tiny("1e-46");
    EXPECT_LE(abs(F.value() / boost::math::ellint_rf(y1, y2, z) - 1), tiny);
    const Wide F_z = -boost::math::ellint_rd(y1, y2, z) / 6;
    EXPECT_LE(abs(F.derivative({0, 0, 1}) / F_z - 1), tiny);
    if (!(std::abs(at.y1 / at.y2 - 1.0) > 1e-3)) continue;
    ++apart;
    const Wide F_1 = -boost::math::ellint_rd(y2, z, y1) / 6;
    const Wide F_2 = -boost::math::ellint_rd(y1, z, y2) / 6;
    const Wide F_D = -(F_2 - F_1) / (y2 - y1);
    EXPECT_LE(abs(F.derivative({0, 1, 0}) / F_D - 1), Wide("1e-40"));
    EXPECT_LE(abs(F.derivative({1, 0, 0}) / (F_1 - y2 * F_D) - 1), Wide("1e-36"));
  }
  EXPECT_GT(apart, 30);
}

TEST(EllipsoidIntegral, SecondDerivativesAreSlopesOfFirstOnes) {
  const Wide h("1e-17");
  for (const Axes& at : all_axes(12)) {
    const std::array<Wide, 3> x{Wide(at.T()), Wide(at.D()), Wide(at.z)};
    const auto exact = wide<3>(at);
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Wide, 3> ahead = x;
      std::array<Wide, 3> behind = x;
      ahead[k] *= 1 + h;
      behind[k] *= 1 - h;
      const auto a = ellipsoid_integral<2>(ahead[0], ahead[1], ahead[2]);
      const auto b = ellipsoid_integral<2>(behind[0], behind[1], behind[2]);
      for (const Powers& p : Monomials<2>::powers) {
        const Wide slope = (a.derivative(p) - b.derivative(p)) / (2 * h * x[k]);
        const Powers next{p.i + (k == 0), p.j + (k == 1), p.k + (k == 2)};
        EXPECT_LE(abs(exact.derivative(next) / slope - 1), Wide("1e-25"));
      }
    }
  }
}

TEST(EllipsoidIntegral, KeepsItsDigits) {
  std::array<double, 3> worst{};
  double worst_pair = 0.0;
  for (const Axes& at : all_axes(600)) {
    const auto exact = wide<2>(at);
    const auto F = ellipsoid_integral<2>(at.T(), at.D(), at.z);
    const auto pair =
        ellipsoid_integral<2>(DoubleDouble(at.T()), DoubleDouble(at.D()), DoubleDouble(at.z));
    for (const Powers& p : Monomials<2>::powers) {
      const std::size_t n = Monomials<2>::place(p);
      const Wide size = size_of(exact, p, at.z);
      const auto total = static_cast<std::size_t>(p.total());
      worst[total] = std::max(worst[total], double(abs(F.c[n] - exact.c[n]) / size) * 0x1p53);
      const Wide off = Wide(pair.c[n].hi) + Wide(pair.c[n].lo) - exact.c[n];
      worst_pair = std::max(worst_pair, double(abs(off) / size) * 0x1p106);
    }
  }
  // In units of the last place.
  EXPECT_LE(worst[0], 8.0);
  EXPECT_LE(worst[1], 18.0);
  EXPECT_LE(worst[2], 36.0);
  EXPECT_LE(worst_pair, 400.0);
}

TEST(EllipsoidIntegral, IsCompletelyMonotoneAndHomogeneous) {
  for (const Axes& at : all_axes(200)) {
    const double T = at.T();
    const double D = at.D();
    const auto F = ellipsoid_integral<2>(T, D, at.z);
    for (const Powers& p : Monomials<2>::powers)
      EXPECT_GT(p.total() % 2 == 0 ? F.derivative(p) : -F.derivative(p), 0.0);
    const double F_D = F.derivative({0, 1, 0});
    const double euler =
        T * F.derivative({1, 0, 0}) + 2.0 * (D * F_D) + at.z * F.derivative({0, 0, 1});
    EXPECT_NEAR(euler / F.value(), -0.5, 1e-14);
    // F_D = -2 F_12.
    const double F_12 =
        F.derivative({2, 0, 0}) + T * F.derivative({1, 1, 0}) + D * F.derivative({0, 2, 0}) + F_D;
    EXPECT_NEAR(-2.0 * F_12 / F_D, 1.0, 1e-13);
  }
  for (const double a : {0.1, 1.0, 7.0}) {
    EXPECT_NEAR(ellipsoid_integral<0>(2.0 * a * a, a * a * a * a, a * a).value() * a, 1.0, 1e-15);
  }
}

/// By the trapezoidal rule in ln u, which converges geometrically: another way altogether.
Wide by_quadrature(const Axes& at) {
  const Wide h = Wide(1) / 8;
  Wide sum = 0;
  for (int k = -1000; k <= 1000; ++k) {
    const Wide u = exp(h * k);
    sum += u / sqrt((u * u + Wide(at.T()) * u + Wide(at.D())) * (u + Wide(at.z)));
  }
  return h * sum / 2;
}

TEST(EllipsoidIntegral, IntervalsHoldTheExactValue) {
  double widest = 0.0;
  for (const Axes& at : all_axes(120)) {
    const auto exact = wide<3>(at);
    const auto F = ellipsoid_integral<3>(Interval(at.T()), Interval(at.D()), Interval(at.z));
    for (std::size_t n = 0; n < F.c.size(); ++n) {
      EXPECT_LE(Wide(F.c[n].lo), exact.c[n]);
      EXPECT_GE(Wide(F.c[n].hi), exact.c[n]);
      if (Monomials<3>::powers[n].total() <= 1)
        widest = std::max(widest, F.c[n].width() / F.c[n].mignitude());
    }
  }
  EXPECT_LE(widest, 1e-11);
  for (const Axes& at : {Axes{1.0, 1.0, 1.0}, Axes{3.0, 0.2, 0.05}, Axes{2.0, 2.0, 40.0}}) {
    const Wide quadrature = by_quadrature(at);
    const auto F = ellipsoid_integral<0>(Interval(at.T()), Interval(at.D()), Interval(at.z));
    EXPECT_LE(Wide(F.value().lo), quadrature);
    EXPECT_GE(Wide(F.value().hi), quadrature);
  }
}

TEST(EllipsoidIntegral, BoxesAreHulls) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> within(0.0, 1.0);
  unsigned wide = 0;  // which of the arguments are: each alone, two, all
  for (const Axes& at : all_axes(140)) {
    wide = wide % 7 + 1;
    const double reach = 3.0 * within(random);
    const auto side = [&](double x, unsigned argument) {
      return Interval(x, (wide & argument) != 0 ? x * (1.0 + reach) : x);
    };
    const Interval T = side(at.T(), 1);
    const Interval D = side(at.D(), 2);
    const Interval z = side(at.z, 4);
    const auto box = ellipsoid_integral<2>(T, D, z);
    const auto least = ellipsoid_integral<2>(T.lo, D.lo, z.lo);
    const auto most = ellipsoid_integral<2>(T.hi, D.hi, z.hi);
    for (int trial = 0; trial < 5; ++trial) {
      const auto in = [&](const Interval& x) { return x.lo + within(random) * (x.hi - x.lo); };
      const auto inside = ellipsoid_integral<2>(in(T), in(D), in(z));
      for (std::size_t n = 0; n < inside.c.size(); ++n) EXPECT_TRUE(box.c[n].may_be(inside.c[n]));
    }
    // No wider than what is attained, but for rounding.
    for (std::size_t n = 0; n < box.c.size(); ++n) {
      const double allowed = 1e-6 * std::abs(least.c[n]);
      EXPECT_LE(box.c[n].hi, std::max(least.c[n], most.c[n]) + allowed);
      EXPECT_GE(box.c[n].lo, std::min(least.c[n], most.c[n]) - allowed);
    }
  }
  // Of what may not be positive there is none.
  const Interval one(1.0);
  for (const Interval& x :
       {Interval(-1.0, 1.0), Interval(0.0, 1.0), Interval(-1.0), Interval(0.0)}) {
    EXPECT_FALSE(ellipsoid_integral<1>(x, one, one).value().bounded());
    EXPECT_FALSE(ellipsoid_integral<1>(one, x, one).value().bounded());
    EXPECT_FALSE(ellipsoid_integral<1>(one, one, x).value().bounded());
  }
}

TEST(EllipsoidIntegral, SlopesOfOtherNumbersAreTheNextDerivatives) {
  for (const Axes& at : all_axes(60)) {
    const auto F = ellipsoid_integral<2>(at.T(), at.D(), at.z);
    using T3 = Dual<double, 3>;
    const auto dual = ellipsoid_integral<1>(T3::along(at.T(), 1.0, 0), T3::along(at.D(), 1.0, 1),
                                            T3::along(at.z, 1.0, 2));
    const auto conditioned =
        ellipsoid_integral<0>(Conditioned::input(at.T()), Conditioned(at.D()), Conditioned(at.z));
    EXPECT_NEAR(conditioned.value().condition / std::abs(at.T() * F.derivative({1, 0, 0})), 1.0,
                1e-12);
    for (const Powers& p : Monomials<1>::powers) {
      const std::size_t n = Monomials<1>::place(p);
      EXPECT_NEAR(dual.c[n].value / F.c[n], 1.0, 1e-13);
      const Powers next[3] = {{p.i + 1, p.j, p.k}, {p.i, p.j + 1, p.k}, {p.i, p.j, p.k + 1}};
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(dual.c[n].slope[k] / F.derivative(next[k]), 1.0, 1e-13);
    }
  }
}

TEST(EllipsoidIntegral, PacksAreDoublesSideBySide) {
  using P = Pack<16>;
  const std::vector<Axes> axes = all_axes(200);
  for (std::size_t k = 0; k + P::lanes <= axes.size(); k += P::lanes) {
    double T[P::lanes];
    double D[P::lanes];
    double z[P::lanes];
    for (std::size_t lane = 0; lane < P::lanes; ++lane) {
      T[lane] = axes[k + lane].T();
      D[lane] = axes[k + lane].D();
      z[lane] = axes[k + lane].z;
    }
    const auto F = ellipsoid_integral<1>(P::load(T), P::load(D), P::load(z));
    for (std::size_t n = 0; n < F.c.size(); ++n) {
      double lanes[P::lanes];
      F.c[n].store(lanes);
      for (std::size_t lane = 0; lane < P::lanes; ++lane) {
        const auto one = ellipsoid_integral<1>(T[lane], D[lane], z[lane]);
        EXPECT_NEAR(lanes[lane] / one.c[n], 1.0, 40.0 * 0x1p-53);
      }
    }
  }
}

}  // namespace
}  // namespace stationary
