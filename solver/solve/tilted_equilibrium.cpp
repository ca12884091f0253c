#include "solver/solve/tilted_equilibrium.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "solver/solve/family_solve.hpp"

namespace stationary {
namespace {

class TiltedSolve : FamilySolve {
 public:
  TiltedSolve(const Body& body, const Potential& potential, const TiltedRotation& motion,
              const SolveOptions& options)
      : FamilySolve(body, potential, options),
        motion_(motion),
        family_(tilted_family(body, potential, motion.plane, false)) {}

  Equilibrium run() {
    if (options_.start) {
      by_newton(*family_, unknowns<2>(*options_.start), motion_.nu, Connection::given_start,
                "Newton from the given start");
    } else {
      from_rest();
    }
    return out_;
  }

 private:
  /// To each tilt into the plane on the sheets through the rest state, and on along the family that
  /// begins there.
  void from_rest() {
    bool any = false;
    std::string failures;
    for (const Branch branch : {in_plane_branch(motion_.plane), Branch::iii}) {
      const Problem problem(body_, potential_, branch);
      const Equilibrium rest =
          solve(problem, 0.0, {.search = options_.search, .stop = options_.stop});
      out_.counts += rest.counts;
      if (rest.status != SolveStatus::solved) continue;
      const AnyFamily straight =
          axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = false});
      for (const Member& tilt : events_from_rest(straight, rest.q, motion_.nu, EventType::tilt)) {
        if (stopped()) break;
        if (!into_the_plane(tilt)) continue;
        any = true;
        from_tilt(branch, tilt);
        if (out_.status == SolveStatus::solved) return;
        failures += (failures.empty() ? "" : "; ") + out_.message;
      }
    }
    fail((any ? failures
              : "no sheet through the rest state tilts in the plane " +
                    std::string(name(motion_.plane))) +
         "; solve.start may lead to another");
  }

  /// (iii) tilts into either plane: into the one whose inertias are equal.
  bool into_the_plane(const Member& tilt) const {
    const int own = axis(in_plane_branch(motion_.plane));
    const auto I = locked_inertia(tilt.body, tilt.q);
    return std::abs(I(own, own) - I(2, 2)) <= 1e-9 * I(2, 2);
  }

  void from_tilt(Branch branch, const Member& tilt) {
    const std::string origin =
        "the tilt of branch (" + std::string(name(branch)) + ") at nu = " + text(tilt.nu);
    const std::string what = "the tilted family that begins at " + origin;
    const std::optional<Member> start = just_inside(*family_, tilt.q, tilt.nu);
    if (!start) return fail(what + " was not found");
    const double to = motion_.nu;
    along(*family_, start->q, start->nu, to,
          start->nu < to ? range(0.0, to, {}) : range(to, 2.0 * tilt.nu + to, {}), what);
    if (out_.status == SolveStatus::solved)
      out_.message = "from rest to " + origin + ", then along the tilted family";
  }

  TiltedRotation motion_;
  std::unique_ptr<Family<2>> family_;
};

}  // namespace

Equilibrium solve_tilted(const Body& body, const Potential& potential, const TiltedRotation& motion,
                         const SolveOptions& options) {
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)))
    throw std::invalid_argument("|nu| finite and > 0");
  if (options.start) {
    require_positive_definite(*options.start);
    if (options.start->alpha != 0.0)
      throw std::invalid_argument("alpha = 0 in the start: the potential is isotropic");
  }
  return TiltedSolve(body, potential, motion, options).run();
}

std::optional<Spectrum> tilted_stability(const Body& body, const Potential& potential,
                                         const TiltedRotation& motion,
                                         const Equilibrium& equilibrium) {
  return family_spectrum(*tilted_family(body, potential, motion.plane, true), equilibrium,
                         motion.nu);
}

}  // namespace stationary
