// Where in a step a count of the spectra changes with no event to account for it (count_changes.hpp), as
// brackets by bisection.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/continuation/count_changes.hpp"
#include "solver/continuation/step_points.hpp"

namespace stationary {

/// The change between two places of the step, u of the way along it.
template <int N>
FoundEvent bracketed(StepPoints<N>& points, const UnexplainedChange& change, double low,
                     double high) {
  CurvePoint<N> middle = points.to();
  for (int k = 0; k < 50; ++k) {
    const double u = 0.5 * (low + high);
    if (!points.evaluate(u, middle)) break;
    (change.count(*middle.member.spectrum) == change.before ? low : high) = u;
  }
  const auto [first, last] = points.around(low, high);
  return {0.5 * (low + high),
          {EventType::unexplained, middle.member, first, last, EventStatus::bracketed}};
}

/// On a circle what is definite changes where no modes meet, and so it may in a step with other events, which do
/// not account for it: what is left between neighbouring ones of `parts`, the ends of the step and its
/// events, is added to `found`.
template <int N>
void add_changes_of_definiteness(StepPoints<N>& points, const std::vector<double>& parts,
                                 std::vector<FoundEvent>& found) {
  constexpr double aside = 1e-6;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    const double low = k == 0 ? 0.0 : parts[k] + aside;
    const double high = k + 2 == parts.size() ? 1.0 : parts[k + 1] - aside;
    CurvePoint<N> a;
    CurvePoint<N> b;
    if (!(low < high) || !points.evaluate(low, a) || !points.evaluate(high, b)) continue;
    const auto first = KnownCounts::at(a.member).definite;
    const auto last = KnownCounts::at(b.member).definite;
    if (first && last && first->modes == last->modes && first->count != last->count)
      found.push_back(bracketed(points, {definite, first->count, first->since, true}, low, high));
  }
}

}  // namespace stationary
