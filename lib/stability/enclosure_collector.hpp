// Modes with their enclosures into a SpectrumEnclosure: the class is claimed where every Lambda
// that enters it is decided, as mode_collector.hpp does with error bounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "lib/matrix/characteristic.hpp"
#include "lib/number/interval.hpp"
#include "lib/stability/spectrum_enclosure.hpp"

namespace stationary {

constexpr int unknown = 0;

/// +1, -1, or unknown.
inline int proven_sign(const Interval& x) { return x.positive() ? 1 : x.negative() ? -1 : unknown; }

/// A count that stays known as long as all that enters it is.
class Count {
 public:
  void add(std::optional<int> more) {
    if (more && total_) {
      *total_ += *more;
    } else {
      total_.reset();
    }
  }
  /// One for a negative x, none for a positive one.
  void add_if_negative(const Interval& x) {
    const int sign = proven_sign(x);
    add(sign == unknown ? std::nullopt : std::optional(sign < 0 ? 1 : 0));
  }
  const std::optional<int>& total() const { return total_; }

 private:
  std::optional<int> total_ = 0;
};

/// Negative eigenvalues of [a b; b c], b^2 = a c - det.
inline std::optional<int> negatives_2(const Interval& a, const Interval& c, const Interval& det) {
  const int sign = proven_sign(det);
  if (sign == unknown) return std::nullopt;
  if (sign < 0) return 1;
  // Both diagonal entries have one sign.
  for (const Interval& each : {c, a, a + c})
    if (const int of = proven_sign(each); of != unknown) return of < 0 ? 2 : 0;
  return std::nullopt;
}

template <std::size_t n>
using IntervalForm = SquareForm<Interval, n>;

/// Negative eigenvalues of a symmetric F of rank `rank`, by Sylvester's law, the largest pivot
/// first; nothing where a pivot has no sign. pivots: their product, that is det F where the rank is n.
template <class S, std::size_t n>
std::optional<int> negative_directions(SquareForm<S, n> F, std::size_t rank = n,
                                       S* pivots = nullptr) {
  std::array<std::size_t, n> order;
  for (std::size_t k = 0; k < n; ++k) order[k] = k;
  int count = 0;
  S all(1.0);
  for (std::size_t a = 0; a < rank; ++a) {
    std::iter_swap(
        order.begin() + a,
        std::max_element(order.begin() + a, order.end(), [&](std::size_t i, std::size_t j) {
          return range(F[i][i]).mignitude() < range(F[j][j]).mignitude();
        }));
    const std::size_t k = order[a];
    const int sign = proven_sign(range(F[k][k]));
    if (sign == unknown) return std::nullopt;
    count += sign < 0;
    all = all * F[k][k];
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = a + 1; c < n; ++c)
        F[order[b]][order[c]] -= F[order[b]][k] * F[k][order[c]] / F[k][k];
  }
  if (pivots != nullptr) *pivots = all;
  return count;
}

/// Of each coefficient.
template <class S, int D>
Polynomial<Interval, D> ranges(const Polynomial<S, D>& p) {
  Polynomial<Interval, D> out;
  for (std::size_t k = 0; k <= D; ++k) out.c[k] = range(p.c[k]);
  return out;
}

/// What the signs of its coefficients tell of the roots of a polynomial, c_D = 1: +1 where one is real
/// and positive, -1 where all are negative, nothing where neither is known. all_real: they are known to be;
/// then as many are positive as the coefficients change their sign (Descartes).
template <int D>
int sign_of_roots(const Polynomial<Interval, D>& p, bool all_real) {
  if (p.c[0].negative()) return 1;
  if (!all_real) return unknown;
  bool all_positive = true;
  for (const Interval& c : p.c) {
    if (c.negative()) return 1;
    all_positive = all_positive && c.positive();
  }
  return all_positive ? -1 : unknown;
}

/// Enclosed modes into what is proven of them together.
class EnclosureCollector {
 public:
  Count negative;

  /// Imaginary where Lambda < 0, with this Krein signature (unknown: 0).
  void add(const RootEnclosure& root, int krein_if_imaginary, bool semisimple) {
    lambda_.push_back(root.z);
    if (!root.real()) {
      const bool complex = root.simple && !root.z.im.may_be(0.0);
      decided_ = decided_ && complex;
      complex_ = complex_ || complex;
      return;
    }
    const int sign = proven_sign(root.z.re);
    decided_ = decided_ && sign != unknown && (root.simple || semisimple);
    if (sign > 0) real_ = true;
    if (sign < 0) {
      definite_ = definite_ && krein_if_imaginary > 0;
      indefinite_ = indefinite_ || krein_if_imaginary < 0;
    }
  }
  void add_real(const Interval& lambda, int krein_if_imaginary) {
    add({{lambda, 0.0}, true}, krein_if_imaginary, true);
  }
  /// A real one whose sign is known, though the enclosure may not tell.
  void add_of_sign(const Interval& lambda, int sign, int krein_if_imaginary) {
    const Interval side = sign > 0 ? Interval(0.0, std::max(lambda.hi, 0.0))
                                   : Interval(std::min(lambda.lo, 0.0), 0.0);
    lambda_.push_back({lambda.apart_from(side) ? side : common(lambda, side), 0.0});
    if (sign > 0) {
      real_ = true;
    } else {
      definite_ = definite_ && krein_if_imaginary > 0;
      indefinite_ = indefinite_ || krein_if_imaginary < 0;
    }
  }
  void add_forced_zero() { lambda_.push_back({}); }
  /// Spectrum's: E'' + c (P -+ |pi|)'' is definite for some c though E'' is not.
  void set_definite_with_momentum() { definite_with_momentum_ = true; }
  /// Whether there is such a c is not decided: stable or elliptic is not told apart.
  void set_momentum_open() { momentum_open_ = true; }
  /// One of the Lambda is real and positive, whichever it is.
  void set_growing() { real_ = true; }
  /// E'' is definite: the motion is stable, whatever of the Lambda is decided.
  void set_definite() { proven_definite_ = true; }
  /// E'' has negative directions, whichever modes they are of.
  void set_indefinite() {
    indefinite_ = true;
    definite_ = false;
  }

  SpectrumEnclosure finish(const Spectrum& approximate) const {
    SpectrumEnclosure out;
    out.modes = static_cast<int>(lambda_.size());
    out.negative = negative.total();
    assign(approximate, out);
    if (proven_definite_) {
      out.verdict = StabilityClass::stable;
    } else if (real_) {
      out.verdict = StabilityClass::unstable;
    } else if (decided_ && complex_) {
      out.verdict = StabilityClass::oscillatory;
    } else if (decided_ && (definite_ || definite_with_momentum_)) {
      out.verdict = StabilityClass::stable;
    } else if (decided_ && indefinite_ && !momentum_open_) {
      out.verdict = StabilityClass::elliptic;
    }
    return out;
  }

 private:
  /// To each enclosure the approximate mode nearest to it, the narrowest first: a wide one may hold several.
  /// A complex one stands for the whole quadruple, with im >= 0.
  void assign(const Spectrum& approximate, SpectrumEnclosure& out) const {
    std::vector<ComplexInterval> all = lambda_;
    std::ranges::stable_sort(all, {}, [](const ComplexInterval& each) {
      return (each.re.hi - each.re.lo) + (each.im.hi - each.im.lo);
    });
    std::vector<std::size_t> left;
    for (int k = 0; k < out.modes && k < approximate.modes; ++k)
      left.push_back(static_cast<std::size_t>(k));
    for (ComplexInterval& each : all) {
      if (left.empty()) return;
      if (each.im.negative()) each.im = -each.im;
      const auto nearest = std::ranges::min_element(left, {}, [&](std::size_t k) {
        const Mode& mode = approximate.mode[k];
        return std::abs(each.re.mid() - mode.lambda_re) + std::abs(each.im.mid() - mode.lambda_im);
      });
      out.lambda[*nearest] = each;
      left.erase(nearest);
    }
  }

  std::vector<ComplexInterval> lambda_;
  bool real_ = false;
  bool complex_ = false;
  bool decided_ = true;
  bool definite_ = true;
  bool indefinite_ = false;
  bool definite_with_momentum_ = false;
  bool momentum_open_ = false;
  bool proven_definite_ = false;
};

}  // namespace stationary
