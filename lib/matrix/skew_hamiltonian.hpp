// Squares of Hamiltonian matrices to Hessenberg form, by elimination that keeps their structure:
//
//   H = [[P, Q], [R, -P^T]],  Q, R symmetric:   H^2 = [[A, G], [F, A^T]],  F, G skew-symmetric,
//   T^-1 H^2 T = [[A', G'], [0, A'^T]],  A' zero below its subdiagonal,  T symplectic.
//
// The eigenvalues of H^2 are those of A', each twice. T is a product of swaps of two planes
// (q_i, p_i), turns of a plane, q -> p, p -> -q, and shears with entries of magnitude 1 at most.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lib/matrix/hessenberg.hpp"

namespace stationary {

/// T.
template <std::size_t n>
struct SymplecticSimilarity {
  /// What made a column zero, plane k + 1 the pivot: p_i -= p[i] p_pivot; the plane turned or not,
  /// then p -= turn q; q_i -= q[i] q_pivot.
  struct Column {
    std::size_t p_pivot = 0;
    std::size_t q_pivot = 0;
    bool turned = false;
    double turn = 0.0;
    std::array<double, n> p{};
    std::array<double, n> q{};
  };
  std::array<Column, n> column;

  /// T (x, 0).
  template <class T>
  std::array<T, 2 * n> carry(const std::array<T, n>& x) const {
    std::array<T, 2 * n> out;
    for (std::size_t i = 0; i < n; ++i) {
      out[i] = x[i];
      out[n + i] = T(0.0);
    }
    const auto swap_planes = [&](std::size_t i, std::size_t j) {
      std::swap(out[i], out[j]);
      std::swap(out[n + i], out[n + j]);
    };
    for (std::size_t k = n - 1; k-- > 0;) {
      const Column& of = column[k];
      const std::size_t top = k + 1;
      for (std::size_t i = top + 1; i < n; ++i) {
        out[i] += of.q[i] * out[top];
        out[n + top] -= of.q[i] * out[n + i];
      }
      swap_planes(top, of.q_pivot);
      out[n + top] += of.turn * out[top];
      if (of.turned) {
        std::swap(out[top], out[n + top]);
        out[top] = -out[top];
      }
      for (std::size_t i = top + 1; i < n; ++i) {
        out[top] -= of.p[i] * out[i];
        out[n + i] += of.p[i] * out[n + top];
      }
      swap_planes(top, of.p_pivot);
    }
    return out;
  }
};

/// S is a pair of doubles, or any real number.
template <class S, std::size_t n>
class SkewHamiltonian {
 public:
  /// Of H in 2n rows, (q, p).
  explicit SkewHamiltonian(const Square<S, 2 * n>& H) {
    set_squares(H);
    for (std::size_t k = 0; k + 1 < n; ++k) eliminate(k);
  }

  /// A'.
  const Square<S, n>& hessenberg() const { return a_; }
  const SymplecticSimilarity<n>& similarity() const { return similarity_; }

 private:
  static double size(const S& x) { return std::abs(leading(x)); }

  void set_squares(const Square<S, 2 * n>& H) {
    const S none(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      a_[i].fill(none);
      f_[i].fill(none);
      g_[i].fill(none);
    }
    // Row i of A, and the rows of F and G beyond their diagonal.
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 2 * n; ++k) {
        if (const S& h = H[i][k]; leading(h) != 0.0) {
          for (std::size_t j = 0; j < n; ++j) a_[i][j] = a_[i][j] + h * H[k][j];
          for (std::size_t j = i + 1; j < n; ++j) g_[i][j] = g_[i][j] + h * H[k][n + j];
        }
        if (const S& h = H[n + i][k]; leading(h) != 0.0)
          for (std::size_t j = i + 1; j < n; ++j) f_[i][j] = f_[i][j] + h * H[k][j];
      }
      for (std::size_t j = 0; j < n; ++j) a_[i][j] = renormalized(a_[i][j]);
      for (std::size_t j = i + 1; j < n; ++j) {
        f_[i][j] = renormalized(f_[i][j]);
        g_[i][j] = renormalized(g_[i][j]);
        f_[j][i] = -f_[i][j];
        g_[j][i] = -g_[i][j];
      }
    }
  }

  /// Rows and columns of planes i and j.
  void swap_planes(std::size_t i, std::size_t j) {
    if (i == j) return;
    for (Square<S, n>* each : {&a_, &f_, &g_}) {
      std::swap((*each)[i], (*each)[j]);
      for (auto& row : *each) std::swap(row[i], row[j]);
    }
  }

  /// x - m y.
  static S less(const S& x, const S& m, const S& y) { return renormalized(S(x - m * y)); }
  /// Row and column i of a skew matrix minus m times those of `of`.
  static void shear(Square<S, n>& skew, std::size_t i, const S& m, std::size_t of) {
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i || j == of) continue;
      skew[i][j] = less(skew[i][j], m, skew[of][j]);
      skew[j][i] = -skew[i][j];
    }
  }
  /// q_i -= m q_of, p_of += m p_i.
  void shear(std::size_t i, const S& m, std::size_t of) {
    for (std::size_t j = 0; j < n; ++j) a_[i][j] = less(a_[i][j], m, a_[of][j]);
    const S back = -m;
    for (std::size_t j = 0; j < n; ++j) a_[j][of] = less(a_[j][of], back, a_[j][i]);
    shear(f_, of, back, i);
    shear(g_, i, m, of);
  }

  void eliminate(std::size_t k) {
    auto& of = similarity_.column[k];
    const std::size_t top = k + 1;
    const auto pivot = [&](const Square<S, n>& block) {
      std::size_t out = top;
      for (std::size_t i = top + 1; i < n; ++i)
        if (size(block[i][k]) > size(block[out][k])) out = i;
      return out;
    };
    of.p_pivot = pivot(f_);
    swap_planes(top, of.p_pivot);
    for (std::size_t i = top + 1; i < n; ++i) {
      if (leading(f_[i][k]) == 0.0) continue;
      const S m = renormalized(S(f_[i][k] / f_[top][k]));
      of.p[i] = leading(m);
      shear(top, S(-m), i);  // p_i -= m p_top, q_top += m q_i
      f_[i][k] = f_[k][i] = S(0.0);
    }
    if (size(f_[top][k]) > size(a_[top][k])) {
      of.turned = true;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == top) continue;
        const S row = a_[top][j];
        const S column = a_[j][top];
        a_[top][j] = f_[top][j];
        f_[top][j] = -row;
        f_[j][top] = row;
        a_[j][top] = g_[j][top];
        g_[j][top] = -column;
        g_[top][j] = column;
      }
    }
    if (leading(f_[top][k]) != 0.0) {
      const S m = renormalized(S(f_[top][k] / a_[top][k]));
      of.turn = leading(m);
      const S back = -m;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == top) continue;
        f_[top][j] = less(f_[top][j], m, a_[top][j]);
        f_[j][top] = -f_[top][j];
        a_[j][top] = less(a_[j][top], back, g_[j][top]);
      }
      f_[top][k] = f_[k][top] = S(0.0);
    }
    of.q_pivot = pivot(a_);
    swap_planes(top, of.q_pivot);
    for (std::size_t i = top + 1; i < n; ++i) {
      if (leading(a_[i][k]) == 0.0) continue;
      const S m = renormalized(S(a_[i][k] / a_[top][k]));
      of.q[i] = leading(m);
      shear(i, m, top);
      a_[i][k] = S(0.0);
    }
  }

  Square<S, n> a_;
  Square<S, n> f_;
  Square<S, n> g_;
  SymplecticSimilarity<n> similarity_;
};

}  // namespace stationary
