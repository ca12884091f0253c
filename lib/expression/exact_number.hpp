// Exact numbers as intervals that hold them, each with a residue by which equal ones are known
// (residue.hpp): what has the residue 0 is 0, but for a probability below 1e-30, where its interval holds 0 (the
// residue of a root of a number may have the other sign).
#pragma once

#include <compare>
#include <optional>
#include <stdexcept>

#include "lib/expression/residue.hpp"
#include "lib/number/interval.hpp"

namespace stationary::expression {

/// Of what a normal form (normal_form.hpp) has no room for; the graph itself is bounded then.
class NotNormal : public std::length_error {
  using std::length_error::length_error;
};

/// An exact number, known to lie in an interval and by its residue.
struct ExactNumber {
  Interval value;
  Residue key;

  static ExactNumber whole(int n);
  bool is_zero() const { return key.is_zero() && value.may_be(0.0); }
  bool is_one() const { return key == Residue{1, 1}; }
};

/// x as a whole number, where it is one and not above Graph::largest_exponent.
std::optional<int> as_whole(const ExactNumber& x);
/// Whole numbers are known exactly.
ExactNumber snapped(const ExactNumber& x);

ExactNumber operator+(const ExactNumber& x, const ExactNumber& y);
ExactNumber operator-(const ExactNumber& x);
ExactNumber operator*(const ExactNumber& x, const ExactNumber& y);
/// Throws NotNormal where n < 0 and x is 0.
ExactNumber power(const ExactNumber& x, int n);
/// x > 0.
ExactNumber power(const ExactNumber& x, const ExactNumber& r);
/// x > 0.
ExactNumber logarithm(const ExactNumber& x);
/// |x|. Throws NotNormal where the sign is not known.
ExactNumber magnitude(const ExactNumber& x);
/// Some order, the same for equal numbers however they were made.
std::strong_ordering compare(const ExactNumber& x, const ExactNumber& y);

}  // namespace stationary::expression
