// What the templates of this library ask of a number type beyond + - * / and log, sqrt found by
// argument-dependent lookup: its leading double (to choose between formulas, never to compute with)
// and its precision. Serves double, DoubleDouble, ceres::Jet and Boost.Multiprecision numbers; any
// other type is served by overloading leading() in its own namespace.
#pragma once

#include <limits>
#include <type_traits>
#include <utility>

#include "lib/number/double_double.hpp"

namespace stationary {

constexpr double leading(double x) { return x; }
constexpr double leading(const DoubleDouble& x) { return x.hi + x.lo; }

/// Numbers that carry derivatives (dual numbers): the value's leading double.
template <class T>
requires requires(const T& x) {
  x.a;
  x.v;
}
double leading(const T& x) { return leading(x.a); }

/// Multiprecision numbers.
template <class T>
requires requires(const T& x) { x.template convert_to<double>(); }
double leading(const T& x) { return x.template convert_to<double>(); }

/// Only pairs need it (double_double.hpp); any other number is itself.
template <class T>
constexpr const T& renormalized(const T& x) {
  return x;
}

/// x^2; an interval's is never negative (interval.hpp).
template <class T>
constexpr T square(const T& x) {
  return x * x;
}

/// The type of a coefficient times a state: the coefficient may be the wider one (a derivative in
/// it).
template <class C, class S>
using Product = std::remove_cvref_t<decltype(std::declval<C>() * std::declval<S>())>;

/// Significand bits of T (53 for double); a decimal type counts in digits, of at most 10/3 bits.
template <class T>
constexpr int significand_bits() {
  using Limits = std::numeric_limits<T>;
  static_assert(Limits::is_specialized && (Limits::radix == 2 || Limits::radix == 10));
  return Limits::radix == 2 ? Limits::digits : Limits::digits * 10 / 3 + 1;
}

/// What an output that was not asked for holds.
template <class T>
T poison() {
  return T(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace stationary
