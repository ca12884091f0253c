// How far the next step may go. With the cubic predictor of hermite_arc.hpp the first correction
// measures the curve's fourth derivative,
//
//   |first correction| = D h^2 (h + l)^2 / 24      (l the last step, h this one),
//
// and a cubic through four rows h apart is off by D h^4/24 at most (in the end interval; less than
// 0.6 of it between the middle two). Steps are chosen so that this stays below the tolerance: the
// table, interpolated, is the curve to the tolerance.
#pragma once

#include <algorithm>
#include <cmath>

namespace stationary {

struct StepOptions {
  double tolerance = 1e-10;  ///< distance in y = (ln x, p/scale)
  double first = 0.01;
  double max = 0.5;
  double min = 1e-12;
  double growth = 1.5;     ///< of one step to the next, at most
  double max_angle = 0.2;  ///< radians between successive tangents
};

class StepControl {
 public:
  /// Corrections below this are rounding and show no derivative: a smaller tolerance cannot be
  /// kept.
  static constexpr double least_tolerance = 1e-13;

  explicit StepControl(const StepOptions& options) : options_(options) {
    options_.tolerance = std::max(options_.tolerance, least_tolerance);
  }
  const StepOptions& options() const { return options_; }

  /// The fourth derivative a step h after one of length l has shown.
  static double fourth_derivative(double correction, double h, double l) {
    const double reach = h * (h + l);
    return 24.0 * std::max(correction, 1e-16) / (reach * reach);
  }

  /// The one that the middle of a step h shows, against the cubic through its ends.
  static double fourth_derivative_in_middle(double correction, double h) {
    return 384.0 * std::max(correction, 1e-16) / (h * h * h * h);
  }

  /// A step this much too long is taken back.
  bool too_long(double D, double h) const { return D * h * h * h * h > 48.0 * options_.tolerance; }

  /// Whether the next step is to be shorter.
  bool shortens(double D, double h) const {
    return D * h * h * h * h > 24.0 * safety * options_.tolerance;
  }

  /// The next step, from what this one showed and what the one before had.
  double next(double D, double D_before, double h, double angle) const {
    const double fits =
        std::sqrt(std::sqrt(24.0 * safety * options_.tolerance / std::max(D, D_before)));
    const double bends = h * 0.7 * options_.max_angle / std::max(angle, 1e-12);
    return std::min({fits, bends, options_.growth * h, options_.max});
  }

 private:
  static constexpr double safety = 0.5;  ///< of the tolerance, aimed at
  StepOptions options_;
};

}  // namespace stationary
