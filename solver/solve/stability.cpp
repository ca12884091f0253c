#include "solver/solve/stability.hpp"

#include <stdexcept>

#include "solver/motion/model_stability.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"

namespace stationary {

Spectrum stability(const Problem& problem, const Equilibrium& equilibrium) {
  if (equilibrium.status != SolveStatus::solved)
    throw std::invalid_argument("a spectrum needs a solved equilibrium");
  if (!problem.potential().is_isotropic()) {
    const auto out = anisotropic_stability(problem, equilibrium);
    if (!out) throw std::invalid_argument("a spectrum needs a solved equilibrium");
    return *out;
  }
  const Branch branch = problem.branch();
  const double nu = equilibrium.nu[axis(branch)];
  return problem.potential().visit_parts([&](const auto& model) {
    return model_stability(problem.body(), branch, model,
                           extended_q(problem.body(), branch, model, equilibrium.q, nu), nu,
                           equilibrium.error_bound);
  });
}

}  // namespace stationary
