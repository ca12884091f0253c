// The decoupled thickness of a separable potential: V_rho'(rho) = m rho, m = J3 (nu1^2 + nu2^2).
//
// Closed form in double, then the common correction (refine.hpp), so rho is rounded correctly even
// where b - m all but vanishes.
#pragma once

#include <variant>

#include "lib/potential.hpp"
#include "solver/refine.hpp"

namespace stationary {

struct ThicknessBalance {
  double rho;  ///< NaN where no solution exists (then `refined` has not converged)
  Refined refined;
};

template <bool bound = true, class Thickness>
ThicknessBalance balanced_thickness(const Thickness& model, const DoubleDouble& m) {
  ReducedVector<1> x(model.balanced(m));
  ThicknessBalance out;
  out.refined = refine<bound>(ThicknessSystem<Thickness>{model, m}, x);
  out.rho = x[0];
  return out;
}

}  // namespace stationary
