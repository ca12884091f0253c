#include "solver/stability.hpp"

#include <stdexcept>

#include "solver/model_stability.hpp"

namespace stationary {

Spectrum stability(const Problem& problem, const Equilibrium& equilibrium) {
  if (equilibrium.status != SolveStatus::solved)
    throw std::invalid_argument("a spectrum needs a solved equilibrium");
  return problem.potential().visit([&](const auto& model) {
    return model_stability(problem.body(), problem.branch(), model, equilibrium.q,
                           equilibrium.nu[axis(problem.branch())], equilibrium.error_bound);
  });
}

}  // namespace stationary
