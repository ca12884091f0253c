// The curve inside one step, by u = 0 ... 1 along its arc and some way beyond: the bordered
// corrector brings the arc's points onto the curve. What a test function is there, and how well it
// is known.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "lib/number/elementary.hpp"
#include "solver/continuation/curve.hpp"

namespace stationary {

template <int N>
class StepPoints {
 public:
  struct Sample {
    double u;
    double value;
  };

  explicit StepPoints(const Curve<N>& curve) : curve_(&curve) {}

  /// Of the step between two points, an arc apart, that outlive what is asked of it.
  void enter(const CurvePoint<N>& from, const CurvePoint<N>& to, const Arc<N>& arc) {
    from_ = &from;
    to_ = &to;
    arc_ = &arc;
  }
  const Curve<N>& curve() const { return *curve_; }
  const CurvePoint<N>& from() const { return *from_; }
  const CurvePoint<N>& to() const { return *to_; }
  const Arc<N>& arc() const { return *arc_; }

  /// Points evaluated so far.
  long evaluations() const { return evaluations_; }
  /// One that another evaluated.
  void count() { ++evaluations_; }

  /// The completed point at u; false where the corrector fails.
  bool evaluate(double u, CurvePoint<N>& out) {
    count();
    const Corrected<N> corrected = curve_->at(from_->arc, *arc_, u);
    if (corrected.status != CorrectorStatus::converged) return false;
    out = curve_->complete(corrected.point);
    // The arc's own direction, as the two ends have it.
    if (out.arc.tangent.dot(arc_->direction(u)) < 0.0) return false;
    return true;
  }

  /// Of function k.
  double value(std::size_t k, double u, double otherwise) {
    CurvePoint<N> point;
    if (!evaluate(u, point)) return otherwise;
    const double f = point.tests.value[k];
    return std::isnan(f) ? otherwise : f;
  }
  /// apart: how far from u it is looked at.
  double slope(std::size_t k, double u, double apart) {
    return (value(k, u + apart, 0.0) - value(k, u - apart, 0.0)) / (2.0 * apart);
  }

  /// The nearest place from u on in a direction where the sign of function k is certain.
  std::optional<Sample> certain_from(std::size_t k, double u, int direction) {
    for (const double aside : aside_of_ends) {
      CurvePoint<N> point;
      const double at = u + direction * aside;
      if (!evaluate(at, point) || point.member.beyond_end()) continue;
      if (point.tests.sign(k) != 0) return Sample{at, point.tests.value[k]};
    }
    return std::nullopt;
  }

  /// How far from u, towards a place where the sign of function k is certain, it is not.
  double uncertain_stretch(std::size_t k, double u, double certain) {
    const double most = std::abs(certain - u);
    for (double aside = 0.0; aside < most; aside = std::max(8.0 * aside, 0x1p-48)) {
      CurvePoint<N> point;
      if (evaluate(u + std::copysign(aside, certain - u), point) && point.tests.sign(k) != 0)
        return aside;
    }
    return most;
  }

  /// Whether function k has certain and opposite signs at two places.
  bool changes_between(std::size_t k, double low, double high) {
    CurvePoint<N> first;
    CurvePoint<N> last;
    return evaluate(low, first) && evaluate(high, last) &&
           first.tests.sign(k) * last.tests.sign(k) < 0;
  }

  /// What function k is known to at u: what the point's errors make of it, and those of the
  /// Lambdas. Where two collide their own errors are roots of what their square's is: beside it, so far apart.
  double noise(std::size_t k, double u, const CurvePoint<N>& point, double apart) {
    constexpr double errors = 32.0;
    const double own = errors * curve_->corrector().curve_error(point.arc);
    if (k >= TestValues::crossings) return std::max(own, mode_noise(point.member));
    if (k != TestValues::collision) return own;
    CurvePoint<N> beside;
    if (!evaluate(u + apart, beside) && !evaluate(u - apart, beside)) return own;
    const double root = std::sqrt(std::abs(beside.tests.value[k]));
    return 2.0 * root * std::max(own, mode_noise(beside.member));
  }

  /// What the parameter is between on a part of the arc. Where it turns there, no farther than the
  /// tangents at both ends reach.
  std::pair<double, double> around(double low, double high) const {
    const double scale = curve_->corrector().scale();
    const double first = parameter(low);
    const double last = parameter(high);
    double least = std::min(first, last);
    double most = std::max(first, last);
    const double leaving = scale * arc_->direction(low)[N] * arc_->length;  // dp/du
    const double arriving = scale * arc_->direction(high)[N] * arc_->length;
    if ((leaving < 0.0) != (arriving < 0.0)) {
      const double beyond = (high - low) * std::max(std::abs(leaving), std::abs(arriving));
      (leaving < 0.0 ? least : most) += leaving < 0.0 ? -beyond : beyond;
    }
    constexpr double rounding = 0x1p-50;
    return {bracket_of(least, rounding * std::abs(least))[0],
            bracket_of(most, rounding * std::abs(most))[1]};
  }

 private:
  /// How far beyond an end of the step a sign is looked for, in arcs.
  static constexpr std::array aside_of_ends{1e-9, 1e-6, 1e-3, 0.03, 0.3, 1.0};

  /// Of the curve itself; the arc's where the corrector fails.
  double parameter(double u) const {
    const Corrected<N> corrected = curve_->at(from_->arc, *arc_, u);
    if (corrected.status == CorrectorStatus::converged) return corrected.point.p;
    return from_->arc.p + curve_->corrector().scale() * arc_->at(u)[N];
  }

  /// The largest relative error of a Lambda that no symmetry forces.
  static double mode_noise(const Member& at) {
    double out = 0.0;
    for (int i = 0; at.spectrum && i < at.spectrum->modes; ++i) {
      const Mode& mode = at.spectrum->mode[static_cast<std::size_t>(i)];
      const double size = hypotenuse(mode.lambda_re, mode.lambda_im);
      if (!mode.forced_zero && size > 0.0) out = std::max(out, mode.lambda_error / size);
    }
    return out;
  }

  const Curve<N>* curve_;
  const CurvePoint<N>* from_ = nullptr;
  const CurvePoint<N>* to_ = nullptr;
  const Arc<N>* arc_ = nullptr;
  long evaluations_ = 0;
};

}  // namespace stationary
