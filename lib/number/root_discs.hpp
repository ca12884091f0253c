// Proven enclosures of the roots of a polynomial whose coefficients are intervals:
//
//   |z - z_i| <= n |p(z_i)| / (|c_n| prod_{j != i} |z_i - z_j|),   i = 1 .. n, z_j any distinct
//
// are discs that together hold all roots, and k of them that touch no other hold exactly k, for
// every polynomial in the intervals. About a real z_i one that touches no other holds a real root.
// Source: B. T. Smith, J. ACM 17 (1970) 661.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <span>

#include "lib/number/interval.hpp"
#include "lib/number/polynomial.hpp"

namespace stationary {

struct ComplexInterval {
  Interval re;
  Interval im;

  Interval modulus() const {
    const Interval sum = square(re) + square(im);
    return sqrt(Interval(std::max(sum.lo, 0.0), sum.hi));  // rounding may have gone below 0
  }
};
inline ComplexInterval operator+(const ComplexInterval& x, const Interval& y) {
  return {x.re + y, x.im};
}
inline ComplexInterval operator-(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.re - y.re, x.im - y.im};
}
inline ComplexInterval operator*(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}

struct RootEnclosure {
  ComplexInterval z;    ///< im is exactly 0 where the root is known to be real
  bool simple = false;  ///< apart from all the others
  bool real() const { return z.im.lo == 0.0 && z.im.hi == 0.0; }
};

/// Approximate roots by the solvers of polynomial.hpp on the middles, no two of a pair equal.
std::array<std::complex<double>, 2> middle_roots(const Polynomial<Interval, 2>& p);
std::array<std::complex<double>, 3> middle_roots(const Polynomial<Interval, 3>& p);
std::array<std::complex<double>, 4> middle_roots(const Polynomial<Interval, 4>& p);
/// By the eigenvalues of the companion matrix.
std::array<std::complex<double>, 5> middle_roots(const Polynomial<Interval, 5>& p);

/// all_real: every polynomial in the intervals is known to have real roots only. Entire where two
/// approximate roots coincide.
template <int D>
std::array<RootEnclosure, D> enclose_roots(const Polynomial<Interval, D>& p, bool all_real) {
  const auto near = middle_roots(p);
  const auto distance = [&near](std::size_t i, std::size_t j) {
    return (ComplexInterval{near[i].real(), near[i].imag()} -
            ComplexInterval{near[j].real(), near[j].imag()})
        .modulus();
  };
  std::array<Interval, D> radius;
  for (std::size_t i = 0; i < D; ++i) {
    const ComplexInterval z{near[i].real(), near[i].imag()};
    ComplexInterval value{p.c[D], 0.0};
    for (std::size_t k = D; k-- > 0;) value = value * z + p.c[k];
    Interval product = p.c[D];
    for (std::size_t j = 0; j < D; ++j)
      if (j != i) product *= distance(i, j);
    const double bound = (static_cast<double>(D) * value.modulus() / product).magnitude();
    radius[i] = {-bound, bound};
  }
  // Each root is somewhere in its component of touching discs.
  std::array<std::size_t, D> component;
  for (std::size_t i = 0; i < D; ++i) component[i] = i;
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (distance(i, j).lo > (radius[i] + radius[j]).hi) continue;
      const std::size_t joined = component[i];
      for (std::size_t& each : component)
        if (each == joined) each = component[j];
    }
  }
  std::array<RootEnclosure, D> out;
  for (std::size_t i = 0; i < D; ++i) {
    RootEnclosure& root = out[i];
    root.simple = radius[i].bounded();
    root.z = {near[i].real() + radius[i], near[i].imag() + radius[i]};
    for (std::size_t j = 0; j < D; ++j) {
      if (j == i || component[j] != component[i]) continue;
      root.simple = false;
      root.z.re = hull(root.z.re, near[j].real() + radius[j]);
      root.z.im = hull(root.z.im, near[j].imag() + radius[j]);
    }
    if (all_real || (root.simple && near[i].imag() == 0.0)) root.z.im = 0.0;
    if (!root.simple || !root.real()) continue;
    // A simple real root once more by the interval Newton step, which has no factor n.
    const Interval middle(near[i].real());
    const Interval step = p(middle) / p.slope(root.z.re);
    const Interval next = middle - step;
    if (next.bounded() && !next.apart_from(root.z.re)) root.z.re = common(root.z.re, next);
  }
  return out;
}

}  // namespace stationary
