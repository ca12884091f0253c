// Leaves that a reversing symmetry divides: where coordinates u and v = J u can be chosen, of each
// pair one, so that
//
//   E'' = u^T A u + v^T B v,   u' = B v,  v' = -A u,
//
// the Lambda are the eigenvalues of -B A. Axes in the plane of 1 and 2 have it of every V (the
// reflection of axis 3, with time reversed: u = x, v = p), tilted ones of an isotropic V (there
// alpha and p_alpha change places). It is seen from the entries of E'' that are zero by structure.
//
// Vectors: A u = a v, B v = b u, Lambda = -a b; the energy of an imaginary mode has the sign of a,
// and of b. For changes dA, dB the matrix in the basis of the u moves by -v_i^T dB v_j a_j
// - b_i u_i^T dA u_j, where u_i^T v_i = 1.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "lib/leaf/leaf_modes.hpp"
#include "lib/leaf/leaf_roots.hpp"
#include "lib/leaf/reductions.hpp"
#include "lib/leaf/symplectic_leaf.hpp"
#include "lib/matrix/form_signs.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

template <std::size_t n>
struct ReversibleLeaf {
  Square<DoubleDouble, n> A;
  Square<DoubleDouble, n> B;
  Square<double, n> A_magnitude;
  Square<double, n> B_magnitude;
};

/// Nothing where no choice of u parts E''.
template <std::size_t n>
std::optional<ReversibleLeaf<n>> reversible(const Leaf& leaf) {
  const auto& size = leaf.magnitude;
  // u_k is x_k or p_k: those coupled with like ones alike, with unlike ones unlike.
  std::array<int, n> exchanged;
  exchanged.fill(-1);
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (exchanged[seed] >= 0) continue;
    exchanged[seed] = 0;
    std::array<std::size_t, n> queue{seed};
    for (std::size_t head = 0, tail = 1; head < tail; ++head) {
      const std::size_t i = queue[head];
      if (size[i][n + i] != 0.0) return std::nullopt;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const bool alike = size[i][j] != 0.0 || size[n + i][n + j] != 0.0;
        const bool unlike = size[i][n + j] != 0.0 || size[n + i][j] != 0.0;
        if (!alike && !unlike) continue;
        if (alike && unlike) return std::nullopt;
        const int wanted = exchanged[i] ^ static_cast<int>(unlike);
        if (exchanged[j] < 0) {
          exchanged[j] = wanted;
          queue[tail++] = j;
        } else if (exchanged[j] != wanted) {
          return std::nullopt;
        }
      }
    }
  }
  ReversibleLeaf<n> out;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      // u = (x or p), v = (p or -x).
      const std::size_t ui = exchanged[i] != 0 ? n + i : i;
      const std::size_t uj = exchanged[j] != 0 ? n + j : j;
      const std::size_t vi = exchanged[i] != 0 ? i : n + i;
      const std::size_t vj = exchanged[j] != 0 ? j : n + j;
      out.A[i][j] = leaf.second_variation[ui][uj];
      out.A_magnitude[i][j] = size[ui][uj];
      const DoubleDouble& entry = leaf.second_variation[vi][vj];
      out.B[i][j] = exchanged[i] != exchanged[j] ? -entry : entry;
      out.B_magnitude[i][j] = size[vi][vj];
    }
  }
  return out;
}

namespace reversible_detail {

template <std::size_t n, class T>
using Vectors = std::array<std::array<T, n>, n>;

template <std::size_t n, class T>
Vectors<n, double> magnitudes(const Vectors<n, T>& x) {
  Vectors<n, double> out;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) out[i][k] = modulus(x[i][k]);
  return out;
}

/// x_i^T F x_j.
template <std::size_t n>
Square<double, n> form_of(const Square<double, n>& F, const Vectors<n, double>& x) {
  Square<double, n> out;
  for (std::size_t j = 0; j < n; ++j) {
    std::array<double, n> Fx;
    for (std::size_t k = 0; k < n; ++k) {
      Fx[k] = 0.0;
      for (std::size_t l = 0; l < n; ++l) Fx[k] += F[k][l] * x[j][l];
    }
    for (std::size_t i = 0; i <= j; ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < n; ++k) sum += x[i][k] * Fx[k];
      out[i][j] = out[j][i] = sum;
    }
  }
  return out;
}

template <std::size_t n, class T>
T dot(const std::array<T, n>& x, const std::array<T, n>& y) {
  T sum = product(x[0], y[0]);
  for (std::size_t k = 1; k < n; ++k) sum += product(x[k], y[k]);
  return sum;
}

/// x^T F x of a complex vector, F real and symmetric.
template <std::size_t n, class T>
T form(const Square<double, n>& F, const std::array<T, n>& x) {
  T sum(0.0);
  for (std::size_t i = 0; i < n; ++i) {
    T row(0.0);
    for (std::size_t j = 0; j < n; ++j) row += F[i][j] * x[j];
    sum += product(x[i], row);
  }
  return sum;
}

}  // namespace reversible_detail

template <std::size_t n>
class ReversibleProblem {
 public:
  ReversibleProblem(const ReversibleLeaf<n>& leaf, const LeafFacts& facts)
      : leaf_(leaf), facts_(facts) {
    for (std::size_t k = 0; k < n; ++k) {
      const double ratio = leaf.A_magnitude[k][k] / leaf.B_magnitude[k][k];
      scale_[k] = ratio > 0.0 && ratio < HUGE_VAL ? std::scalbn(1.0, std::ilogb(ratio) / 4) : 1.0;
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        A_[i][j] = leading(leaf.A[i][j]);
        B_[i][j] = leading(leaf.B[i][j]);
      }
    }
  }

  /// Signs in any case; Lambda, energies and bounds unless two of them are too close: false then.
  bool find(LeafModes<n>& out) {
    count_signs(out);
    // Of scaled coordinates, and of Lambda of order one.
    ReducedProduct<n> reduced;
    leaf_reductions().pairs<n>().product(leaf_.A, leaf_.B, scale_, reduced);
    const LeafRoots<n> roots = facts_.forced_zero ? leaf_roots<n, 1>(reduced.c, reduced.magnitude)
                                                  : leaf_roots<n, 0>(reduced.c, reduced.magnitude);
    if (!roots.sure) return false;
    for (const Complex& lambda : roots.lambda)
      if (lambda.imag() != 0.0) return follow<Complex>(reduced, roots, out);
    return follow<double>(reduced, roots, out);
  }

 private:
  using Complex = std::complex<double>;

  void count_signs(LeafModes<n>& out) const {
    const auto scale_A = unit_scales(leaf_.A_magnitude);
    const auto scale_B = unit_scales(leaf_.B_magnitude);
    const double u = facts_.uncertainty;
    out.negative = 0;
    out.definite = !facts_.forced_zero &&
                   positive_definite(leaf_.A, leaf_.A_magnitude, scale_A, u) &&
                   positive_definite(leaf_.B, leaf_.B_magnitude, scale_B, u);
    if (out.definite) return;
    const PivotSigns A = pivot_signs(leaf_.A, scale_A, facts_.forced_zero);
    const PivotSigns B = pivot_signs(leaf_.B, scale_B, facts_.forced_zero);
    out.negative = A.negative + B.negative;
    if (facts_.forced_zero) {
      const PivotSigns& zero = A.weakest < B.weakest ? A : B;
      out.negative -= zero.last_negative;
    }
  }

  /// Vectors, energies and bounds.
  template <class T>
  bool follow(const ReducedProduct<n>& reduced, const LeafRoots<n>& roots,
              LeafModes<n>& out) const {
    using namespace reversible_detail;
    out.forced = roots.forced;
    Vectors<n, T> u;
    Vectors<n, T> v;
    std::array<T, n> lambda;
    std::array<double, n> rounding;
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (std::is_same_v<T, double>) {
        lambda[i] = roots.lambda[i].real();
      } else {
        lambda[i] = roots.lambda[i];
      }
      const NullSpace<T, n> space(reduced.h, lambda[i]);
      u[i] = space.right();
      v[i] = space.left();
      reduced.similarity.carry_right(u[i]);
      reduced.similarity.carry_left(v[i]);
      double right = 0.0;
      double left = 0.0;
      for (std::size_t k = 0; k < n; ++k) {
        right += one_norm(u[i][k]);
        left += one_norm(v[i][k]);
        u[i][k] *= 1.0 / scale_[k];
        v[i][k] *= scale_[k];
      }
      rounding[i] = right * left;
    }
    // u_i^T v_i = 1.
    std::array<T, n> a;
    std::array<T, n> b;
    for (std::size_t i = 0; i < n; ++i) {
      const T per_c = inverse(dot(u[i], v[i]));
      rounding[i] *= one_norm(per_c);
      for (T& each : u[i]) each = product(each, per_c);
      a[i] = form(A_, u[i]);
      b[i] = form(B_, v[i]);
    }
    const Square<double, n> in_A = form_of(leaf_.A_magnitude, magnitudes(u));
    const Square<double, n> in_B = form_of(leaf_.B_magnitude, magnitudes(v));
    std::array<double, n> t;  // u_i -> t u_i, v_i -> v_i/t: both alike in size
    for (std::size_t i = 0; i < n; ++i) t[i] = std::sqrt(std::sqrt(in_B[i][i] / in_A[i][i]));
    Square<double, n> d;
    for (std::size_t i = 0; i < n; ++i) {
      const double bi = one_norm(b[i]) / t[i];
      for (std::size_t j = 0; j < n; ++j) {
        const double aj = one_norm(a[j]) * t[j];
        d[i][j] = facts_.uncertainty * (aj * in_B[i][j] / t[i] + bi * in_A[i][j] * t[j]);
        if (i == roots.forced || j == roots.forced) d[i][j] = 0.0;
      }
      // They are vectors of -B A with this Lambda.
      const T off = product(a[i], b[i]) + lambda[i] * reduced.unit;
      const double terms = one_norm(a[i]) * in_B[i][i] + one_norm(b[i]) * in_A[i][i];
      if (!(one_norm(off) <= 1e-6 * terms)) return false;
      rounding[i] = reduced.unit * (0x1p-94 * reduced.h_size * rounding[i] + roots.error[i]);
      out.lambda[i] = lambda[i] * reduced.unit;
    }
    if (!out.set_errors(d, rounding)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const bool imaginary = out.lambda[i].imag() == 0.0 && out.lambda[i].real() < 0.0;
      out.energy[i] =
          imaginary ? energy_sign(std::real(a[i]) / in_A[i][i], std::real(b[i]) / in_B[i][i]) : 0;
    }
    return true;
  }

  const ReversibleLeaf<n>& leaf_;
  LeafFacts facts_;
  std::array<double, n> scale_;
  Square<double, n> A_;
  Square<double, n> B_;
};

}  // namespace stationary
