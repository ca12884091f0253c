// The series of Carlson's duplication, whatever its terms are kept as:
//
//   sum_(n <= N) T_n/(2 n + 1),   n T_n = -(n - 1) E2 T_(n-2) + (n - 3/2) E3 T_(n-3),
//   T_0 = 1,  T_1 = 0,  T_2 = -E2/2.
#pragma once

namespace stationary::duplication {

/// S: the numbers; Term has sums, differences and products with S, and Term() is 0. times_E2,
/// times_E3: of a term.
template <class S, class Term, class TimesE2, class TimesE3>
Term carlson_sum(const Term& one, const Term& second, int last, const TimesE2& times_E2,
                 const TimesE3& times_E3) {
  const auto fraction = [](int p, int q) {
    return S(static_cast<double>(p)) / S(static_cast<double>(q));
  };
  Term before[3] = {one, Term(), second};  // T_(n-3), T_(n-2), T_(n-1)
  Term sum = one + fraction(1, 5) * before[2];
  for (int n = 3; n <= last; ++n) {
    const Term next =
        fraction(2 * n - 3, 2 * n) * times_E3(before[0]) - fraction(n - 1, n) * times_E2(before[1]);
    sum = sum + fraction(1, 2 * n + 1) * next;
    before[0] = before[1];
    before[1] = before[2];
    before[2] = next;
  }
  return sum;
}

}  // namespace stationary::duplication
