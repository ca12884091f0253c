// normal_form() of a spin about a material axis, of a potential that is not isotropic.
#pragma once

#include <optional>

#include "solver/motion/problem.hpp"
#include "solver/normal_form/normal_form.hpp"

namespace stationary {

/// Nothing where the parameter is an angle of fibres, or several materials' common number.
std::optional<NormalForm> oriented_normal_form(const Problem& problem,
                                               const FamilyParameter& parameter, EventType type,
                                               const Member& member);

}  // namespace stationary
