// The spectrum of a solved equilibrium (model_stability.hpp) of any potential.
#pragma once

#include "lib/stability/spectrum.hpp"
#include "solver/motion/problem.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// Throws std::invalid_argument unless the equilibrium is solved. Its error_bound (NaN counts as
/// 1e-15) is the uncertainty of the inputs that bounds and classes allow for.
Spectrum stability(const Problem& problem, const Equilibrium& equilibrium);

}  // namespace stationary
