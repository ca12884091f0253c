// A direction in the plane, (cos, sin) of an angle in degrees from axis 1, in extended precision:
// an angle of whole right angles gives zeros and ones exactly.
#pragma once

#include "lib/number/double_double.hpp"
#include "lib/number/interval.hpp"

namespace stationary {

template <class S>
struct Direction {
  S cosine;
  S sine;
};

/// Relative error below 2^-96 of the larger of the two; any finite angle.
Direction<DoubleDouble> direction(double degrees);

/// Of every angle within `spread` degrees of this one.
Direction<Interval> direction_interval(double degrees, double spread);

}  // namespace stationary
