// Elementary functions of intervals (interval.hpp) beyond sqrt, log and exp:
//
//   x in X  =>  f(x) in f(X),   f one of sin, cos, tan, tanh, atan, and x^p.
//
// Each is a series in interval arithmetic whose remainder is an interval too, at the ends of X
// where it is monotonic, so its bounds are proven as far as + - * / and sqrt are. Entire where it
// is not defined all over X (tan at a pole) or where a reduction would be too coarse.
#pragma once

#include <array>
#include <cmath>

#include "lib/number/interval.hpp"
#include "lib/number/quarter_turns.hpp"

namespace stationary {

inline constexpr Interval interval_half_pi{0x1.921fb54442d18p+0, 0x1.921fb54442d19p+0};

/// |x| and the smaller of two, of intervals.
inline Interval absolute(const Interval& x) {
  if (!x.bounded()) return Interval::entire();
  return {x.mignitude(), x.magnitude()};
}
inline Interval smaller(const Interval& x, const Interval& y) {
  if (!x.bounded() || !y.bounded()) return Interval::entire();
  return {std::min(x.lo, y.lo), std::min(x.hi, y.hi)};
}

/// 1/(2 k)! and 1/(2 k + 1)!, as intervals.
inline constexpr int interval_series_length = 12;

/// sin and cos of one double, |x| <= 2^20: x = k pi/2 + r, |r| < 0.79, r an interval; the series
/// end with r^24/24! and r^25/25! times [-1, 1], below 2^-87.
inline SineCosine<Interval> sine_cosine_of_double(double x) {
  if (!(std::abs(x) <= 0x1p20)) return {Interval(-1.0, 1.0), Interval(-1.0, 1.0)};
  // pi/2 = head + tail, the head of 33 bits so that k head is exact; x - k head then is rounded
  // once, and the interval holds it.
  constexpr double head = 0x1.921fb544p+0;
  constexpr Interval tail{0x1.0b4611a626331p-34, 0x1.0b4611a626332p-34};
  const double k = std::round(x / interval_half_pi.lo);
  const Interval r = (Interval(x) - Interval(k * head)) - k * tail;
  const Interval z = square(r);
  Interval sine(-1.0, 1.0);
  Interval cosine(-1.0, 1.0);
  for (int j = interval_series_length; j >= 1; --j) {
    const double n = 2.0 * j;
    sine = Interval(1.0) - z * sine / Interval(n * (n + 1.0));
    cosine = Interval(1.0) - z * cosine / Interval(n * (n - 1.0));
  }
  sine = sine * r;
  return after_quarter_turns(k, sine, cosine);
}

/// Whether x may hold a whole multiple of `period`, shifted: (x - shift)/period may be an integer.
inline bool may_hold_multiple(const Interval& x, const Interval& shift, const Interval& period) {
  const Interval turns = (x - shift) / period;
  return !turns.bounded() || std::floor(turns.hi) >= std::ceil(turns.lo);
}

/// Of a function between -1 and 1 that is monotonic but where it is +1 or -1.
inline Interval between_extremes(const Interval& at_lo, const Interval& at_hi, bool top,
                                 bool bottom) {
  const Interval ends = hull(at_lo, at_hi);
  return {bottom ? -1.0 : std::max(ends.lo, -1.0), top ? 1.0 : std::min(ends.hi, 1.0)};
}

inline Interval sin(const Interval& x) {
  if (!x.bounded() || std::isnan(x.lo) || !(x.magnitude() <= 0x1p20)) return {-1.0, 1.0};
  const Interval period = 4.0 * interval_half_pi;
  return between_extremes(sine_cosine_of_double(x.lo).sine, sine_cosine_of_double(x.hi).sine,
                          may_hold_multiple(x, interval_half_pi, period),
                          may_hold_multiple(x, -interval_half_pi, period));
}

inline Interval cos(const Interval& x) {
  if (!x.bounded() || std::isnan(x.lo) || !(x.magnitude() <= 0x1p20)) return {-1.0, 1.0};
  const Interval period = 4.0 * interval_half_pi;
  return between_extremes(sine_cosine_of_double(x.lo).cosine, sine_cosine_of_double(x.hi).cosine,
                          may_hold_multiple(x, Interval(0.0), period),
                          may_hold_multiple(x, 2.0 * interval_half_pi, period));
}

/// Increasing between its poles.
inline Interval tan(const Interval& x) {
  if (!x.bounded() || !(x.magnitude() <= 0x1p20) ||
      may_hold_multiple(x, interval_half_pi, 2.0 * interval_half_pi))
    return Interval::entire();
  const SineCosine<Interval> lo = sine_cosine_of_double(x.lo);
  const SineCosine<Interval> hi = sine_cosine_of_double(x.hi);
  const Interval out((lo.sine / lo.cosine).lo, (hi.sine / hi.cosine).hi);
  return out.bounded() ? out : Interval::entire();
}

/// tanh x = E/(E + 2), E = e^(2x) - 1; for |2x| <= 1/2 the series E = y (1 + y/2 (1 + y/3 ...)),
/// whose bracket after y/17 is within [0.9, 1.1].
inline Interval tanh_of_double(double x) {
  if (x == 0.0) return 0.0;
  if (std::abs(x) > 20.0) {
    const Interval nearly_one(0x1.fffffffffffffp-1, 1.0);
    return x > 0.0 ? nearly_one : -nearly_one;
  }
  Interval e;
  if (std::abs(x) <= 0.25) {
    const Interval y(2.0 * x);
    Interval bracket(0.9, 1.1);
    for (int k = 17; k >= 2; --k) bracket = Interval(1.0) + y * bracket / Interval(double(k));
    e = y * bracket;
  } else {
    e = exp_of_double(2.0 * x) - Interval(1.0);
  }
  return e / (e + Interval(2.0));
}
inline Interval tanh(const Interval& x) {
  if (!x.bounded()) return {-1.0, 1.0};
  return {std::max(tanh_of_double(x.lo).lo, -1.0), std::min(tanh_of_double(x.hi).hi, 1.0)};
}

/// atan x = 4 atan z, z = h(h(x)), h(x) = x/(1 + sqrt(1 + x^2)), |z| < 0.2; its alternating
/// series, the rest of which is between 0 and its first term. |x| > 1: pi/2 - atan(1/x).
inline Interval atan_of_double(double x) {
  if (x == 0.0) return 0.0;
  if (x < 0.0) return -atan_of_double(-x);
  const bool inverted = x > 1.0;
  Interval z = inverted ? Interval(1.0) / Interval(x) : Interval(x);
  for (int k = 0; k < 2; ++k) z = z / (Interval(1.0) + sqrt(Interval(1.0) + square(z)));
  const Interval y = square(z);
  constexpr int last = 14;  // |z| < 0.2: the next term is below 2^-70 of the first
  Interval sum = Interval(0.0, 1.0) / Interval(2.0 * last + 1.0);
  for (int k = last - 1; k >= 0; --k) sum = Interval(1.0) / Interval(2.0 * k + 1.0) - y * sum;
  const Interval angle = 4.0 * (z * sum);
  return inverted ? interval_half_pi - angle : angle;
}
inline Interval atan(const Interval& x) {
  if (!x.bounded()) return {-interval_half_pi.hi, interval_half_pi.hi};
  return {atan_of_double(x.lo).lo, atan_of_double(x.hi).hi};
}

/// x^p for x > 0, entire otherwise.
inline Interval pow(const Interval& x, const Interval& p) { return exp(p * log(x)); }

}  // namespace stationary
