// The interval of what a cut series leaves out, against the terms themselves in 50 digits: of the
// value and of every derivative in E2 and E3, with all signs of the two and either the larger.
#include "lib/gravity/series_remainder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/wide_numbers.hpp"

namespace stationary {
namespace {

using support::Real50;

/// The terms of duplication.hpp's series after number `last`, up to where they no longer count.
template <int order>
PowerSeries<Real50, order> tail(double e2, double e3, int last) {
  using Series = PowerSeries<Real50, order>;
  const auto E2 = Series::variable(Real50(e2), 0);
  const auto E3 = Series::variable(Real50(e3), 1);
  Series before[3] = {Series(Real50(1)), Series(), -0.5 * E2};
  Series out;
  for (int n = 3; n <= last + 300; ++n) {
    const Series next = Real50(2 * n - 3) / Real50(2 * n) * (E3 * before[0]) -
                        Real50(n - 1) / Real50(n) * (E2 * before[1]);
    if (n > last) out = out + Real50(1) / Real50(2 * n + 1) * next;
    before[0] = before[1];
    before[1] = before[2];
    before[2] = next;
  }
  return out;
}

TEST(SeriesRemainder, HoldsTheTermsLeftOut) {
  constexpr int order = 3;
  using Series = PowerSeries<Interval, order>;
  for (const double e : {0.2, 0.05, 0.01, 0.001}) {
    for (const double share : {1.0, 0.3, 0.0}) {  // of what the other of E2 and E3 allows
      for (const int signs : {0, 1, 2, 3}) {
        for (const bool second : {false, true}) {
          const double e2 = (signs & 1 ? -1.0 : 1.0) * e * e * (second ? share : 1.0);
          const double e3 = (signs & 2 ? -1.0 : 1.0) * e * e * e * (second ? 1.0 : share);
          for (const int last : {9, 10, 11, 14}) {
            Series held;
            add_remainder(Series::variable(Interval(e2), 0), Series::variable(Interval(e3), 1),
                          last, held);
            const auto left_out = tail<order>(e2, e3, last);
            for (std::size_t n = 0; n < held.c.size(); ++n) {
              ASSERT_TRUE(Real50(held.c[n].lo) <= left_out.c[n] &&
                          left_out.c[n] <= Real50(held.c[n].hi))
                  << "E2 " << e2 << " E3 " << e3 << " after " << last << " coefficient " << n;
            }
          }
        }
      }
    }
  }
}

TEST(SeriesRemainder, BoundIsThatOfItsFormula) {
  for (const double e : {0.1, 0.01, 0.0001}) {
    for (const int last : {9, 12, 17}) {
      for (int a = 0; a <= 3; ++a) {
        for (int b = 0; a + b <= 3; ++b) {
          Real50 sum(0);
          for (int n = last + 1; n <= last + 200; ++n)
            sum += pow(Real50(n) / 2, a) * pow(Real50(n) / 3, b) * pow(Real50(1.3248), n) *
                   pow(Real50(e), n - 2 * a - 3 * b) / Real50(2 * n + 1);
          const double bound = remainder_bound(a, b, e, last);
          EXPECT_GE(Real50(bound), sum) << a << " " << b << " " << e << " " << last;
          EXPECT_LE(Real50(bound), Real50(1.2) * sum) << a << " " << b << " " << e << " " << last;
        }
      }
    }
  }
}

TEST(SeriesRemainder, IsUnboundedWhereTermsDoNotFall) {
  EXPECT_TRUE(std::isinf(remainder_bound(0, 0, 0.4, 10)));
  EXPECT_LT(remainder_bound(0, 0, 0.3, 10), 1e-4);
  // Each derivative may cost the growth of its factor n.
  EXPECT_TRUE(std::isinf(remainder_bound(2, 1, 0.36, 10)));
  EXPECT_FALSE(std::isinf(remainder_bound(0, 0, 0.36, 10)));
}

}  // namespace
}  // namespace stationary
