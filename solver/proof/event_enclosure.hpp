// A proof of where an event lies: the balance and the event's own equations together,
//
//   G(x; p) = 0,  f(x, p) = 0                    fold, equal inertias, circle to ellipse, ...
//   G(x; p) = 0,  P(Lambda) = 0,  P'(Lambda) = 0 two Lambdas of a block meet (P its polynomial)
//   G(x; p) = 0,  P_a(Lambda) = 0 = P_b(Lambda)  Lambdas of two blocks do
//
// form a system that is regular where G alone may be singular (a fold). Krawczyk's test
// (krawczyk.hpp) on it, in the logarithms of all unknowns, shows exactly one such point near the
// located one and encloses its p and its stretches. The slopes are exact: dual numbers over
// intervals. The same system in extended precision (extended_root.hpp) is what a located event is
// corrected by, and its error bound comes from.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/body/circle.hpp"
#include "lib/number/dual.hpp"
#include "solver/motion/event.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

struct EventEnclosure {
  bool proven = false;
  std::string reason;  ///< why not
  /// As of a Certificate.
  std::vector<std::string> assuming;
  Interval parameter;  ///< holds the event's p, for every value the inputs may have
  StretchBox q;        ///< likewise its stretches
  /// Proven bound of the relative error of each of the member's xi, zeta, rho as the event's.
  double error_bound = std::numeric_limits<double>::quiet_NaN();
};

/// Whether there are equations for this event here: those of physics, none for the ends of a sheet
/// or what is unexplained.
bool has_enclosure(EventType type);

/// The event of this type at a located member of problem's family in a parameter; the problem is
/// taken at the member's own parameter, with the member's nu. circle: that the family keeps.
/// Inputs as in certify(); the parameter itself is an unknown.
EventEnclosure enclose_event(const Problem& problem, const FamilyParameter& parameter,
                             Circle circle, EventType type, const Member& member,
                             Inputs inputs = Inputs::decimals);

template <int N>
using BoxDual = Dual<Interval, static_cast<std::size_t>(N)>;

/// The elastic part of an isotropic potential's balance over a box of (xi, zeta, rho), p the
/// parameter where it is a coefficient; N = 3 or 4 unknowns of the event's equations.
template <int N>
LogBalance<BoxDual<N>> elastic_over(const Potential& potential, const FamilyParameter& parameter,
                                    const std::array<BoxDual<N>, 3>& x, const BoxDual<N>& p,
                                    Inputs inputs);

/// The event of this type near a located member by the same equations, in extended precision: x is
/// (xi, zeta, rho). Nothing where they are singular or are not known.
std::optional<ExtendedEvent<3>> extended_event(const Problem& problem,
                                               const FamilyParameter& parameter, Circle circle,
                                               EventType type, const Member& member);

}  // namespace stationary
