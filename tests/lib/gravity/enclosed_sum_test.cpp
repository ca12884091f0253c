// The enclosed series and its tail, against the terms themselves in 50 digits: value and every
// derivative, with all signs of E2 and E3 and either the larger.
#include "lib/gravity/enclosed_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using duplication::enclosed_sum;
using duplication::remainder_bound;
using support::Real50;

/// sum_n T_n/(2 n + 1) of duplication.hpp, up to where terms no longer count.
template <int order>
PowerSeries<Real50, order> whole_sum(const PowerSeries<Real50, order>& E2,
                                     const PowerSeries<Real50, order>& E3) {
  using Series = PowerSeries<Real50, order>;
  Series before[3] = {Series(Real50(1)), Series(), -0.5 * E2};
  Series out = before[0] + Real50(1) / Real50(5) * before[2];
  for (int n = 3; n <= 300; ++n) {
    const Series next = Real50(2 * n - 3) / Real50(2 * n) * (E3 * before[0]) -
                        Real50(n - 1) / Real50(n) * (E2 * before[1]);
    out = out + Real50(1) / Real50(2 * n + 1) * next;
    before[0] = before[1];
    before[1] = before[2];
    before[2] = next;
  }
  return out;
}

/// e + first + rest, in which no coefficient but one of third order is zero.
template <class S, int order>
PowerSeries<S, order> bent(double e, int first, int second) {
  using Series = PowerSeries<S, order>;
  const Series x = Series::variable(S(0.0), first);
  const Series y = Series::variable(S(0.0), second);
  const Series z = Series::variable(S(0.0), 3 - first - second);
  return Series(S(e)) + x + 0.5 * y - 0.25 * z + 0.125 * (x * y) - 2.0 * (y * z) + 0.75 * (z * z);
}

TEST(EnclosedSum, HoldsAllTerms) {
  constexpr int order = 3;
  for (const double e : {0.2, 0.05, 0.01, 0.001}) {
    for (const double share : {1.0, 0.3, 0.0}) {  // of what the other of E2 and E3 allows
      for (const int signs : {0, 1, 2, 3}) {
        for (const bool second : {false, true}) {
          const double e2 = (signs & 1 ? -1.0 : 1.0) * e * e * (second ? share : 1.0);
          const double e3 = (signs & 2 ? -1.0 : 1.0) * e * e * e * (second ? 1.0 : share);
          const auto meant =
              whole_sum<order>(bent<Real50, order>(e2, 0, 1), bent<Real50, order>(e3, 2, 0));
          const auto E2 = bent<Interval, order>(e2, 0, 1);
          const auto E3 = bent<Interval, order>(e3, 2, 0);
          for (const auto& [last, held] : {std::pair(9, enclosed_sum<order, 9>(E2, E3)),
                                           {10, enclosed_sum<order, 10>(E2, E3)},
                                           {11, enclosed_sum<order, 11>(E2, E3)},
                                           {14, enclosed_sum<order, 14>(E2, E3)}}) {
            for (std::size_t n = 0; n < held.c.size(); ++n) {
              ASSERT_TRUE(Real50(held.c[n].lo) <= meant.c[n] && meant.c[n] <= Real50(held.c[n].hi))
                  << "E2 " << e2 << " E3 " << e3 << " after " << last << " coefficient " << n;
              if (e <= 0.01 && last == 14) {
                // What is left out of third derivatives is more.
                EXPECT_LT(held.c[n].width(), n < Monomials<2>::count ? 1e-13 : 1e-9) << n;
              }
            }
          }
        }
      }
    }
  }
}

TEST(EnclosedSum, BoundIsThatOfItsFormula) {
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

TEST(EnclosedSum, IsUnboundedWhereTermsDoNotFall) {
  EXPECT_TRUE(std::isinf(remainder_bound(0, 0, 0.4, 10)));
  EXPECT_LT(remainder_bound(0, 0, 0.3, 10), 1e-4);
  // Each derivative may cost the growth of its factor n.
  EXPECT_TRUE(std::isinf(remainder_bound(2, 1, 0.36, 10)));
  EXPECT_FALSE(std::isinf(remainder_bound(0, 0, 0.36, 10)));
}

}  // namespace
}  // namespace stationary
