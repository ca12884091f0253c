// Extended precision: x = hi + lo with |lo| of a few ulp(hi) at most, about 104 significand bits.
//
//   two_sum(a, b)     = (fl(a + b), the exact rounding error)     6 flops
//   two_product(a, b) = (fl(a b),   the exact rounding error)     2 flops with a fused multiply-add
//
// Pair arithmetic: results are not renormalized, which halves the latency of a sum; |lo| grows
// slowly with the number of operations, so this serves short expressions such as ours: the residual
// of the last correction of a solve, where a double residual would leave errors of several units in
// the last place, and far more near a fold. double(x) = hi + lo is the rounded value; hi alone is
// not.
//
// Error of each operation on normalized operands (|lo| <= ulp(hi)/2), relative to their magnitudes
// (so a sum may cancel):
//   x + y: 2^-104 (|x| + |y|);  x y, x / y, sqrt x: 2^-101 of the result;  log x: 2^-82 |log x|.
// Source: M. Lange, S. M. Rump, ACM Trans. Math. Softw. 46 (2020) 21; T. J. Dekker, Numer. Math. 18
// (1971) 224. Must be compiled without contraction (-ffp-contract=off) and without -ffast-math: the
// exported targets carry the flag.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "lib/number/double_double_log_table.hpp"
#include "lib/number/elementary.hpp"

/// Part of its caller, however large that grows; where code is to be small before fast, as in a page,
/// the compiler decides. The numbers are the same.
#ifdef STATIONARY_SMALL_CODE
#define STATIONARY_INLINED
#else
#define STATIONARY_INLINED [[gnu::always_inline]]
#endif

namespace stationary {

template <class Real>
struct Pair;
using DoubleDouble = Pair<double>;

/// (fl(a + b), error), exact for all finite a, b without overflow.
template <class Real>
STATIONARY_INLINED constexpr Pair<Real> two_sum(const Real& a, const Real& b);

/// As two_sum, for |a| >= |b| or a = 0.
template <class Real>
STATIONARY_INLINED constexpr Pair<Real> quick_two_sum(const Real& a, const Real& b);

/// (fl(a b), error), exact for |a|, |b| < 2^996 and |a b| >= 2^-968 or = 0, unless it overflows.
STATIONARY_INLINED constexpr DoubleDouble two_product(double a, double b);

/// Whether Real is one number (double, Fused of fused.hpp) and no pack of them.
template <class Real>
inline constexpr bool is_scalar = std::is_same_v<Real, double>;

/// In any type whose numbers round like doubles: double itself, Fused, and packs of them
/// (simd_pack.hpp).
template <class Real>
struct Pair {
  Real hi{0.0};
  Real lo{0.0};

  constexpr Pair() = default;
  constexpr Pair(double x) : hi(x) {}  // NOLINT(google-explicit-constructor)
  constexpr Pair(const Real& x)        // NOLINT(google-explicit-constructor)
      requires(!std::is_same_v<Real, double>)
      : hi(x) {}
  constexpr Pair(const Real& head, const Real& tail) : hi(head), lo(tail) {}
  constexpr explicit operator Real() const { return hi + lo; }

  STATIONARY_INLINED friend constexpr Pair operator-(const Pair& x) { return {-x.hi, -x.lo}; }

  STATIONARY_INLINED friend constexpr Pair operator+(const Pair& x, const Pair& y) {
    const Pair s = two_sum(x.hi, y.hi);
    return {s.hi, s.lo + (x.lo + y.lo)};
  }
  STATIONARY_INLINED friend constexpr Pair operator+(const Pair& x, double y) {
    const Pair s = two_sum(x.hi, Real(y));
    return {s.hi, s.lo + x.lo};
  }
  STATIONARY_INLINED friend constexpr Pair operator+(double x, const Pair& y) { return y + x; }
  STATIONARY_INLINED friend constexpr Pair operator-(const Pair& x, const Pair& y) {
    return x + (-y);
  }
  STATIONARY_INLINED friend constexpr Pair operator-(const Pair& x, double y) { return x + (-y); }
  STATIONARY_INLINED friend constexpr Pair operator-(double x, const Pair& y) { return (-y) + x; }

  STATIONARY_INLINED friend constexpr Pair operator*(const Pair& x, const Pair& y) {
    const Pair p = two_product(x.hi, y.hi);
    return {p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi)};
  }
  STATIONARY_INLINED friend constexpr Pair operator*(const Pair& x, double y) {
    const Pair p = two_product(x.hi, Real(y));
    return {p.hi, p.lo + x.lo * y};
  }
  STATIONARY_INLINED friend constexpr Pair operator*(double x, const Pair& y) { return y * x; }

  /// The quotient of the heads, and its exact remainder over the whole divisor. Of packs by one
  /// division, which they wait for: the head, off by an ulp then, leaves a larger remainder.
  STATIONARY_INLINED friend constexpr Pair operator/(const Pair& x, const Pair& y) {
    constexpr bool one_division = !is_scalar<Real>;
    const Real inverse = one_division ? 1.0 / y.hi : Real(0.0);
    const Real q = one_division ? x.hi * inverse : x.hi / y.hi;
    const Pair p = two_product(q, y.hi);
    const Real remainder = ((x.hi - p.hi) - p.lo) + x.lo - q * y.lo;
    return {q, one_division ? remainder * inverse : remainder / (y.hi + y.lo)};
  }
  STATIONARY_INLINED friend constexpr Pair operator/(const Pair& x, double y) {
    return x / Pair(y);
  }
  STATIONARY_INLINED friend constexpr Pair operator/(double x, const Pair& y) {
    return Pair(x) / y;
  }
};

template <class Real>
STATIONARY_INLINED constexpr Pair<Real> two_sum(const Real& a, const Real& b) {
  const Real s = a + b;
  const Real bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

template <class Real>
STATIONARY_INLINED constexpr Pair<Real> quick_two_sum(const Real& a, const Real& b) {
  const Real s = a + b;
  return {s, b - (s - a)};
}

/// two_product without a fused multiply-add: the same pair.
template <class Real>
STATIONARY_INLINED constexpr Pair<Real> split_product(const Real& a, const Real& b) {
  const Real p = a * b;
  constexpr double split = 134217729.0;  // 2^27 + 1 (Dekker, Veltkamp)
  const Real ca = split * a;
  const Real a1 = ca - (ca - a);
  const Real a2 = a - a1;
  const Real cb = split * b;
  const Real b1 = cb - (cb - b);
  const Real b2 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

STATIONARY_INLINED constexpr DoubleDouble two_product(double a, double b) {
#ifdef __FMA__
  if (!std::is_constant_evaluated()) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }
#endif
  return split_product(a, b);
}

STATIONARY_INLINED inline DoubleDouble& operator+=(DoubleDouble& x, const DoubleDouble& y) {
  return x = x + y;
}
STATIONARY_INLINED inline DoubleDouble& operator-=(DoubleDouble& x, const DoubleDouble& y) {
  return x = x - y;
}
STATIONARY_INLINED inline DoubleDouble& operator*=(DoubleDouble& x, const DoubleDouble& y) {
  return x = x * y;
}
STATIONARY_INLINED inline DoubleDouble& operator/=(DoubleDouble& x, const DoubleDouble& y) {
  return x = x / y;
}

STATIONARY_INLINED constexpr bool operator==(const DoubleDouble& x, const DoubleDouble& y) {
  return double(x - y) == 0.0;
}
STATIONARY_INLINED constexpr bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
  return double(x - y) < 0.0;
}
STATIONARY_INLINED constexpr bool operator>(const DoubleDouble& x, const DoubleDouble& y) {
  return y < x;
}

STATIONARY_INLINED inline DoubleDouble abs(const DoubleDouble& x) {
  return double(x) < 0.0 ? -x : x;
}

/// The same number with |lo| <= ulp(hi)/2: needed where a sum may have cancelled its heads.
template <class Real>
requires is_scalar<Real> STATIONARY_INLINED constexpr Pair<Real> renormalized(const Pair<Real>& x) {
  return two_sum(x.hi, x.lo);
}

/// Square root of x >= 0 (NaN below).
template <class Real>
requires is_scalar<Real> STATIONARY_INLINED inline Pair<Real> sqrt(const Pair<Real>& y) {
  const Pair<Real> x = renormalized(y);
  if (double(x.hi) == 0.0) return {};
  const Real r = std::sqrt(double(x.hi));
  const Pair<Real> square = two_product(r, r);
  return {r, (((x.hi - square.hi) - square.lo) + x.lo) / (2.0 * r)};
}

inline constexpr DoubleDouble double_double_log_two{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// Natural logarithm of x > 0 (NaN below, -inf at 0): x = 2^k m, m r_i = 1 + z with r_i from a
/// table of 128 reciprocals, |z| < 2^-7; log x = k log 2 - log r_i + log(1 + z). In double
/// precision where x is subnormal or at least 2^1022, whose 2^-k is no normal number.
template <class Real>
requires is_scalar<Real>
[[gnu::pure]] inline Pair<Real> log(const Pair<Real>& x) {
  constexpr std::uint64_t first_interval = 0x3fe6000000000000;  // 0.6875, so that 1 needs no table
  const double head(x.hi);
  if (!(head >= std::numeric_limits<double>::min()) || !(head < 0x1p1022)) {
    return Real(log(head));  // also zero, negative, infinite, NaN
  }
  const auto bits = std::bit_cast<std::uint64_t>(head);
  const std::uint64_t offset = bits - first_interval;
  const auto exponent = static_cast<int>(static_cast<std::int64_t>(offset) >> 52);
  const LogRow& coarse = coarse_rows[(offset >> 45) & 127];
  const double m = std::bit_cast<double>(bits - (offset & 0xfff0000000000000));
  const Real m_tail =
      x.lo * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);

  // m r1 = 1 + z1, |z1| < 2^-7; then (1 + z1) r2 = 1 + z, |z| < 2^-14.9.
  const Pair<Real> p1 = two_product(Real(m), Real(coarse.reciprocal));
  const Real p1_tail = p1.lo + m_tail * coarse.reciprocal;
  // Adding 1.5 * 2^52 leaves the nearest integer in the low bits.
  const auto j = std::bit_cast<std::uint64_t>((double(p1.hi) - 1.0) * 0x1p14 + (0x1.8p52 + 128.0));
  const LogRow& fine = fine_rows[j & 0x1ff];
  const Pair<Real> p2 = two_product(p1.hi, Real(fine.reciprocal));
  const Pair<Real> z = two_sum(Real(p2.hi - 1.0), Real(p2.lo + p1_tail * fine.reciprocal));

  // log(1 + z) = z - z^2/2 + z^3 (1/3 - z/4 + z^2/5 - z^3/6 + ...): the cube is below 2^-46.
  const double h(z.hi);
  const double cubic = h * h * h * (1.0 / 3.0 - h * (0.25 - h * (0.2 - h * (1.0 / 6.0))));
  const Pair<Real> square = z * z;
  const Pair<Real> logarithm_1p = z + Pair<Real>(-0.5 * square.hi, -0.5 * square.lo) + cubic;
  const Pair<Real> table = Pair<Real>(coarse.head, coarse.tail) + Pair<Real>(fine.head, fine.tail);
  if (exponent == 0) return table + logarithm_1p;
  return Pair<Real>(double_double_log_two.hi, double_double_log_two.lo) *
             static_cast<double>(exponent) +
         (table + logarithm_1p);
}

}  // namespace stationary

template <>
class std::numeric_limits<stationary::DoubleDouble> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr int radix = 2;
  static constexpr int digits = 104;
  static constexpr int digits10 = 31;
  static constexpr int max_digits10 = 33;
  static constexpr stationary::DoubleDouble quiet_NaN() {
    return {std::numeric_limits<double>::quiet_NaN(), 0.0};
  }
  static constexpr stationary::DoubleDouble epsilon() { return {0x1p-103, 0.0}; }
};
