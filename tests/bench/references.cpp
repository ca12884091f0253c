#include "tests/bench/references.hpp"

#include "tests/support/general_path.hpp"
#include "tests/support/wide_spectrum.hpp"

namespace stationary::bench {

std::array<DoubleDouble, 3> exact_stretches(const Problem& problem, double nu, const Stretch& q) {
  const auto x = testing::reference_solution(problem, nu, q);
  return {testing::extended(x[0]), testing::extended(x[1]), testing::extended(x[2])};
}

std::vector<ExactLambda> exact_lambdas(const Problem& problem, const Equilibrium& at) {
  std::vector<ExactLambda> out;
  for (const testing::WideLambda& lambda : testing::wide_motion({problem, at, ""}).lambdas)
    out.push_back({testing::extended(lambda.re), testing::extended(lambda.im)});
  return out;
}

}  // namespace stationary::bench
