// First-order dual number with N directions: value + slope . eps, over doubles (the sensitivity of
// a residual to a model's coefficients) or intervals (a proof that needs the slopes of a function
// over a box). ceres::Jet would do for doubles; this keeps Ceres out of solver headers that users
// include.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "lib/number/number.hpp"

namespace stationary {

template <class T, std::size_t N>
struct Dual {
  T value = T(0.0);
  std::array<T, N> slope{};

  Dual() = default;
  Dual(double x) : value(x) {}  // NOLINT(google-explicit-constructor)
  Dual(const T& x)              // NOLINT(google-explicit-constructor)
      requires(!std::is_same_v<T, double>)
      : value(x) {}
  Dual(const T& x, const std::array<T, N>& s) : value(x), slope(s) {}

  /// x, of this slope in direction k.
  static Dual along(const T& x, const T& slope, std::size_t k) {
    Dual out(x);
    out.slope[k] = slope;
    return out;
  }
  /// The unknown x = e^y in direction k: dx/dy = x.
  static Dual logarithmic(const T& x, std::size_t k) { return along(x, x, k); }

  friend Dual operator+(const Dual& x, const Dual& y) { return apply<&plus>(x, y); }
  friend Dual operator-(const Dual& x) {
    return of(-x.value, [&](std::size_t k) { return -x.slope[k]; });
  }
  friend Dual operator-(const Dual& x, const Dual& y) { return apply<&minus>(x, y); }
  friend Dual operator*(const Dual& x, const Dual& y) { return apply<&times>(x, y); }
  friend Dual operator*(double a, const Dual& x) {
    return of(a * x.value, [&](std::size_t k) { return a * x.slope[k]; });
  }
  friend Dual operator/(const Dual& x, const Dual& y) { return apply<&over>(x, y); }
  friend Dual& operator+=(Dual& x, const Dual& y) { return x = x + y; }
  friend Dual& operator-=(Dual& x, const Dual& y) { return x = x - y; }
  friend Dual log(const Dual& x) {
    const T inverse = T(1.0) / x.value;
    return of(log(x.value), [&](std::size_t k) { return x.slope[k] * inverse; });
  }
  friend Dual sqrt(const Dual& x) {
    using std::sqrt;
    const T root = sqrt(x.value);
    const T slope = T(0.5) / root;
    return of(root, [&](std::size_t k) { return moved(slope, x.slope[k]); });
  }
  friend Dual exp(const Dual& x) {
    const T value = exp(x.value);
    return chain(x, value, value);
  }
  friend Dual sin(const Dual& x) { return chain(x, sin(x.value), cos(x.value)); }
  friend Dual cos(const Dual& x) { return chain(x, cos(x.value), -sin(x.value)); }
  friend Dual tan(const Dual& x) {
    const T value = tan(x.value);
    return chain(x, value, T(1.0) + square(value));
  }
  friend Dual tanh(const Dual& x) {
    const T value = tanh(x.value);
    return chain(x, value, T(1.0) - square(value));
  }
  friend Dual atan(const Dual& x) {
    return chain(x, atan(x.value), T(1.0) / (T(1.0) + square(x.value)));
  }
  /// x^p for x > 0, and where x does not move for any x that has a value.
  friend Dual pow(const Dual& x, const Dual& p) {
    const T value = pow(x.value, p.value);
    const T of_base = p.value * value / x.value;
    const T of_exponent = is_none(x.value) ? T(0.0) : value * log(size(x.value));
    return of(value, [&](std::size_t k) {
      return moved(of_base, x.slope[k]) + moved(of_exponent, p.slope[k]);
    });
  }
  friend bool operator>(const Dual& x, double y) requires std::is_same_v<T, double> {
    return x.value > y;
  }

 private:
  static bool is_none(const T& x) {
    if constexpr (requires { x.lo; }) {
      return x.lo == 0.0 && x.hi == 0.0;
    } else {
      return x == T(0.0);
    }
  }
  /// Of a negative number to a whole power.
  static T size(const T& x) {
    if constexpr (std::is_same_v<T, double>) {
      return std::abs(x);
    } else {
      return x;
    }
  }
  /// slope times x; 0 where x is, whatever the slope.
  static T moved(const T& slope, const T& x) { return is_none(x) ? T(0.0) : slope * x; }
  static Dual plus(const Dual& x, const Dual& y) {
    return of(x.value + y.value, [&](std::size_t k) { return x.slope[k] + y.slope[k]; });
  }
  static Dual minus(const Dual& x, const Dual& y) {
    return of(x.value - y.value, [&](std::size_t k) { return x.slope[k] - y.slope[k]; });
  }
  static Dual times(const Dual& x, const Dual& y) {
    return of(x.value * y.value,
              [&](std::size_t k) { return x.slope[k] * y.value + x.value * y.slope[k]; });
  }
  static Dual over(const Dual& x, const Dual& y) {
    const T inverse = T(1.0) / y.value;
    const T q = x.value * inverse;
    return of(q, [&](std::size_t k) { return (x.slope[k] - q * y.slope[k]) * inverse; });
  }
  /// Many slopes of intervals are called, not inlined: their code is long, and compilers take their
  /// time over it.
  static constexpr bool called = N > 2 && !std::is_same_v<T, double>;
  template <auto operation>
  [[gnu::noinline]] static Dual call(const Dual& x, const Dual& y) {
    return operation(x, y);
  }
  template <auto operation>
  static Dual apply(const Dual& x, const Dual& y) {
    if constexpr (called) {
      return call<operation>(x, y);
    } else {
      return operation(x, y);
    }
  }
  /// f(x) from f and f' at its value.
  static Dual chain(const Dual& x, const T& f, const T& slope) {
    return of(f, [&](std::size_t k) { return slope * x.slope[k]; });
  }
  template <class Slope>
  static Dual of(const T& value, const Slope& slope) {
    Dual out(value);
    for (std::size_t k = 0; k < N; ++k) out.slope[k] = slope(k);
    return out;
  }
};

using Dual2 = Dual<double, 2>;

template <class T, std::size_t N>
double leading(const Dual<T, N>& x) {
  return leading(x.value);
}

}  // namespace stationary

template <class T, std::size_t N>
class std::numeric_limits<stationary::Dual<T, N>> : public std::numeric_limits<double> {};
