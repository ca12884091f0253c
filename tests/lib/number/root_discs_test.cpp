// Enclosures of roots against polynomials made from roots.
#include "lib/number/root_discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <vector>

#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using Complex = std::complex<long double>;
using support::Random;

/// c (x - r_1)(x - r_2) ..., its coefficients in intervals that hold them.
template <std::size_t D>
Polynomial<Interval, static_cast<int>(D)> from_roots(const std::array<Complex, D>& roots,
                                                     double leading_coefficient, double spread) {
  std::vector<Complex> c{Complex(leading_coefficient)};
  for (const Complex& r : roots) {
    std::vector<Complex> next(c.size() + 1);
    for (std::size_t k = 0; k < c.size(); ++k) {
      next[k + 1] += c[k];
      next[k] -= r * c[k];
    }
    c = next;
  }
  Polynomial<Interval, static_cast<int>(D)> out;
  for (std::size_t k = 0; k <= D; ++k) {
    const double x = static_cast<double>(c[k].real());
    const double by = spread * std::abs(x);
    out.c[k] = Interval::outward(x - by, x + by);
  }
  return out;
}

bool root_is_in(const RootEnclosure& e, const Complex& r) {
  const auto re = static_cast<double>(r.real());
  const auto im = static_cast<double>(r.imag());
  return e.z.re.may_be(re) && e.z.im.may_be(im);
}

/// Roots of all kinds and sizes, far enough apart to be told apart.
template <std::size_t D>
void check_separate(std::uint64_t seed) {
  Random random(seed);
  for (int trial = 0; trial < 500; ++trial) {
    std::array<Complex, D> roots;
    std::size_t k = 0;
    while (k < D) {
      const double re = random.sign() * random.log_uniform(1e-2, 1e2);
      if (D - k >= 2 && random.integer(0, 1) == 0) {
        const double im = random.log_uniform(0.1, 10.0);
        roots[k++] = Complex(re, im);
        roots[k++] = Complex(re, -im);
      } else {
        roots[k++] = re;
      }
    }
    double nearest = 1e300;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, static_cast<double>(std::abs(roots[i] - roots[j]) /
                                                        (1.0L + std::abs(roots[i]))));
    if (nearest < 1e-2) continue;
    const auto found = enclose_roots(from_roots(roots, random.sign() * 3.0, 1e-13), false);
    for (const Complex& r : roots) {
      const auto at = std::find_if(found.begin(), found.end(),
                                   [&](const RootEnclosure& e) { return root_is_in(e, r); });
      ASSERT_NE(at, found.end()) << r;
      EXPECT_TRUE(at->simple);
      EXPECT_EQ(at->real(), r.imag() == 0.0L) << r;
      EXPECT_LE(at->z.re.width(), 1e-4 * (1.0 + static_cast<double>(std::abs(r))));
    }
  }
}

TEST(RootDiscs, SeparateRootsAreHeldAndTold) {
  check_separate<2>(921);
  check_separate<3>(922);
  check_separate<4>(923);
  check_separate<5>(924);
}

TEST(RootDiscs, TouchingRootsAreNotToldApart) {
  for (const double gap : {0.0, 1e-9, 1e-8}) {
    const std::array<Complex, 3> roots{Complex(1.0), Complex(1.0 + gap), Complex(-2.0)};
    const auto p = from_roots(roots, 1.0, 1e-15);
    int together = 0;
    for (const RootEnclosure& e : enclose_roots(p, false)) {
      if (root_is_in(e, roots[2])) {
        EXPECT_TRUE(e.simple && e.real());
        continue;
      }
      ++together;
      EXPECT_FALSE(e.simple);
      EXPECT_FALSE(e.real()) << "they may be a complex pair";
      EXPECT_TRUE(root_is_in(e, roots[0]) && root_is_in(e, roots[1]));
    }
    EXPECT_EQ(together, 2);
    for (const RootEnclosure& e : enclose_roots(p, true)) EXPECT_TRUE(e.real());
  }
}

TEST(RootDiscs, UnboundedCoefficientsDecideNothing) {
  const Polynomial<Interval, 2> p{{Interval(1.0), Interval::entire(), Interval(1.0)}};
  for (const RootEnclosure& e : enclose_roots(p, false)) {
    EXPECT_FALSE(e.simple);
    EXPECT_TRUE(e.z.re.may_be(1e9) && e.z.re.may_be(-1e9));
  }
}

}  // namespace
}  // namespace stationary
