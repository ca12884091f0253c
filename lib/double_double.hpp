// Extended precision: x = hi + lo with |lo| <= ulp(hi)/2, about 106 significand bits.
//
//   two_sum(a, b)     = (fl(a + b), the exact rounding error)     6 flops
//   two_product(a, b) = (fl(a b),   the exact rounding error)     2 flops with a fused multiply-add
//
// It exists for one purpose: the residual of the last correction of a solve, where a double
// residual would leave errors of several units in the last place, and far more near a fold.
//
// Error of each operation, relative to the operands' magnitudes (so a sum may cancel):
//   x + y: 2^-104 (|x| + |y|);  x y, x / y, sqrt x: 2^-102 of the result;
//   log x: 2^-82 |log x| (a residual needs no more; the tests hold it to this).
// Source: T. J. Dekker, Numer. Math. 18 (1971) 224; Hida, Li, Bailey, ARITH-15 (2001).
// Must be compiled without contraction (-ffp-contract=off) and without -ffast-math: the exported
// targets carry the flag.
#pragma once

#include <cmath>
#include <limits>

namespace stationary {

struct DoubleDouble {
  double hi = 0.0;
  double lo = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi(x) {}  // NOLINT(google-explicit-constructor)
  constexpr DoubleDouble(double head, double tail) : hi(head), lo(tail) {}
  constexpr explicit operator double() const { return hi + lo; }
};

/// (fl(a + b), error), exact for all finite a, b without overflow.
constexpr DoubleDouble two_sum(double a, double b) {
  const double s = a + b;
  const double bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// As two_sum, for |a| >= |b| or a = 0.
constexpr DoubleDouble quick_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// (fl(a b), error), exact unless the product under- or overflows.
inline DoubleDouble two_product(double a, double b) {
  const double p = a * b;
#ifdef __FMA__
  return {p, std::fma(a, b, -p)};
#else
  constexpr double split = 134217729.0;  // 2^27 + 1 (Dekker, Veltkamp)
  const double ca = split * a;
  const double a1 = ca - (ca - a);
  const double a2 = a - a1;
  const double cb = split * b;
  const double b1 = cb - (cb - b);
  const double b2 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
#endif
}

constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi, -x.lo}; }

constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi);
  return quick_two_sum(s.hi, s.lo + (x.lo + y.lo));
}
constexpr DoubleDouble operator+(const DoubleDouble& x, double y) {
  const DoubleDouble s = two_sum(x.hi, y);
  return quick_two_sum(s.hi, s.lo + x.lo);
}
constexpr DoubleDouble operator+(double x, const DoubleDouble& y) { return y + x; }
constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + (-y); }
constexpr DoubleDouble operator-(const DoubleDouble& x, double y) { return x + (-y); }
constexpr DoubleDouble operator-(double x, const DoubleDouble& y) { return (-y) + x; }

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble p = two_product(x.hi, y.hi);
  return quick_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}
inline DoubleDouble operator*(const DoubleDouble& x, double y) {
  const DoubleDouble p = two_product(x.hi, y);
  return quick_two_sum(p.hi, p.lo + x.lo * y);
}
inline DoubleDouble operator*(double x, const DoubleDouble& y) { return y * x; }

inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  // One division: the quotient of the heads, corrected by the exact remainder over y.hi.
  const double inverse = 1.0 / y.hi;
  const double q1 = x.hi * inverse;
  const DoubleDouble r1 = x - y * q1;
  const double q2 = r1.hi * inverse;
  const DoubleDouble r2 = r1 - y * q2;
  return quick_two_sum(q1, q2) + r2.hi * inverse;
}
inline DoubleDouble operator/(const DoubleDouble& x, double y) { return x / DoubleDouble(y); }
inline DoubleDouble operator/(double x, const DoubleDouble& y) { return DoubleDouble(x) / y; }

inline DoubleDouble& operator+=(DoubleDouble& x, const DoubleDouble& y) { return x = x + y; }
inline DoubleDouble& operator-=(DoubleDouble& x, const DoubleDouble& y) { return x = x - y; }
inline DoubleDouble& operator*=(DoubleDouble& x, const DoubleDouble& y) { return x = x * y; }
inline DoubleDouble& operator/=(DoubleDouble& x, const DoubleDouble& y) { return x = x / y; }

constexpr bool operator==(const DoubleDouble& x, const DoubleDouble& y) {
  return x.hi == y.hi && x.lo == y.lo;
}
constexpr bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
  return x.hi < y.hi || (x.hi == y.hi && x.lo < y.lo);
}
constexpr bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }

inline DoubleDouble abs(const DoubleDouble& x) { return x.hi < 0.0 ? -x : x; }

/// Square root of x >= 0 (NaN below).
inline DoubleDouble sqrt(const DoubleDouble& x) {
  if (x.hi == 0.0) return {};
  const double r = std::sqrt(x.hi);
  const DoubleDouble remainder = x - two_product(r, r);
  return quick_two_sum(r, remainder.hi / (2.0 * r));
}

/// Natural logarithm of x > 0 (NaN below, -inf at 0): x = 2^k m, m r_i = 1 + z with r_i from a
/// table of 128 reciprocals, |z| < 2^-7; log x = k log 2 - log r_i + log(1 + z).
DoubleDouble log(const DoubleDouble& x);

}  // namespace stationary

template <>
class std::numeric_limits<stationary::DoubleDouble> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr int digits = 104;
  static constexpr stationary::DoubleDouble quiet_NaN() {
    return {std::numeric_limits<double>::quiet_NaN(), 0.0};
  }
  static constexpr stationary::DoubleDouble epsilon() { return {0x1p-103, 0.0}; }
};
