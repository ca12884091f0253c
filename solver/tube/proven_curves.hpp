// The curves of one set (curve_equations.hpp), all of them proven by tubes, whatever the number of
// their unknowns: what is left of it where motions are put together from several.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "solver/tube/tube_set.hpp"

namespace stationary {

/// A piece of one tube, s in an interval.
struct CurvePiece {
  static constexpr std::size_t most = 5;

  std::size_t tube = 0;
  Interval s;
  std::array<Interval, most> y;         ///< where it lies; of fewer coordinates the first
  std::array<Interval, most> velocity;  ///< dy/ds
  std::size_t last = 0;                 ///< the place of q
  double width = 0.0;                   ///< the longest side
  Within within = Within::unclear;

  const Interval& q() const { return y[last]; }
  const Interval& q_slope() const { return velocity[last]; }
  bool is_point() const { return !(s.lo < s.mid() && s.mid() < s.hi); }
};

class ProvenCurves {
 public:
  ProvenCurves() = default;
  ProvenCurves(const ProvenCurves&) = delete;
  ProvenCurves& operator=(const ProvenCurves&) = delete;
  virtual ~ProvenCurves() = default;

  virtual std::size_t tubes() const = 0;
  virtual double half_length(std::size_t tube) const = 0;
  virtual CurvePiece piece(std::size_t tube, const Interval& s) const = 0;
  CurvePiece middle_of(const CurvePiece& whole) const {
    return piece(whole.tube, Interval(whole.s.mid()));
  }
  /// All of the piece with these q, and perhaps more.
  CurvePiece trimmed(const CurvePiece& whole, const Interval& q) const {
    constexpr double worth_it = 0.75;
    if (q.hi - q.lo > worth_it * (whole.q().hi - whole.q().lo)) return whole;
    const auto s = s_of(whole, q);
    return s ? piece(whole.tube, common(*s, whole.s)) : whole;
  }
  /// All of the piece with these q, where each of them is shown to be there, once.
  std::optional<CurvePiece> crossed(const CurvePiece& whole, const Interval& q) const {
    const auto s = s_of(whole, q);
    // The image of Newton's operator in the piece: each q has its s there.
    if (!s || s->lo < whole.s.lo || s->hi > whole.s.hi) return std::nullopt;
    return piece(whole.tube, *s);
  }
  /// Adds what they tell of motions. scale: of the velocities.
  virtual void place(const CurvePiece& piece, const Interval& scale,
                     PlacedMotions& motions) const = 0;

 private:
  /// Newton's step for q(s) = q from the middle: nothing where dq/ds may vanish.
  std::optional<Interval> s_of(const CurvePiece& whole, const Interval& q) const {
    if (whole.q_slope().may_be(0.0) || !whole.q_slope().bounded()) return std::nullopt;
    const CurvePiece middle = middle_of(whole);
    const Interval out = middle.s + (q - middle.q()) / whole.q_slope();
    if (!out.bounded() || out.apart_from(whole.s)) return std::nullopt;
    return out;
  }
};

/// equations and region must outlive this.
template <int N>
class ProvenCurvesOf final : public ProvenCurves {
 public:
  ProvenCurvesOf(const CurveEquations<N>& equations, const CurveRegion<N>& region,
                 const TubeOptions& options)
      : equations_(equations), region_(region), set_(equations, region, options) {}

  TubeSet<N>& set() { return set_; }

  std::size_t tubes() const override { return set_.tubes().size(); }
  double half_length(std::size_t tube) const override { return set_.tubes()[tube].half_length(); }
  CurvePiece piece(std::size_t tube, const Interval& s) const override {
    const auto [y, velocity] = set_.tubes()[tube].slice(equations_, s);
    CurvePiece out;
    out.tube = tube;
    out.s = s;
    out.last = static_cast<std::size_t>(N);
    for (std::size_t k = 0; k < y.size(); ++k) {
      out.y[k] = y[k];
      out.velocity[k] = velocity[k];
      out.width = std::max(out.width, y[k].hi - y[k].lo);
    }
    out.within = within_region(equations_, region_, y);
    return out;
  }
  void place(const CurvePiece& piece, const Interval& scale,
             PlacedMotions& motions) const override {
    CurveCoordinates<N> y;
    for (std::size_t k = 0; k < y.size(); ++k)
      y[k] = AlongCurve(piece.y[k], {piece.velocity[k] * scale});
    equations_.place(y, motions);
  }

 private:
  const CurveEquations<N>& equations_;
  const CurveRegion<N>& region_;
  TubeSet<N> set_;
};

}  // namespace stationary
