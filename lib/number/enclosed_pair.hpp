// A pair of doubles with a bound of its error, for proofs that need more digits than an interval of
// doubles keeps:
//
//   |value - exact| <= error.
//
// Each operation adds what double_double.hpp says it may be wrong by, the bound itself rounded up.
#pragma once

#include <cmath>

#include "lib/number/double_double.hpp"
#include "lib/number/interval.hpp"

namespace stationary {

class EnclosedPair {
 public:
  EnclosedPair(double exact = 0.0) : value_(exact) {}  // NOLINT(google-explicit-constructor)

  /// Entire where something overflowed.
  Interval interval() const {
    const Interval out = Interval(value_.hi) + Interval(value_.lo) + Interval(-error_, error_);
    return out.bounded() ? out : Interval::entire();
  }

  friend EnclosedPair operator-(const EnclosedPair& x) { return {-x.value_, x.error_}; }
  friend EnclosedPair operator+(const EnclosedPair& x, const EnclosedPair& y) {
    return {x.value_ + y.value_,
            x.error_ + y.error_ + sum_rounding * (x.size() + y.size()) + underflow};
  }
  friend EnclosedPair operator*(const EnclosedPair& x, const EnclosedPair& y) {
    const double product = x.size() * y.size();
    return {x.value_ * y.value_, x.size() * y.error_ + y.size() * x.error_ + x.error_ * y.error_ +
                                     product_rounding * product + underflow};
  }
  friend EnclosedPair operator/(const EnclosedPair& x, double y) {
    const double quotient = x.size() / std::abs(y);
    return {x.value_ / DoubleDouble(y),
            x.error_ / std::abs(y) + product_rounding * quotient + underflow};
  }
  friend EnclosedPair& operator+=(EnclosedPair& x, const EnclosedPair& y) { return x = x + y; }

 private:
  static constexpr double sum_rounding = 0x1p-103;
  static constexpr double product_rounding = 0x1p-100;
  static constexpr double underflow = 0x1p-960;  ///< what is below the range of doubles

  EnclosedPair(const DoubleDouble& value, double error)
      : value_(renormalized(value)), error_((1.0 + 0x1p-48) * error) {}
  /// Not below |value|.
  double size() const { return (1.0 + 0x1p-50) * std::abs(value_.hi); }

  DoubleDouble value_;
  double error_ = 0.0;
};

}  // namespace stationary
