// Roots against the roots a polynomial was made of: coefficients are formed in 50 digits from
// chosen roots and rounded to extended precision, so what is asked is the accuracy of the root
// finders, not of the coefficients.
#include "lib/number/polynomial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr double half_unit = 0x1p-53;

/// Nearest DoubleDouble.
DoubleDouble rounded(const Real50& x) {
  const double hi = nearest(x);
  return {hi, nearest(Real50(x - hi))};
}

template <int D>
Polynomial<DoubleDouble, D> rounded(const Polynomial<Real50, D>& p) {
  Polynomial<DoubleDouble, D> out;
  for (std::size_t k = 0; k <= D; ++k) out.c[k] = rounded(p.c[k]);
  return out;
}

Polynomial<Real50, 1> factor(const Real50& root) { return {{Real50(-root), Real50(1)}}; }
/// mean +- sqrt(separation), complex where separation < 0.
Polynomial<Real50, 2> pair_factor(const Real50& mean, const Real50& separation) {
  return {{Real50(mean * mean - separation), Real50(-2 * mean), Real50(1)}};
}

/// How far `actual` is from the nearest of `expected`, relative to that one.
double relative_distance(const DoubleDouble& actual, const std::vector<Real50>& expected) {
  Real50 best = -1;
  for (const Real50& e : expected) {
    const Real50 difference = abs(Real50(exact<Real50>(actual) - e));
    const Real50 distance = e == 0 ? difference : Real50(difference / abs(e));
    if (best < 0 || distance < best) best = distance;
  }
  return nearest(best);
}

/// All roots found, each once.
void expect_roots(const std::string& where, const std::vector<DoubleDouble>& actual,
                  std::vector<Real50> expected, double allowed) {
  std::vector<DoubleDouble> sorted = actual;
  std::sort(sorted.begin(), sorted.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(sorted.size(), expected.size());
  for (std::size_t k = 0; k < sorted.size(); ++k)
    EXPECT_LE(relative_distance(sorted[k], {expected[k]}), allowed) << where << " root " << k;
}

Real50 random_root(Random& random, double low, double high) {
  return Real50(random.sign() * random.log_uniform(low, high));
}

TEST(Polynomial, IsWhatItsFactorsAre) {
  Random random(101);
  for (int k = 0; k < 200; ++k) {
    const Real50 a = random_root(random, 0.1, 10.0);
    const Real50 b = random_root(random, 0.1, 10.0);
    const Real50 c = random_root(random, 0.1, 10.0);
    const Real50 x = random_root(random, 0.1, 10.0);
    const Polynomial<Real50, 3> p = factor(a) * factor(b) * factor(c);
    const Real50 tiny("1e-44");
    const Real50 value = (x - a) * (x - b) * (x - c);
    const Real50 slope = (x - a) * (x - b) + (x - a) * (x - c) + (x - b) * (x - c);
    EXPECT_TRUE(agrees<Real50>("value", value, p(x), tiny));
    EXPECT_TRUE(agrees<Real50>("slope", slope, p.slope(x), tiny));
    EXPECT_TRUE(agrees<Real50>("curvature", 2 * (3 * x - a - b - c), p.curvature(x), tiny));
    EXPECT_TRUE(agrees<Real50>("raised", x * p(x), raised(p)(x), tiny * 100));
    const auto difference = p - factor(a);
    EXPECT_TRUE(agrees<Real50>("difference", value - (x - a), difference(x), tiny));
    const auto sum = factor(a) + p;  // the longer one on either side
    EXPECT_TRUE(agrees<Real50>("sum", value + (x - a), sum(x), tiny));
    EXPECT_TRUE(agrees<Real50>("multiple", a * value, (a * p)(x), tiny * 100));
  }
}

TEST(QuadraticRoots, WidelySpreadRealOnesToTheLastPlace) {
  Random random(102);
  double worst = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const std::vector<Real50> roots{random_root(random, 1e-9, 1e9), random_root(random, 1e-9, 1e9)};
    const auto p = rounded(factor(roots[0]) * factor(roots[1]));
    const auto found = quadratic_roots(p.c[1], p.c[0]);
    ASSERT_TRUE(found.real());
    worst = std::max(worst, relative_distance(found.small, roots));
    worst = std::max(worst, relative_distance(found.large, roots));
    EXPECT_LE(std::abs(leading(found.small)), std::abs(leading(found.large)));
  }
  EXPECT_LE(worst, 0.1 * half_unit);
}

TEST(QuadraticRoots, SeparationOfNearDoubleRoots) {
  Random random(103);
  for (int k = 0; k < 2000; ++k) {
    const Real50 mean = random_root(random, 1e-3, 1e3);
    for (const double gap : {1e-3, 1e-8, 1e-11, 1e-14}) {
      for (const double sign : {1.0, -1.0}) {
        const Real50 separation = sign * pow(Real50(mean * gap), 2);
        const auto p = rounded(pair_factor(mean, separation));
        const auto found = quadratic_roots(p.c[1], p.c[0]);
        EXPECT_EQ(found.real(), sign > 0) << gap;
        // mean^2 carries 2^-101: a gap of 1e-14 keeps two figures, wider ones more.
        const double relative =
            nearest(Real50(abs(exact<Real50>(found.separation) - separation) / abs(separation)));
        EXPECT_LE(relative, 0x1p-98 / (gap * gap)) << at("mean", mean, "gap", gap);
      }
    }
  }
}

TEST(QuadraticRoots, NoConstantTerm) {
  for (const double b : {-3.0, 0.0, 1e-100, 5.0}) {
    const auto found = quadratic_roots(DoubleDouble(b), DoubleDouble(0.0));
    EXPECT_EQ(leading(found.small), 0.0);
    EXPECT_EQ(leading(found.large), -b);
  }
}

TEST(CubicRoots, WidelySpreadRealOnesToTheLastPlace) {
  Random random(104);
  double worst = 0.0;
  int compared = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<Real50> roots;
    for (int j = 0; j < 3; ++j) roots.push_back(random_root(random, 1e-5, 1e5));
    bool apart = true;  // near-double ones have their own law
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < j; ++i)
        apart = apart &&
                abs(Real50(roots[static_cast<std::size_t>(i)] / roots[static_cast<std::size_t>(j)] -
                           1)) > 1e-3;
    }
    if (!apart) continue;
    ++compared;
    const Real50 lead = random_root(random, 1e-3, 1e3);
    const auto found =
        cubic_roots(rounded(lead * (factor(roots[0]) * factor(roots[1]) * factor(roots[2]))));
    ASSERT_TRUE(found.pair.real()) << at("roots", roots[0], roots[1], roots[2]);
    expect_roots(at("roots", roots[0], roots[1], roots[2]),
                 {found.single, found.pair.small, found.pair.large}, roots, half_unit);
    for (const auto& root : {found.single, found.pair.small, found.pair.large})
      worst = std::max(worst, relative_distance(root, roots));
  }
  RecordProperty("worst_units", std::to_string(worst / half_unit));
  EXPECT_GE(compared, 19000);
}

TEST(CubicRoots, SingleIsTheOneFartherFromTheOthers) {
  Random random(105);
  for (int k = 0; k < 2000; ++k) {
    const Real50 mean = random_root(random, 0.1, 10.0);
    const Real50 single = mean * (1 + random_root(random, 0.05, 10.0));
    const Real50 gap = abs(mean - single) * random.uniform(0.0, 0.3);
    const auto found = cubic_roots(rounded(factor(single) * pair_factor(mean, gap * gap)));
    EXPECT_LE(relative_distance(found.single, {single}), half_unit)
        << at("mean", mean, "single", single, "gap", gap);
  }
}

/// Near-double roots: the pair's mean and separation, not its members, are what is well known.
void expect_pair(const std::string& where, const RootPair<DoubleDouble>& found, const Real50& mean,
                 const Real50& separation, double gap, double amplification) {
  EXPECT_LE(relative_distance(found.mean, {mean}), half_unit) << where;
  const Real50 off = abs(exact<Real50>(found.separation) - separation);
  EXPECT_LE(nearest(Real50(off / (mean * mean))), 0x1p-98 * amplification) << where;
  if (gap >= 1e-13) {
    EXPECT_EQ(found.real(), separation > 0) << where;
  }
}

TEST(CubicRoots, NearDoubleAndComplexPairs) {
  Random random(106);
  for (int k = 0; k < 3000; ++k) {
    const Real50 mean = random_root(random, 0.1, 10.0);
    // At a distance of at least a tenth of the pair's size, on either side.
    const Real50 single = mean * (1 + random_root(random, 0.1, 10.0));
    for (const double gap : {0.0, 1e-14, 1e-12, 1e-9, 1e-5}) {
      for (const double sign : {1.0, -1.0}) {
        const Real50 separation = sign * pow(Real50(mean * gap), 2);
        const auto found = cubic_roots(rounded(factor(single) * pair_factor(mean, separation)));
        const std::string where = at("mean", mean, "single", single, "gap", sign * gap);
        EXPECT_LE(relative_distance(found.single, {single}), half_unit) << where;
        const double distance = nearest(Real50(abs(single - mean) / abs(mean)));
        const double size = 1.0 + distance;
        expect_pair(where, found.pair, mean, separation, gap,
                    std::pow(size, 3) / std::pow(std::min(distance, 1.0), 2));
      }
    }
  }
}

TEST(CubicRoots, WideComplexPairs) {
  Random random(107);
  for (int k = 0; k < 5000; ++k) {
    const Real50 re = random_root(random, 1e-3, 1e3);
    const Real50 im = random_root(random, 1e-3, 1e3);
    const Real50 single = random_root(random, 1e-3, 1e3);
    const Real50 separation = -im * im;
    const auto found = cubic_roots(rounded(factor(single) * pair_factor(re, separation)));
    const std::string where = at("single", single, "pair", re, im);
    EXPECT_LE(relative_distance(found.single, {single}), half_unit) << where;
    EXPECT_FALSE(found.pair.real()) << where;
    const Real50 size = sqrt(Real50(re * re + im * im));
    const Real50 off_re = exact<Real50>(found.pair.mean) - re;
    const Real50 off_im = sqrt(Real50(-exact<Real50>(found.pair.separation))) - abs(im);
    EXPECT_LE(nearest(Real50((abs(off_re) + abs(off_im)) / size)), 4 * half_unit) << where;
  }
}

TEST(CubicRoots, ZeroConstantTermGivesZero) {
  Random random(108);
  for (int k = 0; k < 500; ++k) {
    const Real50 a = random_root(random, 1e-3, 1e3);
    const Real50 b = a * (1 + random_root(random, 0.01, 10.0));
    auto p = rounded(factor(a) * factor(b) * factor(Real50(0)));
    const auto found = cubic_roots(p);
    // To the size of the others: a zero is not known relatively.
    Real50 least = abs(a);
    for (const auto& root : {found.single, found.pair.small, found.pair.large})
      least = std::min(least, Real50(abs(exact<Real50>(root))));
    EXPECT_LE(nearest(least), 0x1p-90 * nearest(Real50(abs(a) + abs(b)))) << at(a, b);
  }
  const auto triple = cubic_roots(Polynomial<DoubleDouble, 3>{{0.0, 0.0, 0.0, 1.0}});
  EXPECT_EQ(leading(triple.single), 0.0);
  EXPECT_EQ(leading(triple.pair.large), 0.0);
}

TEST(CubicRoots, TripleRoot) {
  for (const double a : {-2.0, 0.125, 3.0}) {
    const auto p = rounded(factor(Real50(a)) * factor(Real50(a)) * factor(Real50(a)));
    const auto found = cubic_roots(p);
    EXPECT_NEAR(leading(found.single), a, 1e-9 * std::abs(a));
    EXPECT_NEAR(leading(found.pair.mean), a, 1e-9 * std::abs(a));
  }
}

/// A root of a = -2 ... -8 and as many more within a gap of it: each found to what coefficients in pairs of
/// doubles know of a root among n that are that near.
std::vector<Real50> near_one_another(Random& random, double a, double gap, int count) {
  std::vector<Real50> out;
  for (int k = 0; k < count; ++k)
    out.push_back(Real50(a) * (1 + Real50(gap) * random.uniform(-1.0, 1.0)));
  return out;
}
double known_to(double gap, int near) {
  return gap >= 0x1p-7 ? 4.0 * half_unit : 32.0 * std::pow(0x1p-100, 1.0 / near);
}

TEST(CubicRoots, NearlyTripleOnesAreKnownAsFarAsTheCoefficientsAre) {
  Random random(113);
  for (int exponent = -52; exponent <= -3; ++exponent) {
    const double gap = std::ldexp(1.0, exponent);
    for (int k = 0; k < 200; ++k) {
      const auto roots = near_one_another(random, -random.uniform(2.0, 8.0), gap, 3);
      const auto found =
          cubic_roots(rounded(factor(roots[0]) * factor(roots[1]) * factor(roots[2])));
      const double spread = std::sqrt(std::abs(leading(found.pair.separation)));
      for (const double each : {leading(found.single), leading(found.pair.mean) - spread,
                                leading(found.pair.mean) + spread})
        ASSERT_LE(relative_distance(DoubleDouble(each), roots), known_to(gap, 3))
            << at("gap", gap, "roots", roots[0], roots[1], roots[2]);
    }
  }
}

std::vector<DoubleDouble> all_four(const QuarticRoots<DoubleDouble>& found) {
  return {found.first.small, found.first.large, found.second.small, found.second.large};
}

/// Whether real ones are no pair that is nearly double; then the quartic's are compared with them.
bool expect_quartic(std::vector<Real50> roots) {
  std::sort(roots.begin(), roots.end());
  for (std::size_t j = 1; j < 4; ++j)
    if (abs(Real50(roots[j - 1] / roots[j] - 1)) <= Real50(1e-2)) return false;
  const auto p =
      rounded((factor(roots[0]) * factor(roots[1])) * (factor(roots[2]) * factor(roots[3])));
  expect_roots(at("roots", roots[0], roots[1], roots[2], roots[3]), all_four(quartic_roots(p)),
               roots, half_unit);
  return true;
}

TEST(QuarticRoots, SpreadRealOnesToTheLastPlace) {
  Random random(109);
  int compared = 0;
  for (int k = 0; k < 5000; ++k) {
    std::vector<Real50> roots;
    for (int j = 0; j < 4; ++j) roots.push_back(Real50(-random.log_uniform(1e-2, 1e2)));
    compared += expect_quartic(roots);
  }
  EXPECT_GE(compared, 4000);
}

/// In two or three sizes, apart by any factors up to 1e28.
TEST(QuarticRoots, RootsOfVeryDifferentSizesToTheLastPlace) {
  Random random(127);
  int compared = 0;
  for (int k = 0; k < 4000; ++k) {
    const double sizes[] = {random.log_uniform(1e-14, 1e14), random.log_uniform(1e-14, 1e14),
                            random.log_uniform(1e-14, 1e14)};
    const std::size_t of[4] = {0, k % 3 == 0 ? 0U : 1U, k % 3 == 1 ? 0U : 1U, k % 2 == 0 ? 1U : 2U};
    std::vector<Real50> roots;
    for (int j = 0; j < 4; ++j)
      roots.push_back(Real50((j % 2 == 0 ? -1.0 : 1.0) *
                             (1.0 + 0.3 * j + 0.1 * random.uniform(0.0, 1.0)) * sizes[of[j]]));
    compared += expect_quartic(roots);
  }
  EXPECT_GE(compared, 3000);
}

/// Roots that all but meet are told from a complex pair, also beside ones that are far larger: the distance of
/// a pair is known to some 1e-15 of its size.
TEST(QuarticRoots, ANearDoublePairBesideALargeRoot) {
  for (const double large : {6.4e3, 6.4e5, 6.4e6, 1e8}) {
    const Real50 x(6.924);
    const Real50 other = x * (1 + Real50("1e-13"));
    const Real50 half = (other - x) / 2;
    const auto found = quartic_roots(
        rounded((factor(Real50(-large)) * factor(Real50(0.966))) * (factor(x) * factor(other))));
    int pairs = 0;
    for (const auto& each : {found.first, found.second}) {
      if (!(std::abs(leading(each.mean) - 6.924) < 1e-6)) continue;
      ++pairs;
      EXPECT_LE(relative_distance(each.separation, {Real50(half * half)}), 0.05) << large;
    }
    EXPECT_EQ(pairs, 1) << large;
  }
}

/// Between them, beyond, or below.
TEST(QuarticRoots, AComplexPairBesideRealOnesOfOtherSizes) {
  Random random(131);
  int compared = 0;
  for (int k = 0; k < 4000; ++k) {
    const double size = random.log_uniform(1e-8, 1e8);
    const double angle = random.uniform(0.2, 2.9);
    const Real50 re(size * std::cos(angle));
    const Real50 im(size * std::sin(angle));
    const Real50 a(random.sign() * random.log_uniform(1e-14, 1e14));
    const Real50 b(random.sign() * random.log_uniform(1e-14, 1e14));
    if (abs(Real50(a / b - 1)) < Real50(0.1)) continue;
    ++compared;
    const auto found =
        quartic_roots(rounded(factor(a) * factor(b) * pair_factor(re, Real50(-im * im))));
    const auto& complex = found.first.real() ? found.second : found.first;
    const auto& real = found.first.real() ? found.first : found.second;
    const std::string where = at("real", a, b, "complex", re, im);
    ASSERT_FALSE(complex.real()) << where;
    ASSERT_TRUE(real.real()) << where;
    expect_roots(where, {real.small, real.large}, {a, b}, half_unit);
    EXPECT_NEAR(leading(complex.mean) / size, nearest(Real50(re / size)), 4.0 * half_unit) << where;
    EXPECT_LE(relative_distance(complex.separation, {Real50(-im * im)}), 64.0 * half_unit) << where;
  }
  EXPECT_GE(compared, 3000);
}

TEST(QuarticRoots, TwoNearDoublePairsEachShareAFactor) {
  Random random(110);
  for (int k = 0; k < 1000; ++k) {
    const Real50 m1 = random_root(random, 0.3, 3.0);
    const Real50 m2 = m1 * (random.sign() < 0 ? -1 : 1) * random.log_uniform(1.3, 4.0);
    for (const double gap : {0.0, 1e-14, 1e-10, 1e-6}) {
      for (const double sign : {1.0, -1.0}) {
        const Real50 s1 = sign * pow(Real50(m1 * gap), 2);
        const Real50 s2 = -sign * pow(Real50(m2 * gap), 2);
        auto found = quartic_roots(rounded(pair_factor(m1, s1) * pair_factor(m2, s2)));
        const std::string where = at("means", m1, m2, "gap", sign * gap);
        if (relative_distance(found.first.mean, {m1}) > relative_distance(found.first.mean, {m2}))
          std::swap(found.first, found.second);
        const double distance = nearest(Real50(abs(m1 - m2)));
        const double size = nearest(Real50(abs(m1) + abs(m2)));
        const double amplification = std::pow(size / std::min(distance, 0.3), 4);
        expect_pair(where, found.first, m1, s1, gap, amplification);
        expect_pair(where, found.second, m2, s2, gap, amplification);
      }
    }
  }
}

/// Where Durand and Kerner's steps never become short: in double the roots of a pair come no nearer than
/// half its digits.
TEST(QuarticRoots, TwoDoubleRootsAreFoundHoweverTheRoundingFalls) {
  Random random(112);
  for (int k = 0; k < 20000; ++k) {
    const double m1 = random.sign() * random.log_uniform(0.3, 3.0);
    const double m2 = m1 * random.sign() * random.log_uniform(1.3, 4.0);
    const Real50 zero(0);
    const auto found =
        quartic_roots(rounded(pair_factor(Real50(m1), zero) * pair_factor(Real50(m2), zero)));
    const double x = leading(found.first.mean);
    const double y = leading(found.second.mean);
    const double off =
        std::min(std::abs(x - m1) + std::abs(y - m2), std::abs(x - m2) + std::abs(y - m1));
    ASSERT_LE(off, 1e-6 * std::abs(m1)) << at("means", m1, m2);
  }
}

TEST(QuarticRoots, ComplexPairBesideRealOnes) {
  Random random(111);
  for (int k = 0; k < 2000; ++k) {
    const Real50 re = random_root(random, 0.1, 10.0);
    const Real50 im = random.log_uniform(0.1, 10.0);
    const Real50 a = random_root(random, 0.1, 10.0);
    const Real50 b = a * (1 + random_root(random, 0.05, 5.0));
    const auto found =
        quartic_roots(rounded(factor(a) * factor(b) * pair_factor(re, Real50(-im * im))));
    const auto& complex = found.first.real() ? found.second : found.first;
    const auto& real = found.first.real() ? found.first : found.second;
    const std::string where = at("real", a, b, "complex", re, im);
    ASSERT_FALSE(complex.real()) << where;
    ASSERT_TRUE(real.real()) << where;
    expect_roots(where, {real.small, real.large}, {a, b}, half_unit);
    EXPECT_LE(relative_distance(complex.mean, {re}), half_unit) << where;
    EXPECT_LE(relative_distance(complex.separation, {Real50(-im * im)}), half_unit) << where;
  }
}

TEST(QuarticRoots, NearlyTripleAndQuadrupleOnesAreKnownAsFarAsTheCoefficientsAre) {
  Random random(114);
  for (int exponent = -52; exponent <= -3; exponent += 3) {
    const double gap = std::ldexp(1.0, exponent);
    for (int k = 0; k < 100; ++k) {
      const double a = -random.uniform(2.0, 8.0);
      for (const bool all : {false, true}) {
        auto roots = near_one_another(random, a, gap, all ? 4 : 3);
        if (!all) roots.push_back(Real50(a * random.log_uniform(1.5, 10.0)));
        const auto found = quartic_roots(
            rounded((factor(roots[0]) * factor(roots[1])) * (factor(roots[2]) * factor(roots[3]))));
        for (const auto& pair : {found.first, found.second}) {
          const double spread = std::sqrt(std::abs(leading(pair.separation)));
          const bool real = pair.real();
          for (const double each : {real ? leading(pair.small) : leading(pair.mean) - spread,
                                    real ? leading(pair.large) : leading(pair.mean) + spread})
            ASSERT_LE(relative_distance(DoubleDouble(each), roots), known_to(gap, all ? 4 : 3))
                << at("gap", gap, "all", all, "roots", roots[0], roots[1], roots[2], roots[3]);
        }
      }
    }
  }
}

TEST(QuarticRoots, ZeroConstantTerm) {
  const auto p =
      rounded(factor(Real50(0)) * factor(Real50(-1)) * factor(Real50(-3)) * factor(Real50(-7)));
  const auto roots = all_four(quartic_roots(p));
  double least = 1.0;
  for (const auto& root : roots) least = std::min(least, std::abs(leading(root)));
  EXPECT_LE(least, 0x1p-95);
}

}  // namespace
}  // namespace stationary
