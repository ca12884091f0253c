// A real monic polynomial of degree up to five as real factors, one linear where the degree is odd,
// else quadratics:
//
//   p = (x - r)(x^2 + b x + c)(x^2 + d x + e).
//
// Two roots that all but coincide stay one factor, well-conditioned where each of them is not: in
// extended precision they are told apart at 1e-20 of their size. Roots in double by Laguerre's
// method with deflation, the nearest ones into one factor; then Newton on all factors at once,
//
//   factor += R h mod factor,   h = the inverse modulo it of the product of the others,
//
// R = p - product in extended precision, the rest in double. Where three roots are close it does
// not converge, and says so.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

#include "lib/number/number.hpp"
#include "lib/number/polynomial.hpp"

namespace stationary {

/// x^2 + b x + c.
template <class S>
struct QuadraticFactor {
  S b;
  S c;
};

template <class S, std::size_t degree>
struct RealFactors {
  static constexpr bool has_linear = degree % 2 == 1;
  static constexpr std::size_t quadratics = degree / 2;

  S single{0.0};  ///< the root of the linear one
  std::array<QuadraticFactor<S>, quadratics> quadratic;
  bool converged = true;
};

/// One root of the polynomial of this degree, c[degree] = 1; the smallest, mostly.
inline std::complex<double> laguerre_root(const double* c, std::size_t degree) {
  constexpr int most = 60;
  constexpr double enough = 0x1p-36;  // cubic convergence: the next one would be exact
  const auto n = static_cast<double>(degree);
  double x = 0.0;
  int pass = 0;
  for (; pass < most; ++pass) {
    double p = c[degree];
    double slope = 0.0;
    double half_curvature = 0.0;
    for (std::size_t k = degree; k-- > 0;) {
      half_curvature = half_curvature * x + slope;
      slope = slope * x + p;
      p = p * x + c[k];
    }
    if (p == 0.0) return x;
    const double under = (n - 1.0) * ((n - 1.0) * slope * slope - 2.0 * n * p * half_curvature);
    if (under < 0.0) break;
    const double root = std::sqrt(under);
    const double below = slope < 0.0 ? slope - root : slope + root;
    if (below == 0.0) break;
    const double step = n * p / below;
    x -= step;
    if (std::abs(step) <= enough * std::abs(x)) return x;
  }
  std::complex<double> z = x;
  for (; pass < 2 * most; ++pass) {
    std::complex<double> p = c[degree];
    std::complex<double> slope = 0.0;
    std::complex<double> half_curvature = 0.0;
    for (std::size_t k = degree; k-- > 0;) {
      half_curvature = product(half_curvature, z) + slope;
      slope = product(slope, z) + p;
      p = product(p, z) + c[k];
    }
    if (p == 0.0) return z;
    const std::complex<double> root = square_root(
        (n - 1.0) * (product((n - 1.0) * slope, slope) - product(2.0 * n * p, half_curvature)));
    const std::complex<double> plus = slope + root;
    const std::complex<double> minus = slope - root;
    const std::complex<double> below = std::norm(plus) < std::norm(minus) ? minus : plus;
    if (below == 0.0) {
      z += 1.0;
      continue;
    }
    const std::complex<double> step = quotient(n * p, below);
    z -= step;
    if (std::norm(step) <= enough * enough * std::norm(z)) break;
  }
  return z;
}

/// The real factors of the rough roots, the nearest ones together.
template <std::size_t degree>
RealFactors<double, degree> rough_factors(const std::array<double, degree + 1>& given) {
  std::array<double, degree + 1> c = given;
  RealFactors<double, degree> out;
  std::array<double, degree> real;
  std::size_t count = 0;
  std::size_t quadratics = 0;
  for (std::size_t left = degree; left > 0;) {
    if (left == 2) {
      const RootPair<double> pair = quadratic_roots(c[1], c[0]);
      if (!pair.real()) {
        out.quadratic[quadratics++] = {c[1], c[0]};
      } else {
        real[count++] = pair.small;
        real[count++] = pair.large;
      }
      break;
    }
    const std::complex<double> z = left == 1 ? -c[0] : laguerre_root(c.data(), left);
    if (std::abs(z.imag()) <= 0x1p-30 * std::abs(z.real()) || z.imag() == 0.0) {
      const double x = real[count++] = z.real();
      for (std::size_t k = left - 1; k > 0; --k) c[k] += x * c[k + 1];
      std::shift_left(c.begin(), c.end(), 1);
      --left;
    } else {
      const QuadraticFactor<double> f{-2.0 * z.real(), std::norm(z)};
      out.quadratic[quadratics++] = f;
      for (std::size_t k = left - 1; k >= 2; --k) {
        c[k] -= f.b * c[k + 1];
        if (k + 2 <= left) c[k] -= f.c * c[k + 2];
      }
      std::shift_left(c.begin(), c.end(), 2);
      left -= 2;
    }
  }
  for (std::size_t k = 1; k < count; ++k)
    for (std::size_t j = k; j > 0 && real[j] < real[j - 1]; --j) std::swap(real[j], real[j - 1]);
  // Which roots stand alone, or with which neighbours: so that the least distance between the
  // roots of two factors, relative to their size, is largest.
  const auto apart = [&](std::size_t k) {
    return (real[k + 1] - real[k]) / (std::abs(real[k + 1]) + std::abs(real[k]));
  };
  const auto pair = [&](std::size_t i, std::size_t j) {
    out.quadratic[quadratics++] = {-(real[i] + real[j]), real[i] * real[j]};
  };
  if (count % 2 == 1) {
    std::size_t alone = 0;
    double best = -1.0;
    for (std::size_t k = 0; k < count; k += 2) {
      double least = 4.0;
      for (std::size_t j = 0; j + 1 < count; ++j) {
        const bool together = j < k ? j % 2 == 0 : j > k && j % 2 == 1;
        if (!together) least = std::fmin(least, apart(j));
      }
      if (least > best) {
        best = least;
        alone = k;
      }
    }
    out.single = real[alone];
    for (std::size_t j = 0; j + 1 < count; j += 2) {
      const std::size_t first = j < alone ? j : j + 1;
      pair(first, first + 1);
    }
  } else {
    const bool nested = degree >= 4 && count == 4 && std::fmin(apart(0), apart(2)) > apart(1);
    if (nested) pair(0, 3);
    for (std::size_t j = nested ? 1 : 0; j + 1 < count - nested; j += 2) pair(j, j + 1);
  }
  return out;
}

/// c: of the monic polynomial, c[degree] = 1.
template <class S, std::size_t degree>
RealFactors<S, degree> real_factors(const std::array<S, degree + 1>& c) {
  using Out = RealFactors<S, degree>;
  Out out;
  if constexpr (degree == 1) {
    out.single = -c[0];
    return out;
  }
  if constexpr (degree == 2) {
    out.quadratic[0] = {c[1], c[0]};
    return out;
  }
  std::array<double, degree + 1> rough;
  for (std::size_t k = 0; k <= degree; ++k) rough[k] = leading(c[k]);
  const RealFactors<double, degree> start = rough_factors<degree>(rough);
  out.single = S(start.single);
  for (std::size_t k = 0; k < Out::quadratics; ++k)
    out.quadratic[k] = {S(start.quadratic[k].b), S(start.quadratic[k].c)};

  constexpr int most = 6;
  constexpr double enough = 0x1p-50;
  out.converged = false;
  for (int pass = 0; pass < most && !out.converged; ++pass) {
    // The product, and R; and of each factor the product of the others, in double.
    std::array<S, degree + 1> product;
    product.fill(S(0.0));
    product[0] = S(1.0);
    std::size_t size = 0;
    if constexpr (Out::has_linear) {
      product[1] = S(1.0);
      product[0] = -out.single;
      size = 1;
    }
    for (const QuadraticFactor<S>& f : out.quadratic) {
      for (std::size_t k = size + 3; k-- > 0;) {
        S sum = k >= 2 ? product[k - 2] : S(0.0);
        if (k >= 1 && k <= size + 1) sum = sum + f.b * product[k - 1];
        if (k <= size) sum = sum + f.c * product[k];
        product[k] = renormalized(sum);
      }
      size += 2;
    }
    std::array<double, degree> R;
    for (std::size_t k = 0; k < degree; ++k) R[k] = leading(S(c[k] - product[k]));
    out.converged = true;
    std::array<QuadraticFactor<double>, Out::quadratics> f;
    for (std::size_t k = 0; k < Out::quadratics; ++k)
      f[k] = {leading(out.quadratic[k].b), leading(out.quadratic[k].c)};
    const double r = leading(out.single);
    if constexpr (Out::has_linear) {
      double value = R[degree - 1];
      for (std::size_t k = degree - 1; k-- > 0;) value = value * r + R[k];
      double others = 1.0;
      for (const auto& each : f) others *= (r + each.b) * r + each.c;
      const double step = value / others;
      out.single = renormalized(S(out.single - step));
      out.converged = std::abs(step) <= enough * std::abs(r);
    }
    for (std::size_t k = 0; k < Out::quadratics; ++k) {
      const auto [b, e] = f[k];
      // Modulo x^2 + b x + e.
      double g1 = 0.0;
      double g0 = 1.0;
      if constexpr (Out::has_linear) {
        g1 = 1.0;
        g0 = -r;
      }
      for (std::size_t j = 0; j < Out::quadratics; ++j) {
        if (j == k) continue;
        const double f1 = f[j].b - b;
        const double f0 = f[j].c - e;
        const double square = g1 * f1;
        const double first = g1 * f0 + g0 * f1 - b * square;
        g0 = g0 * f0 - e * square;
        g1 = first;
      }
      double R1 = R[degree - 1];
      double R0 = R[degree - 2];
      for (std::size_t j = degree - 2; j-- > 0;) {
        const double top = R1;
        R1 = R0 - b * top;
        R0 = R[j] - e * top;
      }
      const double det = g0 * (g0 - b * g1) + e * g1 * g1;
      const double d1 = (R1 * g0 - R0 * g1) / det;
      const double d0 = (R0 * (g0 - b * g1) + e * g1 * R1) / det;
      out.quadratic[k].b = renormalized(S(out.quadratic[k].b + d1));
      out.quadratic[k].c = renormalized(S(out.quadratic[k].c + d0));
      const double width = std::abs(b) + std::sqrt(std::abs(e));
      out.converged = out.converged && std::abs(d1) <= enough * width &&
                      std::abs(d0) <= enough * (std::abs(e) + 0x1p-40 * width * width);
    }
  }
  return out;
}

}  // namespace stationary
