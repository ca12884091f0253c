// The table [motion] of a case.
#pragma once

#include <optional>
#include <vector>

#include "lib/body/body.hpp"
#include "lib/body/motion.hpp"
#include "solver/program/case/case_potential.hpp"
#include "solver/program/case/case_toml.hpp"

namespace stationary {

/// body, models: nothing where something else is wrong with them. Throws InputError.
Motion read_motion(const CaseTree& tree, const std::optional<Body>& body,
                   const std::optional<std::vector<ModelChoice>>& models);

}  // namespace stationary
