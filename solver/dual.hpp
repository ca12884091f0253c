// First-order dual number with two directions: x + slope . eps, for the sensitivity of a residual
// to a model's two coefficients. ceres::Jet would do as well; this keeps Ceres out of solver
// headers that users include.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "lib/number.hpp"

namespace stationary {

struct Dual2 {
  double value = 0.0;
  std::array<double, 2> slope{0.0, 0.0};

  Dual2() = default;
  Dual2(double x) : value(x) {}  // NOLINT(google-explicit-constructor)
  Dual2(double x, std::array<double, 2> s) : value(x), slope(s) {}

  friend Dual2 operator+(const Dual2& x, const Dual2& y) {
    return {x.value + y.value, {x.slope[0] + y.slope[0], x.slope[1] + y.slope[1]}};
  }
  friend Dual2 operator-(const Dual2& x) { return {-x.value, {-x.slope[0], -x.slope[1]}}; }
  friend Dual2 operator-(const Dual2& x, const Dual2& y) { return x + (-y); }
  friend Dual2 operator*(const Dual2& x, const Dual2& y) {
    return {
        x.value * y.value,
        {x.slope[0] * y.value + x.value * y.slope[0], x.slope[1] * y.value + x.value * y.slope[1]}};
  }
  friend Dual2 operator/(const Dual2& x, const Dual2& y) {
    const double inverse = 1.0 / y.value;
    const double q = x.value * inverse;
    return {q, {(x.slope[0] - q * y.slope[0]) * inverse, (x.slope[1] - q * y.slope[1]) * inverse}};
  }
  friend bool operator>(const Dual2& x, double y) { return x.value > y; }
};

inline double leading(const Dual2& x) { return x.value; }

}  // namespace stationary

template <>
class std::numeric_limits<stationary::Dual2> : public std::numeric_limits<double> {};
