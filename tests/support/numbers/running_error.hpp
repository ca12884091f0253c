// A double that carries a bound of its own rounding error (running error analysis: Wilkinson;
// Higham, Accuracy and Stability of Numerical Algorithms, section 3.3):
//
//   |value - exact| <= bound 2^-53  to first order,  each operation adding |result| to what it
//   inherits from its operands.
//
// So "a few eps relative to the terms" needs no list of terms: the bound is their sum, made by the
// same source the double is. Inputs are exact.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace stationary::support {

struct BoundedDouble {
  double value = 0.0;
  double bound = 0.0;

  BoundedDouble() = default;
  BoundedDouble(double x) : value(x) {}  // NOLINT(google-explicit-constructor)
  BoundedDouble(double x, double inherited) : value(x), bound(inherited + std::abs(x)) {}
};

inline double leading(const BoundedDouble& x) { return x.value; }

inline BoundedDouble operator-(const BoundedDouble& x) {
  BoundedDouble out = x;
  out.value = -x.value;
  return out;
}
inline BoundedDouble operator+(const BoundedDouble& x, const BoundedDouble& y) {
  return {x.value + y.value, x.bound + y.bound};
}
inline BoundedDouble operator-(const BoundedDouble& x, const BoundedDouble& y) {
  return {x.value - y.value, x.bound + y.bound};
}
inline BoundedDouble operator*(const BoundedDouble& x, const BoundedDouble& y) {
  return {x.value * y.value, std::abs(x.value) * y.bound + std::abs(y.value) * x.bound};
}
inline BoundedDouble operator/(const BoundedDouble& x, const BoundedDouble& y) {
  const double quotient = x.value / y.value;
  return {quotient, (x.bound + std::abs(quotient) * y.bound) / std::abs(y.value)};
}
inline BoundedDouble& operator+=(BoundedDouble& x, const BoundedDouble& y) { return x = x + y; }
inline BoundedDouble& operator-=(BoundedDouble& x, const BoundedDouble& y) { return x = x - y; }
inline BoundedDouble& operator*=(BoundedDouble& x, const BoundedDouble& y) { return x = x * y; }
inline bool operator==(const BoundedDouble& x, const BoundedDouble& y) {
  return x.value == y.value;
}
inline bool operator<(const BoundedDouble& x, const BoundedDouble& y) { return x.value < y.value; }
inline BoundedDouble sqrt(const BoundedDouble& x) {
  const double root = std::sqrt(x.value);
  return {root, x.value == 0.0 ? 0.0 : x.bound / (2.0 * root)};
}
/// The library's logarithm is good to one unit in the last place, two halves of one.
inline BoundedDouble log(const BoundedDouble& x) {
  const double logarithm = std::log(x.value);
  return {logarithm, x.bound / std::abs(x.value) + std::abs(logarithm)};
}

}  // namespace stationary::support

template <>
class std::numeric_limits<stationary::support::BoundedDouble> : public std::numeric_limits<double> {
};
