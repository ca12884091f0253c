#include "solver/equilibrium_row.hpp"

#include <limits>

#include "lib/inertia.hpp"

namespace stationary {

void fill_row(const Problem& problem, const Equilibrium& equilibrium, TableRow& row) {
  const Stretch& q = equilibrium.q;
  const Vector3<double>& nu = equilibrium.nu;
  row.branch = name(problem.branch());
  row[Column::nu1] = nu[0];
  row[Column::nu2] = nu[1];
  row[Column::nu3] = nu[2];
  row[Column::alpha] = q.alpha;
  row[Column::xi] = q.xi;
  row[Column::zeta] = q.zeta;
  row[Column::rho] = q.rho;
  const PrincipalStretches principal = principal_stretches(q);
  row[Column::lambda] = principal.lambda;
  row[Column::mu] = principal.mu;
  row[Column::angle] = principal.theta.value_or(std::numeric_limits<double>::quiet_NaN());
  const Vector3<double> pi = locked_inertia(problem.body(), q) * nu;
  row[Column::pi1] = pi[0];
  row[Column::pi2] = pi[1];
  row[Column::pi3] = pi[2];
  row[Column::energy] = energy(problem.body(), problem.potential(), q, nu);
  row[Column::residual] = equilibrium.residual;
  row[Column::compatibility] = equilibrium.compatibility;
  row[Column::error_bound] = equilibrium.error_bound;
}

}  // namespace stationary
