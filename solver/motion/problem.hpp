// A family of stationary ellipsoids: body, potential, branch, and what these facts leave to be
// solved.
//
//   separable V: rho decouples, V_rho'(rho) = J3 nu^2 rho in (i), (ii) and V_rho' = 0 in (iii)
//   isotropic V: alpha = 0 is held, which loses no solution without gravity: in (i), (ii) by
//                compatibility; in (iii) because nu lies along a principal axis (J1 != J2), or by
//                the choice of gauge on the circle of solutions (J1 = J2). With gravity there are
//                others, a family of their own (lib/balance/sheared_balance.hpp)
// so (xi, zeta) remain, or (xi, zeta, rho) where V couples them. Other V have alpha, too, an unknown
// where they are not even in it. Worked out once; the solvers ask.
#pragma once

#include <string>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/body/body.hpp"
#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

/// One line of `stationary check`: a quantity, how it is had, and why no more is computed.
struct PlanItem {
  std::string quantity;
  std::string how;
  std::string why;
};

enum class ThicknessRule {
  constant,     ///< (iii), separable: V_rho'(rho) = 0, solved once for all nu
  closed_form,  ///< (i), (ii), separable: one equation in rho alone
  coupled       ///< an unknown beside xi, zeta
};

class Problem {
 public:
  Problem(const Body& body, const Potential& potential, Branch branch);

  const Body& body() const { return body_; }
  const Potential& potential() const { return potential_; }
  Branch branch() const { return branch_; }
  ThicknessRule thickness_rule() const { return thickness_rule_; }
  /// Of an isotropic V, the coupled unknowns left: 2 (xi, zeta) or 3 (xi, zeta, rho).
  int unknowns() const { return thickness_rule_ == ThicknessRule::coupled ? 3 : 2; }
  const std::vector<PlanItem>& plan() const { return plan_; }

  /// With the potential restricted to the part of its domain that q lies in.
  Problem on_part_of(const Stretch& q) const { return {body_, potential_.on_part_of(q), branch_}; }

  /// Rates of C(nu) for a given nu^2, in double or in extended precision.
  template <class S>
  CentrifugalRates<S> rates(const S& nu_squared) const {
    return axis_rates(body_, branch_, nu_squared);
  }

 private:
  Body body_;
  Potential potential_;
  Branch branch_;
  ThicknessRule thickness_rule_;
  std::vector<PlanItem> plan_;
};

/// Whether the balance is unchanged with xi and zeta exchanged: for J1 = J2 in (iii), and at rest
/// where V is isotropic and no gravity sees J1 != J2.
bool mirror_symmetric(const Problem& problem, double nu);

}  // namespace stationary
