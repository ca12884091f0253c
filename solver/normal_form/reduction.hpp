// From derivatives of a reduced energy F at an event to its normal form (normal_form.hpp). F is known
// by its gradient along lines: at the event and s times a direction d away from it, the parameter at
// p0 + c s, p in units of its own size. It is all that the kinds of motion have in common here.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "lib/number/interval.hpp"
#include "lib/number/taylor.hpp"
#include "solver/normal_form/normal_form.hpp"

namespace stationary {

/// A number along a line, to the third order in s.
using AlongLine = Taylor<Interval, 3>;
/// A direction, or one number for each coordinate.
using IntervalVector = std::vector<Interval>;
/// Rows.
using IntervalMatrix = std::vector<IntervalVector>;
/// Of F, one number for each coordinate.
using GradientAlong = std::function<std::vector<AlongLine>(const IntervalVector& d, double c)>;
using NumberAlong = std::function<AlongLine(const IntervalVector& d, double c)>;

/// A number of a located member, with its error.
inline Interval about(double x, const Member& member) {
  return Interval(1.0 - 2.0 * member.error_bound, 1.0 + 2.0 * member.error_bound) * x;
}
/// The family's parameter, p + c s in units of its size.
class NearParameter {
 public:
  explicit NearParameter(const Member& at)
      : value_(about(at.parameter, at)),
        size_(at.parameter != 0.0 ? std::abs(at.parameter) : 1.0) {}

  AlongLine along(double c) const { return AlongLine::along(value_, Interval(c * size_)); }

 private:
  Interval value_;
  double size_;
};

/// n directions of unit length, each along one of these coordinates of `dimension`.
std::vector<IntervalVector> along_coordinates(const std::vector<std::size_t>& places,
                                              std::size_t dimension);

/// The unit vector v with K v = 0, K symmetric among these matrices and singular once, n >= 2.
std::optional<IntervalVector> null_vector(const IntervalMatrix& K);

/// Row i, column j: the derivative along basis j of the component along basis i.
IntervalMatrix stiffness(const GradientAlong& gradient, const std::vector<IntervalVector>& basis);

/// p - p0 = -F_vvv s^2/(2 F_vp), v among the directions that `kept`, orthonormal, spans, turned to
/// where F_vp < 0.
std::optional<NormalForm> fold_form(const GradientAlong& gradient,
                                    const std::vector<IntervalVector>& kept);

/// v: the direction that breaks the symmetry which those of `kept` keep.
std::optional<NormalForm> breaking_form(const GradientAlong& gradient, const IntervalVector& v,
                                        const std::vector<IntervalVector>& kept);

/// The same where F has its angle s from what it is at s = 0 as F_vv sin^2(s)/2 alone: F_vvvv is 0
/// where F_vv is.
std::optional<NormalForm> turning_form(const GradientAlong& gradient, const NumberAlong& F_vv,
                                       const std::vector<IntervalVector>& kept);

/// A located event can be told of: its bound is small, and it is no motion at rest.
bool is_known(const Member& member);

}  // namespace stationary
