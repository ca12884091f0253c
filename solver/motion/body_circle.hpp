// The circle (body/circle.hpp) that figures of a body may be.
#pragma once

#include "lib/body/circle.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// About the branch's axis, at every value of the parameter. That V is symmetric in rho and another
/// stretch is seen at points, to 20 digits.
Circle circle_of(const Problem& problem, const FamilyParameter& parameter = {});

}  // namespace stationary
