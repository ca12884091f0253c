// Leaves that no reversing symmetry divides, as a whole: H = J E'', its square to Hessenberg form
// (skew_hamiltonian.hpp), whose characteristic polynomial is that of Lambda = s^2.
//
// Of H^2 X = Lambda X the vectors of s and -s are z = (H + s) X and w = (H - s) X (w conjugate to z
// where s is imaginary). The left vector of s is J w up to sign, and a change dE moves the matrix of
// H^2 in the basis of all z, w by (s_i + s_j) w_i^T dE z_j/(w_i^T J^-1 z_i), but for squares of dE.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lib/leaf/leaf_modes.hpp"
#include "lib/leaf/leaf_roots.hpp"
#include "lib/leaf/reductions.hpp"
#include "lib/leaf/symplectic_leaf.hpp"
#include "lib/matrix/form_signs.hpp"
#include "lib/number/elementary.hpp"

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
    out.negative = 0;
    out.definite =
        !facts_.forced_zero && positive_definite(E_, magnitude_, own, facts_.uncertainty);
    if (!out.definite) {
      const PivotSigns signs = pivot_signs(E_, own, facts_.forced_zero);
      out.negative = signs.negative - (facts_.forced_zero && signs.last_negative);
    }
    // Of scaled coordinates, x_k -> x_k/c_k, p_k -> c_k p_k, and of s of order one.
    ReducedSquare<n> reduced;
    leaf_reductions().pairs<n>().square(E_, scale_, H_, reduced);
    const LeafRoots<n> roots = facts_.forced_zero ? leaf_roots<n, 1>(reduced.c, reduced.magnitude)
                                                  : leaf_roots<n, 0>(reduced.c, reduced.magnitude);
    return roots.sure && follow(reduced, roots, out);
  }

 private:
  static constexpr std::size_t N = 2 * n;
  using Complex = std::complex<double>;
  template <class T>
  using Vector = std::array<T, N>;

  struct Mode {
    bool imaginary = false;  ///< w is conjugate to z
    Vector<Complex> z;
    Vector<Complex> w;
    Vector<double> z_size;
    Vector<double> w_size;
    double paired = 0.0;   ///< |w^T J^-1 z|
    double overlap = 0.0;  ///< |left| |right|/|left . right| of the scaled vectors
    double energy = 0.0;   ///< of an imaginary one: z^* E'' z, against its terms
  };

  /// (H + s) X and (H - s) X, of X that H^2 takes to s^2 X; false where one of them is mostly
  /// rounding.
  template <class T>
  bool set_vectors(const Vector<T>& X, const Complex& s, Mode& m) const {
    double z = 0.0;
    double w = 0.0;
    double terms = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      T row(0.0);
      for (std::size_t j = 0; j < N; ++j) row += H_[i][j] * X[j];
      const Complex turned = product(s, Complex(X[i]));
      m.z[i] = row + turned;
      m.w[i] = row - turned;
      z += one_norm(m.z[i]);
      w += one_norm(m.w[i]);
      terms += one_norm(row) + one_norm(turned);
    }
    return std::fmin(z, w) > 0x1p-20 * terms;
  }

  /// From z and w in scaled coordinates.
  void complete(Mode& m) const {
    double right = 0.0;
    double left = 0.0;
    for (std::size_t k = 0; k < N; ++k) {
      right += one_norm(m.z[k]);
      m.z[k] /= scale_[k];
      m.z_size[k] = modulus(m.z[k]);
    }
    if (m.imaginary) {
      // (x - iy)^T J^-1 (x + iy), and z^* E'' z.
      left = right;
      m.w_size = m.z_size;
      for (std::size_t k = 0; k < n; ++k)
        m.paired += m.z[n + k].real() * m.z[k].imag() - m.z[n + k].imag() * m.z[k].real();
      m.paired = 2.0 * std::abs(m.paired);
      double terms = 0.0;
      for (std::size_t k = 0; k < N; ++k) {
        double re = 0.0;
        double im = 0.0;
        double sizes = 0.0;
        for (std::size_t l = 0; l < N; ++l) {
          re += leading(E_[k][l]) * m.z[l].real();
          im += leading(E_[k][l]) * m.z[l].imag();
          sizes += magnitude_[k][l] * m.z_size[l];
        }
        m.energy += m.z[k].real() * re + m.z[k].imag() * im;
        terms += m.z_size[k] * sizes;
      }
      m.energy /= terms;
    } else {
      Complex sum = 0.0;
      for (std::size_t k = 0; k < N; ++k) {
        left += one_norm(m.w[k]);
        m.w[k] /= scale_[k];
        m.w_size[k] = modulus(m.w[k]);
      }
      for (std::size_t k = 0; k < n; ++k)
        sum += product(m.w[n + k], m.z[k]) - product(m.w[k], m.z[n + k]);
      m.paired = modulus(sum);
    }
    m.overlap = right * left / m.paired;
  }

  static double inner(const Vector<double>& x, const Vector<double>& y) {
    double sum = 0.0;
    for (std::size_t k = 0; k < N; ++k) sum += x[k] * y[k];
    return sum;
  }

  /// Vectors, energies and bounds.
  bool follow(const ReducedSquare<n>& reduced, const LeafRoots<n>& roots, LeafModes<n>& out) const {
    out.forced = roots.forced;
    std::array<Complex, n> s;
    std::array<Mode, n> modes;
    for (std::size_t i = 0; i < n; ++i) {
      s[i] = 0.0;
      if (i == roots.forced) continue;
      const Complex& lambda = roots.lambda[i];
      s[i] = square_root(lambda);
      Mode& m = modes[i];
      if (lambda.imag() == 0.0) {
        m.imaginary = lambda.real() < 0.0;
        if (m.imaginary) s[i] = Complex(0.0, std::abs(s[i].imag()));
        const auto x = NullSpace<double, n>(reduced.h, lambda.real()).right();
        if (!set_vectors(reduced.similarity.carry(x), s[i], m)) return false;
      } else {
        const auto x = NullSpace<Complex, n>(reduced.h, lambda).right();
        if (!set_vectors(reduced.similarity.carry(x), s[i], m)) return false;
      }
      complete(m);
    }
    Square<double, n> d;
    for (std::size_t j = 0; j < n; ++j) {
      const Mode& other = modes[j];
      for (std::size_t i = 0; i < n; ++i) d[i][j] = 0.0;
      if (j == roots.forced) continue;
      Vector<double> of_z;
      Vector<double> of_w;
      for (std::size_t k = 0; k < N; ++k) of_z[k] = inner(magnitude_[k], other.z_size);
      if (other.imaginary) {
        of_w = of_z;
      } else {
        for (std::size_t k = 0; k < N; ++k) of_w[k] = inner(magnitude_[k], other.w_size);
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (i == roots.forced) continue;
        const Mode& m = modes[i];
        if (i == j) {
          d[i][i] = facts_.uncertainty * 2.0 * modulus(s[i]) * inner(m.w_size, of_z) / m.paired;
          continue;
        }
        // Rows of z_i and of w_i; z and w of j.
        const double sum = modulus(s[i] + s[j]);
        const double difference = modulus(s[i] - s[j]);
        double by = 0.0;
        if (m.imaginary && other.imaginary) {
          by = (sum + difference) * inner(m.z_size, of_z);
        } else {
          const double by_w = sum * inner(m.w_size, of_z) + difference * inner(m.w_size, of_w);
          const double by_z = difference * inner(m.z_size, of_z) + sum * inner(m.z_size, of_w);
          by = std::fmax(by_w, by_z);
        }
        d[i][j] = facts_.uncertainty * by / std::sqrt(m.paired * other.paired);
      }
    }
    std::array<double, n> rounding{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) d[i][j] *= reduced.unit;
      out.lambda[i] = roots.lambda[i] * (reduced.unit * reduced.unit);
      if (i == roots.forced) continue;
      rounding[i] =
          reduced.unit * reduced.unit *
          (2.0 * 0x1p-94 * std::fmax(1.0, reduced.h_size) * modes[i].overlap + roots.error[i]);
    }
    // s and -s have to stand apart too.
    for (std::size_t i = 0; i < n; ++i)
      if (i != roots.forced && !(d[i][i] <= discs_apart * modulus(out.lambda[i]))) return false;
    if (!out.set_errors(d, rounding)) return false;
    for (std::size_t i = 0; i < n; ++i) out.energy[i] = energy_sign(modes[i].energy);
    return true;
  }

  LeafFacts facts_;
  Square<DoubleDouble, N> E_;
  Square<double, N> magnitude_;
  Square<double, N> H_;  ///< of scaled coordinates, largest entry of order one
  std::array<double, N> scale_;
};

}  // namespace stationary
