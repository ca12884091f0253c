#include "tests/stress/cases/two_polar_case.hpp"

#include <cmath>
#include <sstream>

#include "lib/balance/two_polar.hpp"
#include "solver/proof/two_polar_enclosure.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::stress {
namespace {

using testing::Number50;

TwoPolarRates<Number50> widened(const TwoPolarRates<double>& m) {
  return {Number50(m.omega), Number50(m.theta_dot)};
}
TwoPolarMomenta<Number50> widened(const TwoPolarMomenta<double>& m) {
  return {Number50(m.s3), Number50(m.p_theta)};
}

/// (lambda, mu, rho) near x: the elastic balance minus the pull of the motion.
template <class Motion>
std::array<Number50, 3> two_polar_reference(const Problem& problem, const Motion& motion,
                                            const Vector3<double>& x) {
  const Number50 J(problem.body().J1);
  const CentrifugalRates<Number50> none{Number50(0), Number50(0), Number50(0)};
  return testing::newton_50<3>(
      {Number50(x[0]), Number50(x[1]), Number50(x[2])}, [&](const std::array<Number50, 3>& at) {
        const auto b = testing::log_balance_50(problem.potential(), none, at);
        const auto pull = two_polar_pull(J, at[0], at[1], motion);
        return testing::Linearized50<3>{{b.g_xi - pull.lambda, b.g_zeta - pull.mu, b.g_rho},
                                        {{{b.uu - pull.ll, b.uv - pull.lm, b.uw},
                                          {b.uv - pull.lm, b.vv - pull.mm, b.vw},
                                          {b.uw, b.vw, b.ww}}}};
      });
}

std::array<Number50, 3> motion_reference(const Problem& problem, const TwoPolarMotion& motion,
                                         const Equilibrium& at) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion))
    return two_polar_reference(problem, widened(*rates), diagonal(at.q));
  const auto& momenta = std::get<TwoPolarMomenta<double>>(motion);
  if (at.circle)
    return two_polar_reference(problem, TwoPolarEqualMomenta<Number50>{Number50(momenta.s3)},
                               diagonal(at.q));
  return two_polar_reference(problem, widened(momenta), diagonal(at.q));
}

std::string motion_text(const TwoPolarMotion& motion) {
  std::ostringstream text;
  text.precision(17);
  const bool rates = std::holds_alternative<TwoPolarRates<double>>(motion);
  std::visit(
      [&](const auto& m) {
        const auto& [first, second] = m;
        text << ", two-polar " << (rates ? "rates " : "momenta ") << first << " " << second;
      },
      motion);
  return text.str();
}

/// A second number beside the first: any, or nearly its equal or opposite.
double partner(Random& random, double first) {
  const double apart = std::pow(10.0, random.uniform(-12.0, -1.0));
  switch (random.integer(0, 3)) {
    case 0:
      return first * (1.0 + random.sign() * apart);
    case 1:
      return -first * (1.0 + random.sign() * apart);
    default:
      return first * random.uniform(-1.0, 1.0);
  }
}

}  // namespace

Outcome try_two_polar(Random& random) {
  Ingredients family = random_ingredients(random, 1.0);
  family.J2 = family.J1;
  family.branch = Branch::iii;
  const HardCase c = family.posed();
  const double speed = escape_speed(family) * random.log_uniform(0.05, 1.5);
  TwoPolarMotion motion = TwoPolarRates<double>{speed, partner(random, speed)};
  if (random.integer(0, 1) == 0) {
    const double s3 = family.J1 * speed * random.log_uniform(0.3, 3.0);
    motion = TwoPolarMomenta<double>{s3, partner(random, s3)};
  }
  return judged_two_polar(c.problem, motion, c.text);
}

Outcome judged_two_polar(const Problem& problem, const TwoPolarMotion& motion,
                         const std::string& of) {
  const Body& body = problem.body();
  const Potential& potential = problem.potential();
  const std::string text = of + motion_text(motion);
  const Equilibrium at = solve_two_polar(body, potential, motion);
  Outcome out;
  out.status = at.status;
  out.work = work(at.counts);
  if (at.status != SolveStatus::solved) return out;
  judge_stretch(motion_reference(problem, motion, at), {at.q.xi, at.q.zeta, at.q.rho},
                at.error_bound, text, out);
  const Certificate proof = certify_two_polar(body, potential, motion, at);
  const Spectrum spectrum = two_polar_stability(body, potential, at);
  judge_by_proof(
      proof, spectrum,
      [&] { return enclose_spectrum(body, potential, motion, at, proof, spectrum); }, text, out);
  return out;
}

}  // namespace stationary::stress
