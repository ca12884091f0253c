// A number with its conditioning: the first-order bound of what a relative perturbation u of every
// input does to it,
//
//   |change| <= u . condition + O(u^2),
//
// carried through + - * / sqrt log by the triangle inequality. The templates of this library,
// evaluated in it, say how far each coefficient of a characteristic polynomial can be trusted,
// cancellation included, for inputs (and rounding errors) of relative size u.
// A double multiplied in counts as an input too (a material coefficient); one added does not (1, 2,
// ...).
#pragma once

#include <cmath>
#include <limits>

#include "lib/number/number.hpp"

namespace stationary {

struct Conditioned {
  double value = 0.0;
  double condition = 0.0;

  constexpr Conditioned() = default;
  constexpr Conditioned(double exact) : value(exact) {}  // NOLINT(google-explicit-constructor)
  constexpr Conditioned(double x, double c) : value(x), condition(c) {}

  /// An input: perturbed by u |x|.
  static Conditioned input(double x) { return {x, std::abs(x)}; }
};

inline Conditioned operator-(const Conditioned& x) { return {-x.value, x.condition}; }
inline Conditioned operator+(const Conditioned& x, const Conditioned& y) {
  return {x.value + y.value, x.condition + y.condition};
}
inline Conditioned operator-(const Conditioned& x, const Conditioned& y) { return x + (-y); }
inline Conditioned operator*(const Conditioned& x, const Conditioned& y) {
  return {x.value * y.value, std::abs(x.value) * y.condition + std::abs(y.value) * x.condition};
}
inline Conditioned operator/(const Conditioned& x, const Conditioned& y) {
  const double q = x.value / y.value;
  return {q, (x.condition + std::abs(q) * y.condition) / std::abs(y.value)};
}
inline Conditioned operator*(double c, const Conditioned& x) { return Conditioned::input(c) * x; }
inline Conditioned operator*(const Conditioned& x, double c) { return c * x; }
inline Conditioned operator/(const Conditioned& x, double c) { return x / Conditioned::input(c); }
inline Conditioned operator/(double c, const Conditioned& x) { return Conditioned::input(c) / x; }
inline Conditioned& operator+=(Conditioned& x, const Conditioned& y) { return x = x + y; }
inline Conditioned& operator-=(Conditioned& x, const Conditioned& y) { return x = x - y; }

inline Conditioned log(const Conditioned& x) {
  return {log(x.value), x.condition / std::abs(x.value)};
}
inline Conditioned sqrt(const Conditioned& x) {
  const double root = std::sqrt(x.value);
  return {root, root > 0.0 ? 0.5 * x.condition / root : 0.0};
}

constexpr double leading(const Conditioned& x) { return x.value; }

/// e from e = b + kappa e^2: the linear bound b made to hold where curvature matters. Beyond the
/// smaller root's existence (4 kappa b > 1: a fold within the bound) the distance to the fold.
inline double with_curvature(double b, double kappa) {
  const double discriminant = 1.0 - 4.0 * kappa * b;
  return discriminant > 0.0 ? 2.0 * b / (1.0 + std::sqrt(discriminant))
                            : 0.5 / kappa + std::sqrt(b / kappa);
}

}  // namespace stationary

template <>
class std::numeric_limits<stationary::Conditioned> : public std::numeric_limits<double> {};
