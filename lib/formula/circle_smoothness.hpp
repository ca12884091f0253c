// Where a potential of t, d, I1 and the principal stretches is smooth at the circle lambda = mu.
// Symmetry alone does not make it so: sqrt((lambda - mu)^2) is the same with lambda and mu
// exchanged and has a kink there; a solve needs the second derivatives.
#pragma once

#include "lib/formula/expression.hpp"

namespace stationary::expression {

/// Throws Unsuitable where sqrt, log, a quotient or a power of exponent not known to be above 2 is
/// taken of something that vanishes on all of the circle. Parts with alpha, xi or zeta pass.
void require_smooth_at_circle(Expression& expression);

}  // namespace stationary::expression
