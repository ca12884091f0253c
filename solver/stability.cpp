#include "solver/stability.hpp"

#include <stdexcept>

#include "solver/model_stability.hpp"

namespace stationary {

Spectrum stability(const Problem& problem, const Equilibrium& equilibrium) {
  if (equilibrium.status != SolveStatus::solved)
    throw std::invalid_argument("a spectrum needs a solved equilibrium");
  const Branch branch = problem.branch();
  const double nu = equilibrium.nu[axis(branch)];
  return problem.potential().visit([&](const auto& model) {
    return model_stability(problem.body(), branch, model,
                           extended_q(problem.body(), branch, model, equilibrium.q, nu), nu,
                           equilibrium.error_bound);
  });
}

}  // namespace stationary
