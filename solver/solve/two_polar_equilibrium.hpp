// Two-polar stationary motions (J1 = J2): lambda, mu, rho given the rates (omega, theta') or the
// momenta (s3, p_theta); equations in lib/balance/two_polar.hpp.
//
// An answer has lambda > mu. Where the rates lie on a line of solutions (two_polar_motion.hpp) that
// is said instead of returning one of them. Where no lambda > mu is found, the circle lambda = mu,
// which depends on omega + theta' only and has s3 = p_theta, is returned and named.
#pragma once

#include <span>

#include "lib/stability/spectrum.hpp"
#include "solver/motion/two_polar_motion.hpp"
#include "solver/solve/at_values.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// Without a start all motions are searched for (two_polar_search.hpp) and the ellipse nearest to
/// the unit stretches is the answer; what that search leaves undecided NLopt and Newton's method
/// look into. With one: Newton's method there; one on the circle, at given rates that allow no ellipse near by, leads to
/// the circle near it. options.method: automatic, or nlopt without that search. Throws as require_two_polar().
Equilibrium solve_two_polar(const Body& body, const Potential& potential,
                            const TwoPolarMotion& motion, const SolveOptions& options = {});

/// At each value of a number of the motion that has none yet what solve_two_polar() finds without a
/// start, by searches that serve many of them (TwoPolarSearches). spectra: theirs too. options: method,
/// search and stop. Throws as solve_two_polar().
void solve_two_polar_each(const Body& body, const Potential& potential,
                          const TwoPolarMotion& motion, bool spectra, const SolveOptions& options,
                          const NumberRange& range, std::span<AtValue> at);

/// Its spectrum on the leaf |s|, p_theta fixed (lambda != mu), or that of (iii) with nu3 = omega +
/// theta' on the circle.
Spectrum two_polar_stability(const Body& body, const Potential& potential,
                             const Equilibrium& equilibrium);

}  // namespace stationary
