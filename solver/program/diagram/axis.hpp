// An axis of a picture: the range it shows, linear or logarithmic, and how that is chosen from the
// curves. A curve that runs off, as where a stretch escapes, may not press all others flat: what lies
// far outside of where the curves spend their way is cut off.
#pragma once

#include <limits>
#include <vector>

namespace stationary {

struct AxisRange {
  double low;
  double high;
};

/// Numbers beyond this size are not drawn: the length of an axis, and twice that, is a double.
constexpr double largest_drawn = 0.25 * std::numeric_limits<double>::max();

/// Cut off at largest_drawn; of a logarithmic axis, at the least normal number too. What lies wholly
/// beyond leaves the last factor of two.
AxisRange drawable(const AxisRange& range, bool logarithmic);

struct Axis {
  AxisRange range{0.0, 1.0};
  bool logarithmic = false;

  /// 0 at the low end, 1 at the high one; NaN where a logarithmic axis has no place for it.
  double place(double value) const;
  double value(double place) const;
};

/// What all numbers of a range all but share, 0 where it is not narrow: shown less it, they have ticks that can
/// be read.
double base_of(const AxisRange& range);

/// A number along a curve, and how much of the curve's way it stands for.
struct WeightedValue {
  double value;
  double weight;
};
using WeightedCurve = std::vector<WeightedValue>;

/// Shows all of the curves, or where all is more than twice what they cover on 96 % of their way,
/// that and half as much beyond; of a short curve, less of its way. Logarithmic where that spans more
/// than a factor of 12.
Axis fitted_axis(const std::vector<WeightedCurve>& curves);

/// From zero; cut off above the others where one curve outgrows them, and logarithmic where one would
/// lie flat on the axis because the next is 15 times as high: a stiff mode does not hide the others.
Axis fitted_rate_axis(const std::vector<WeightedCurve>& curves);

/// The same, of everything that is there.
Axis whole_axis(const std::vector<WeightedCurve>& curves);

/// What is to be shown as asked; linear where the lower end is not a positive normal number.
Axis asked_axis(const AxisRange& range, bool logarithmic);

}  // namespace stationary
