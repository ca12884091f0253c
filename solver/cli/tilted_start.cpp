#include "solver/cli/tilted_start.hpp"

#include <fmt/format.h>

#include <utility>

#include "solver/case_keys.hpp"
#include "solver/cli/report.hpp"
#include "solver/tilted_equilibrium.hpp"

namespace stationary::cli {

Equilibrium tilted_start(const Case& input, const Potential& potential, TiltedMotion& motion,
                         const SolveOptions& options) {
  const std::vector<TiltedRotation> rotations = motion.rotations();
  Equilibrium out;
  std::string failures;
  for (const TiltedRotation& rotation : rotations) {
    Equilibrium found = solve_tilted(input.body, potential, rotation, options);
    if (found.status == SolveStatus::interrupted) return found;
    if (found.status != SolveStatus::solved) {
      failures += fmt::format("{}{} plane: {}", failures.empty() ? "" : "; ",
                              plane_text(rotation.plane), found.message);
      if (out.status != SolveStatus::solved) out = std::move(found);
      continue;
    }
    if (out.status == SolveStatus::solved) {
      throw fault_at(input.source, "motion.plane",
                     fmt::format("found no such key, and tilted motions with |nu| = {} in both "
                                 "planes",
                                 motion.nu),
                     "\"13\" or \"23\" for continue", "a table follows one of the two families");
    }
    motion.plane = rotation.plane;
    out = std::move(found);
  }
  if (out.status != SolveStatus::solved && rotations.size() > 1) out.message = failures;
  return out;
}

}  // namespace stationary::cli
