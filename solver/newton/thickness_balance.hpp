// The decoupled thickness of a separable potential: V_rho'(rho) = m rho, m = J3 (nu1^2 + nu2^2).
//
// Closed form in double, then the common correction (refine.hpp), so rho is rounded correctly even
// where b - m all but vanishes. An expression may have several solutions: the one connected to its
// rest thickness is taken, or the one Newton reaches from a thickness given.
#pragma once

#include <optional>

#include "lib/material/potential.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

struct ThicknessBalance {
  double rho;   ///< NaN where no solution exists (then `refined` has not converged)
  double tail;  ///< what rounding left of it (refine.hpp)
  Refined refined;
};

/// Whether a model's V' = m rho may have more than one solution.
template <class Model>
constexpr bool several_thicknesses = requires(const Model& model) {
  model.thickness.is_expression();
};

/// What to say of a balance that was not met.
constexpr const char* unbalanced = "did not converge to a solution connected to rest";

/// near: where to begin, used only where there may be several solutions.
template <bool bound = true, class Thickness>
ThicknessBalance balanced_thickness(const Thickness& model, const DoubleDouble& m,
                                    const std::optional<double>& near = {}) {
  const ThicknessSystem<Thickness> system{model, m};
  ReducedVector<1> x(model.balanced(m));
  if constexpr (requires { model.is_expression(); }) {
    ReducedVector<1> y(near.value_or(x[0]));
    if (near && newton(system, y).converged) x = y;
  }
  ThicknessBalance out;
  ReducedVector<1> tail;
  out.refined = refine<bound>(system, x, most_corrections, &tail);
  out.rho = x[0];
  out.tail = tail[0];
  return out;
}

}  // namespace stationary
