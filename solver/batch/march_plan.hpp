// The steps of a march (march.hpp) to given nu: all of them in order of |nu|, and between
// them, and on the way from rest, as many as the predictor needs.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "solver/batch/march.hpp"

namespace stationary {

struct MarchPlan {
  std::vector<MarchStep> steps;   ///< the first at s = 0
  std::vector<double> s;          ///< of the outputs, ascending: different |nu|
  std::vector<std::size_t> slot;  ///< of each nu
};

/// nu finite.
MarchPlan march_plan(std::span<const double> nu);

}  // namespace stationary
