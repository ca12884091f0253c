// How far the rows of a followed sheet, interpolated, are from its curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/continuation/corrector.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {

inline bool is_moderate(const Stretch& q) {
  return std::min({q.xi, q.zeta, q.rho}) > 1e-3 && std::max({q.xi, q.zeta, q.rho}) < 1e3;
}

/// Interpolated as a reader of the table would (a cubic through four rows, by their chords), how
/// far each gap between rows is from the curve; infinity where no curve is near.
template <int N>
std::vector<double> interpolation_errors(const Family<N>& family,
                                         const std::vector<FollowedRow>& all, double scale) {
  using Y = ArcVector<N>;
  std::vector<Y> y;
  std::vector<double> s;
  for (const FollowedRow& row : all) {
    if (row.event != EventType::none && !is_end(row.event)) continue;
    if (!is_moderate(row.member.q)) continue;
    Y at = Y::Zero();
    at[0] = std::log(row.member.q.xi);
    at[1] = std::log(row.member.q.zeta);
    if constexpr (N == 3) at[2] = std::log(row.member.q.rho);
    at[N] = row.member.parameter / scale;
    s.push_back(y.empty() ? 0.0 : s.back() + (at - y.back()).norm());
    y.push_back(at);
  }
  const Corrector<N> corrector(family, scale, Circle::none);
  std::vector<double> out;
  for (std::size_t k = 1; k + 2 < y.size(); ++k) {
    const double u = 0.5 * (s[k] + s[k + 1]);
    Y at = Y::Zero();
    Y slope = Y::Zero();
    for (std::size_t i = k - 1; i <= k + 2; ++i) {
      double weight = 1.0;
      double change = 0.0;
      for (std::size_t j = k - 1; j <= k + 2; ++j) {
        if (j == i) continue;
        const double factor = (u - s[j]) / (s[i] - s[j]);
        change = change * factor + weight / (s[i] - s[j]);
        weight *= factor;
      }
      at += weight * y[i];
      slope += change * y[i];
    }
    slope.normalize();
    const ReducedVector<N> x = at.template head<N>().array().exp();
    const Corrected<N> exact = corrector.correct(x, scale * at[N], slope, 0.1);
    if (exact.status != CorrectorStatus::converged) {
      out.push_back(std::numeric_limits<double>::infinity());
      continue;
    }
    // Across the curve: along it a point near an asymptote of p is known only to p's rounding.
    const Y& off = exact.correction;
    out.push_back((off - off.dot(slope) * slope).norm());
  }
  return out;
}

/// The largest of them: to the tolerance the rows are the curve.
template <int N>
double interpolation_error(const Family<N>& family, const std::vector<FollowedRow>& all,
                           double scale) {
  double worst = 0.0;
  for (const double error : interpolation_errors(family, all, scale))
    worst = std::max(worst, error);
  return worst;
}

}  // namespace stationary::testing
