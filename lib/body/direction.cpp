#include "lib/body/direction.hpp"

#include <cmath>

namespace stationary {
namespace {

constexpr DoubleDouble radians_per_degree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

}  // namespace

Direction<DoubleDouble> direction(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  const double quarter = std::round(turn / 90.0);
  const double rest = turn - 90.0 * quarter;  // exact, at most 45
  // Taylor's series; its last terms are below 2^-104.
  const DoubleDouble x = radians_per_degree * rest;
  const DoubleDouble square = x * x;
  constexpr int last = 14;
  DoubleDouble sine(1.0);
  DoubleDouble cosine(1.0);
  for (int k = last; k >= 1; --k) {
    sine = 1.0 - square * sine / static_cast<double>(2 * k * (2 * k + 1));
    cosine = 1.0 - square * cosine / static_cast<double>(2 * k * (2 * k - 1));
  }
  sine = renormalized(sine * x);
  cosine = renormalized(cosine);
  switch (static_cast<int>(quarter)) {
    case 1:
      return {-sine, cosine};
    case -1:
      return {sine, -cosine};
    case 2:
    case -2:
      return {-cosine, -sine};
    default:
      return {cosine, sine};
  }
}

Direction<Interval> direction_interval(double degrees, double spread) {
  // Neither turns by more than the angle, of a little less than 2^-5 of the degrees.
  const auto around = [&](const DoubleDouble& x) {
    const bool exact = spread == 0.0 && x.lo == 0.0 && (x.hi == 0.0 || std::abs(x.hi) == 1.0);
    if (exact) return Interval(x.hi);
    const double radius = above(0x1p-5 * spread + 0x1p-96);
    return Interval(x.hi) + (Interval(x.lo) + Interval(-radius, radius));
  };
  const Direction<DoubleDouble> middle = direction(degrees);
  return {around(middle.cosine), around(middle.sine)};
}

}  // namespace stationary
