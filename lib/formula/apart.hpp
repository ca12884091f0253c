// A coupled potential that is a sum of one of the plane and one of the thickness, as these two:
//
//   V(q) = V_plane(alpha, xi, zeta) + V_rho(rho)
//
// Addends go where their variables are. One that has both, as log(d rho), is V(S, 1) + V(1, rho) -
// V(1, 1): its values at rho = 1 and in the plane at S = 1.
#pragma once

#include <optional>

#include "lib/formula/expression.hpp"

namespace stationary::expression {

struct PlaneAndThickness {
  Expression plane;
  Expression thickness;  ///< both with the parameters of the whole
};

/// Of a separable expression (facts.hpp). Nothing where a part would be constant, where their sum
/// is not found to be the whole, or where a condition of its domain is one of both.
std::optional<PlaneAndThickness> taken_apart(const Expression& whole);

}  // namespace stationary::expression
