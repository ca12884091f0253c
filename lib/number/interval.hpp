// Interval arithmetic: [lo, hi] holds every value the exact operands can give,
//
//   x in X, y in Y  =>  x o y in X o Y,   o one of + - * /, and sqrt, log, exp.
//
// The rounding mode stays to nearest; each bound is then moved outward past the next double,
//   above(x) = fl(x + fl(phi |x| + eta)) >= succ(x),  phi = 2^-53 (1 + 2^-52),  eta = 2^-960
// (S. M. Rump, P. Zimmermann, S. Boldo, G. Melquiond, BIT 49 (2009) 419; their eta is the smallest
// subnormal, 2^-1074). With 0 a sum or a product is [-eta, eta]: eta is so large that what is made of
// that is hardly ever a subnormal number, for which a processor takes a hundred times as long. log
// and exp are series with proven remainders and rounding errors, not the run-time library's.
//
// An interval is bounded, or it is entire: overflow, division by an interval that holds 0, a
// logarithm of what may not be positive, NaN. Entire (or a NaN) decides nothing: no test below is
// true of it but may_be().
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "lib/number/number.hpp"

namespace stationary {

constexpr double interval_eta = 0x1p-960;

STATIONARY_INLINED inline double above(double x) {
  return x + (0x1.0000000000001p-53 * std::abs(x) + interval_eta);
}
STATIONARY_INLINED inline double below(double x) {
  return x - (0x1.0000000000001p-53 * std::abs(x) + interval_eta);
}

struct Interval {
  double lo = 0.0;
  double hi = 0.0;

  constexpr Interval() = default;
  constexpr Interval(double x) : lo(x), hi(x) {}  // NOLINT(google-explicit-constructor)
  constexpr Interval(double lower, double upper) : lo(lower), hi(upper) {}

  static constexpr Interval entire() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  /// Bounds rounded to nearest, moved outward.
  STATIONARY_INLINED static Interval outward(double lower, double upper) {
    const Interval out(below(lower), above(upper));
    return out.bounded() ? out : entire();
  }
  /// The doubles next to x and all between: what a decimal number that reads as x may have been.
  static Interval decimal(double x) {
    if (x == 0.0) return x;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // An interval is bounded or all there is.
    if (std::abs(x) == std::numeric_limits<double>::max()) return entire();
    return {std::nextafter(x, -infinity), std::nextafter(x, infinity)};
  }

  bool bounded() const { return hi - lo < std::numeric_limits<double>::infinity(); }
  /// Some double in it; NaN of an unbounded one.
  double mid() const { return lo == hi ? lo : lo + 0.5 * (hi - lo); }
  /// Largest |x|, and smallest.
  double magnitude() const { return std::max(std::abs(lo), std::abs(hi)); }
  double mignitude() const { return lo > 0.0 ? lo : hi < 0.0 ? -hi : 0.0; }
  double width() const { return above(hi - lo); }

  bool positive() const { return lo > 0.0 && bounded(); }
  bool negative() const { return hi < 0.0 && bounded(); }
  bool may_be(double x) const { return !(x < lo) && !(x > hi); }
  /// True only of bounded intervals.
  bool within(const Interval& other) const { return other.lo <= lo && hi <= other.hi && bounded(); }
  bool inside(const Interval& other) const { return other.lo < lo && hi < other.hi && bounded(); }
  bool apart_from(const Interval& other) const { return hi < other.lo || other.hi < lo; }
};

STATIONARY_INLINED inline Interval operator-(const Interval& x) { return {-x.hi, -x.lo}; }
STATIONARY_INLINED inline Interval operator+(const Interval& x, const Interval& y) {
  return Interval::outward(x.lo + y.lo, x.hi + y.hi);
}
STATIONARY_INLINED inline Interval operator-(const Interval& x, const Interval& y) {
  return Interval::outward(x.lo - y.hi, x.hi - y.lo);
}
/// Of an entire operand every product is infinite or NaN, and so is its result's width: entire.
STATIONARY_INLINED inline Interval operator*(const Interval& x, const Interval& y) {
  const double a = x.lo * y.lo;
  const double b = x.lo * y.hi;
  const double c = x.hi * y.lo;
  const double d = x.hi * y.hi;
  return Interval::outward(std::min(std::min(a, b), std::min(c, d)),
                           std::max(std::max(a, b), std::max(c, d)));
}
STATIONARY_INLINED inline Interval operator*(double a, const Interval& y) {
  const double b = a * y.lo;
  const double c = a * y.hi;
  return Interval::outward(std::min(b, c), std::max(b, c));
}
STATIONARY_INLINED inline Interval operator*(const Interval& x, double a) { return a * x; }
inline Interval operator/(const Interval& x, const Interval& y) {
  if (y.positive())
    return Interval::outward(x.lo / (x.lo < 0.0 ? y.lo : y.hi), x.hi / (x.hi < 0.0 ? y.hi : y.lo));
  if (y.negative())
    return Interval::outward(x.hi / (x.hi < 0.0 ? y.lo : y.hi), x.lo / (x.lo < 0.0 ? y.hi : y.lo));
  return Interval::entire();
}
inline Interval& operator+=(Interval& x, const Interval& y) { return x = x + y; }
inline Interval& operator-=(Interval& x, const Interval& y) { return x = x - y; }
inline Interval& operator*=(Interval& x, const Interval& y) { return x = x * y; }
inline Interval& operator/=(Interval& x, const Interval& y) { return x = x / y; }

inline Interval hull(const Interval& x, const Interval& y) {
  return {std::min(x.lo, y.lo), std::max(x.hi, y.hi)};
}
/// Only where they are not apart.
inline Interval common(const Interval& x, const Interval& y) {
  return {std::max(x.lo, y.lo), std::min(x.hi, y.hi)};
}

/// {x^2 : x in X}: never negative, unlike X X.
inline Interval square(const Interval& x) {
  const double far = x.magnitude();
  const double near = x.mignitude();
  const Interval out = Interval::outward(near * near, far * far);
  return out.bounded() ? Interval(std::max(out.lo, 0.0), out.hi) : out;
}

/// A sum of products, rounded outward once.
class IntervalSum {
 public:
  explicit IntervalSum(const Interval& first = Interval())
      : lo_(first.lo), hi_(first.hi), size_(first.magnitude()) {}

  STATIONARY_INLINED void add_product(const Interval& x, const Interval& y) {
    const double a = x.lo * y.lo;
    const double b = x.lo * y.hi;
    const double c = x.hi * y.lo;
    const double d = x.hi * y.hi;
    add(std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d)));
  }
  STATIONARY_INLINED void add_product(double a, const Interval& y) {
    const double b = a * y.lo;
    const double c = a * y.hi;
    add(std::min(b, c), std::max(b, c));
  }
  /// Each product and each sum, this one's too, rounds by 2^-53 of no more than all magnitudes' sum.
  Interval value() const {
    const double rounding = 0x1.0001p-53 * roundings_ * size_ + interval_eta * roundings_;
    const Interval out(lo_ - rounding, hi_ + rounding);
    return out.bounded() ? out : Interval::entire();
  }

 private:
  STATIONARY_INLINED void add(double lower, double upper) {
    lo_ += lower;
    hi_ += upper;
    size_ += std::max(std::abs(lower), std::abs(upper));
    roundings_ += 2.0;
  }

  double lo_;
  double hi_;
  double size_;
  double roundings_ = 2.0;
};

/// The square root of IEEE 754 is rounded to nearest.
inline Interval sqrt(const Interval& x) {
  if (!(x.lo >= 0.0) || !x.bounded()) return Interval::entire();
  const Interval out = Interval::outward(std::sqrt(x.lo), std::sqrt(x.hi));
  return {std::max(out.lo, 0.0), out.hi};
}

/// The first 32 bits of ln 2, so that a multiple by an exponent is exact, and the rest, less than 2^-84 away.
constexpr double log_two_head = 0x1.62e42feep-1;
constexpr double log_two_tail = 0x1.a39ef35793c76p-33;

/// Logarithm of one double x > 0, normal: x = 2^k m, 0.7 < m < 1.42, s = (m - 1)/(m + 1),
///   log m = 2 atanh s = 2 s (1 + P),  P = sum_{j >= 1} t^j/(2 j + 1),  t = s^2 < 0.0305.
/// s is a rounded value and the double nearest to the rest. P is cut after j = 12 (the rest is below
/// t^13/27/(1 - t) < 2^-64 t) and summed in double, even and odd j apart: its terms are positive, and the
/// one of order j, which is below t^(j - 1) P, carries at most 5 j + 2 roundings, so P errs by less than
/// 16 * 2^-53 of itself. What is added to the largest terms has six roundings more.
inline Interval log_of_double(double x) {
  constexpr std::uint64_t first_mantissa = 0x3fe6a09e667f3bcd;  // sqrt(1/2)
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t offset = bits - first_mantissa;
  const auto exponent = static_cast<double>(static_cast<std::int64_t>(offset) >> 52);
  const double m = std::bit_cast<double>(bits - (offset & 0xfff0000000000000));
  if (m == 1.0 && exponent == 0.0) return 0.0;
  // m - 1 is exact, and so is its difference from the product below, one or two units of it.
  const DoubleDouble denominator = two_sum(m, 1.0);
  const double inverse = 1.0 / denominator.hi;
  const double s = (m - 1.0) * inverse;
  const DoubleDouble product = two_product(s, denominator.hi);
  const double rest = ((((m - 1.0) - product.hi) - product.lo) - s * denominator.lo) * inverse;
  const double t = s * s;
  const double t2 = t * t;
  double even = 1.0 / 25.0;
  double odd = 1.0 / 23.0;
  for (const double next : {21.0, 17.0, 13.0, 9.0, 5.0}) {
    even = even * t2 + 1.0 / next;
    odd = odd * t2 + 1.0 / (next - 2.0);
  }
  const double P = t * (odd + t * even);
  // The largest terms first and exactly, so that the end is the only rounding of their size.
  const DoubleDouble main = two_sum(exponent * log_two_head, 2.0 * s);
  const double of_P = 2.0 * s * P;
  const double of_rest = 2.0 * rest * (1.0 + P);
  const double tail = exponent * log_two_tail;
  const double small = ((of_P + of_rest) + main.lo) + tail;
  const double error = 0x1.8p-49 * std::abs(of_P) +
                       0x1p-49 * (std::abs(of_rest) + std::abs(main.lo) + std::abs(tail)) +
                       0x1p-84 * std::abs(exponent) + 0x1p-98 * std::abs(s);
  return Interval::outward(main.hi + (small - error), main.hi + (small + error));
}

inline Interval log(const Interval& x) {
  if (!(x.lo >= 0x1p-1022) || !x.bounded()) return Interval::entire();
  return {log_of_double(x.lo).lo, log_of_double(x.hi).hi};
}

/// Exponential of one double |x| < 700: x = k log 2 + r, |r| < 0.35,
///   e^r = 1 + r + r^2 Q,  Q = sum_{j >= 0} r^j/(j + 2)!.
/// r is a double and the rest of it. Q is cut after j = 11 (what follows is below
/// 0.35^12/14!/(1 - 0.35) < 2^-53) and summed in double, even and odd j apart; term j carries at most
/// 2 j + 4 roundings, together below 3 * 2^-53. What is added to 1 + r has five roundings more.
inline Interval exp_of_double(double x) {
  if (x == 0.0) return 1.0;
  constexpr double to_integer = 0x1.8p52;  // added and taken away it rounds to an integer
  const double k = (x * 0x1.71547652b82fep+0 + to_integer) - to_integer;
  const DoubleDouble r = two_sum(x - k * log_two_head, -(k * log_two_tail));
  static constexpr auto reciprocal = [] {  // 1/(j + 2)!; the factorials are exact
    std::array<double, 12> out{};
    double factorial = 1.0;
    for (std::size_t j = 0; j < out.size(); ++j) {
      factorial *= static_cast<double>(j + 2);
      out[j] = 1.0 / factorial;
    }
    return out;
  }();
  const double r2 = r.hi * r.hi;
  double even = reciprocal[10];
  double odd = reciprocal[11];
  for (std::size_t j = 10; j > 0; j -= 2) {
    even = even * r2 + reciprocal[j - 2];
    odd = odd * r2 + reciprocal[j - 1];
  }
  const double Q = even + r.hi * odd;
  const DoubleDouble main = two_sum(1.0, r.hi);
  const double of_rest = r.lo * (1.0 + r.hi);
  const double small = (r2 * Q + of_rest) + main.lo;
  const double error =
      0x1.8p-50 * r2 + 0x1p-50 * (std::abs(of_rest) + std::abs(main.lo)) + 0x1p-83 * std::abs(k);
  const Interval power = Interval::outward(main.hi + (small - error), main.hi + (small + error));
  // A power of two, and no subnormal number.
  const double scale =
      std::bit_cast<double>(static_cast<std::uint64_t>(1023 + static_cast<int>(k)) << 52);
  return {scale * power.lo, scale * power.hi};
}

inline Interval exp(const Interval& x) {
  if (!(x.lo > -700.0) || !(x.hi < 700.0)) return Interval::entire();
  return {exp_of_double(x.lo).lo, exp_of_double(x.hi).hi};
}

/// A place in the interval, for code that only starts an iteration from it. Never a reason to
/// choose a formula: that must hold over all of the interval.
inline double leading(const Interval& x) { return x.mid(); }

/// Whether a number stands for all values in an interval: one itself, or what carries derivatives
/// over one.
template <class S>
constexpr bool over_intervals = false;
template <class S>
requires requires(const S& x) { x.value; }
constexpr bool over_intervals<S> =
    over_intervals<std::remove_cvref_t<decltype(std::declval<S>().value)>>;
template <>
inline constexpr bool over_intervals<Interval> = true;

/// The values that it stands for.
inline const Interval& values_of(const Interval& x) { return x; }
template <class S>
const Interval& values_of(const S& x) {
  return values_of(x.value);
}

}  // namespace stationary

template <>
class std::numeric_limits<stationary::Interval> : public std::numeric_limits<double> {};
