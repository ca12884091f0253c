// How far an eigenvalue of the chain
//
//     [ a  d  0 ]
//     [ d  b  e ]      p(Lambda) = det(chain + Lambda) = 0
//     [ 0  e  c ]
//
// moves with a, b, c, d^2, e^2: sum |dp/dx| |change of x| over |p'(Lambda)|, and 2 |change|^2/gap of second
// order (the change of the matrix as a whole, the distance to the nearest other root), which holds where
// the change is small beside that distance. Of any root: Weyl's bound.
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/balanced/balanced_blocks.hpp"
#include "lib/number/first_order_bound.hpp"

namespace stationary {

/// For Conditioned entries, each uncertain by u (|x| + its condition).
class ChainBound {
 public:
  ChainBound(const ChainEntries<Conditioned>& at, double u) : at_(at) {
    const auto error = [&](const Conditioned& x) { return u * (x.condition + std::abs(x.value)); };
    a_ = error(at.a);
    b_ = error(at.b);
    c_ = error(at.c);
    d2_ = error(at.d2);
    e2_ = error(at.e2);
    // |d|'s change of d^2's: where d = 0 it has none.
    const double d = at.d2.value > 0.0 ? d2_ * d2_ / at.d2.value : 0.0;
    const double e = at.e2.value > 0.0 ? e2_ * e2_ / at.e2.value : 0.0;
    square_ = a_ * a_ + b_ * b_ + c_ * c_ + 0.5 * (d + e);
  }

  /// Of a root with p' = slope, the nearest other gap away.
  double operator()(double root, double slope, double gap) const {
    constexpr double rounding = 0x1p-50;
    const double a = at_.a.value + root;
    const double b = at_.b.value + root;
    const double c = at_.c.value + root;
    const auto minor = [](double x, double y, double square) {
      return std::abs(x * y - square) + rounding * (std::abs(x * y) + square);
    };
    const double first = minor(b, c, at_.e2.value) * a_ + std::abs(a * c) * b_ +
                         minor(a, b, at_.d2.value) * c_ + std::abs(c) * d2_ + std::abs(a) * e2_;
    return first / std::abs(slope) + 2.0 * square_ / gap + 0x1p-53 * std::abs(root);
  }
  /// Whether that is a bound.
  bool resolves(double gap) const { return 256.0 * square_ < gap * gap; }

  /// Of any root.
  double largest() const {
    const double d = change_of_root(at_.d2.value, d2_);
    const double e = change_of_root(at_.e2.value, e2_);
    return std::max({a_ + d, b_ + d + e, c_ + e});
  }

 private:
  static double change_of_root(double square, double change) {
    return square > 0.0 ? change / std::sqrt(square) : 0.0;
  }

  ChainEntries<Conditioned> at_;
  double a_, b_, c_, d2_, e2_;
  double square_;
};

}  // namespace stationary
