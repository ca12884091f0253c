// Polynomials of degree up to four in Lambda = s^2 and their roots, in any number type.
//
// The roots start in double and are polished in S by Newton on the polynomial itself (a real root)
// or on a quadratic factor (Bairstow), so two roots that all but coincide stay one well-conditioned
// factor: in extended precision their distance is resolved to about 1e-15 of their size. Where three or
// four do, they are sought about their mean: to 1e-10 or 1e-7 of their size, which is what coefficients
// in pairs of doubles know of them. Small roots keep their relative accuracy as far as the coefficients
// carry it.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "lib/number/number.hpp"

namespace stationary {

/// sum c[k] x^k, degree D.
template <class S, int D>
struct Polynomial {
  std::array<S, D + 1> c;

  S operator()(const S& x) const {
    S sum = c[D];
    for (std::size_t k = D; k-- > 0;) sum = sum * x + c[k];
    return sum;
  }
  S slope(const S& x) const {
    S sum = static_cast<double>(D) * c[D];
    for (std::size_t k = D; k-- > 1;) sum = sum * x + static_cast<double>(k) * c[k];
    return sum;
  }
  S curvature(const S& x) const {
    S sum = static_cast<double>(D * (D - 1)) * c[D];
    for (std::size_t k = D; k-- > 2;) sum = sum * x + static_cast<double>(k * (k - 1)) * c[k];
    return sum;
  }
};

template <class S, int D, int E>
Polynomial<S, D + E> operator*(const Polynomial<S, D>& p, const Polynomial<S, E>& q) {
  Polynomial<S, D + E> out;
  for (std::size_t i = 0; i <= D; ++i) {
    for (std::size_t j = 0; j <= E; ++j) {
      const S product = p.c[i] * q.c[j];
      out.c[i + j] = i == 0 || j == E ? product : out.c[i + j] + product;
    }
  }
  return out;
}
template <class S, int D>
Polynomial<S, D> operator*(const S& a, const Polynomial<S, D>& p) {
  Polynomial<S, D> out;
  for (std::size_t k = 0; k <= D; ++k) out.c[k] = a * p.c[k];
  return out;
}
template <class S, int D, int E>
Polynomial<S, (D > E ? D : E)> operator+(const Polynomial<S, D>& p, const Polynomial<S, E>& q) {
  Polynomial<S, (D > E ? D : E)> out;
  for (std::size_t k = 0; k < out.c.size(); ++k) {
    if (k > D) {
      out.c[k] = q.c[k];
    } else {
      out.c[k] = k > E ? p.c[k] : p.c[k] + q.c[k];
    }
  }
  return out;
}
template <class S, int D>
Polynomial<S, D> operator-(const Polynomial<S, D>& p) {
  Polynomial<S, D> out;
  for (std::size_t k = 0; k <= D; ++k) out.c[k] = -p.c[k];
  return out;
}
template <class S, int D, int E>
auto operator-(const Polynomial<S, D>& p, const Polynomial<S, E>& q) {
  return p + (-q);
}
/// x p(x).
template <class S, int D>
Polynomial<S, D + 1> raised(const Polynomial<S, D>& p) {
  Polynomial<S, D + 1> out;
  out.c[0] = S(0.0);
  for (std::size_t k = 0; k <= D; ++k) out.c[k + 1] = p.c[k];
  return out;
}
template <class S>
Polynomial<S, 0> constant(const S& a) {
  return {{a}};
}

/// mean +- sqrt(separation): two real roots, or a conjugate pair where separation < 0. `small` is
/// the real root of smaller magnitude, without cancellation (mean where complex).
template <class S>
struct RootPair {
  S mean;
  S separation;
  S large;
  S small;
  bool real() const { return !(leading(separation) < 0.0); }
};

/// Roots of x^2 + b x + c.
template <class S>
RootPair<S> quadratic_roots(const S& b, const S& c) {
  using std::sqrt;
  RootPair<S> out;
  out.mean = -0.5 * b;
  out.separation = renormalized(out.mean * out.mean - c);
  out.large = out.small = out.mean;
  if (out.real()) {
    const S root = sqrt(out.separation);
    out.large = renormalized(leading(out.mean) < 0.0 ? S(out.mean - root) : S(out.mean + root));
    out.small = leading(out.large) == 0.0 ? out.large : c / out.large;
  }
  return out;
}

/// Two real roots as a pair.
template <class S>
RootPair<S> pair_of_roots(const S& a, const S& b) {
  const S half = renormalized(S(0.5 * (a - b)));
  const bool first = std::abs(leading(a)) >= std::abs(leading(b));
  return {renormalized(S(0.5 * (a + b))), renormalized(S(half * half)), first ? a : b,
          first ? b : a};
}

/// The roots, each moved by a shift.
template <class S>
RootPair<S> shifted(const RootPair<S>& pair, const S& shift) {
  const auto moved = [&](const S& x) { return renormalized(S(x + shift)); };
  RootPair<S> out{moved(pair.mean), pair.separation, moved(pair.large), moved(pair.small)};
  if (std::abs(leading(out.large)) < std::abs(leading(out.small))) std::swap(out.large, out.small);
  return out;
}

template <class S>
struct CubicRoots {
  S single;          ///< the real root farther from the other two
  RootPair<S> pair;  ///< the others
};
template <class S>
CubicRoots<S> shifted(const CubicRoots<S>& roots, const S& shift) {
  return {renormalized(S(roots.single + shift)), shifted(roots.pair, shift)};
}

/// Whether the roots of a monic cubic y^3 + P y + Q, y = x - inflection, are near one another beside their
/// size: the polynomial in x is mostly rounding there.
inline bool is_cluster(double inflection, double P, double Q) {
  const double size = std::abs(inflection);
  return std::abs(P) <= 0x1p-10 * size * size && std::abs(Q) <= 0x1p-15 * size * size * size;
}
/// Of any cubic, in double: the limits are far above what that rounds.
template <class S>
bool is_cluster(const Polynomial<S, 3>& p) {
  const double lead = leading(p.c[3]);
  const double c0 = leading(p.c[0]) / lead;
  const double c1 = leading(p.c[1]) / lead;
  const double c2 = leading(p.c[2]) / lead;
  const double inflection = c2 * (-1.0 / 3.0);
  return is_cluster(inflection, c1 + c2 * inflection,
                    ((inflection + c2) * inflection + c1) * inflection + c0);
}

/// Where Newton's method for y^3 + P y + Q, Q != 0, has to begin to come to its isolated root, on the side
/// of -Q, monotonically: three real ones lie within 2 sqrt(-P/3).
inline double beyond_isolated_root(double P, double Q) {
  double bound = std::sqrt(std::fmax(-4.0 * P / 3.0, 0.0));
  if (4.0 * P * P * P + 27.0 * Q * Q > 0.0) bound += cube_root(std::abs(Q));
  return Q < 0.0 ? bound : -bound;
}

/// Roots of y^3 + P y + Q.
template <class S>
CubicRoots<S> depressed_cubic_roots(const S& P, const S& Q) {
  using std::sqrt;
  const double p = leading(P);
  const double q = leading(Q);
  double y = q == 0.0 ? 0.0 : beyond_isolated_root(p, q);
  for (int k = 0; k < 100 && y != 0.0; ++k) {
    const double step = ((y * y + p) * y + q) / (3.0 * y * y + p);
    if (!std::isfinite(step)) break;
    y -= step;
    if (std::abs(step) <= 1e-9 * std::abs(y)) break;
  }
  S z(y);
  constexpr int polish = significand_bits<S>() > 106 ? 4 : 2;
  for (int k = 0; k < polish; ++k) {
    const S slope = renormalized(S(3.0 * (z * z) + P));
    if (leading(slope) == 0.0) break;
    z = renormalized(S(z - renormalized(S((z * z + P) * z + Q)) / slope));
  }
  CubicRoots<S> out;
  out.single = z;
  RootPair<S>& pair = out.pair;
  pair.mean = -0.5 * z;
  pair.separation = renormalized(S(-P - 0.75 * (z * z)));
  pair.large = pair.small = pair.mean;
  if (pair.real()) {
    const S root = sqrt(pair.separation);
    const bool left = leading(pair.mean) < 0.0;
    pair.large = renormalized(left ? S(pair.mean - root) : S(pair.mean + root));
    pair.small = renormalized(left ? S(pair.mean + root) : S(pair.mean - root));
  }
  return out;
}

/// Roots of c3 x^3 + ..., c3 != 0.
template <class S>
CubicRoots<S> cubic_roots(const Polynomial<S, 3>& p) {
  const S inverse = S(1.0) / p.c[3];
  const Polynomial<S, 3> monic{{p.c[0] * inverse, p.c[1] * inverse, p.c[2] * inverse, S(1.0)}};
  const Polynomial<double, 3> rough{
      {leading(monic.c[0]), leading(monic.c[1]), leading(monic.c[2]), 1.0}};
  // Newton from beyond the isolated root's side of the inflection, where it converges
  // monotonically: y^3 + P y + Q in y = x - inflection has its isolated root on the side of -Q.
  const S inflection = -monic.c[2] / S(3.0);
  const S Q_exact = renormalized(monic(inflection));
  const S P_exact = renormalized(monic.slope(inflection));
  const double Q = leading(Q_exact);
  const double P = leading(P_exact);
  if (is_cluster(leading(inflection), P, Q))
    return shifted(depressed_cubic_roots(P_exact, Q_exact), inflection);
  S x = inflection;
  if (Q != 0.0) {
    double r = leading(inflection) + beyond_isolated_root(P, Q);
    for (int k = 0; k < 60; ++k) {
      const double step = rough(r) / rough.slope(r);
      if (!std::isfinite(step)) break;
      r -= step;
      if (std::abs(step) <= 1e-9 * std::abs(r)) break;
    }
    x = S(r);
    constexpr int polish = significand_bits<S>() > 106 ? 5 : 3;
    for (int k = 0; k < polish; ++k) {
      const S slope = monic.slope(x);
      if (leading(slope) == 0.0) break;
      const S step = renormalized(monic(x)) / slope;
      x = renormalized(S(x - step));
      // The error left is about step^2 over the distance from the inflection.
      const double size = leading(step);
      const double reach = leading(x) * (leading(x) - leading(inflection));
      if (size * size <= leading(std::numeric_limits<S>::epsilon()) * std::abs(reach)) break;
    }
  }
  CubicRoots<S> out;
  out.single = x;
  // x^3 + ... = (x - r)(x^2 + b x + c), from the end where nothing cancels.
  const double r = leading(x);
  S b;
  S c;
  if (std::abs(r * r * r) >= std::abs(leading(monic.c[0])) && r != 0.0) {
    c = -monic.c[0] / x;
    b = renormalized(S((c - monic.c[1]) / x));
  } else {
    b = renormalized(S(monic.c[2] + x));
    c = renormalized(S(monic.c[1] + x * b));
  }
  out.pair = quadratic_roots(b, c);
  return out;
}

template <class S>
struct QuarticRoots {
  RootPair<S> first;
  RootPair<S> second;
};

/// Roots of a monic quartic in double, by Durand and Kerner's method. scale: about the largest's size.
inline std::array<std::complex<double>, 4> rough_quartic_roots(const std::array<double, 4>& rough,
                                                               double scale) {
  using Complex = std::complex<double>;
  std::array<Complex, 4> z;
  Complex power = scale;
  for (Complex& each : z) {
    each = power;
    power *= Complex(0.4, 0.9);
  }
  // At double roots its steps shrink to where rounding drives them, and then may be of any length:
  // those after the shortest ones are forgotten.
  double least = std::numeric_limits<double>::infinity();
  std::array<Complex, 4> nearest = z;
  for (int sweep = 0; sweep < 200; ++sweep) {
    double moved = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Complex value =
          (((z[i] + rough[3]) * z[i] + rough[2]) * z[i] + rough[1]) * z[i] + rough[0];
      Complex others = 1.0;
      for (std::size_t j = 0; j < 4; ++j)
        if (j != i) others *= z[i] - z[j];
      if (others == 0.0) continue;
      const Complex step = quotient(value, others);
      z[i] -= step;
      moved = std::fmax(moved, modulus(step));
    }
    if (moved < least) {
      least = moved;
      nearest = z;
    }
    if (moved <= 1e-15 * scale) break;
  }
  return nearest;
}

/// How many of the roots are near one another beside their size, three or four; `apart` is the other of
/// three. Else 0.
struct RootCluster {
  int count = 0;
  std::size_t apart = 0;
};
inline RootCluster cluster_of(const std::array<std::complex<double>, 4>& z) {
  constexpr double near = 0x1p-7;
  const auto are_near = [&](std::size_t i, std::size_t j) {
    return modulus(z[i] - z[j]) < near * std::fmin(modulus(z[i]), modulus(z[j]));
  };
  RootCluster out;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t a = (k + 1) % 4;
    const std::size_t b = (k + 2) % 4;
    const std::size_t c = (k + 3) % 4;
    if (!are_near(a, b) || !are_near(b, c) || !are_near(a, c)) continue;
    out.apart = k;
    out.count = out.count == 0 ? 3 : 4;
  }
  return out;
}

/// The three others of a monic quartic with a real root.
template <class S>
Polynomial<S, 3> without_root(const std::array<S, 4>& m, const S& x) {
  const double r = leading(x);
  // From the end where nothing cancels.
  if (r * r * r * r >= std::abs(leading(m[0])) && r != 0.0) {
    const S c0 = renormalized(S(-m[0] / x));
    const S c1 = renormalized(S((c0 - m[1]) / x));
    return {{c0, c1, renormalized(S((c1 - m[2]) / x)), S(1.0)}};
  }
  const S c2 = renormalized(S(m[3] + x));
  const S c1 = renormalized(S(m[2] + x * c2));
  return {{renormalized(S(m[1] + x * c1)), c1, c2, S(1.0)}};
}

/// Which of a monic quartic's roots are far smaller or far larger than all others, by the sizes of its
/// coefficients: where the largest is 1e10 times the smallest, a method in double that looks for all of them at
/// once does not tell the small ones.
enum class RootGrading { none, one_large, one_small, two_small };
inline RootGrading grading_of(const std::array<double, 4>& m) {
  constexpr double far = 0x1p-20;
  const double a = std::abs(m[3]);
  const double b = std::abs(m[2]);
  const double c = std::abs(m[1]);
  const double d = std::abs(m[0]);
  const auto largest = [](double x, double y, double z) { return std::fmax(x, std::fmax(y, z)); };
  if (a > 0.0 && largest(b / a, std::sqrt(c / a), cube_root(d / a)) < far * a)
    return RootGrading::one_large;
  if (c > 0.0 && d / c * largest(b / c, std::sqrt(a / c), 1.0 / cube_root(c)) < far)
    return RootGrading::one_small;
  // x^2 + m3 x + m2 has the large ones.
  if (b > 0.0 && std::fmax(c / b, std::sqrt(d / b)) * std::fmax(a / b, 1.0 / std::sqrt(b)) < far)
    return RootGrading::two_small;
  return RootGrading::none;
}

/// A real root of a monic quartic, from near it.
template <class S>
S polished_root(const std::array<S, 4>& m, S x) {
  const Polynomial<S, 4> monic{{m[0], m[1], m[2], m[3], S(1.0)}};
  constexpr int most = significand_bits<S>() > 106 ? 6 : 4;
  for (int k = 0; k < most; ++k) {
    const S slope = renormalized(monic.slope(x));
    if (leading(slope) == 0.0) break;
    x = renormalized(S(x - renormalized(monic(x)) / slope));
  }
  return x;
}
/// All of them, where a real one is known that is near no other.
template <class S>
QuarticRoots<S> with_root(const std::array<S, 4>& m, const S& x) {
  const CubicRoots<S> others = cubic_roots(without_root(m, x));
  return {others.pair, pair_of_roots(others.single, x)};
}

/// Of a monic quartic near whose factor x^2 + b x + c is, by Bairstow's method:
/// x^4 + ... = (x^2 + b x + c)(x^2 + e x + f) + r1 x + r0, Newton on (b, c) until r = 0.
template <class S>
QuarticRoots<S> by_factor(const std::array<S, 4>& m, S b, S c) {
  S e;
  S f;
  for (int k = 0; k < 8; ++k) {
    e = renormalized(S(m[3] - b));
    f = renormalized(S(m[2] - c - b * e));
    const S r1 = renormalized(S(m[1] - b * f - c * e));
    const S r0 = renormalized(S(m[0] - c * f));
    // Derivatives of the remainder, from e_b = -1, f_b = b - e, f_c = -1.
    const S r1_b = -f - b * (b - e) + c;
    const S r1_c = b - e;
    const S r0_b = -c * (b - e);
    const S r0_c = c - f;
    const S det = renormalized(S(r1_b * r0_c - r1_c * r0_b));
    if (leading(det) == 0.0) break;
    b = renormalized(S(b - (r1 * r0_c - r1_c * r0) / det));
    c = renormalized(S(c - (r1_b * r0 - r1 * r0_b) / det));
  }
  e = renormalized(S(m[3] - b));
  f = renormalized(S(m[2] - c - b * e));
  return {quadratic_roots(b, c), quadratic_roots(e, f)};
}

/// Roots of c4 x^4 + ..., c4 != 0, as two quadratic factors: the nearest roots share a factor.
template <class S>
QuarticRoots<S> quartic_roots(const Polynomial<S, 4>& p) {
  using Complex = std::complex<double>;
  const S inverse = S(1.0) / p.c[4];
  std::array<S, 4> m;
  std::array<double, 4> rough;
  double scale = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    m[k] = p.c[k] * inverse;
    rough[k] = leading(m[k]);
    scale = std::fmax(scale, pow(std::abs(rough[k]), 1.0 / static_cast<double>(4 - k)));
  }
  if (scale == 0.0) scale = 1.0;
  const RootGrading grading = grading_of(rough);
  if (grading == RootGrading::one_large) return with_root(m, polished_root(m, S(-m[3])));
  if (grading == RootGrading::one_small) return with_root(m, polished_root(m, S(-m[0] / m[1])));
  if (grading == RootGrading::two_small) return by_factor(m, S(m[1] / m[2]), S(m[0] / m[2]));
  const std::array<Complex, 4> z = rough_quartic_roots(rough, scale);
  const RootCluster cluster = cluster_of(z);
  if (cluster.count == 4 && leading(m[3]) != 0.0) {
    // About their mean they are not all near one another.
    const S mean = -0.25 * m[3];
    const S square = renormalized(S(mean * mean));
    const S q2 = renormalized(S(6.0 * square + 3.0 * (m[3] * mean) + m[2]));
    const S q1 = renormalized(S(mean * (4.0 * square + 3.0 * (m[3] * mean) + 2.0 * m[2]) + m[1]));
    const S q0 = renormalized(S(mean * (mean * (square + m[3] * mean + m[2]) + m[1]) + m[0]));
    const QuarticRoots<S> about = quartic_roots(Polynomial<S, 4>{{q0, q1, q2, S(0.0), S(1.0)}});
    return {shifted(about.first, mean), shifted(about.second, mean)};
  }
  if (cluster.count == 3) {
    // The one apart is real, for complex ones come in pairs.
    return with_root(m, polished_root(m, S(z[cluster.apart].real())));
  }
  // Of the three pairings the one whose factors lie farthest apart, conjugates together.
  constexpr std::size_t pairings[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
  double best = -1.0;
  Complex sum;
  Complex product;
  for (const auto& i : pairings) {
    const Complex s = z[i[0]] + z[i[1]];
    const Complex q = z[i[0]] * z[i[1]];
    if (std::abs(s.imag()) > 1e-6 * scale || std::abs(q.imag()) > 1e-6 * scale * scale) continue;
    double apart = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 2; b < 4; ++b) apart = std::fmin(apart, modulus(z[i[a]] - z[i[b]]));
    if (apart > best) {
      best = apart;
      sum = s;
      product = q;
      // By the factor of the small roots: what is left of the large ones' would cancel.
      if (const Complex others = z[i[2]] * z[i[3]]; modulus(others) < 0.25 * modulus(q)) {
        sum = z[i[2]] + z[i[3]];
        product = others;
      }
    }
  }
  return by_factor(m, S(-sum.real()), S(product.real()));
}

}  // namespace stationary
