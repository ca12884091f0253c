// Motions with alpha != 0 of an isotropic body (sheared_balance.hpp) as a kind: about an axis in no
// material plane, and with gravity oblique ones and those about axis 3.
#pragma once

#include <memory>

#include "lib/balance/sheared_balance.hpp"
#include "solver/kind/kind.hpp"

namespace stationary {

/// motion: of this axis. nu: its |nu|, about axis 3 of either sign.
std::unique_ptr<Kind> sheared_kind(const Body& body, const Potential& potential, ShearedAxis axis,
                                   const Motion& motion, double nu);

}  // namespace stationary
