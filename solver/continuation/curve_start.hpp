// Where a curve starts: the point at a solved x, p, and whether the curve there is vertical, all of
// it at one p (J1 = J2, branch (iii): some potentials have their ellipses at one nu only).
#pragma once

#include <cmath>
#include <optional>

#include "solver/continuation/curve.hpp"

namespace stationary {

/// The one p of the vertical curve near x, p, if that is what it is: with p no unknown of its own
/// the balance is singular there, and some way along the curve p is still the same.
template <int N>
std::optional<double> pinned_parameter(const Curve<N>& curve, const ReducedVector<N>& x, double p) {
  constexpr double apart = 0.05;
  constexpr double same = 1e-11;  // near a circle p is no better determined
  const Corrector<N>& corrector = curve.corrector();
  const ArcVector<N> along = corrector.direction_near(x, p);
  if (!along.allFinite()) return std::nullopt;
  const Corrected<N> here = corrector.correct_freely(x, p, along, 2.0 * apart);
  if (here.status != CorrectorStatus::converged) return std::nullopt;
  const ArcVector<N> step = apart * along;
  const Corrected<N> next =
      corrector.correct_freely(moved<N>(here.point.x, ReducedVector<N>(step.template head<N>())),
                               here.point.p + corrector.scale() * step[N], along, apart);
  if (next.status != CorrectorStatus::converged) return std::nullopt;
  const double there = next.point.p;
  const double tolerated = same * std::abs(p);
  if (std::abs(there - here.point.p) > tolerated || std::abs(p - there) > tolerated)
    return std::nullopt;
  return std::abs(p - there) <= 0x1p-50 * std::abs(p) ? p : there;
}

/// The completed point of a curve at a solved x, p; its tangent towards larger p, of a vertical
/// curve towards larger xi. At a turn of p, where no other point has its p, along the curve.
template <int N>
Corrected<N> start_of(const Curve<N>& curve, const ReducedVector<N>& x, double p) {
  ArcVector<N> up = ArcVector<N>::Zero();
  up[N] = 1.0;
  if (curve.corrector().vertical()) {
    up = curve.corrector().direction_near(x, p);
    if (up[0] < 0.0) up = -up;
  }
  const Corrected<N> out = curve.corrector().correct_at(x, p, up);
  if (out.status == CorrectorStatus::converged) return out;
  const ArcVector<N> along = curve.corrector().direction_near(x, p);
  return along.allFinite() ? curve.corrector().correct_at(x, p, along) : out;
}

}  // namespace stationary
