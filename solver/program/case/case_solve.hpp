// The table [solve] of a case.
#pragma once

#include <optional>
#include <vector>

#include "solver/program/case/case_file.hpp"

namespace stationary {

/// motion, models: nothing where something else is wrong with them.
Case::Solve read_solve(const CaseTree& tree, const std::optional<Motion>& motion,
                       const std::optional<std::vector<ModelChoice>>& models, Faults& faults);

/// Throws InputError of a start with alpha != 0 where no such motion can have one.
void require_alpha(const CaseTree& tree, const std::optional<Stretch>& start, const Motion& motion,
                   const Potential& potential);

}  // namespace stationary
