// On the circle of (iii), nu3 > 0 (nu3 < 0 gives the same spectrum): is E'' + c (P - |pi|)''
// definite for some c? P = pi3 + p_alpha (xi - zeta) - 2 alpha (p_xi - p_zeta), the momentum of
// material rotations; pi3 - |pi| = -(pi1^2 + pi2^2)/(2 |pi|).
#pragma once

#include "lib/leaf/symplectic_leaf.hpp"

namespace stationary {

/// For all inputs of relative uncertainty u. leaf: of five pairs.
bool definite_with_momentum(const Leaf& leaf, double u);

}  // namespace stationary
