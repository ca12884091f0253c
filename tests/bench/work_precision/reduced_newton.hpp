// The library's own reduced equations by its own parts, called as the peers are
// (four_equations.hpp): Newton in (ln xi, ln zeta) and, where the thickness depends on nu, in ln
// rho, until a step is below `tolerance`; then, if asked for, the correction with a residual in
// extended precision.
#pragma once

#include "solver/motion/problem.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/refine.hpp"

namespace stationary::bench {

enum class Finish { in_double, corrected };

template <class Plane, class Thickness>
struct ReducedNewton {
  const Problem& problem;
  const Separable<Plane, Thickness>& model;
  double tolerance;
  Finish finish;

  /// Flattened, as the sweep is.
  [[gnu::flatten]] bool operator()(const Vector3<double>& nu, Vector4<double>& q) const {
    const double along = nu[axis(problem.branch())];
    const CentrifugalRates<DoubleDouble> rates = problem.rates(two_product(along, along));
    ReducedVector<2> x(q[1], q[2]);
    if (!solved(PlanarSystem<Plane>{model.plane, rates}, x)) return false;
    q[1] = x[0];
    q[2] = x[1];
    if (problem.thickness_rule() == ThicknessRule::constant) return true;
    ReducedVector<1> rho(q[3]);
    if (!solved(ThicknessSystem<Thickness>{model.thickness, rates.rho}, rho)) return false;
    q[3] = rho[0];
    return true;
  }

 private:
  template <class System>
  bool solved(const System& system, ReducedVector<System::dimension>& x) const {
    if (!newton(system, x, {.tolerance = tolerance}).converged) return false;
    return finish == Finish::in_double || refine<false>(system, x).converged;
  }
};

}  // namespace stationary::bench
