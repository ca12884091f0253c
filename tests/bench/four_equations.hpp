// Peers of the library's solvers: the balance F(q, nu) = 0 as four equations in (alpha, xi, zeta,
// rho), as one would put them without reducing them first, solved by
//   Newton4x4     Newton, Eigen's partialPivLu, analytic Jacobian
//   TinySolver    ceres::TinySolver, derivatives by Jets
//   CeresSolve    ceres::Solve (Levenberg-Marquardt, dense QR), derivatives by Jets
// Each is called as solve(nu, x), x in place; false: not converged. The formulas are lib's.
#pragma once

#include <ceres/ceres.h>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <Eigen/LU>

#include "lib/balance/balance.hpp"

namespace stationary::bench {

template <class Model>
struct FourResiduals {
  const Body& body;
  const Model& model;
  Vector3<double> nu;

  template <class T>
  bool operator()(const T* const q, T* out) const {
    const BasicStretch<T> stretch{q[0], q[1], q[2], q[3]};
    const Vector3<T> rate = nu.cast<T>();
    const Vector4<T> F = balance_residual(body, model, stretch, rate);
    for (int i = 0; i < 4; ++i) out[i] = F[i];
    return true;
  }
};

template <class Model>
struct Newton4x4 {
  const Body& body;
  const Model& model;
  double tolerance;  ///< on max |delta q|

  bool operator()(const Vector3<double>& nu, Vector4<double>& x) const {
    const Matrix4<double> C = centrifugal_matrix(body, nu);
    for (int step = 0; step < 20; ++step) {
      const auto v = potential_derivatives<2>(model, Stretch::from(x));
      const Vector4<double> F = v.gradient - C * x;
      const Vector4<double> delta = (v.hessian - C).partialPivLu().solve(F);
      x -= delta;
      if (delta.cwiseAbs().maxCoeff() <= tolerance) return true;
    }
    return false;
  }
};

template <class Model>
class TinySolver {
 public:
  /// function_tolerance: on the change of the cost, absolute; by default Ceres' own, which ends
  /// most sweeps after one step.
  TinySolver(const Body& body, const Model& model, double tolerance,
             double function_tolerance = 1e-6)
      : body_(body), model_(model) {
    solver_.options.gradient_tolerance = 1e-30;
    solver_.options.function_tolerance = function_tolerance;
    solver_.options.parameter_tolerance = tolerance;
    solver_.options.cost_threshold = 1e-32;
    solver_.options.initial_trust_region_radius = 1e12;
  }
  /// Flattened: what the compiler inlines of it would otherwise depend on how much else there is
  /// (measured: 2 times; 4x4 Newton and hybrj are faster as they are).
  [[gnu::flatten]] bool operator()(const Vector3<double>& nu, Vector4<double>& x) {
    const FourResiduals<Model> residuals{body_, model_, nu};
    solver_.Solve(Function(residuals), &x);
    return x.allFinite();
  }

 private:
  using Function = ceres::TinySolverAutoDiffFunction<FourResiduals<Model>, 4, 4>;
  const Body& body_;
  const Model& model_;
  ceres::TinySolver<Function> solver_;
};

template <class Model>
struct CeresSolve {
  const Body& body;
  const Model& model;
  double tolerance;  ///< parameter_tolerance

  bool operator()(const Vector3<double>& nu, Vector4<double>& x) const {
    using Residuals = FourResiduals<Model>;
    ceres::Problem problem;
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<Residuals, 4, 4>(new Residuals{body, model, nu}), nullptr,
        x.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.function_tolerance = 1e-30;
    options.gradient_tolerance = 1e-30;
    options.parameter_tolerance = tolerance;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return summary.IsSolutionUsable();
  }
};

}  // namespace stationary::bench
