#include "tests/stress/cases/tilted_case.hpp"

#include <cmath>

#include "lib/balance/tilted_balance.hpp"
#include "solver/proof/tilted_enclosure.hpp"
#include "solver/solve/tilted_equilibrium.hpp"
#include "tests/stress/cases/near_event.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::stress {
namespace {

using testing::Number50;

/// (xi, zeta, rho) near q: the balance of all three stretches with rho tied to the plane's own
/// axis.
std::array<Number50, 3> tilted_reference(const Problem& problem, const TiltedRotation& motion,
                                         const Stretch& q) {
  const Body& body = problem.body();
  const testing::Inertia50 J{Number50(body.J1), Number50(body.J2), Number50(body.J3)};
  const Number50 nu(motion.nu);
  const auto thickness = [&](const auto& x) {
    return tilted_thickness(J, motion.plane, x[0], x[1]);
  };
  const auto c = axis_rates(body, Branch::iii, Number50(nu * nu));
  const auto x = testing::newton_50<2>(
      {Number50(q.xi), Number50(q.zeta)}, [&](const std::array<Number50, 2>& at) {
        const auto b = tied_to_plane<2>(
            testing::log_balance_50(problem.potential(), c, {at[0], at[1], thickness(at)}),
            motion.plane);
        return testing::Linearized50<2>{{b.g_xi, b.g_zeta}, {{{b.uu, b.uv}, {b.uv, b.vv}}}};
      });
  return {x[0], x[1], thickness(x)};
}

TiltPlane plane_of(const LocatedEvent& tilt) {
  if (tilt.family.branch != Branch::iii)
    return tilt.family.branch == Branch::i ? TiltPlane::one_three : TiltPlane::two_three;
  const Stretch& q = tilt.q;
  const auto apart = [&](double J, double stretch) {
    return std::abs(std::log(J * stretch * stretch / (tilt.family.J3 * q.rho * q.rho)));
  };
  return apart(tilt.family.J1, q.xi) < apart(tilt.family.J2, q.zeta) ? TiltPlane::one_three
                                                                     : TiltPlane::two_three;
}

}  // namespace

Outcome try_tilted(Random& random) {
  const LocatedEvent tilt = random_event(random, {EventType::tilt});
  const HardCase c = beside_event(random, tilt, std::pow(10.0, random.uniform(-12.0, -1.0)));
  const TiltedRotation motion{plane_of(tilt), std::abs(c.nu)};
  const Body& body = c.problem.body();
  const Potential& potential = c.problem.potential();
  const Equilibrium at = solve_tilted(body, potential, motion, c.options);
  Outcome out;
  out.status = at.status;
  out.work = work(at.counts);
  if (at.status != SolveStatus::solved) return out;
  const std::string text = "tilted " + std::string(name(motion.plane)) + ", " + c.text;
  judge_stretch(tilted_reference(c.problem, motion, at.q), {at.q.xi, at.q.zeta, at.q.rho},
                at.error_bound, text, out);
  const Certificate proof = certify_tilted(body, potential, motion, at);
  const auto spectrum = tilted_stability(body, potential, motion, at);
  if (!spectrum) return out;
  judge_by_proof(
      proof, *spectrum, [&] { return enclose_spectrum(body, potential, motion, proof, *spectrum); },
      text, out);
  return out;
}

}  // namespace stationary::stress
