#include "solver/solve/stability.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "solver/motion/model_stability.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"

namespace stationary {
namespace {

/// (xi, zeta, rho) with what rounding left of them, where the solve has told it and they still are
/// what it found.
std::optional<std::array<DoubleDouble, 3>> extended(const Equilibrium& equilibrium) {
  const Stretch& q = equilibrium.q;
  const std::array<DoubleDouble, 3> out{DoubleDouble(q.xi, equilibrium.tail[0]),
                                        DoubleDouble(q.zeta, equilibrium.tail[1]),
                                        DoubleDouble(q.rho, equilibrium.tail[2])};
  for (const DoubleDouble& x : out)
    if (!(std::abs(x.lo) <= 0x1p-52 * x.hi)) return std::nullopt;
  return out;
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
    const auto q = extended(equilibrium);
    return model_stability(problem.body(), branch, model,
                           q ? *q : extended_q(problem.body(), branch, model, equilibrium.q, nu),
                           nu, equilibrium.error_bound);
  });
}

}  // namespace stationary
