#include "solver/solve/tilted_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

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

  void run_each(const NumberRange& all, std::span<AtValue> values) {
    for_each_beginning(all.most(), [&](const Beginning& at) {
      const auto range_to = [&](double nu) { return limits(at, nu); };
      along_each(*family_, at.q, at.nu, range_to, all, values);
      return std::ranges::all_of(values, &AtValue::solved);
    });
  }

 private:
  /// A motion just inside the family that begins at a tilt.
  struct Beginning {
    Stretch q;
    double nu;
    double tilt;  ///< |nu| there
    std::string where;
  };

  /// Of the range in which the family is followed to nu.
  static std::pair<double, double> limits(const Beginning& at, double nu) {
    if (at.nu < nu) return {0.0, nu};
    return {nu, 2.0 * at.tilt + nu};
  }

  static std::string family_at(const std::string& where) {
    return "the tilted family that begins at " + where;
  }

  void from_rest() {
    const bool any = for_each_beginning(motion_.nu, [&](const Beginning& at) {
      const auto [from, to] = limits(at, motion_.nu);
      along(*family_, at.q, at.nu, motion_.nu, range(from, to, EventSet::none()),
            family_at(at.where));
      const bool solved = out_.status == SolveStatus::solved;
      if (!solved) failed(out_.message);
      if (solved) out_.message = "from rest to " + at.where + ", then along the tilted family";
      return solved;
    });
    if (out_.status == SolveStatus::solved) return;
    fail((any ? failures_
              : "no sheet through the rest state tilts in the plane " +
                    std::string(name(motion_.plane))) +
         "; solve.start may lead to another");
  }

  /// The families that begin at a tilt into the plane on the sheets through the rest state, tilts far
  /// beyond `most` too, until take() has what it wants. Whether there was one.
  template <class Take>
  bool for_each_beginning(double most, const Take& take) {
    bool any = false;
    for (const Branch branch : {in_plane_branch(motion_.plane), Branch::iii}) {
      const Problem problem(body_, potential_, branch);
      SolveOptions how;
      how.search = options_.search;
      how.stop = options_.stop;
      const Equilibrium rest = solve(problem, 0.0, how);
      out_.counts += rest.counts;
      if (rest.status != SolveStatus::solved) continue;
      const AnyFamily straight =
          axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = false});
      for (const Member& tilt : events_from_rest(straight, rest.q, most, EventType::tilt)) {
        if (stopped()) return any;
        if (!into_the_plane(tilt)) continue;
        any = true;
        const std::string where =
            "the tilt of branch (" + std::string(name(branch)) + ") at nu = " + text(tilt.nu);
        const std::optional<Member> start = just_inside(*family_, tilt.q, tilt.nu);
        if (!start) {
          failed(family_at(where) + " was not found");
        } else if (take(Beginning{start->q, start->nu, tilt.nu, where})) {
          return true;
        }
      }
    }
    return any;
  }

  void failed(const std::string& why) { failures_ += (failures_.empty() ? "" : "; ") + why; }

  /// (iii) tilts into either plane: into the one whose inertias are equal.
  bool into_the_plane(const Member& tilt) const {
    const int own = axis(in_plane_branch(motion_.plane));
    const auto I = locked_inertia(tilt.body, tilt.q);
    return std::abs(I(own, own) - I(2, 2)) <= 1e-9 * I(2, 2);
  }

  TiltedRotation motion_;
  std::unique_ptr<Family<2>> family_;
  std::string failures_;
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

void solve_tilted_each(const Body& body, const Potential& potential, TiltPlane plane, bool spectra,
                       const SolveOptions& options, const NumberRange& all, std::span<AtValue> at) {
  if (at.empty()) return;
  require_rates(at);
  TiltedSolve(body, potential, {plane, at.front().value}, options).run_each(all, at);
  if (!spectra) return;
  const auto family = tilted_family(body, potential, plane, true);
  for (AtValue& each : at)
    if (each.solved() && !each.spectrum)
      each.spectrum = family_spectrum(*family, each.equilibrium, each.value);
}

std::optional<Spectrum> tilted_stability(const Body& body, const Potential& potential,
                                         const TiltedRotation& motion,
                                         const Equilibrium& equilibrium) {
  return family_spectrum(*tilted_family(body, potential, motion.plane, true), equilibrium,
                         motion.nu);
}

}  // namespace stationary
