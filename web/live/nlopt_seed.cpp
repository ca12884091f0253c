// In the place of solver/newton/nlopt_seed.cpp, for pages, which have no NLopt. Where the program asks it, a page could
// find something else: it says so.
#include "solver/newton/nlopt_seed.hpp"

#include <stdexcept>

namespace stationary {

std::string version_of_nlopt() { return {}; }

template <int N>
Seeds<N> nlopt_seeds(const std::function<double(const ReducedVector<N>&)>&, const SeedOptions&) {
  throw std::runtime_error(
      "here the program looks for a start with NLopt, which a page does not have: ask "
      "`stationary solve`");
}

template Seeds<2> nlopt_seeds<2>(const std::function<double(const ReducedVector<2>&)>&,
                                 const SeedOptions&);
template Seeds<3> nlopt_seeds<3>(const std::function<double(const ReducedVector<3>&)>&,
                                 const SeedOptions&);

}  // namespace stationary
