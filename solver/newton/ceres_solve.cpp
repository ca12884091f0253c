#include "solver/newton/ceres_solve.hpp"

#include <ceres/ceres.h>

#include <algorithm>

#include "lib/matrix/elementwise.hpp"
#include "solver/newton/available_threads.hpp"

namespace stationary {
namespace {

/// G/s and its Jacobian in ln x, as every other method has them.
template <class System>
class Residual final : public ceres::SizedCostFunction<System::dimension, System::dimension> {
 public:
  static constexpr int N = System::dimension;

  Residual(const System& system, double scale) : system_(&system), inverse_scale_(1.0 / scale) {}

  bool Evaluate(const double* const* log_x, double* g, double** jacobians) const override {
    const ReducedVector<N> x = exponentials(Eigen::Map<const ReducedVector<N>>(log_x[0]).array());
    const Linearized<N> at = system_->linearize(x);
    const ReducedVector<N> scaled = inverse_scale_ * at.g;
    std::copy_n(scaled.data(), N, g);
    if (jacobians == nullptr || jacobians[0] == nullptr) return scaled.allFinite();
    const Eigen::Matrix<double, N, N> jacobian = inverse_scale_ * at.jacobian.matrix();
    std::copy_n(jacobian.data(), N * N, jacobians[0]);  // symmetric: its rows are its columns
    return scaled.allFinite() && jacobian.allFinite();
  }

 private:
  const System* system_;
  double inverse_scale_;
};

}  // namespace

std::string version_of_ceres() { return CERES_VERSION_STRING; }

template <class System>
CeresOutcome ceres_solve(const System& system, ReducedVector<System::dimension>& x, int threads) {
  constexpr int N = System::dimension;
  CeresOutcome out;
  // Of a start without numbers Ceres tells the standard error, whatever its logging type.
  const Linearized<N> start = system.linearize(x);
  const double inverse_scale = 1.0 / start.magnitude;
  if (!(inverse_scale * start.g).allFinite() ||
      !(inverse_scale * start.jacobian.matrix()).allFinite())
    return out;
  Eigen::Matrix<double, N, 1> log_x = logarithms(x.array());
  ceres::Problem problem;
  problem.AddResidualBlock(new Residual<System>(system, start.magnitude), nullptr, log_x.data());
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
  options.num_threads = available_threads(threads);
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

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
