// A function of u in [-1, 1] by its range, its value at 0 and its slope:
//
//   f(u) in over,   f(0) in at,   f(u) - f(0) in slope u,
//
// so that f(u) is in at + slope [-1, 1] as well: of a difference whose terms vary alike that is much
// narrower than their ranges'. Slopes as R. Krawczyk, A. Neumaier, SIAM J. Numer. Anal. 22 (1985)
// 604.
#pragma once

#include "lib/number/interval.hpp"

namespace stationary {

class Sloped {
 public:
  Sloped() : Sloped(0.0) {}
  Sloped(double x) : over_(x), at_(x), slope_(0.0) {}  // NOLINT(google-explicit-constructor)
  /// A number known in an interval, whatever u.
  Sloped(const Interval& x) : over_(x), at_(x), slope_(0.0) {}  // NOLINT
  Sloped(const Interval& over, const Interval& at, const Interval& slope)
      : over_(over), at_(at), slope_(slope) {
    const Interval centered = at_ + slope_ * Interval(-1.0, 1.0);
    if (centered.bounded() && !centered.apart_from(over_)) over_ = common(over_, centered);
  }

  const Interval& range() const { return over_; }

  friend Sloped operator+(const Sloped& x, const Sloped& y) {
    return {x.over_ + y.over_, x.at_ + y.at_, x.slope_ + y.slope_};
  }
  friend Sloped operator-(const Sloped& x) { return {-x.over_, -x.at_, -x.slope_}; }
  friend Sloped operator-(const Sloped& x, const Sloped& y) {
    return {x.over_ - y.over_, x.at_ - y.at_, x.slope_ - y.slope_};
  }
  friend Sloped operator*(const Sloped& x, const Sloped& y) {
    return {x.over_ * y.over_, x.at_ * y.at_, x.slope_ * y.over_ + x.at_ * y.slope_};
  }
  friend Sloped operator*(double a, const Sloped& x) {
    return {a * x.over_, a * x.at_, a * x.slope_};
  }
  friend Sloped operator/(const Sloped& x, const Sloped& y) {
    const Interval quotient = x.at_ / y.at_;
    return {x.over_ / y.over_, quotient, (x.slope_ - quotient * y.slope_) / y.over_};
  }
  friend Sloped& operator+=(Sloped& x, const Sloped& y) { return x = x + y; }
  friend Sloped& operator-=(Sloped& x, const Sloped& y) { return x = x - y; }
  friend Sloped square(const Sloped& x) {
    return {square(x.over_), square(x.at_), x.slope_ * (x.over_ + x.at_)};
  }
  friend Sloped sqrt(const Sloped& x) {
    const Interval over = sqrt(x.over_);
    const Interval at = sqrt(x.at_);
    return {over, at, x.slope_ / (over + at)};
  }

 private:
  Interval over_;
  Interval at_;
  Interval slope_;
};

inline double leading(const Sloped& x) { return x.range().mid(); }

/// Where a number may lie.
inline const Interval& range(const Interval& x) { return x; }
inline const Interval& range(const Sloped& x) { return x.range(); }

}  // namespace stationary
