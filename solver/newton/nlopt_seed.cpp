#include "solver/newton/nlopt_seed.hpp"

#include <cmath>
#include <nlopt.hpp>

#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"
#include "solver/newton/seed_selection.hpp"

namespace stationary {
namespace {

template <int N>
struct Recorder {
  const std::function<double(const ReducedVector<N>&)>& objective;
  const std::atomic<bool>* stop;
  nlopt::opt* optimizer;
  std::vector<SampledSeed<N>> sampled;

  static double evaluate(const std::vector<double>& log_x, std::vector<double>&, void* self) {
    auto& recorder = *static_cast<Recorder*>(self);
    if (recorder.stop != nullptr && recorder.stop->load(std::memory_order_relaxed))
      recorder.optimizer->force_stop();
    const ReducedVector<N> point = Eigen::Map<const ReducedVector<N>>(log_x.data());
    const double f = recorder.objective(exponentials(point.array()));
    if (!std::isfinite(f)) return std::numeric_limits<double>::max();
    recorder.sampled.emplace_back(f, point);
    return f;
  }
};

}  // namespace

std::string version_of_nlopt() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  ::nlopt_version(&major, &minor, &patch);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

template <int N>
Seeds<N> nlopt_seeds(const std::function<double(const ReducedVector<N>&)>& objective,
                     const SeedOptions& options) {
  nlopt::opt optimizer(nlopt::GN_DIRECT_L, N);
  Recorder<N> recorder{objective, options.stop, &optimizer, {}};
  recorder.sampled.reserve(static_cast<std::size_t>(options.evaluations));
  optimizer.set_min_objective(&Recorder<N>::evaluate, &recorder);
  optimizer.set_lower_bounds(log(options.min_stretch));
  optimizer.set_upper_bounds(log(options.max_stretch));
  optimizer.set_maxeval(options.evaluations);

  Seeds<N> out;
  std::vector<double> log_x(N, 0.0);
  double smallest = 0.0;
  try {
    optimizer.optimize(log_x, smallest);
  } catch (const nlopt::forced_stop&) {
    out.interrupted = true;
  } catch (const nlopt::roundoff_limited&) {
    // The points sampled so far are as good as any: the caller polishes and checks them.
  }
  out.evaluations = optimizer.get_numevals();
  out.points = select_seeds<N>(recorder.sampled, options);
  return out;
}

template Seeds<2> nlopt_seeds<2>(const std::function<double(const ReducedVector<2>&)>&,
                                 const SeedOptions&);
template Seeds<3> nlopt_seeds<3>(const std::function<double(const ReducedVector<3>&)>&,
                                 const SeedOptions&);

}  // namespace stationary
