// Elementary functions of extended precision (double_double.hpp) beyond sqrt and log:
//
//   exp x        x = k log 2 + 512 r, e^r - 1 by its series, squared nine times
//   sin x, cos x x = k pi/2 + r, series of r                (|x| up to 2^30, NaN beyond)
//   tan, tanh    from those;   atan x one Newton step from the double's;   x^p = exp(p log x)
//
// Error, relative to the result but for sin, cos and tan near their zeros, where it is of 1, tan near its poles, where
// it is of 1/cos, and exp below 2^-900, whose second double may be subnormal:
//   exp, tanh 2^-92;  sin, cos, tan, atan 2^-95 (1 + |x|);  pow 2^-80 (1 + |p log x|).
#pragma once

#include <cmath>

#include "lib/number/double_double.hpp"
#include "lib/number/quarter_turns.hpp"

namespace stationary {

inline constexpr DoubleDouble double_double_pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble double_double_e{0x1.5bf0a8b145769p+1, 0x1.4d57ee2b1013ap-53};

/// e^x - 1 for |x| < 0.4, to full relative precision.
inline DoubleDouble double_double_small_exp_minus_one(const DoubleDouble& x) {
  const DoubleDouble r(x.hi * 0x1p-9, x.lo * 0x1p-9);
  // r (1 + r/2 (1 + r/3 (...))): |r| < 2^-10, so the ninth term is below 2^-98.
  DoubleDouble sum(1.0);
  for (int k = 9; k >= 2; --k) sum = 1.0 + sum * r / static_cast<double>(k);
  DoubleDouble s = renormalized(sum * r);
  for (int k = 0; k < 9; ++k) s = renormalized(2.0 * s + s * s);  // (1 + s)^2 - 1
  return s;
}

inline DoubleDouble exp(const DoubleDouble& y) {
  const DoubleDouble x = renormalized(y);
  if (!(x.hi > -700.0) || !(x.hi < 700.0)) return exp(x.hi);  // also NaN; in double precision
  const double k = std::round(x.hi / double_double_log_two.hi);
  const DoubleDouble r = renormalized(x - double_double_log_two * k);
  const DoubleDouble power = renormalized(1.0 + double_double_small_exp_minus_one(r));
  const int exponent = static_cast<int>(k);
  return {std::ldexp(power.hi, exponent), std::ldexp(power.lo, exponent)};
}

inline SineCosine<DoubleDouble> sine_cosine(const DoubleDouble& y) {
  const DoubleDouble x = renormalized(y);
  if (!(std::abs(x.hi) <= 0x1p30)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  constexpr DoubleDouble half_pi{0.5 * double_double_pi.hi, 0.5 * double_double_pi.lo};
  constexpr double half_pi_rest = -0x1.f1976b7ed8fbcp-110;
  const double k = std::round(x.hi / half_pi.hi);
  const DoubleDouble r = renormalized((x - half_pi * k) - half_pi_rest * k);
  const DoubleDouble z = r * r;
  DoubleDouble sine(1.0);
  DoubleDouble cosine(1.0);
  // |r| < 0.79: the terms of order 30 and 31 are below 2^-115.
  for (int j = 14; j >= 1; --j) {
    const double n = 2.0 * j;
    sine = 1.0 - z * sine / (n * (n + 1.0));
    cosine = 1.0 - z * cosine / (n * (n - 1.0));
  }
  sine = sine * r;
  return after_quarter_turns(k, sine, cosine);
}

inline DoubleDouble sin(const DoubleDouble& x) { return sine_cosine(x).sine; }
inline DoubleDouble cos(const DoubleDouble& x) { return sine_cosine(x).cosine; }
inline DoubleDouble tan(const DoubleDouble& x) {
  const SineCosine<DoubleDouble> of = sine_cosine(x);
  return renormalized(of.sine) / renormalized(of.cosine);
}

inline DoubleDouble tanh(const DoubleDouble& y) {
  const DoubleDouble x = renormalized(y);
  if (std::abs(x.hi) > 40.0) return tanh(x.hi);
  const DoubleDouble twice = 2.0 * x;
  const DoubleDouble e = std::abs(twice.hi) < 0.4 ? double_double_small_exp_minus_one(twice)
                                                  : renormalized(exp(twice) - 1.0);
  return e / renormalized(e + 2.0);
}

inline DoubleDouble atan(const DoubleDouble& y) {
  const DoubleDouble x = renormalized(y);
  const double near = atan(x.hi);
  if (!(std::abs(x.hi) < 0x1p60)) return near;  // pi/2 to a double; also NaN
  const SineCosine<DoubleDouble> of = sine_cosine(near);
  // tan(near + h) = x, and h is as small as a rounding error.
  const DoubleDouble h =
      renormalized(x * of.cosine - of.sine) / renormalized(of.cosine + x * of.sine);
  return near + h;
}

/// x^p for x > 0 (NaN below; 0 or infinite at 0).
inline DoubleDouble pow(const DoubleDouble& x, const DoubleDouble& p) {
  if (!(double(x) > 0.0)) return pow(double(x), double(p));
  return exp(p * log(renormalized(x)));
}

}  // namespace stationary
