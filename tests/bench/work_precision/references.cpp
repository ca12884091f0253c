#include "tests/bench/work_precision/references.hpp"

#include <Eigen/QR>

#include "tests/support/general_path.hpp"
#include "tests/support/numbers/wide_spectrum.hpp"

namespace stationary::bench {

std::array<DoubleDouble, 3> exact_stretches(const Problem& problem, double nu, const Stretch& q) {
  const auto x = testing::reference_solution(problem, nu, q);
  return {testing::extended(x[0]), testing::extended(x[1]), testing::extended(x[2])};
}

double distance_from_sheet(const Problem& problem, const std::array<DoubleDouble, 3>& stretches,
                           double nu, double scale) {
  using testing::Number50;
  std::array<Number50, 3> x;
  for (std::size_t i = 0; i < 3; ++i) x[i] = Number50(stretches[i].hi) + Number50(stretches[i].lo);
  const auto at =
      testing::log_balance_50(problem.potential(), problem.rates(Number50(nu) * Number50(nu)), x);
  const CentrifugalRates<double> unit = problem.rates(1.0);
  const double rates[3] = {unit.xi, unit.zeta, unit.rho};
  const Number50 jacobian[3][3] = {
      {at.uu, at.uv, at.uw}, {at.uv, at.vv, at.vw}, {at.uw, at.vw, at.ww}};
  const Number50 residual[3] = {at.g_xi, at.g_zeta, at.g_rho};
  Eigen::Matrix<double, 3, 4> A;
  Vector3<double> G;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 3; ++j)
      A(row, static_cast<Eigen::Index>(j)) = jacobian[i][j].convert_to<double>();
    A(row, 3) = -2.0 * scale * nu * rates[i] * Number50(x[i] * x[i]).convert_to<double>();
    G[row] = residual[i].convert_to<double>();
    const double size = A.row(row).cwiseAbs().maxCoeff();
    A.row(row) /= size;
    G[row] /= size;
  }
  return A.completeOrthogonalDecomposition().solve(G).norm();
}

std::vector<ExactLambda> exact_lambdas(const Problem& problem, const Equilibrium& at) {
  std::vector<ExactLambda> out;
  for (const testing::WideLambda& lambda : testing::wide_motion({problem, at, ""}).lambdas)
    out.push_back({testing::extended(lambda.re), testing::extended(lambda.im)});
  return out;
}

}  // namespace stationary::bench
