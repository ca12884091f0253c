// Eigenvalues of a Hessenberg matrix in any number type by the shifted QR algorithm: slower than
// the roots of its characteristic polynomial (real_factors.hpp), but backward stable, so that
// several close eigenvalues that a symmetric problem has keep their digits. Source: the procedure
// hqr of R. S. Martin, G. Peters, J. H. Wilkinson, Numer. Math. 14 (1970) 219.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "lib/matrix/hessenberg.hpp"

namespace stationary {

template <class S>
struct ComplexOf {
  S re;
  S im;
};

/// Of the leading n rows and columns, one code for all sizes. False where it does not
/// converge.
template <class S, std::size_t most>
bool shifted_qr(Square<S, most>& a, std::size_t n, std::array<ComplexOf<S>, most>& out) {
  using std::sqrt;
  const double epsilon = leading(std::numeric_limits<S>::epsilon());
  const auto size = [](const S& x) { return std::abs(leading(x)); };
  const auto tidy = [](const S& x) -> S { return renormalized(x); };
  double norm = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i > 0 ? i - 1 : 0; j < n; ++j) norm += size(a[i][j]);
  S shifted(0.0);
  int passes = 0;
  for (std::size_t rest = n; rest > 0;) {
    const std::size_t last = rest - 1;
    // Where the part that is still to be done begins.
    std::size_t first = last;
    for (; first > 0; --first) {
      double scale = size(a[first - 1][first - 1]) + size(a[first][first]);
      if (scale == 0.0) scale = norm;
      if (size(a[first][first - 1]) <= epsilon * scale) {
        a[first][first - 1] = S(0.0);
        break;
      }
    }
    S x = a[last][last];
    if (first == last) {
      out[last] = {tidy(x + shifted), S(0.0)};
      rest -= 1;
      passes = 0;
      continue;
    }
    S y = a[last - 1][last - 1];
    S w = a[last][last - 1] * a[last - 1][last];
    if (first + 1 == last) {
      const S half = tidy(0.5 * (y - x));
      const S under = tidy(half * half + w);
      x = tidy(x + shifted);
      if (leading(under) >= 0.0) {
        const S root = sqrt(under);
        const S z = leading(half) < 0.0 ? tidy(half - root) : tidy(half + root);
        out[last - 1] = out[last] = {tidy(x + z), S(0.0)};
        if (leading(z) != 0.0) out[last].re = tidy(x - w / z);
      } else {
        const S root = sqrt(S(-under));
        out[last - 1] = {tidy(x + half), root};
        out[last] = {tidy(x + half), -root};
      }
      rest -= 2;
      passes = 0;
      continue;
    }
    if (passes == 60) return false;
    if (passes % 10 == 9) {  // an exceptional shift
      shifted = tidy(shifted + x);
      for (std::size_t i = 0; i <= last; ++i) a[i][i] = tidy(a[i][i] - x);
      const double s = size(a[last][last - 1]) + size(a[last - 1][last - 2]);
      x = y = S(0.75 * s);
      w = S(-0.4375 * s * s);
    }
    ++passes;
    // Two small subdiagonal entries in a row are a start too.
    S p;
    S q;
    S r;
    std::size_t start = last - 2;
    for (;; --start) {
      const S z = a[start][start];
      const S rx = x - z;
      const S sy = y - z;
      p = tidy((rx * sy - w) / a[start + 1][start] + a[start][start + 1]);
      q = tidy(a[start + 1][start + 1] - z - rx - sy);
      r = a[start + 2][start + 1];
      const double s = size(p) + size(q) + size(r);
      p = p / s;
      q = q / s;
      r = r / s;
      if (start == first) break;
      const double u = size(a[start][start - 1]) * (size(q) + size(r));
      const double v =
          size(p) * (size(a[start - 1][start - 1]) + size(z) + size(a[start + 1][start + 1]));
      if (u <= epsilon * v) break;
    }
    for (std::size_t i = start + 2; i <= last; ++i) {
      a[i][i - 2] = S(0.0);
      if (i != start + 2) a[i][i - 3] = S(0.0);
    }
    for (std::size_t k = start; k < last; ++k) {
      const bool three = k + 1 != last;
      double scale = 1.0;
      if (k != start) {
        p = a[k][k - 1];
        q = a[k + 1][k - 1];
        r = three ? a[k + 2][k - 1] : S(0.0);
        scale = size(p) + size(q) + size(r);
        if (scale == 0.0) continue;
        p = p / scale;
        q = q / scale;
        r = r / scale;
      }
      S s = sqrt(tidy(p * p + q * q + r * r));
      if (leading(s) == 0.0) continue;
      if (leading(p) < 0.0) s = -s;
      if (k != start) {
        a[k][k - 1] = -(s * scale);
      } else if (first != start) {
        a[k][k - 1] = -a[k][k - 1];
      }
      p = tidy(p + s);
      x = p / s;
      y = q / s;
      const S z = r / s;
      q = q / p;
      r = r / p;
      for (std::size_t j = k; j <= last; ++j) {
        S sum = a[k][j] + q * a[k + 1][j];
        if (three) {
          sum = sum + r * a[k + 2][j];
          a[k + 2][j] = tidy(a[k + 2][j] - sum * z);
        }
        a[k + 1][j] = tidy(a[k + 1][j] - sum * y);
        a[k][j] = tidy(a[k][j] - sum * x);
      }
      const std::size_t end = last < k + 3 ? last : k + 3;
      for (std::size_t i = first; i <= end; ++i) {
        S sum = x * a[i][k] + y * a[i][k + 1];
        if (three) {
          sum = sum + z * a[i][k + 2];
          a[i][k + 2] = tidy(a[i][k + 2] - sum * r);
        }
        a[i][k + 1] = tidy(a[i][k + 1] - sum * q);
        a[i][k] = tidy(a[i][k] - sum);
      }
    }
  }
  return true;
}

/// Nothing where it does not converge.
template <class S, std::size_t n>
std::optional<std::array<ComplexOf<S>, n>> shifted_qr(const Square<S, n>& h) {
  constexpr std::size_t most = 10;
  static_assert(n <= most);
  Square<S, most> a;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a[i][j] = h[i][j];
  std::array<ComplexOf<S>, most> values;
  if (!shifted_qr<S, most>(a, n, values)) return std::nullopt;
  std::array<ComplexOf<S>, n> out;
  std::copy_n(values.begin(), n, out.begin());
  return out;
}

}  // namespace stationary
