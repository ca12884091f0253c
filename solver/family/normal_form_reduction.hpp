// From derivatives of a reduced energy F at an event to its normal form (normal_form.hpp): F_i its
// gradient, K the Hessian on directions of one parity, p the parameter. It is all that isotropic
// bodies (normal_form.cpp) and others (oriented_normal_form.cpp) have in common.
#pragma once

#include <optional>
#include <vector>

#include "lib/number/interval.hpp"
#include "solver/family/normal_form.hpp"

namespace stationary {

using IntervalVector = std::vector<Interval>;
/// Rows.
using IntervalMatrix = std::vector<IntervalVector>;

/// The unit vector v with K v = 0, K symmetric among these matrices and singular once, n >= 2.
std::optional<IntervalVector> null_vector(const IntervalMatrix& K);

/// p - p0 = -F_vvv s^2/(2 F_vp), v turned to where F_vp < 0.
std::optional<NormalForm> fold_form(const Interval& F_vvv, const Interval& F_vp);

/// F_vvvv, the gradient of F_vv in the directions that keep the symmetry, and its derivative in p
/// at fixed x.
struct Breaking {
  Interval vvvv;
  IntervalVector vv_slope;
  Interval vv_parameter;
};
/// K, dG/dp: in these directions.
std::optional<NormalForm> breaking_form(const Breaking& F, const IntervalMatrix& K,
                                        const IntervalVector& slope);

/// normal_form() of a potential that is not isotropic. Nothing where alpha != 0, V is not known to be
/// even in alpha, or the parameter is an angle of fibres.
std::optional<NormalForm> oriented_normal_form(const Problem& problem,
                                               const FamilyParameter& parameter, EventType type,
                                               const Member& member);

}  // namespace stationary
