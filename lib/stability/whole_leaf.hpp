// Leaves that no reversing symmetry divides, as a whole: H = J E'' to Hessenberg form, its
// characteristic polynomial, even but for rounding, as one in Lambda = s^2.
//
// With z, w the vectors of s and -s (w conjugate to z where s is imaginary) the left vector of s is
// J w up to sign, and a change dE moves the matrix of H^2 in the basis of all z, w by
// (s_i + s_j) w_i^T dE z_j/(w_i^T J^-1 z_i), but for squares of dE.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lib/matrix/eigenvalue_discs.hpp"
#include "lib/matrix/form_signs.hpp"
#include "lib/number/elementary.hpp"
#include "lib/stability/leaf_modes.hpp"
#include "lib/stability/leaf_roots.hpp"
#include "lib/stability/symplectic_leaf.hpp"

namespace stationary {

template <std::size_t n>
class WholeLeafProblem {
 public:
  WholeLeafProblem(const Leaf& leaf, const LeafFacts& facts) : facts_(facts) {
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        E_[i][j] = leaf.second_variation[i][j];
        magnitude_[i][j] = leaf.magnitude[i][j];
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double ratio = magnitude_[n + k][n + k] / magnitude_[k][k];
      const bool finite = ratio > 0.0 && ratio < HUGE_VAL;
      scale_[k] = finite ? std::scalbn(1.0, std::ilogb(ratio) / 4) : 1.0;
      scale_[n + k] = 1.0 / scale_[k];
    }
  }

  /// Signs in any case; Lambda, energies and bounds unless two of them, or one and zero, are too
  /// close: false then.
  bool find(LeafModes<n>& out) {
    const auto own = unit_scales(magnitude_);
    const PivotSigns signs = pivot_signs(E_, own, facts_.forced_zero);
    out.negative = signs.negative - (facts_.forced_zero && signs.last_negative);
    out.definite = out.negative == 0 && !facts_.forced_zero &&
                   positive_definite(E_, magnitude_, own, facts_.uncertainty);
    // H of scaled coordinates, x_k -> x_k/c_k, p_k -> c_k p_k, and of s of order one.
    Square<DoubleDouble, N> H;
    double largest = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        const DoubleDouble& entry = E_[i < n ? n + i : i - n][j];
        const double by = scale_[i] / scale_[j] * (i < n ? 1.0 : -1.0);
        H[i][j] = {entry.hi * by, entry.lo * by};
        largest = std::fmax(largest, std::abs(H[i][j].hi));
      }
    }
    unit_ = largest > 0.0 && largest < HUGE_VAL ? std::scalbn(1.0, std::ilogb(largest)) : 1.0;
    for (auto& row : H) {
      for (DoubleDouble& entry : row) {
        entry.hi /= unit_;
        entry.lo /= unit_;
      }
    }
    const Hessenberg<DoubleDouble, N> hessenberg(H);
    const HessenbergPolynomial<DoubleDouble, N> p(hessenberg.h);
    std::array<DoubleDouble, n + 1> even;
    std::array<double, n + 1> magnitude;
    for (std::size_t k = 0; k <= n; ++k) {
      even[k] = p.c[2 * k];
      magnitude[k] = p.magnitude[2 * k];
    }
    const LeafRoots<n> roots =
        facts_.forced_zero ? leaf_roots<n, 1>(even, magnitude) : leaf_roots<n, 0>(even, magnitude);
    return roots.sure && follow(hessenberg, roots, out);
  }

 private:
  static constexpr std::size_t N = 2 * n;
  using Complex = std::complex<double>;
  template <class T>
  using Vector = std::array<T, N>;

  /// w^T J^-1 z.
  static Complex paired(const Vector<Complex>& w, const Vector<Complex>& z) {
    Complex sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) sum += product(w[n + k], z[k]) - product(w[k], z[n + k]);
    return sum;
  }

  static double inner(const Vector<double>& x, const Vector<double>& y) {
    double sum = 0.0;
    for (std::size_t k = 0; k < N; ++k) sum += x[k] * y[k];
    return sum;
  }

  /// Vectors, energies and bounds.
  bool follow(const Hessenberg<DoubleDouble, N>& hessenberg, const LeafRoots<n>& roots,
              LeafModes<n>& out) const {
    out.forced = roots.forced;
    Square<double, N> h;
    double h_size = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        h[i][j] = leading(hessenberg.h[i][j]);
        h_size = std::fmax(h_size, std::abs(h[i][j]));
      }
    }
    std::array<Vector<Complex>, n> z;
    std::array<Vector<Complex>, n> w;
    std::array<Complex, n> s;
    std::array<double, n> rounding{};
    std::array<Complex, n> c;
    std::array<double, n> energy{};
    std::array<Vector<double>, n> z_size;
    std::array<Vector<double>, n> w_size;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == roots.forced) {
        s[i] = 0.0;
        continue;
      }
      s[i] = square_root(roots.lambda[i]);
      if (roots.lambda[i].imag() == 0.0 && roots.lambda[i].real() < 0.0)
        s[i] = Complex(0.0, std::abs(s[i].imag()));
      NullVectors<Complex, N> x = null_vectors<Complex, N>(h, s[i]);
      hessenberg.carry_right(x.right);
      hessenberg.carry_left(x.left);
      double right = 0.0;
      double left = 0.0;
      for (std::size_t k = 0; k < N; ++k) {
        right += one_norm(x.right[k]);
        left += one_norm(x.left[k]);
        z[i][k] = x.right[k] / scale_[k];
      }
      for (std::size_t k = 0; k < n; ++k) {
        w[i][k] = -x.left[n + k] * scale_[n + k];
        w[i][n + k] = x.left[k] * scale_[k];
      }
      c[i] = paired(w[i], z[i]);
      rounding[i] = right * left / modulus(c[i]);
      for (std::size_t k = 0; k < N; ++k) {
        z_size[i][k] = modulus(z[i][k]);
        w_size[i][k] = modulus(w[i][k]);
      }
      if (roots.lambda[i].imag() == 0.0 && roots.lambda[i].real() < 0.0) {
        // z^* E z, against its terms.
        double terms = 0.0;
        for (std::size_t k = 0; k < N; ++k) {
          Complex row = 0.0;
          double sizes = 0.0;
          for (std::size_t l = 0; l < N; ++l) {
            row += leading(E_[k][l]) * z[i][l];
            sizes += magnitude_[k][l] * z_size[i][l];
          }
          energy[i] += z[i][k].real() * row.real() + z[i][k].imag() * row.imag();
          terms += z_size[i][k] * sizes;
        }
        energy[i] /= terms;
      }
    }
    Square<double, n> d;
    for (std::size_t j = 0; j < n; ++j) {
      Vector<double> of_z;
      Vector<double> of_w;
      if (j == roots.forced) {
        for (std::size_t i = 0; i < n; ++i) d[i][j] = 0.0;
        continue;
      }
      for (std::size_t k = 0; k < N; ++k) {
        of_z[k] = inner(magnitude_[k], z_size[j]);
        of_w[k] = inner(magnitude_[k], w_size[j]);
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (i == roots.forced) {
          d[i][j] = 0.0;
          continue;
        }
        if (i == j) {
          d[i][i] =
              facts_.uncertainty * 2.0 * modulus(s[i]) * inner(w_size[i], of_z) / modulus(c[i]);
          continue;
        }
        // Rows of z_i and of w_i; z and w of j.
        const double sum = modulus(s[i] + s[j]);
        const double difference = modulus(s[i] - s[j]);
        const double by_w = sum * inner(w_size[i], of_z) + difference * inner(w_size[i], of_w);
        const double by_z = difference * inner(z_size[i], of_z) + sum * inner(z_size[i], of_w);
        d[i][j] =
            facts_.uncertainty * std::fmax(by_w, by_z) / std::sqrt(modulus(product(c[i], c[j])));
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) d[i][j] *= unit_;
      out.lambda[i] = roots.lambda[i] * (unit_ * unit_);
      rounding[i] =
          i == roots.forced
              ? 0.0
              : unit_ * unit_ *
                    (2.0 * modulus(s[i]) * 0x1p-94 * h_size * rounding[i] + roots.error[i]);
    }
    // s and -s have to stand apart too.
    for (std::size_t i = 0; i < n; ++i)
      if (i != roots.forced && !(d[i][i] <= discs_apart * modulus(out.lambda[i]))) return false;
    const auto discs = eigenvalue_discs(out.lambda, d);
    if (!discs) return false;
    out.error = *discs;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != roots.forced && !(rounding[i] <= 0x1p-8 * out.error[i])) return false;
      out.error[i] += rounding[i] + 0x1p-53 * one_norm(out.lambda[i]);
      out.energy[i] = energy[i] > energy_doubt ? 1 : energy[i] < -energy_doubt ? -1 : 0;
    }
    return true;
  }

  LeafFacts facts_;
  Square<DoubleDouble, N> E_;
  Square<double, N> magnitude_;
  std::array<double, N> scale_;
  double unit_ = 1.0;
};

}  // namespace stationary
