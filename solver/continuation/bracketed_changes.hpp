// Where in a step a count of the spectra changes with no event to account for it (count_changes.hpp), as
// brackets by bisection.
#pragma once

#include <cstddef>
#include <optional>
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

/// A place of the step where it is known what is definite.
struct KnownDefinite {
  double u;
  KnownCount count;
};
/// The nearest to u, towards the other end of its part of the step; an event at u says nothing itself.
template <int N>
std::optional<KnownDefinite> definite_near(StepPoints<N>& points, double u, double other) {
  for (const double aside : {0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1}) {
    const double at = u + aside * (other - u);
    CurvePoint<N> point;
    if (!points.evaluate(at, point)) continue;
    if (const auto known = KnownCounts::at(point.member).definite) return KnownDefinite{at, *known};
  }
  return std::nullopt;
}

/// On a circle what is definite changes where no modes meet, and so it may in a step with other events, or with
/// one at its end, which do not account for it: what is left between neighbouring ones of `parts`, the
/// ends of the step and its events, is added to `found`.
template <int N>
void add_changes_of_definiteness(StepPoints<N>& points, const std::vector<double>& parts,
                                 std::vector<FoundEvent>& found) {
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    const auto first = definite_near(points, parts[k], parts[k + 1]);
    if (!first) continue;
    const auto last = definite_near(points, parts[k + 1], parts[k]);
    if (last && first->u < last->u && first->count.modes == last->count.modes &&
        first->count.count != last->count.count)
      found.push_back(bracketed(points, {definite, first->count.count, first->count.since, true},
                                first->u, last->u));
  }
}

}  // namespace stationary
