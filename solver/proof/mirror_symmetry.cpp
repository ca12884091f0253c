#include "solver/proof/certify.hpp"

namespace stationary {

bool mirror_symmetric(const Problem& problem, double nu) {
  if (!problem.potential().is_isotropic()) return false;
  const BodyModel<>* body = problem.potential().body_model();
  const bool sees_no_axes = body == nullptr || body->isotropic();
  return (nu == 0.0 && sees_no_axes) ||
         (problem.branch() == Branch::iii && problem.body().symmetric());
}

}  // namespace stationary
