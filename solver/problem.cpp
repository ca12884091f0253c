#include "solver/problem.hpp"

#include <string>

namespace stationary {
namespace {

ThicknessRule thickness_rule(const Potential& potential, Branch branch) {
  if (!potential.is_separable()) return ThicknessRule::coupled;
  return branch == Branch::iii ? ThicknessRule::constant : ThicknessRule::closed_form;
}

std::vector<PlanItem> make_plan(const Body& body, Branch branch, ThicknessRule rule) {
  std::vector<PlanItem> plan;
  if (branch != Branch::iii) {
    plan.push_back({"alpha", "0, not an unknown",
                    "compatibility (J1 xi + J2 zeta) alpha = 0 leaves no other value"});
  } else if (!body.symmetric()) {
    plan.push_back({"alpha", "0, not an unknown",
                    "isotropic potential and J1 != J2: the spin lies along a principal axis"});
  } else {
    plan.push_back({"alpha", "0, not an unknown",
                    "J1 = J2 and an isotropic potential: material rotations are a symmetry, "
                    "solutions come in circles and theta = 0 is chosen"});
  }
  switch (rule) {
    case ThicknessRule::constant:
      plan.push_back({"rho", "closed form, once for all nu",
                      "separable potential; V_rho'(rho) = 0 has no nu in it"});
      break;
    case ThicknessRule::closed_form:
      plan.push_back({"rho", "closed form, corrected in extended precision",
                      "separable potential: V_rho'(rho) = J3 nu^2 rho has no xi, zeta in it"});
      break;
    case ThicknessRule::coupled:
      plan.push_back({"rho", "an unknown", "the potential couples it to xi and zeta"});
      break;
  }
  plan.push_back({"xi, zeta",
                  rule == ThicknessRule::coupled ? "3 equations with rho" : "2 equations",
                  "balance of elastic and centrifugal force"});
  return plan;
}

}  // namespace

Problem::Problem(const Body& body, const Potential& potential, Branch branch)
    : body_(body),
      potential_(potential),
      branch_(branch),
      thickness_rule_(stationary::thickness_rule(potential, branch)),
      plan_(make_plan(body, branch, thickness_rule_)) {}

}  // namespace stationary
