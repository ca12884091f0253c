// Elementary functions of a number with its conditioning (first_order_bound.hpp) beyond sqrt and
// log:
//
//   f(x): condition |f'(x)| c,   x^p: condition |x^p| (|p|/|x| c_x + |log x| c_p).
#pragma once

#include <cmath>

#include "lib/number/first_order_bound.hpp"

namespace stationary {

inline Conditioned exp(const Conditioned& x) {
  const double value = exp(x.value);
  return {value, value * x.condition};
}
inline Conditioned sin(const Conditioned& x) {
  return {sin(x.value), std::abs(cos(x.value)) * x.condition};
}
inline Conditioned cos(const Conditioned& x) {
  return {cos(x.value), std::abs(sin(x.value)) * x.condition};
}
inline Conditioned tan(const Conditioned& x) {
  const double value = tan(x.value);
  return {value, (1.0 + value * value) * x.condition};
}
inline Conditioned tanh(const Conditioned& x) {
  const double e = exp(-2.0 * std::abs(x.value));  // 1 - tanh^2 = 4 e/(1 + e)^2
  return {tanh(x.value), 4.0 * e / ((1.0 + e) * (1.0 + e)) * x.condition};
}
inline Conditioned atan(const Conditioned& x) {
  return {atan(x.value), x.condition / (1.0 + x.value * x.value)};
}
inline Conditioned pow(const Conditioned& x, const Conditioned& p) {
  const double value = pow(x.value, p.value);
  // 0^p, of which nothing moves.
  if (value == 0.0 && x.condition == 0.0) return {value, 0.0};
  const double of_base = x.condition == 0.0 ? 0.0 : std::abs(p.value / x.value) * x.condition;
  // Of a negative number to a whole one its size.
  const double of_exponent =
      p.condition == 0.0 ? 0.0 : std::abs(log(std::abs(x.value))) * p.condition;
  return {value, std::abs(value) * (of_base + of_exponent)};
}

}  // namespace stationary
