// A step along a curve, for every path that is followed: where it is predicted to lead to, what tells the point it came to
// from one of another sheet, and how long the next one is.
//
//   predictor      the cubic of the last step (hermite_arc.hpp), carried on; at the start the tangent
//   guard          jump_guard.hpp, and how far the tangent turned
//   step control   the fourth derivative the first correction shows (step_control.hpp)
//
// Who follows the curve corrects (bordered_newton.hpp) and may ask for more. Whatever refuses a step shortens it.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "solver/continuation/bordered_newton.hpp"
#include "solver/continuation/step_control.hpp"

namespace stationary {

template <int N>
class PathStep {
 public:
  explicit PathStep(const StepOptions& options) : control_(options), length_(options.first) {}

  /// Of the next step, in y.
  double length() const { return length_; }
  bool too_short() const { return length_ < control_.options().min; }
  /// Why the last step was refused.
  const std::string& refusal() const { return refusal_; }
  /// The last step's, if there was one.
  bool has_arc() const { return has_arc_; }
  const Arc<N>& arc() const { return arc_; }

  /// From the last point, with this tangent, to that predicted at a distance.
  ArcVector<N> ahead(const ArcVector<N>& tangent, double distance) const {
    if (!has_arc_) return distance * tangent;
    return arc_.at(1.0 + distance / arc_.length) - arc_.chord;
  }
  /// The longest first correction of a step of this length.
  double longest_correction(double length) const {
    return longest_first_correction(length, control_.options().max_angle);
  }

  /// Whether the tangent turned no further than it may.
  bool straight(double angle) const { return angle <= control_.options().max_angle; }

  /// Returns false, as whoever refuses a step does.
  bool refuse(std::string why) { return refuse(std::move(why), 0.5 * length_); }
  bool refuse(std::string why, double length) {
    refusal_ = std::move(why);
    length_ = length;
    return false;
  }

  /// Whether a first correction that shortens the steps is too large to be taken for rounding.
  bool is_coarse(double correction, double h) const {
    return correction >= coarse &&
           control_.shortens(StepControl::fourth_derivative(correction, h, arc_.length), h);
  }
  /// The fourth derivative that the first correction of a step of length h showed, after the first step. rounding(): what of
  /// that correction may be rounding, of G or of the tangents.
  template <class Rounding>
  double shown(double correction, double h, const Rounding& rounding) const {
    const double D = StepControl::fourth_derivative(correction, h, arc_.length);
    if (!control_.shortens(D, h) || correction >= coarse) return D;
    // Believe the last step, as far as what is left allows.
    const double left = correction - rounding();
    return std::clamp(D_, StepControl::fourth_derivative(left, h, arc_.length), D);
  }
  /// Whether a step of length h that showed it may be taken.
  bool fits(double D, double h) const { return !control_.too_long(D, h); }
  /// Refuses one that does not fit.
  bool refuse_bend(double D) {
    const double h = length_;
    const double half = 0.5 * h;
    return refuse("the curve bends more than the tolerance allows",
                  has_arc_ ? std::clamp(control_.next(D, 0.0, h, 0.0), 0.25 * h, half) : half);
  }

  /// The step was taken, along this arc.
  void take(const Arc<N>& arc) {
    arc_ = arc;
    has_arc_ = true;
  }
  /// The next is predicted along the tangent, as the first one is: the coordinates are others now.
  void forget_arc() { has_arc_ = false; }
  /// The length of the next, after one that showed this fourth derivative and turned by this angle.
  void lengthen(double D, double angle) {
    length_ = control_.next(D, D_, length_, angle);
    D_ = D;
  }

 private:
  static constexpr double coarse = 1e-8;

  StepControl control_;
  Arc<N> arc_;
  bool has_arc_ = false;
  double length_;
  double D_ = 0.0;  ///< shown by the last step
  std::string refusal_ = "the first step";
};

}  // namespace stationary
