// Newton's method in ln x with the analytic Jacobian, in double: brings a start near enough for
// refine(), which ends every solve. A step is cut to max |delta| <= max_log_step, nothing else is
// globalized: where it fails, Ceres or a walk is the tool.
#pragma once

#include "solver/newton/refine.hpp"

namespace stationary {

struct NewtonOptions {
  int max_steps = 60;
  double max_log_step = 1.0;
  double tolerance = 0x1p-26;  ///< on max |delta|
};

struct NewtonResult {
  bool converged = false;
  int steps = 0;
};

/// x in place; on failure the last finite iterate.
template <class System>
NewtonResult newton(const System& system, ReducedVector<System::dimension>& x,
                    const NewtonOptions& options = {}) {
  constexpr int N = System::dimension;
  NewtonResult out;
  while (out.steps < options.max_steps) {
    const auto at = system.linearize(x);
    const ReducedVector<N> step = at.jacobian.inverse() * at.g;
    const double size = largest_magnitude<N>(step);
    if (!std::isfinite(size)) return out;
    ++out.steps;
    x = moved<N>(x, step, size > options.max_log_step ? -options.max_log_step / size : -1.0);
    if (size <= options.tolerance) {
      out.converged = true;
      return out;
    }
  }
  return out;
}

}  // namespace stationary
