// Pairs of doubles (double_double.hpp) as a scalar of Eigen's, for iterations: each result is
// renormalized, so that any number of operations may follow one another. The same on every
// processor, where `long double` has 53, 64 or 113 bits.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>

#include "lib/number/double_double.hpp"

namespace stationary {

class EigenPair {
 public:
  EigenPair() = default;
  EigenPair(double x) : pair_(x) {}  // NOLINT(google-explicit-constructor)
  explicit EigenPair(const DoubleDouble& x) : pair_(renormalized(x)) {}
  explicit operator double() const { return pair_.hi; }

  STATIONARY_INLINED friend EigenPair operator-(const EigenPair& x) { return EigenPair(-x.pair_); }
  /// The sums of the tails are added exactly too: a difference of neighbours keeps its digits.
  STATIONARY_INLINED friend EigenPair operator+(const EigenPair& x, const EigenPair& y) {
    const DoubleDouble heads = two_sum(x.pair_.hi, y.pair_.hi);
    const DoubleDouble tails = two_sum(x.pair_.lo, y.pair_.lo);
    const DoubleDouble sum = quick_two_sum(heads.hi, heads.lo + tails.hi);
    return EigenPair(DoubleDouble(sum.hi, sum.lo + tails.lo));
  }
  STATIONARY_INLINED friend EigenPair operator-(const EigenPair& x, const EigenPair& y) {
    return x + (-y);
  }
  STATIONARY_INLINED friend EigenPair operator*(const EigenPair& x, const EigenPair& y) {
    return EigenPair(x.pair_ * y.pair_);
  }
  STATIONARY_INLINED friend EigenPair operator/(const EigenPair& x, const EigenPair& y) {
    return EigenPair(x.pair_ / y.pair_);
  }
  EigenPair& operator+=(const EigenPair& y) { return *this = *this + y; }
  EigenPair& operator-=(const EigenPair& y) { return *this = *this - y; }
  EigenPair& operator*=(const EigenPair& y) { return *this = *this * y; }
  EigenPair& operator/=(const EigenPair& y) { return *this = *this / y; }

  friend bool operator==(const EigenPair& x, const EigenPair& y) {
    return x.pair_.hi == y.pair_.hi && x.pair_.lo == y.pair_.lo;
  }
  friend bool operator<(const EigenPair& x, const EigenPair& y) {
    return x.pair_.hi < y.pair_.hi || (x.pair_.hi == y.pair_.hi && x.pair_.lo < y.pair_.lo);
  }
  friend bool operator>(const EigenPair& x, const EigenPair& y) { return y < x; }
  friend bool operator<=(const EigenPair& x, const EigenPair& y) { return x < y || x == y; }
  friend bool operator>=(const EigenPair& x, const EigenPair& y) { return y <= x; }

  friend EigenPair abs(const EigenPair& x) { return x < 0.0 ? -x : x; }
  STATIONARY_INLINED friend EigenPair sqrt(const EigenPair& x) { return EigenPair(sqrt(x.pair_)); }
  friend bool isfinite(const EigenPair& x) { return std::isfinite(x.pair_.hi); }
  friend bool isnan(const EigenPair& x) { return std::isnan(x.pair_.hi); }
  friend bool isinf(const EigenPair& x) { return std::isinf(x.pair_.hi); }

 private:
  DoubleDouble pair_;
};

/// Eigen and std::complex find these before the standard library's, which are for its own numbers.
using ComplexPair = std::complex<EigenPair>;

STATIONARY_INLINED inline ComplexPair operator*(const ComplexPair& z, const ComplexPair& w) {
  return {z.real() * w.real() - z.imag() * w.imag(), z.real() * w.imag() + z.imag() * w.real()};
}
inline ComplexPair operator/(const ComplexPair& z, const ComplexPair& w) {
  const EigenPair size = w.real() * w.real() + w.imag() * w.imag();
  return {(z.real() * w.real() + z.imag() * w.imag()) / size,
          (z.imag() * w.real() - z.real() * w.imag()) / size};
}

/// Divided by the larger part first: no square overflows.
inline EigenPair abs(const ComplexPair& z) {
  const EigenPair x = abs(z.real());
  const EigenPair y = abs(z.imag());
  const EigenPair larger = x < y ? y : x;
  if (larger == 0.0) return larger;
  const EigenPair a = x / larger;
  const EigenPair b = y / larger;
  return larger * sqrt(a * a + b * b);
}

/// The root with a real part that is not negative.
inline ComplexPair sqrt(const ComplexPair& z) {
  const EigenPair x = z.real();
  const EigenPair y = z.imag();
  if (x == 0.0) {
    const EigenPair part = sqrt(abs(y) / 2.0);
    return {part, y < 0.0 ? -part : part};
  }
  const EigenPair twice = sqrt(2.0 * (abs(z) + abs(x)));
  const EigenPair half = twice / 2.0;
  if (x > 0.0) return {half, y / twice};
  return {abs(y) / twice, y < 0.0 ? -half : half};
}

}  // namespace stationary

/// epsilon: what a few of its operations may be off by.
template <>
class std::numeric_limits<stationary::EigenPair> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr bool has_infinity = true;
  static constexpr int radix = 2;
  static constexpr int digits = 100;
  static constexpr int digits10 = 30;
  static stationary::EigenPair epsilon() { return 0x1p-99; }
  static stationary::EigenPair min() { return 0x1p-900; }  // products below it lose their tails
  static stationary::EigenPair max() { return 0x1p990; }
  static stationary::EigenPair lowest() { return -0x1p990; }
  static stationary::EigenPair infinity() { return std::numeric_limits<double>::infinity(); }
  static stationary::EigenPair quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
};

template <>
struct Eigen::NumTraits<stationary::EigenPair>
    : public Eigen::GenericNumTraits<stationary::EigenPair> {
  enum { RequireInitialization = 0, ReadCost = 2, AddCost = 20, MulCost = 30 };
};
