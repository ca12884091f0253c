// Value, gradient and Hessian in (alpha, xi, zeta, rho), for the tester's own evaluation of
// formulas: independent of the library's derivatives, in any number type.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace stationary::stress {

template <class T>
struct Jet {
  T value{0};
  std::array<T, 4> slope{};
  std::array<std::array<T, 4>, 4> curvature{};

  Jet() { clear(); }
  Jet(const T& constant) : value(constant) { clear(); }
  static Jet variable(const T& at, std::size_t which) {
    Jet out(at);
    out.slope[which] = T(1);
    return out;
  }

  /// f(x) by f, f' and f'' at x.
  Jet through(const T& f, const T& first, const T& second) const {
    Jet out(f);
    for (std::size_t i = 0; i < 4; ++i) {
      out.slope[i] = first * slope[i];
      for (std::size_t j = 0; j < 4; ++j)
        out.curvature[i][j] = first * curvature[i][j] + second * slope[i] * slope[j];
    }
    return out;
  }

  friend Jet operator+(const Jet& x, const Jet& y) { return combined(x, T(1), y); }
  friend Jet operator-(const Jet& x, const Jet& y) { return combined(x, T(-1), y); }
  friend Jet operator*(const Jet& x, const Jet& y) {
    Jet out(x.value * y.value);
    for (std::size_t i = 0; i < 4; ++i) {
      out.slope[i] = x.slope[i] * y.value + x.value * y.slope[i];
      for (std::size_t j = 0; j < 4; ++j)
        out.curvature[i][j] = x.curvature[i][j] * y.value + x.slope[i] * y.slope[j] +
                              x.slope[j] * y.slope[i] + x.value * y.curvature[i][j];
    }
    return out;
  }

 private:
  static Jet combined(const Jet& x, const T& sign, const Jet& y) {
    Jet out(x.value + sign * y.value);
    for (std::size_t i = 0; i < 4; ++i) {
      out.slope[i] = x.slope[i] + sign * y.slope[i];
      for (std::size_t j = 0; j < 4; ++j)
        out.curvature[i][j] = x.curvature[i][j] + sign * y.curvature[i][j];
    }
    return out;
  }
  void clear() {
    for (std::size_t i = 0; i < 4; ++i) {
      slope[i] = T(0);
      for (std::size_t j = 0; j < 4; ++j) curvature[i][j] = T(0);
    }
  }
};

}  // namespace stationary::stress
