#include "solver/tube/proven_curves.hpp"

namespace stationary {
namespace {

/// Newton's step for q(s) = q from the middle: nothing where dq/ds may vanish.
std::optional<Interval> s_of(const CurvePiece& whole, const CurvePiece& middle, const Interval& q) {
  if (whole.q_slope().may_be(0.0) || !whole.q_slope().bounded()) return std::nullopt;
  const Interval out = middle.s + (q - middle.q()) / whole.q_slope();
  if (!out.bounded() || out.apart_from(whole.s)) return std::nullopt;
  return out;
}

}  // namespace

CurvePiece ProvenCurves::trimmed(const CurvePiece& whole, const Interval& q) const {
  constexpr double worth_it = 0.75;
  if (q.hi - q.lo > worth_it * (whole.q().hi - whole.q().lo)) return whole;
  const auto s = s_of(whole, middle_of(whole), q);
  return s ? piece(whole.tube, common(*s, whole.s)) : whole;
}

std::optional<CurvePiece> ProvenCurves::crossed(const CurvePiece& whole, const Interval& q) const {
  const auto s = s_of(whole, middle_of(whole), q);
  // The image of Newton's operator in the piece: each q has its s there.
  if (!s || s->lo < whole.s.lo || s->hi > whole.s.hi) return std::nullopt;
  return piece(whole.tube, *s);
}

}  // namespace stationary
