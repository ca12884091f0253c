// Two-polar motions at given rates or momenta, held against 50 digits and against what is proven of
// them.
#pragma once

#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/stress/judge/judge.hpp"

namespace stationary::stress {

/// Rates or momenta of every size, nearly equal ones (1e-12) and nearly opposite ones among them.
Outcome try_two_polar(Random& random);

/// text: of body and potential, for messages.
Outcome judged_two_polar(const Problem& problem, const TwoPolarMotion& motion,
                         const std::string& text);

}  // namespace stationary::stress
