// A double whose exact products are had by a fused multiply-add, for files that are compiled for
// processors with that instruction: Pair<Fused> rounds as DoubleDouble does, to the bit, and takes 2
// operations a product instead of 17,
//
//   two_product(a, b) = (fl(a b), fma(a, b, -fl(a b))).
//
// As with packs, the name of the type is in every name built from it, so that the linker cannot take
// code of such a file for another's.
#pragma once

#include <limits>

#include "lib/number/number.hpp"

namespace stationary {

struct Fused {
  double value;

  constexpr Fused() : value(0.0) {}
  [[gnu::always_inline]] constexpr Fused(double x)  // NOLINT(google-explicit-constructor)
      : value(x) {}
  [[gnu::always_inline]] constexpr explicit operator double() const { return value; }

  [[gnu::always_inline]] friend constexpr Fused operator+(Fused x, Fused y) {
    return x.value + y.value;
  }
  [[gnu::always_inline]] friend constexpr Fused operator-(Fused x, Fused y) {
    return x.value - y.value;
  }
  [[gnu::always_inline]] friend constexpr Fused operator*(Fused x, Fused y) {
    return x.value * y.value;
  }
  [[gnu::always_inline]] friend constexpr Fused operator/(Fused x, Fused y) {
    return x.value / y.value;
  }
  [[gnu::always_inline]] friend constexpr Fused operator-(Fused x) { return -x.value; }
};
using FusedPair = Pair<Fused>;

template <>
inline constexpr bool is_scalar<Fused> = true;

[[gnu::always_inline]] inline FusedPair two_product(Fused a, Fused b) {
  const double p = a.value * b.value;
  return {p, __builtin_fma(a.value, b.value, -p)};
}

[[gnu::always_inline]] constexpr double leading(const FusedPair& x) {
  return x.hi.value + x.lo.value;
}

}  // namespace stationary

template <>
class std::numeric_limits<stationary::FusedPair>
    : public std::numeric_limits<stationary::DoubleDouble> {};
