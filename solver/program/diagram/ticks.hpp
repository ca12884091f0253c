// The ticks of an axis, for gnuplot: so many that the numbers at them are apart.
#pragma once

#include <string>

#include "solver/program/diagram/axis.hpp"

namespace stationary {

/// Along which way the numbers stand: beside one another or on one another.
enum class AxisWay { level, upright };

/// How many ticks may be on a logarithmic axis of this length, in pixels.
double most_ticks(double length, AxisWay way);

/// Of a logarithmic axis, for `set tics`: powers of ten and, where there is room, 2 and 5 between
/// them; none where the range is not one of positive numbers. decades: the axis is of the logarithms,
/// not itself logarithmic.
std::string logarithmic_ticks(const AxisRange& range, double most, bool decades = false);

/// Of a linear axis of this length: what `set tics` is told. `autofreq`, gnuplot's own choice, where
/// that leaves room for the numbers, else a step.
std::string linear_ticks(const AxisRange& range, double length, AxisWay way);

}  // namespace stationary
