// In the place of ceres_solve.cpp where there is no Ceres Solver: its Levenberg-Marquardt method with its default
// numbers, step by step, so that a start leads to the solution it leads to with Ceres:
//
//   (J' J + D' D / radius) step = -J' G,   D = diag(J' J) within 1e-6 ... 1e32,
//   columns of J scaled by 1 / (1 + norm);  the radius grows as the model proves right.
//
// Rounding differs from Ceres', and what is answered does not depend on it: it is corrected once more
// (solver/solve/reduced_solve.hpp).
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/newton/ceres_solve.hpp"

namespace stationary {

std::string version_of_ceres() { return {}; }

template <class System>
CeresOutcome ceres_solve(const System& system, ReducedVector<System::dimension>& x, int) {
  constexpr int N = System::dimension;
  using Vector = Eigen::Matrix<double, N, 1>;
  using Square = Eigen::Matrix<double, N, N>;
  constexpr int most_iterations = 100;
  constexpr double least_decrease = 1e-3;
  constexpr double largest_radius = 1e16;
  constexpr double least_radius = 1e-32;

  CeresOutcome out;
  struct Point {
    Vector log_x;
    Vector residual;
    Square jacobian;
    double cost;
  };
  double scale = 0.0;
  const auto at = [&](const Vector& log_x) {
    ReducedVector<N> stretches;
    for (int k = 0; k < N; ++k) stretches[k] = exp(log_x[k]);
    const auto linearized = system.linearize(stretches);
    if (scale == 0.0) scale = linearized.magnitude;
    Point point{log_x, {}, {}, 0.0};
    for (int i = 0; i < N; ++i) {
      point.residual[i] = linearized.g[i] / scale;
      for (int k = 0; k < N; ++k) point.jacobian(i, k) = linearized.jacobian(i, k) / scale;
    }
    point.cost = 0.5 * point.residual.squaredNorm();
    ++out.residuals;
    ++out.jacobians;
    return point;
  };

  Vector start;
  for (int k = 0; k < N; ++k) start[k] = log(x[k]);
  Point here = at(start);
  if (!std::isfinite(here.cost)) return out;
  const double first_cost = here.cost;
  Vector columns;
  for (int k = 0; k < N; ++k) columns[k] = 1.0 / (1.0 + here.jacobian.col(k).norm());
  double radius = 1e4;
  double shrink = 2.0;
  while (out.iterations < most_iterations && radius > least_radius) {
    ++out.iterations;
    const Square J = here.jacobian * columns.asDiagonal();
    Square normal = J.transpose() * J;
    for (int k = 0; k < N; ++k) normal(k, k) += std::clamp(normal(k, k), 1e-6, 1e32) / radius;
    const Vector scaled = -normal.inverse() * (J.transpose() * here.residual);
    const Vector step = columns.asDiagonal() * scaled;
    const Vector linear = here.jacobian * step;
    const double predicted = -linear.dot(here.residual + 0.5 * linear);
    if (!(predicted > 0.0) || !(step.norm() > 1e-16)) break;
    const Point next = at(here.log_x + step);
    const double gained = (here.cost - next.cost) / predicted;
    if (std::isfinite(next.cost) && gained > least_decrease) {
      const bool tiny = here.cost - next.cost <= 1e-32 * here.cost;
      here = next;
      radius =
          std::min(largest_radius, radius / std::max(1.0 / 3.0, 1.0 - pow(2.0 * gained - 1.0, 3)));
      shrink = 2.0;
      if (tiny || here.cost == 0.0) break;
    } else {
      radius /= shrink;
      shrink *= 2.0;
    }
  }
  if (!(here.cost <= first_cost)) return out;
  for (int k = 0; k < N; ++k) x[k] = exp(here.log_x[k]);
  out.usable = true;
  return out;
}

template CeresOutcome ceres_solve(const PlanarSystem<BuiltInPlane<>>&, ReducedVector<2>&, int);
template CeresOutcome ceres_solve(const PlanarSystem<AnyPlane<>>&, ReducedVector<2>&, int);
template CeresOutcome ceres_solve(const CoupledSystem<NeoHookean3d<>>&, ReducedVector<3>&, int);
template CeresOutcome ceres_solve(const CoupledSystem<CoupledExpression<>>&, ReducedVector<3>&,
                                  int);
template CeresOutcome ceres_solve(const CoupledSystem<BodyModel<>>&, ReducedVector<3>&, int);

}  // namespace stationary
