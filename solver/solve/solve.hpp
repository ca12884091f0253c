// One stationary ellipsoid: S given nu.
//
// Cold start, method automatic:
//   1. a walk along the rest state's sheet (rest_walk) from nu = 0 to nu, so that the answer is the
//      solution connected to rest; Ceres (trust region) solves at nu from where the walk arrived;
//   2. where that sheet does not reach nu, or its balance is singular there, and unless search =
//      false, branch and prune (search.hpp) finds all solutions in its box. The answer is the one
//      nearest to the rest state, and says that its connection to rest is not known. NLopt searches
//      what that leaves undecided.
// From a given start: Ceres, then Newton, then the same searches.
// ceres, newton: that solver alone, from the rest state or the given start, with no walk.
// nlopt: Newton from the points of NLopt's global search, nothing else.
// All end in the same correction with an extended-precision residual (refine). The residual of
// what is returned is recomputed in lib, and that decides, whatever a solver said.
#pragma once

#include <atomic>
#include <optional>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "solver/motion/equilibrium.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

enum class Method { automatic, ceres, newton, nlopt };
constexpr std::string_view method_names[] = {"auto", "ceres", "newton", "nlopt"};
constexpr std::string_view name(Method m) { return method_names[static_cast<int>(m)]; }

struct SolveOptions {
  Method method = Method::automatic;
  std::optional<Stretch> start = {};        ///< default: the rest state
  bool search = true;                       ///< false: rest's sheet alone, no global search
  int threads = 1;                          ///< for Ceres
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: return with status interrupted
};

/// nu: along the branch's axis, any finite value. Throws std::invalid_argument for a nu that is not
/// finite or a start that is not positive definite or, of an isotropic potential, has alpha != 0.
/// Of another potential: anisotropic_equilibrium.hpp.
Equilibrium solve(const Problem& problem, double nu, const SolveOptions& options = {});

}  // namespace stationary
