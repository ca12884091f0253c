#include "solver/newton/ceres_solve.hpp"

#include <ceres/ceres.h>

#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

template <class System>
struct Residual {
  static constexpr int N = System::dimension;
  System system;
  double inverse_scale;

  template <class T>
  bool operator()(const T* const log_x, T* out) const {
    std::array<T, N> x;
    for (std::size_t i = 0; i < N; ++i) x[i] = exp(log_x[i]);
    const auto g = system.residual(x);
    for (std::size_t i = 0; i < N; ++i) {
      out[i] = g[i] * inverse_scale;
      if (!std::isfinite(leading(out[i]))) return false;
    }
    return true;
  }
};

}  // namespace

std::string version_of_ceres() { return CERES_VERSION_STRING; }

template <class System>
CeresOutcome ceres_solve(const System& system, ReducedVector<System::dimension>& x, int threads) {
  constexpr int N = System::dimension;
  Eigen::Matrix<double, N, 1> log_x = logarithms(x.array());
  ceres::Problem problem;
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual<System>, N, N>(
                               new Residual<System>{system, 1.0 / system.linearize(x).magnitude}),
                           nullptr, log_x.data());
  ceres::Solver::Options options;
  options.minimizer_type = ceres::TRUST_REGION;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.linear_solver_type = ceres::DENSE_QR;
  options.initial_trust_region_radius = 1e4;
  options.max_num_iterations = 200;
  options.max_num_consecutive_invalid_steps = 20;
  options.function_tolerance = 1e-30;
  options.gradient_tolerance = 1e-30;
  options.parameter_tolerance = 1e-16;
  options.num_threads = threads;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  CeresOutcome out;
  out.iterations = static_cast<int>(summary.iterations.size());
  out.residuals = summary.num_residual_evaluations;
  out.jacobians = summary.num_jacobian_evaluations;
  const ReducedVector<N> found = exponentials(log_x.array());
  out.usable = found.allFinite() && found.minCoeff() > 0.0 && summary.IsSolutionUsable();
  if (out.usable) x = found;
  return out;
}

template CeresOutcome ceres_solve(const PlanarSystem<BuiltInPlane<>>&, ReducedVector<2>&, int);
template CeresOutcome ceres_solve(const PlanarSystem<AnyPlane<>>&, ReducedVector<2>&, int);
template CeresOutcome ceres_solve(const CoupledSystem<NeoHookean3d<>>&, ReducedVector<3>&, int);
template CeresOutcome ceres_solve(const CoupledSystem<CoupledExpression<>>&, ReducedVector<3>&,
                                  int);
template CeresOutcome ceres_solve(const CoupledSystem<BodyModel<>>&, ReducedVector<3>&, int);

}  // namespace stationary
