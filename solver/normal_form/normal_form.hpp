// On which side of an event the motions lie that begin there, and how they begin. F(x; p) is the
// reduced energy of a kind of motion in x, the logarithms of the stretches and what else the kind
// leaves open (isotropic_gradient.hpp, oriented_normal_form.cpp, two_polar_normal_form.cpp), p the
// family's parameter; v the direction that is singular at the event, K the Hessian across it.
//
//   a fold         v unit, K v = 0:  p - p0 = -F_vvv s^2/(2 F_vp),  s the length along v;
//                  v points where F_vp < 0, and the coefficient is F_vvv
//   fold-momentum  the same of V + |pi|^2/(2 I), I the locked inertia about the axis, and p = |pi|
//   ellipse        v = (1, -1, 0), s = ln(xi/zeta)/2; ellipse-23, ellipse-13: of zeta and rho, xi and rho
//   tilt           v the angle s from the axis of the spin to that it tilts to:
//                  F_ss = -nu^2 (I_b - I_a), and F_ssss = 0 at the event
//   shear, oblique of anisotropic bodies (oriented_normal_form.cpp)
//
// But for folds these break a symmetry, so that odd derivatives vanish; along the sheet that keeps it
// F_vv = e (p - p0), and
//
//   p - p0 = -a s^2/(6 e),   a = F_vvvv - 3 F_vv. K^-1 F_vv.   the coefficient.
//
// A family that begins there has that event as its end. Derivatives are Taylor numbers
// (lib/number/taylor.hpp) over intervals about the event, through the formulas of the balance itself.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "lib/body/circle.hpp"
#include "solver/motion/event.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// Where p grows, |pi| at `fold-momentum`: the motions that meet at a fold, or those that leave the
/// symmetric sheet, exist before the event or after it.
enum class EventSide { before, after };
constexpr std::string_view event_side_names[] = {"before", "after"};
constexpr std::string_view name(EventSide s) { return event_side_names[static_cast<int>(s)]; }

struct NormalForm {
  double coefficient;  ///< in units of V
  double error;        ///< of it, as far as the event's own error bound holds
  EventSide side;
};

/// Of the event of this type at a located member of problem's family in a parameter, problem and nu
/// those at the event; circle: that the family keeps. Nothing where the event is of another type, or
/// the error leaves a sign open.
std::optional<NormalForm> normal_form(const Problem& problem, const FamilyParameter& parameter,
                                      Circle circle, EventType type, const Member& member);

/// Likewise of a tilted family in |nu|.
std::optional<NormalForm> tilted_normal_form(const Body& body, const Potential& potential,
                                             TiltPlane plane, EventType type, const Member& member);

/// Of an oblique family of a potential that is not isotropic.
std::optional<NormalForm> oblique_normal_form(const Body& body, const Potential& potential,
                                              const FamilyParameter& parameter, EventType type,
                                              const Member& member);

/// Of a two-polar family in what it holds or a number of the problem. Nothing where |pi| turns at
/// given rates, which no number of the family does there, or where its axis tilts.
std::optional<NormalForm> two_polar_normal_form(const Body& body, const Potential& potential,
                                                const TwoPolarMotion& motion,
                                                const FamilyParameter& parameter, EventType type,
                                                const Member& member);

}  // namespace stationary
