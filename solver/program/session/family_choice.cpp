#include "solver/program/session/family_choice.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>

#include "solver/program/case/case_schema.hpp"
#include "solver/program/session/report.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/tilted_equilibrium.hpp"

namespace stationary::cli {
namespace {

/// The motion of the only candidate that has one, which is left in `chosen`; both(): throws.
template <class Candidate, class Solve, class Name, class Both>
Equilibrium only_one(std::span<const Candidate> candidates, const Solve& solve, const Name& name,
                     const Both& both, Candidate& chosen) {
  Equilibrium out;
  std::string failures;
  for (const Candidate& candidate : candidates) {
    Equilibrium found = solve(candidate);
    if (found.status == SolveStatus::interrupted) return found;
    if (found.status != SolveStatus::solved) {
      failures +=
          fmt::format("{}{}: {}", failures.empty() ? "" : "; ", name(candidate), found.message);
      if (out.status != SolveStatus::solved) out = std::move(found);
      continue;
    }
    if (out.status == SolveStatus::solved) both();
    chosen = candidate;
    out = std::move(found);
  }
  if (out.status != SolveStatus::solved && candidates.size() > 1) out.message = failures;
  return out;
}

}  // namespace

Equilibrium tilted_start(const Case& input, const Potential& potential, TiltedMotion& motion,
                         const SolveOptions& options) {
  const std::vector<TiltedRotation> rotations = motion.rotations();
  TiltedRotation chosen = rotations.front();
  Equilibrium out = only_one<TiltedRotation>(
      rotations,
      [&](const TiltedRotation& each) {
        return solve_tilted(input.body, potential, each, options);
      },
      [](const TiltedRotation& each) { return std::string(plane_text(each.plane)) + " plane"; },
      [&] {
        throw fault_at(input.source, "motion.plane",
                       fmt::format("found no such key, and tilted motions with |nu| = {} in both "
                                   "planes",
                                   motion.nu),
                       "\"13\" or \"23\" for continue", "a table follows one of the two families");
      },
      chosen);
  if (out.status == SolveStatus::solved) motion.plane = chosen.plane;
  return out;
}

Equilibrium oblique_start(const Case& input, const Body& body, const Potential& potential,
                          ObliqueRotation& motion, const SolveOptions& options) {
  if (motion.near || options.start) return solve_oblique(body, potential, motion, options);
  const std::array<ObliqueRotation, 2> families{ObliqueRotation{motion.nu, Branch::i},
                                                ObliqueRotation{motion.nu, Branch::ii}};
  ObliqueRotation chosen = motion;
  SolveOptions following = options;  // a search would find either family's motion
  following.search = false;
  Equilibrium out = only_one<ObliqueRotation>(
      families,
      [&](const ObliqueRotation& each) { return solve_oblique(body, potential, each, following); },
      [](const ObliqueRotation& each) { return fmt::format("axis {}", axis(*each.near) + 1); },
      [&] {
        throw fault_at(input.source, "motion.axis",
                       fmt::format("found no such key, and oblique motions with |nu| = {} of the "
                                   "families of both axes",
                                   motion.nu),
                       "\"1\" or \"2\" for continue", "a table follows one of the two families");
      },
      chosen);
  if (out.status == SolveStatus::not_found) return solve_oblique(body, potential, motion, options);
  if (out.status == SolveStatus::solved) motion.near = chosen.near;
  return out;
}

}  // namespace stationary::cli
