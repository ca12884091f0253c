// The last point of a curve inside the domain of its potential (domain_guard.hpp), by bisection along
// its tangent.
#pragma once

#include <optional>

#include "solver/continuation/domain_guard.hpp"

namespace stationary {

template <int N>
struct BorderEnd {
  const expression::TapeCondition* broken;  ///< beyond it
  double inside = 0.0;                      ///< distance of the last point; 0: none was found
  double outside;
  Corrected<N> corrected;  ///< the last point
  Arc<N> arc;              ///< to it
};

/// Whether a point of the curve at a distance lies inside; it is put into `out` then.
template <int N>
bool reaches(const Curve<N>& curve, const DomainGuard<N>& guard, const ArcPoint<N>& here,
             double distance, BorderEnd<N>& out) {
  const ArcVector<N> ahead = distance * here.tangent;
  const Corrector<N>& corrector = curve.corrector();
  const Corrected<N> corrected = corrector.correct(
      moved<N>(here.x, ReducedVector<N>(ahead.template head<N>())),
      here.p + corrector.scale() * ahead[N], here.tangent, 1e-3 * distance + 1e-13);
  if (corrected.status != CorrectorStatus::converged || !guard.has(corrected.point)) return false;
  out.inside = distance;
  out.corrected = corrected;
  out.arc = Arc<N>(ahead + corrected.correction, here.tangent, corrected.point.tangent);
  return true;
}

/// Nothing where the domain does not end within `reach`.
template <int N>
std::optional<BorderEnd<N>> border_within(const Curve<N>& curve, const DomainGuard<N>& guard,
                                          const ArcPoint<N>& here, double reach) {
  const auto* broken = guard.broken_along(here.tangent, reach);
  if (broken == nullptr) return std::nullopt;
  BorderEnd<N> out{.broken = broken, .outside = reach, .corrected = {}, .arc = {}};
  for (int k = 0; k < 60 && out.outside - out.inside > 0x1p-52; ++k) {
    const double middle = 0.5 * (out.inside + out.outside);
    if (!reaches(curve, guard, here, middle, out)) out.outside = middle;
  }
  return out;
}

}  // namespace stationary
