// Taylor number: a function of one parameter s, cut after order n,
//
//   f(s) = f_0 + f_1 s + ... + f_n s^n,   f^(k)(0) = k! f_k,
//
// carried through + - * / and the elementary functions. Over intervals every coefficient is an
// enclosure. Products drop what is of higher order; the others follow order by order from their
// differential equation, k f_k = sum_j j x_j (...)_(k-j).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "lib/number/number.hpp"

namespace stationary {

template <class T, int order>
struct Taylor {
  T value = T(0.0);  ///< f_0
  std::array<T, static_cast<std::size_t>(order)> higher{};

  Taylor() = default;
  Taylor(double x) : value(x) {}  // NOLINT(google-explicit-constructor)
  Taylor(const T& x)              // NOLINT(google-explicit-constructor)
      requires(!std::is_same_v<T, double>)
      : value(x) {}
  /// x + slope s.
  static Taylor along(const T& x, const T& slope) {
    Taylor out(x);
    out[1] = slope;
    return out;
  }

  const T& operator[](int k) const {
    return k == 0 ? value : higher[static_cast<std::size_t>(k - 1)];
  }
  T& operator[](int k) { return k == 0 ? value : higher[static_cast<std::size_t>(k - 1)]; }
  /// f^(k)(0).
  T derivative(int k) const {
    double factorial = 1.0;
    for (int j = 2; j <= k; ++j) factorial *= j;
    return factorial * (*this)[k];
  }

  friend Taylor operator+(const Taylor& x, const Taylor& y) {
    return each([&](int k) { return x[k] + y[k]; });
  }
  friend Taylor operator-(const Taylor& x) {
    return each([&](int k) { return -x[k]; });
  }
  friend Taylor operator-(const Taylor& x, const Taylor& y) {
    return each([&](int k) { return x[k] - y[k]; });
  }
  friend Taylor operator*(double a, const Taylor& x) {
    return each([&](int k) { return a * x[k]; });
  }
  friend Taylor operator*(const Taylor& x, const Taylor& y) {
    return each([&](int k) { return product(x, y, k); });
  }
  friend Taylor operator/(const Taylor& x, const Taylor& y) {
    const T inverse = T(1.0) / y.value;
    Taylor out;
    for (int k = 0; k <= order; ++k) {
      T rest = x[k];
      for (int j = 1; j <= k; ++j) rest -= y[j] * out[k - j];
      out[k] = rest * inverse;
    }
    return out;
  }
  friend Taylor& operator+=(Taylor& x, const Taylor& y) { return x = x + y; }
  friend Taylor& operator-=(Taylor& x, const Taylor& y) { return x = x - y; }

  friend Taylor square(const Taylor& x) {
    Taylor out = x * x;
    out.value = square(x.value);
    return out;
  }
  friend Taylor sqrt(const Taylor& x) {
    using std::sqrt;
    Taylor out(sqrt(x.value));
    const T half = T(0.5) / out.value;
    for (int k = 1; k <= order; ++k) {
      T rest = x[k];
      for (int j = 1; j < k; ++j) rest -= out[j] * out[k - j];
      out[k] = half * rest;
    }
    return out;
  }
  friend Taylor exp(const Taylor& x) {
    return integrated(exp(x.value), x, [](const Taylor& f) { return f; });
  }
  friend Taylor log(const Taylor& x) {
    return integrated(log(x.value), x, [&](const Taylor&) { return Taylor(1.0) / x; });
  }
  friend Taylor sin(const Taylor& x) { return sine_and_cosine(x)[0]; }
  friend Taylor cos(const Taylor& x) { return sine_and_cosine(x)[1]; }
  friend Taylor tan(const Taylor& x) {
    return integrated(tan(x.value), x, [](const Taylor& f) { return Taylor(1.0) + square(f); });
  }
  friend Taylor tanh(const Taylor& x) {
    return integrated(tanh(x.value), x, [](const Taylor& f) { return Taylor(1.0) - square(f); });
  }
  friend Taylor atan(const Taylor& x) {
    return integrated(atan(x.value), x,
                      [&](const Taylor&) { return Taylor(1.0) / (Taylor(1.0) + square(x)); });
  }
  /// x^p for x > 0.
  friend Taylor pow(const Taylor& x, const Taylor& p) {
    const Taylor exponent = p * log(x);
    return integrated(pow(x.value, p.value), exponent, [](const Taylor& f) { return f; });
  }

 private:
  template <class Coefficient>
  static Taylor each(const Coefficient& coefficient) {
    Taylor out;
    for (int k = 0; k <= order; ++k) out[k] = coefficient(k);
    return out;
  }
  static T product(const Taylor& x, const Taylor& y, int k) {
    T out = x.value * y[k];
    for (int j = 1; j <= k; ++j) out += x[j] * y[k - j];
    return out;
  }
  /// f with f' = slope(f) x': slope's coefficients below k need those of f below k alone.
  template <class Slope>
  static Taylor integrated(const T& first, const Taylor& x, const Slope& slope) {
    Taylor out(first);
    for (int k = 1; k <= order; ++k) {
      const Taylor rate = slope(out);
      T sum(0.0);
      for (int j = 1; j <= k; ++j) sum += static_cast<double>(j) * (x[j] * rate[k - j]);
      out[k] = sum / T(static_cast<double>(k));
    }
    return out;
  }
  static std::array<Taylor, 2> sine_and_cosine(const Taylor& x) {
    std::array<Taylor, 2> out{Taylor(sin(x.value)), Taylor(cos(x.value))};
    for (int k = 1; k <= order; ++k) {
      T sine(0.0);
      T cosine(0.0);
      for (int j = 1; j <= k; ++j) {
        const T slope = static_cast<double>(j) * x[j];
        sine += slope * out[1][k - j];
        cosine -= slope * out[0][k - j];
      }
      out[0][k] = sine / T(static_cast<double>(k));
      out[1][k] = cosine / T(static_cast<double>(k));
    }
    return out;
  }
};

template <class T, int order>
double leading(const Taylor<T, order>& x) {
  return leading(x.value);
}

}  // namespace stationary

template <class T, int order>
class std::numeric_limits<stationary::Taylor<T, order>> : public std::numeric_limits<double> {};
