#include "solver/solve/stability.hpp"

#include <array>
#include <optional>
#include <stdexcept>

#include "solver/motion/model_stability.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"

namespace stationary {
namespace {

/// (xi, zeta, rho) unrounded, where the solve has told it and q is still what it found.
std::optional<std::array<DoubleDouble, 3>> unrounded(const Equilibrium& equilibrium) {
  if (!equilibrium.unrounded) return std::nullopt;
  const Stretch& q = equilibrium.q;
  const auto& [alpha, xi, zeta, rho] = *equilibrium.unrounded;
  if (xi.hi != q.xi || zeta.hi != q.zeta || rho.hi != q.rho) return std::nullopt;
  return std::array{xi, zeta, rho};
}

}  // namespace

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
    const auto q = unrounded(equilibrium);
    return model_stability(problem.body(), branch, model,
                           q ? *q : extended_q(problem.body(), branch, model, equilibrium.q, nu),
                           nu, equilibrium.error_bound);
  });
}

}  // namespace stationary
