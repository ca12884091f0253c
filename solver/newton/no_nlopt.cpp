// In the place of nlopt_seed.cpp where there is no NLopt: the objective on a grid of as many points as NLopt would
// have asked for.
#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"
#include "solver/newton/nlopt_seed.hpp"
#include "solver/newton/seed_selection.hpp"

namespace stationary {

std::string version_of_nlopt() { return {}; }

template <int N>
Seeds<N> nlopt_seeds(const std::function<double(const ReducedVector<N>&)>& objective,
                     const SeedOptions& options) {
  const int count = static_cast<int>(std::floor(pow(options.evaluations, 1.0 / N)));
  const double from = log(options.min_stretch);
  const double step = log(options.max_stretch / options.min_stretch) / count;
  Seeds<N> out;
  std::vector<SampledSeed<N>> sampled;
  std::array<int, N> index{};
  for (std::size_t k = 0; k < N;) {
    if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed)) {
      out.interrupted = true;
      break;
    }
    ReducedVector<N> log_x;
    for (std::size_t i = 0; i < N; ++i)
      log_x[static_cast<Eigen::Index>(i)] = from + (index[i] + 0.5) * step;
    const double f = objective(exponentials(log_x.array()));
    ++out.evaluations;
    if (std::isfinite(f)) sampled.emplace_back(f, log_x);
    for (k = 0; k < N && ++index[k] == count; ++k) index[k] = 0;
  }
  out.points = select_seeds<N>(sampled, options);
  return out;
}

template Seeds<2> nlopt_seeds<2>(const std::function<double(const ReducedVector<2>&)>&,
                                 const SeedOptions&);
template Seeds<3> nlopt_seeds<3>(const std::function<double(const ReducedVector<3>&)>&,
                                 const SeedOptions&);

}  // namespace stationary
